#include "pose/pose.h"

#include <algorithm>

namespace marrow {
namespace {

JointMotion motionOf(const Pose& pose, const std::string& id) {
  const auto found = pose.find(id);
  return found == pose.end() ? JointMotion{} : found->second;
}

}  // namespace

std::vector<Rigid> posed(const Rig& rig, const Pose& pose) {
  std::vector<Rigid> motions(rig.joints.size());
  for (size_t i = 0; i < rig.joints.size(); ++i) {
    const Rig::Joint& joint = rig.joints[i];
    const JointMotion own = motionOf(pose, joint.id);
    const Rigid motion = rotationAbout(joint.position, normalised(own.rotation), own.move);
    motions[i] = joint.parent < 0 ? motion : motions[static_cast<size_t>(joint.parent)] * motion;
  }
  return motions;
}

Pose mixed(const Pose& a, const Pose& b, double t) {
  Pose result;
  const auto add = [&](const std::string& id) {
    const JointMotion from = motionOf(a, id), to = motionOf(b, id);
    result[id] = {mixed(from.rotation, to.rotation, t), lerp(from.move, to.move, t)};
  };
  for (const auto& [id, motion] : a) add(id);
  for (const auto& [id, motion] : b) add(id);
  return result;
}

Pose turned(const Rig& rig, const Pose& pose, uint32_t joint, const Quaternion& rotation) {
  if (joint >= rig.joints.size()) return pose;
  const int32_t above = rig.joints[joint].parent;
  const Quaternion parent =
      above < 0 ? Quaternion{} : posed(rig, pose)[static_cast<size_t>(above)].rotation;
  Pose result = pose;
  JointMotion& own = result[rig.joints[joint].id];
  own.rotation = normalised(conjugate(parent) * rotation * parent * normalised(own.rotation));
  return result;
}

Pose withoutResting(const Pose& pose) {
  Pose result;
  for (const auto& [id, motion] : pose) {
    if (!(motion == JointMotion{})) result.emplace(id, motion);
  }
  return result;
}

std::vector<Quaternion> restAxes(const Rig& rig) {
  const size_t n = rig.joints.size();
  const auto wayTo = [&](size_t child) {
    const size_t parent = static_cast<size_t>(rig.joints[child].parent);
    return rig.joints[child].position - rig.joints[parent].position;
  };
  std::vector<Vec3> onward(n);  // along the bone that each joint goes on with; 0: none
  std::vector<double> straightest(n, -2);
  for (size_t i = 0; i < n; ++i) {
    if (rig.joints[i].parent < 0) continue;
    const auto parent = static_cast<size_t>(rig.joints[i].parent);
    const Vec3 way = wayTo(i);
    if (!(dot(way, way) > 0)) continue;
    const Vec3 before = rig.joints[parent].parent < 0 ? Vec3{0, 1, 0} : wayTo(parent);
    const double lengths = std::sqrt(dot(way, way) * dot(before, before));
    const double straight = lengths > 0 ? dot(way, before) / lengths : -1;
    if (straight <= straightest[parent]) continue;
    straightest[parent] = straight;
    onward[parent] = way;
  }
  std::vector<Quaternion> axes(n);
  for (size_t i = 0; i < n; ++i) {
    const int32_t parent = rig.joints[i].parent;
    const Quaternion before = parent < 0 ? Quaternion{} : axes[static_cast<size_t>(parent)];
    axes[i] = normalised(between(rotated(before, {0, 1, 0}), onward[i]) * before);
  }
  return axes;
}

}  // namespace marrow
