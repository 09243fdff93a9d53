#include "skeleton/inside.h"

#include <algorithm>
#include <limits>

namespace marrow {

bool segmentInside(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double whole = dot(along, along);
  Vec2 p = polygon.back();
  double side_p = cross(along, p - a);
  for (const Vec2 q : polygon) {
    const double side_q = cross(along, q - a);
    // Does the edge meet the segment's line, and the segment the edge's line? Both also hold for
    // two that lie on one line far from each other, or seem to after rounding.
    if (std::min(side_p, side_q) <= 0 && std::max(side_p, side_q) >= 0) {
      const double at_p = dot(along, p - a), at_q = dot(along, q - a);
      const double side_a = cross(q - p, a - p), side_b = cross(q - p, b - p);
      if (std::max(at_p, at_q) >= 0 && std::min(at_p, at_q) <= whole &&
          std::min(side_a, side_b) <= 0 && std::max(side_a, side_b) >= 0) {
        return false;
      }
    }
    p = q;
    side_p = side_q;
  }
  return true;
}

bool segmentInside(const Region& region, Vec2 a, Vec2 b) {
  return segmentInside(region.polygon, a, b) &&
         (!region.outline || segmentInside(*region.outline, a, b));
}

bool segmentClear(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b, double clearance) {
  // Two segments that do not cross are nearest to each other at an end of one of them.
  const Vec2 along = b - a;
  const double inverse = 1 / std::max(dot(along, along), std::numeric_limits<double>::min());
  for (const Vec2 p : polygon) {
    const double t = std::clamp(dot(p - a, along) * inverse, 0.0, 1.0);
    const Vec2 away = p - a - along * t;
    if (dot(away, away) < clearance * clearance) return false;
  }
  return segmentInside(polygon, a, b);
}

}  // namespace marrow
