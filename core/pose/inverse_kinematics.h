// A joint is dragged, and the character follows.
#pragma once

#include <vector>

#include "pose/pose.h"

namespace marrow {

struct ReachOptions {
  int rounds = 40;     // at most, for one chain
  double near = 1e-5;  // × the chain's length: that close is there
};

/// The pose in which `joint` is at `target` (space), or as near as its bones reach, which keep
/// their lengths. What bends is the chain from the nearest pinned joint above it, or else the root,
/// which stay where they are; a root that is dragged moves. Pinned joints below what moved are held
/// where they were, as far as their own chains reach. Bones turn as little as can be: without
/// twist. Nothing changes for a target that is not finite. FABRIK [Aristidou & Lasenby 2011];
/// O(rounds × length of the chains + joints).
Pose reach(const Rig& rig, const Pose& pose, uint32_t joint, Vec3 target,
           const std::vector<uint32_t>& pins, const ReachOptions& options = {});

}  // namespace marrow
