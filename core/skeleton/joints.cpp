#include "skeleton/joints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "skeleton/bounded_dp.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kSampleStep = 10;  // units at the reference perimeter

BoundedDpOptions scaled(const JointOptions& options, double scale) {
  return {options.epsilon_s * scale, options.shape_weight, options.shrink};
}

class Placement {
 public:
  Placement(const Region& region, const Axis& axis, double scale, const JointOptions& options)
      : region_(region), axis_(axis), step_(kSampleStep * scale), dp_(scaled(options, scale)) {
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

  void addBones(const std::vector<uint32_t>& line, uint32_t from, uint32_t to) {
    PartSkeleton::Branch branch;
    branch.first_bone = static_cast<uint32_t>(result_.bones.size());
    branch.joints.push_back(from);
    if (line.size() == 2) {
      // Along a single edge the inscribed radius is linear: one bone says it all.
      const Vec2 a = axis_.points[line[0]], b = axis_.points[line[1]];
      branch.samples.resize(2);
      branch.samples[0].point = a;
      branch.samples[0].radius = result_.joints[from].radius;
      branch.samples[1].point = b;
      branch.samples[1].radius = result_.joints[to].radius;
      branch.samples[1].along = distance(a, b);
      branch.levels.assign(2, std::numeric_limits<double>::infinity());
    } else {
      std::vector<Vec2> points;
      for (const uint32_t i : line) points.push_back(axis_.points[i]);
      branch.samples = sampleBranch(region_, points, step_);
      branch.levels = branchLevels(region_, branch.samples, dp_);
      branch.level_floor = dp_.epsilon;
    }
    const auto& samples = branch.samples;
    branch.at.push_back(0);
    for (uint32_t k = 1; k + 1 < samples.size(); ++k) {
      if (!isKept(branch.levels[k], dp_.epsilon)) continue;
      branch.joints.push_back(addJoint(samples[k].point, samples[k].radius));
      branch.at.push_back(k);
    }
    branch.joints.push_back(to);
    branch.at.push_back(static_cast<uint32_t>(samples.size() - 1));
    for (size_t k = 0; k + 1 < branch.joints.size(); ++k) {
      result_.bones.push_back({branch.joints[k], branch.joints[k + 1]});
    }
    result_.branches.push_back(std::move(branch));
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

void completeLevels(PartSkeleton::Branch& branch, const std::vector<Vec2>& polygon, double scale,
                    const JointOptions& options, const std::vector<Vec2>* outline) {
  if (branch.level_floor <= 0) return;
  BoundedDpOptions dp = scaled(options, scale);
  dp.epsilon = 0;
  std::vector<double> levels = branchLevels({polygon, outline}, branch.samples, dp);
  // What is known already stays to the last bit; the rest lies below.
  for (size_t i = 0; i < levels.size(); ++i) {
    levels[i] = branch.levels[i] > branch.level_floor ? branch.levels[i]
                                                      : std::min(levels[i], branch.level_floor);
  }
  branch.levels = std::move(levels);
  branch.level_floor = 0;
}

}  // namespace marrow
