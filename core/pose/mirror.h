// What is opposite what on a rig, and poses seen in the mirror.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/placed_parts.h"
#include "document/pose.h"
#include "rig/rig.h"

namespace marrow {

constexpr uint32_t kNoPartner = UINT32_MAX;

/// For each joint the one whose bones lie where the mirror image of its own would, of the same part
/// or its twin; of an end without bones the end there. Joints are matched first, each with one: the
/// nearest to each other's mirror places first, no farther from them than the larger of their
/// radii; one that near to its own is its own. A bone whose ends are matched goes with the one
/// between their matches, whichever way that runs; any other joint with the one whose bone is
/// nearest to the mirror place of the middle of its own, which need not go with it in turn; or none
/// (kNoPartner) where no bone of the part passes by there. O(joints² of a part).
std::vector<uint32_t> mirrorPartners(const Rig& rig, const std::vector<PlacedPart>& placed,
                                     const Plane& plane);

/// Joints at mirror places, by ids.
class OppositeJoints {
 public:
  /// Document and rig must outlive this.
  OppositeJoints(const Document& document, const Rig& rig);

  /// With the opposite parts in its id where the rig has such a joint; else its partner across the
  /// plane where that is mutual and has no such joint itself (several limbs may hang at one joint,
  /// and a body drawn as one shape has no opposite parts); else itself. Twice, it is the joint
  /// again. Of an id that the rig does not have: the one with the opposite parts.
  std::string of(const std::string& joint, const Plane& plane);

 private:
  bool hasOppositeId(const std::string& joint) const;

  const Document& document_;
  const Rig& rig_;
  std::map<std::string, uint32_t> joints_;
  std::optional<Plane> plane_;  // asked last
  std::vector<uint32_t> partners_;
};

/// The same pose on the other side: each joint does what its partner does, in the mirror image;
/// turned as far in space as that where they hang on different joints, so that of limbs with
/// different numbers of joints no bend is lost. What has no partner, as a trunk that hangs to the
/// side, keeps its own motion as it is. Joints that the rig does not have keep theirs for when they
/// are back: with the opposite parts in their ids; where these are the same, mirrored if the
/// nearest joint of their branch is in the plane, else as it is.
///
/// Twice, on a symmetric rig, it is the pose again.
Pose mirroredPose(const Document& document, const Rig& rig, const Pose& pose, const Plane& plane);

}  // namespace marrow
