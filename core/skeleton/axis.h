// Straight skeleton → axis: the tree that is left without peripheral and very short edges
// [RS §3.1 "Straight-skeleton simplification", Fig. 2d]
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "skeleton/straight_skeleton.h"
#include "sketch/mirror_line.h"

namespace marrow {

struct AxisOptions {
  std::optional<MirrorLine> mirror;  // across which the polygon is its own mirror image
};

struct Axis {
  std::vector<Vec2> points;
  std::vector<double> radii;                   // one per point: inscribed radius, model units
  std::vector<std::array<uint32_t, 2>> edges;  // a tree with at least one edge
};

/// The inner arcs of the straight skeleton, without
/// - edges shorter than collapse_ratio × the mean, collapsed the shortest first: into the end with
///   the higher degree, then the larger ball; a terminal wins over a sleeve, so that limbs keep
///   their length; a fork of short prongs at a limb's end becomes one prong between them;
/// - branches whose tip reaches less than 1.5 inscribed radii from the junction they start at: the
///   corners of blocks and the bumps of a trembling hand;
/// and with the greater part of the peripheral arcs into sharp tips (2.5 inscribed radii, or 1.6
/// between two reflex vertices). Without those, whether a pointed arm gets a bone would hang on
/// whether its tip has one vertex or two.
///
/// A blob whose skeleton collapses to a point gets one edge: along the longest inscribed diameter
/// through it, inside the polygon.
/// Errors: skeletonFailed.
Result<Axis> extractAxis(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton,
                         const AxisOptions& options = {});

}  // namespace marrow
