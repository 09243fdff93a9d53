#include "skeleton/joints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "skeleton/bounded_dp.h"
#include "skeleton/branches.h"
#include "skeleton/limb_joints.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kSampleStep = 10;  // units at the reference perimeter

BoundedDpOptions scaled(const JointOptions& options, double scale) {
  return {options.epsilon_s * scale, options.shape_weight, options.shrink};
}

class Placement {
 public:
  Placement(const Region& region, AxisBranches branches, const MirrorLine* mirror, double scale,
            const JointOptions& options)
      : region_(region),
        axis_(std::move(branches)),
        mirror_(mirror),
        step_(kSampleStep * scale),
        usual_(JointOptions().epsilon_s * scale),
        dp_(scaled(options, scale)) {}

  PartSkeleton run() {
    for (const AxisBranches::End& end : axis_.ends) {
      addJoint(end.point, distanceToBorder(region_.polygon, end.point));
    }
    for (uint32_t b = 0; b < axis_.branches.size(); ++b) {
      const AxisBranches::Branch& way = axis_.branches[b];
      PartSkeleton::Branch branch =
          mirror_ && way.image < b ? imageOf(result_.branches[way.image]) : branchAlong(way, b);
      branch.image = way.image;
      addBones(way, std::move(branch));
    }
    setKinds();
    if (mirror_) result_.mirror = *mirror_;
    return std::move(result_);
  }

 private:
  uint32_t addJoint(Vec2 position, double radius) {
    result_.joints.push_back({JointKind::sleeve, position, radius});
    return static_cast<uint32_t>(result_.joints.size() - 1);
  }

  BranchEnd endOf(const AxisBranches::Branch& way, bool at_end) const {
    const uint32_t end = at_end ? way.to : way.from;
    BranchEnd found{axis_.ends[end].branches > 1, result_.joints[end].radius, {}};
    if (at_end ? way.mouth_to : way.mouth_from) {
      found.mouth = way.line[at_end ? way.line.size() - 2 : 1];
    }
    return found;
  }

  static AxisLine lineOf(const AxisBranches::Branch& way) {
    AxisLine line{way.line, way.radii, {}};
    if (way.mouth_from) line.corners.push_back(1);
    if (way.mouth_to) line.corners.push_back(way.line.size() - 2);
    return line;
  }

  /// Samples and levels.
  PartSkeleton::Branch branchAlong(const AxisBranches::Branch& way, uint32_t index) const {
    PartSkeleton::Branch branch;
    const bool across =
        mirror_ && way.image == index && axis_.ends[way.from].image == way.to && way.from != way.to;
    branch.samples = across ? sampleMirroredBranch(region_, lineOf(way), step_, *mirror_)
                            : sampleBranch(region_, lineOf(way), step_);
    BoundedDpOptions all = dp_;
    all.epsilon = 0;
    branch.levels = branchLevels(region_, branch.samples, all);
    addLimbJoints(branch.samples, endOf(way, false), endOf(way, true), usual_, branch.levels);
    std::vector<double> before;
    do {
      before = branch.levels;
      keepInside(region_, branch.samples, branch.levels);
      if (across) makeEven(branch.levels);
    } while (across && branch.levels != before);
    return branch;
  }

  static void makeEven(std::vector<double>& levels) {
    for (size_t k = 0, other = levels.size() - 1; k < other; ++k, --other) {
      levels[k] = levels[other] = std::max(levels[k], levels[other]);
    }
  }

  PartSkeleton::Branch imageOf(const PartSkeleton::Branch& branch) const {
    PartSkeleton::Branch image;
    for (const BranchSample& sample : branch.samples) {
      image.samples.push_back(mirrored(sample, *mirror_));
    }
    image.levels = branch.levels;
    return image;
  }

  void addBones(const AxisBranches::Branch& way, PartSkeleton::Branch branch) {
    branch.first_bone = static_cast<uint32_t>(result_.bones.size());
    branch.samples.front().point = result_.joints[way.from].position;
    branch.samples.back().point = result_.joints[way.to].position;
    branch.joints.push_back(way.from);
    const auto& samples = branch.samples;
    branch.at.push_back(0);
    for (uint32_t k = 1; k + 1 < samples.size(); ++k) {
      if (!isKept(branch.levels[k], dp_.epsilon)) continue;
      branch.joints.push_back(addJoint(samples[k].point, samples[k].radius));
      branch.at.push_back(k);
    }
    branch.joints.push_back(way.to);
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
  AxisBranches axis_;
  const MirrorLine* mirror_;
  double step_, usual_;
  BoundedDpOptions dp_;
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

SkeletonHints hintsOf(const PartSkeleton& skeleton) {
  SkeletonHints hints;
  for (const auto& joint : skeleton.joints) {
    if (joint.kind == JointKind::terminal) hints.ends.push_back(joint.position);
    if (joint.kind == JointKind::junction) hints.junctions.push_back(joint.position);
  }
  hints.mirrored = skeleton.mirror.has_value();
  return hints;
}

Result<PartSkeleton> placeJoints(const std::vector<Vec2>& polygon, const Axis& axis, double scale,
                                 const JointOptions& options, const std::vector<Vec2>* outline,
                                 const MirrorLine* mirror) {
  if (polygon.size() < 3 || axis.edges.empty() || axis.points.size() != axis.edges.size() + 1) {
    return Status::skeletonFailed;
  }
  if (!std::isfinite(scale) || scale < 0) return Status::skeletonFailed;
  Region region{polygon, outline};
  AxisBranches branches = branchesOf(region, axis, options.hints ? &*options.hints : nullptr);
  if (!mirror) return Placement(region, std::move(branches), nullptr, scale, options).run();

  auto both = mirroredBranches(branches, *mirror);
  if (!both) return {Status::skeletonFailed, "The skeleton is not symmetric."};
  std::vector<Vec2> image;
  if (outline) {
    for (const Vec2 p : *outline) image.push_back(mirror->mirrored(p));
    region.image = &image;
  }
  for (const AxisBranches::Branch& branch : both->branches) {
    for (size_t k = 0; k + 1 < branch.line.size(); ++k) {
      if (segmentInside(region, branch.line[k], branch.line[k + 1])) continue;
      return {Status::skeletonFailed, "The symmetric skeleton leaves the shape."};
    }
  }
  return Placement(region, std::move(*both), mirror, scale, options).run();
}

}  // namespace marrow
