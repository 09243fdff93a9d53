// Dense outline → flat triangles  [RS §4.1]
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace marrow {

struct TriangulationOptions {
  int target_points =
      1000;  // points aimed at, border included; bounds the work, whatever the stroke
};

struct Triangulation {
  std::vector<Vec2> points;   // the border first, in the outline's order, then the interior
  uint32_t border_count = 0;  // how many of `points` lie on the border
  std::vector<std::array<uint32_t, 3>> triangles;  // counter-clockwise, none degenerate
};

/// Constrained Delaunay triangulation of the outline as drawn, with evenly spaced interior points.
/// No triangle has all three corners on the border (an interior point is put there), so that
/// nothing inside stays flat when inflated.
/// outline: simple, counter-clockwise. Errors: tooFewPoints, meshFailed.
Result<Triangulation> triangulate(const std::vector<Vec2>& outline,
                                  const TriangulationOptions& options = {});

}  // namespace marrow
