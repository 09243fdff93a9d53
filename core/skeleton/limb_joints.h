// Where limbs have joints: at their mouths, and where they bend.
#pragma once

#include <optional>
#include <vector>

#include "skeleton/bounded_dp.h"

namespace marrow {

/// What a branch ends in.
struct BranchEnd {
  bool junction = false;
  double radius = 0;          // of the ball there
  std::optional<Vec2> mouth;  // where a limb that begins there has its joint: one of the samples
};

/// Makes levels (see branchLevels) of a branch heed what limbs need besides bends of the axis:
/// - a limb that is thinner than the body which it leaves has a joint at its mouth: hip, shoulder;
/// - a limb longer than three of its radii has a joint where it narrows, or else in its middle:
///   elbow, knee, neck, waist;
/// - no two joints lie within a radius, so that no bone is shorter than thick. What bends there
///   counts for a fifth, and for less than `usual`.
/// What bones need to stay inside stays.
///
/// usual: the default threshold, model units.
void addLimbJoints(const std::vector<BranchSample>& samples, const BranchEnd& start,
                   const BranchEnd& end, double usual, std::vector<double>& levels);

}  // namespace marrow
