#include "document/posed_parts.h"

#include <memory>
#include <utility>

#include "document/document.h"
#include "document/joint_id.h"

namespace marrow {
namespace {

constexpr double kSameAxis = 1e-14;  // rounding alone turned it

/// Of the map without its move.
bool isNone(const Affine& turn) {
  return distance(turn.x, {1, 0, 0}) < kSameAxis && distance(turn.y, {0, 1, 0}) < kSameAxis &&
         distance(turn.z, {0, 0, 1}) < kSameAxis;
}

bool mirrors(const Affine& map) { return dot(cross(map.x, map.y), map.z) < 0; }

/// What a rotation is after space was turned or mirrored.
Quaternion turnedRotation(const Quaternion& q, const Affine& turn) {
  if (Vec3{q.x, q.y, q.z} == Vec3{} || isNone(turn)) return q;
  const Vec3 axis = turn.direction({q.x, q.y, q.z}) * (mirrors(turn) ? -1 : 1);
  return {axis.x, axis.y, axis.z, q.w};
}

JointMotion turnedMotion(const JointMotion& motion, const PartTurn& part) {
  JointMotion turned{turnedRotation(motion.rotation, part.turn), motion.move};
  if (!(motion.move == Vec3{} || isNone(part.stretch))) {
    turned.move = part.stretch.direction(motion.move);
  }
  if (!isDrawable(turned.move)) turned.move = motion.move;
  return withUnitRotation(turned).value_or(motion);
}

}  // namespace

void renamePosed(const std::function<std::string(const std::string& joint)>& rename,
                 Document& document) {
  for (auto& shared : document.poses) {
    Pose renamed, kept;
    for (const auto& [joint, motion] : shared->joints) {
      std::string id = rename(joint);
      (id == joint ? kept : renamed).emplace(std::move(id), motion);
    }
    if (renamed.empty()) continue;
    renamed.merge(kept);
    NamedPose pose = *shared;
    pose.joints = std::move(renamed);
    shared = std::make_shared<const NamedPose>(std::move(pose));
  }
}

PartTurn turnOf(const Frame& before, const Affine& map, const Frame& now) {
  const double old_scale = before.scale(), scale = now.scale();
  const Vec3 old_x = before.x / old_scale, old_y = before.y / old_scale,
             old_z = cross(old_x, old_y);
  const Vec3 x = now.x / scale, y = now.y / scale;
  const Vec3 z = cross(x, y) * (mirrors(map) ? -1 : 1);
  const auto direction = [&](Vec3 v) {
    return x * dot(old_x, v) + y * dot(old_y, v) + z * dot(old_z, v);
  };
  return {{direction({1, 0, 0}), direction({0, 1, 0}), direction({0, 0, 1}), {}}, map};
}

void turnPosed(const std::map<std::string, PartTurn>& turns, Document& document) {
  if (turns.empty()) return;
  for (auto& shared : document.poses) {
    Pose joints = shared->joints;
    for (auto& [joint, motion] : joints) {
      const auto part = turns.find(partOfJoint(joint));
      if (part != turns.end()) motion = turnedMotion(motion, part->second);
    }
    if (joints == shared->joints) continue;
    NamedPose pose = *shared;
    pose.joints = std::move(joints);
    shared = std::make_shared<const NamedPose>(std::move(pose));
  }
}

}  // namespace marrow
