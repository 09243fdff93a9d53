#include "sketch/tidy.h"

#include <algorithm>
#include <cstddef>

#include "sketch/polygon.h"

namespace marrow {

std::vector<Vec2> withoutSpikes(const std::vector<Vec2>& polygon, double thin) {
  const auto isTip = [thin](Vec2 a, Vec2 b, Vec2 c) {
    return dot(b - a, c - b) < 0 &&
           (distanceToSegment(a, b, c) <= thin || distanceToSegment(b, c, a) <= thin);
  };
  std::vector<Vec2> kept;
  kept.reserve(polygon.size());
  for (const Vec2& p : polygon) {
    while (kept.size() > 1 && isTip(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  size_t first = 0;
  while (kept.size() - first > 3) {
    const size_t last = kept.size() - 1;
    if (isTip(kept[last - 1], kept[last], kept[first])) {
      kept.pop_back();
    } else if (isTip(kept[last], kept[first], kept[first + 1])) {
      ++first;
    } else {
      break;
    }
  }
  kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
  return kept;
}

std::vector<uint32_t> withoutCollinear(const std::vector<Vec2>& polygon, double near) {
  std::vector<uint32_t> kept;
  kept.reserve(polygon.size());
  const auto n = static_cast<uint32_t>(polygon.size());
  for (uint32_t i = 0; i < n; ++i) {
    const Vec2 before = polygon[kept.empty() ? n - 1 : kept.back()];
    const Vec2 after = polygon[i + 1 < n ? i + 1 : (kept.empty() ? 0 : kept[0])];
    // Far from the line, beyond all rounding, is far from the segment.
    const Vec2 way = after - before, to = polygon[i] - before;
    const double across = cross(way, to);
    const double far = (4 * near * near + 1e-24 * dot(to, to)) * dot(way, way);
    if (across * across > far || distanceToSegment(before, after, polygon[i]) > near) {
      kept.push_back(i);
    }
  }
  return kept;
}

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  for (const int half : {0, 1}) {
    const size_t base = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    if (half == 0) std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace marrow
