// The axis as junctions, ends and smooth lines between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "skeleton/axis.h"
#include "skeleton/inside.h"
#include "sketch/mirror_line.h"

namespace marrow {

struct AxisBranches {
  struct End {  // of one branch, or a junction of several
    Vec2 point;
    double radius;  // inscribed
    uint32_t branches = 0;
    uint32_t image = 0;  // the end that is its mirror image, itself on the line
  };
  struct Branch {
    uint32_t from, to;          // of `ends`
    std::vector<Vec2> line;     // along the axis, from end to end
    std::vector<double> radii;  // one per point
    // Whether it leaves a body at either end as a limb does: its joint there is the point next to
    // that end.
    bool mouth_from = false, mouth_to = false;
    uint32_t image = 0;  // the branch that is its mirror image; itself where it lies on the line,
                         // and where it goes across it
  };
  std::vector<End> ends;
  std::vector<Branch> branches;
};

/// Divides the axis at its junctions, and gives junctions and limbs the places that joints have in
/// bodies: junctions too near to each other for a bone are one; limbs thinner than their body leave
/// it by a mouth on their own line, as hips and shoulders are; a body's end joint lies towards its
/// limbs' mouths; a chest, towards the neck. Lines stay in the region where the axis does.
AxisBranches branchesOf(const Region& region, const Axis& axis,
                        const SkeletonHints* hints = nullptr);

/// What lies on one side of a line, and on it, with its mirror image: ends on the line exactly on
/// it, the others in pairs; branches too, whose images have images for ends in the same order. Of a
/// branch that goes across the line, the points of one half are the images of the other's, with one
/// in the middle. Nothing where that makes no tree.
std::optional<AxisBranches> mirroredBranches(const AxisBranches& branches, const MirrorLine& line);

}  // namespace marrow
