// Triangles for regions of a plane that are given by their borders.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

struct PlanarPoint {
  uint32_t id;
  Vec2 at;
};

/// Closed borders, the region on their left: counter-clockwise around it, clockwise around its
/// holes. `outer` says which of them touch the border of the triangle that the region is a piece
/// of; of the others, the sense of turning decides.
struct Border {
  std::vector<PlanarPoint> points;
  bool outer = false;
};

/// Appends triangles whose borders are exactly the given ones. Borders that cross themselves by
/// rounding are filled all the same. False where there is nothing that a hole could be in.
bool fillRegion(std::vector<Border> borders, std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace marrow
