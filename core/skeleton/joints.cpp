#include "skeleton/joints.h"

#include <cmath>

#include "skeleton/bounded_dp.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kSampleStep = 10;  // units at the reference perimeter

class Placement {
 public:
  Placement(const Region& region, const Axis& axis, double scale, const JointOptions& options)
      : region_(region), axis_(axis), step_(kSampleStep * scale) {
    dp_.epsilon = options.epsilon_s * scale;
    dp_.shape_weight = options.shape_weight;
    dp_.shrink = options.shrink;
    neighbours_.resize(axis.points.size());
    for (const auto& edge : axis.edges) {
      neighbours_[edge[0]].push_back(edge[1]);
      neighbours_[edge[1]].push_back(edge[0]);
    }
  }

  PartSkeleton run() {
    const uint32_t count = static_cast<uint32_t>(axis_.points.size());
    std::vector<uint32_t> joint_of(count);
    for (uint32_t i = 0; i < count; ++i) {
      if (neighbours_[i].size() == 2) continue;
      joint_of[i] = addJoint(axis_.points[i], distanceToBorder(region_.polygon, axis_.points[i]));
    }
    for (uint32_t start = 0; start < count; ++start) {
      if (neighbours_[start].size() == 2) continue;
      for (const uint32_t next : neighbours_[start]) {
        const std::vector<uint32_t> branch = branchFrom(start, next);
        if (branch.back() < start) continue;  // met from its other end
        addBones(branch, joint_of[start], joint_of[branch.back()]);
      }
    }
    setKinds();
    return std::move(result_);
  }

 private:
  uint32_t addJoint(Vec2 position, double radius) {
    result_.joints.push_back({JointKind::sleeve, position, radius});
    return static_cast<uint32_t>(result_.joints.size() - 1);
  }

  /// The axis points from one non-sleeve to the next.
  std::vector<uint32_t> branchFrom(uint32_t start, uint32_t next) const {
    std::vector<uint32_t> branch{start, next};
    while (neighbours_[branch.back()].size() == 2) {
      const uint32_t before = branch[branch.size() - 2];
      const auto& around = neighbours_[branch.back()];
      branch.push_back(around[0] == before ? around[1] : around[0]);
    }
    return branch;
  }

  void addBones(const std::vector<uint32_t>& branch, uint32_t from, uint32_t to) {
    // Along a single edge the inscribed radius is linear: one bone says it all.
    if (branch.size() == 2) {
      result_.bones.push_back({from, to});
      return;
    }
    std::vector<Vec2> points;
    for (const uint32_t i : branch) points.push_back(axis_.points[i]);
    const auto samples = sampleBranch(region_, points, step_);
    const auto kept = boundedDp(region_, samples, dp_);
    uint32_t last = from;
    for (size_t k = 1; k + 1 < kept.size(); ++k) {
      const uint32_t joint = addJoint(samples[kept[k]].point, samples[kept[k]].radius);
      result_.bones.push_back({last, joint});
      last = joint;
    }
    result_.bones.push_back({last, to});
  }

  void setKinds() {
    std::vector<int> degrees(result_.joints.size());
    for (const auto& bone : result_.bones) {
      ++degrees[bone[0]];
      ++degrees[bone[1]];
    }
    for (size_t i = 0; i < degrees.size(); ++i) {
      result_.joints[i].kind = degrees[i] == 1   ? JointKind::terminal
                               : degrees[i] == 2 ? JointKind::sleeve
                                                 : JointKind::junction;
    }
  }

  Region region_;
  const Axis& axis_;
  double step_;
  BoundedDpOptions dp_;
  std::vector<std::vector<uint32_t>> neighbours_;
  PartSkeleton result_;
};

}  // namespace

const char* toString(JointKind kind) {
  switch (kind) {
    case JointKind::terminal:
      return "terminal";
    case JointKind::sleeve:
      return "sleeve";
    case JointKind::junction:
      return "junction";
  }
  return "";
}

Result<PartSkeleton> placeJoints(const std::vector<Vec2>& polygon, const Axis& axis, double scale,
                                 const JointOptions& options, const std::vector<Vec2>* outline) {
  if (polygon.size() < 3 || axis.edges.empty() || axis.points.size() != axis.edges.size() + 1) {
    return Status::skeletonFailed;
  }
  if (!std::isfinite(scale) || scale < 0) return Status::skeletonFailed;
  return Placement({polygon, outline}, axis, scale, options).run();
}

}  // namespace marrow
