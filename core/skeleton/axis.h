// Straight skeleton → axis: the tree that is left without peripheral and very short edges
// [RS §3.1 "Straight-skeleton simplification", Fig. 2d]
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "skeleton/straight_skeleton.h"

namespace marrow {

struct AxisOptions {
  double collapse_ratio = 0.5;  // × the mean skeleton-edge length: shorter edges are collapsed
};

struct Axis {
  std::vector<Vec2> points;
  std::vector<double> radii;                    // one per point: inscribed radius, model units
  std::vector<std::array<uint32_t, 2>> edges;   // a tree with at least one edge
};

/// A blob whose skeleton collapses to a point gets one edge: along the longest inscribed diameter
/// through it, inside the polygon.
/// Errors: skeletonFailed.
Result<Axis> extractAxis(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
                         const AxisOptions& options = {});

}  // namespace marrow
