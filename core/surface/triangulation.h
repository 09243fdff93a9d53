// Dense outline → flat triangles  [RS §4.1]
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace marrow {

struct TriangulationOptions {
  // Points aimed at, border included; bounds the work, whatever the stroke.
  int target_points = 1000;
  static constexpr int kFewest = 48;
};

struct Triangulation {
  std::vector<Vec2> points;   // the border first, in the outline's order, then the interior
  uint32_t border_count = 0;  // how many of `points` lie on the border
  std::vector<std::array<uint32_t, 3>> triangles;  // counter-clockwise, none degenerate
};

/// Constrained Delaunay triangulation of the outline as drawn, for a surface that rises from the
/// border like a circle: rings of points along it, a row along the middle of thin places, an
/// equilateral lattice elsewhere. The border keeps the outline's vertices where they are about as
/// far apart as the lattice's, fewer where they are denser (its corners stay, and the first
/// vertex), more on long edges.
///
/// No edge but the border's joins two border points (an interior point is put there), so that
/// nothing inside stays flat when inflated. The number of points is usually within a sixth of the
/// target; targets under kFewest are taken as that. Moving or scaling the outline moves or scales
/// the points, but for rounding. outline: simple, counter-clockwise. Errors: tooFewPoints;
/// meshFailed where it is not simple or front and back of it touch but for rounding.
Result<Triangulation> triangulate(const std::vector<Vec2>& outline,
                                  const TriangulationOptions& options = {});

}  // namespace marrow
