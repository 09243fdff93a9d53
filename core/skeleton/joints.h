// Axis → joints and bones by BoundedDP  [RS §3.1, Fig. 2e–g, Fig. 7, Algorithms 1 and 2]
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "skeleton/axis.h"
#include "skeleton/bounded_dp.h"

namespace marrow {

enum class JointKind : uint8_t {
  terminal,  // one bone
  sleeve,    // two
  junction,  // three or more
};
const char* toString(JointKind kind);

struct JointOptions {
  double epsilon_s = 5.0;     // BoundedDP threshold, units at the reference perimeter
  double shape_weight = 1.0;  // α_s of Equation 1
  double shrink = 0.8;        // the threshold's factor while a bone leaves the shape
  std::optional<SkeletonHints> hints;
};

/// A part's own skeleton in the part's plane: a tree.
struct PartSkeleton {
  struct Joint {
    JointKind kind;
    Vec2 position;
    double radius;  // of the ball there, model units; the inscribed radius until the proxy sets it
    double depth = 0;  // z; other than 0 in imported parts alone

    Vec3 place() const { return {position.x, position.y, depth}; }
  };
  /// The way from one terminal or junction to the next, and what it can be simplified to.
  struct Branch {
    std::vector<uint32_t> joints;       // from end to end
    uint32_t first_bone = 0;            // its bones, joints.size() − 1 of them, are in its order
    std::vector<BranchSample> samples;  // at least the two ends
    std::vector<uint32_t> at;           // sample of each joint
    std::vector<double> levels;         // one per sample, see branchLevels and addLimbJoints

    uint32_t image = 0;  // the branch that is its mirror image, or itself; see mirror

    double length() const { return samples.back().along; }
  };
  std::vector<Joint> joints;                   // terminals and junctions first, then the sleeves
  std::vector<std::array<uint32_t, 2>> bones;  // pairs of joint indices
  std::vector<Branch> branches;
  /// The line across which it is its own mirror image: joints on it are exactly on it, the others
  /// in pairs, and so are branches. An image has the images of all samples and joints in the same
  /// order; a branch that goes across the line is its own, backwards.
  std::optional<MirrorLine> mirror;
};

SkeletonHints hintsOf(const PartSkeleton& skeleton);

/// scale: what epsilon_s is multiplied by, Outline::scale().
/// outline: what the polygon was simplified from, if bones have to stay inside that too; the axis
/// must do so.
/// mirror: the line across which the polygon is its own mirror image; the skeleton is so, too.
/// Every bone lies inside the polygon. Errors: skeletonFailed, also where that cannot be had in the
/// mirror as well: try without it.
Result<PartSkeleton> placeJoints(const std::vector<Vec2>& polygon, const Axis& axis, double scale,
                                 const JointOptions& options = {},
                                 const std::vector<Vec2>* outline = nullptr,
                                 const MirrorLine* mirror = nullptr);

}  // namespace marrow
