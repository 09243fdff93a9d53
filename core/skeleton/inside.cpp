#include "skeleton/inside.h"

namespace marrow {

bool segmentInside(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  Vec2 p = polygon.back();
  double side_p = cross(along, p - a);
  for (const Vec2 q : polygon) {
    const double side_q = cross(along, q - a);
    // The edge has points on both sides of the segment's line: then the segment must be clear of
    // the edge's line.
    if ((side_p <= 0 || side_q <= 0) && (side_p >= 0 || side_q >= 0)) {
      const double side_a = cross(q - p, a - p), side_b = cross(q - p, b - p);
      if ((side_a <= 0 || side_b <= 0) && (side_a >= 0 || side_b >= 0)) return false;
    }
    p = q;
    side_p = side_q;
  }
  return true;
}

}  // namespace marrow
