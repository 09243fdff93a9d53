// Straight skeleton → axis: the tree that is left without what adds nothing to the shape
// [RS §3.1 "Straight-skeleton simplification", Fig. 2d]
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "skeleton/hints.h"
#include "skeleton/straight_skeleton.h"
#include "sketch/mirror_line.h"

namespace marrow {

struct AxisOptions {
  std::optional<MirrorLine> mirror;  // across which the polygon is its own mirror image
  std::optional<SkeletonHints> hints;
};

struct Axis {
  std::vector<Vec2> points;
  std::vector<double> radii;  // one per point: of a ball inside the polygon, model units;
                              // nearly the largest
  std::vector<std::array<uint32_t, 2>> edges;  // a tree with at least one edge
};

/// The inner arcs of the straight skeleton whose sides are limbs: which of them are is told by what
/// each adds to the shape (AxisTree::significance), not by how long or short edges are, so that a
/// trembling hand changes little. What the paper's collapse of short edges is for, comes by that.
///
/// A limb ends in the middle of its end, nearly its own half width from the outline: it goes on
/// into a point, and between the corners of a blunt end. Between both it ends between both. A body
/// all of whose limbs leave it on one side has a bone towards the other. A blob, whose axis is
/// hardly a line, gets one bone along its longer direction, upright where none is longer.
///
/// All points are inside the polygon, edges may touch its border where it is thin. O(n²) at worst,
/// about O(n) for drawings. Errors: skeletonFailed.
Result<Axis> extractAxis(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
                         const AxisOptions& options = {});

}  // namespace marrow
