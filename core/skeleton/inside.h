// Does a segment stay inside a polygon?
#pragma once

#include <vector>

#include "base/vec.h"

namespace marrow {

/// What bones must stay in: the polygon, and the outline it was simplified from where there is one.
struct Region {
  const std::vector<Vec2>& polygon;
  const std::vector<Vec2>* outline = nullptr;
};

/// a, b: points inside the polygon. False also where the segment touches the border. O(n).
bool segmentInside(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b);
bool segmentInside(const Region& region, Vec2 a, Vec2 b);

/// And comes nowhere nearer to it than `clearance`, which a and b may not either. O(n).
bool segmentClear(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b, double clearance);

}  // namespace marrow
