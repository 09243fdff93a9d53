// Where a pose puts the joints of a rig.
#pragma once

#include <vector>

#include "document/pose.h"
#include "rig/rig.h"

namespace marrow {

/// For each joint of the rig the way from rest to pose, in space; it carries the bones that leave
/// the joint. O(joints · log of the pose).
std::vector<Rigid> posed(const Rig& rig, const Pose& pose);

/// t = 0: a, t = 1: b; in between each joint on its own.
Pose mixed(const Pose& a, const Pose& b, double t);

/// The pose in which a joint has turned in space, about where it is, and all that hangs on it with
/// it.
Pose turned(const Rig& rig, const Pose& pose, uint32_t joint, const Quaternion& rotation);

/// The same pose without joints that rest.
Pose withoutResting(const Pose& pose);

/// Axes for each joint at rest: y along the bone that goes on from it (where several do, the one
/// that turns least; at the ends as before), x and z turned as little as can be from the parent's.
std::vector<Quaternion> restAxes(const Rig& rig);

}  // namespace marrow
