// Random skeletons and poses.
#pragma once

#include <string>

#include "pose/pose.h"
#include "support/creatures.h"

namespace marrow {

/// A tree of joints at random distances, parents before their children.
inline Rig randomRig(Random& random, int joints) {
  Rig rig;
  for (int i = 0; i < joints; ++i) {
    Rig::Joint joint;
    joint.id = "part-1/n" + std::to_string(i);
    joint.name = "Bone." + std::to_string(i + 1);
    joint.parent = i == 0 ? -1 : random.below(2) == 0 ? i - 1 : random.below(i);
    const Vec3 from = i == 0 ? Vec3{} : rig.joints[static_cast<size_t>(joint.parent)].position;
    joint.position = from + randomRotation(random).x * random.between(5, 60);
    if (i == 0) rig.roots.push_back(0);
    if (i > 0) {
      rig.bones.push_back({static_cast<uint32_t>(joint.parent), static_cast<uint32_t>(i)});
    }
    rig.joints.push_back(std::move(joint));
  }
  return rig;
}

/// A straight chain of joints along y, `length` apart.
inline Rig chainRig(int joints, double length) {
  Rig rig;
  for (int i = 0; i < joints; ++i) {
    Rig::Joint joint;
    joint.id = "part-1/n" + std::to_string(i);
    joint.name = "Bone." + std::to_string(i + 1);
    joint.parent = i - 1;
    joint.position = {0, length * i, 0};
    if (i > 0) rig.bones.push_back({static_cast<uint32_t>(i - 1), static_cast<uint32_t>(i)});
    rig.joints.push_back(std::move(joint));
  }
  rig.roots.push_back(0);
  return rig;
}

inline Quaternion randomTurn(Random& random) {
  const Affine turn = randomRotation(random);
  return rotationTo(turn.x, turn.y, turn.z);
}

/// Of some joints; roots move, too.
inline Pose randomPose(Random& random, const Rig& rig) {
  Pose pose;
  for (const Rig::Joint& joint : rig.joints) {
    if (random.below(3) == 0) continue;
    pose[joint.id].rotation = randomTurn(random);
    if (joint.parent < 0) pose[joint.id].move = randomRotation(random).z * random.between(0, 40);
  }
  return pose;
}

}  // namespace marrow
