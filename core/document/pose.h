// How a character is posed: what the user turned and moved, by the joints' ids.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/quaternion.h"

namespace marrow {

/// How far a joint, and all that hangs on it, has moved from its rest within its parent: turned
/// about its own place and then moved, both along the axes of space at rest.
struct JointMotion {
  Quaternion rotation;
  Vec3 move;
};
inline bool operator==(const JointMotion& a, const JointMotion& b) {
  return a.rotation == b.rotation && a.move == b.move;
}

/// By the joints' ids; who is not there rests, and ids that a rig does not have change nothing, so
/// that a pose outlives what happens to the rig.
using Pose = std::map<std::string, JointMotion>;

struct NamedPose {
  static constexpr size_t kMostJoints = 100'000;

  std::string name;  // unique in the document, not empty
  Pose joints;
  std::string extra = "{}";  // JSON object: fields this version does not know, kept on save
};

/// With a rotation of unit length, of what is one already bit for bit; nothing where it turns by
/// nothing that is finite, or moves beyond the drawable.
std::optional<JointMotion> withUnitRotation(const JointMotion& motion);

}  // namespace marrow
