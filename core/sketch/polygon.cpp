#include "sketch/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.h"
#include "sketch/edge_grid.h"
#include "sketch/turn_sign.h"

namespace marrow {
namespace {

bool boxesApart(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
         std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
}

/// Whether the closed segments ab and cd have a point in common.
bool segmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (boxesApart(a, b, c, d)) return false;
  if (turnSign(a, b, c) * turnSign(a, b, d) > 0) return false;
  return turnSign(c, d, a) * turnSign(c, d, b) <= 0;
}

/// The directions, of right, left, up and down, that an edge surely goes into: a bit each.
uint32_t directions(Vec2 a, Vec2 b) {
  return (b.x > a.x ? 1u : 0u) | (b.x < a.x ? 2u : 0u) | (b.y > a.y ? 4u : 0u) |
         (b.y < a.y ? 8u : 0u);
}

/// Calls visit(e, f) for pairs of edges e > f, no neighbours, that have a point in common, while it
/// returns true: runs of edges against runs of edges, by the boxes around them. Edges that follow
/// one another all into one direction have nothing in common but their ends.
template <typename Visit>
void forEachMeeting(const std::vector<Vec2>& polygon, Visit visit) {
  constexpr uint32_t kRun = 6;
  const auto n = static_cast<uint32_t>(polygon.size());
  std::vector<Box2> edges(n), runs((n + kRun - 1) / kRun);
  std::vector<uint32_t> ways(runs.size(), 15);  // directions that all edges of a run have
  for (uint32_t i = 0; i < n; ++i) {
    const Vec2 a = polygon[i], b = polygon[i + 1 < n ? i + 1 : 0];
    edges[i] = {least(a, b), most(a, b)};
    runs[i / kRun].include(edges[i]);
    ways[i / kRun] &= directions(a, b);
  }
  for (uint32_t r = 0; r < runs.size(); ++r) {
    for (uint32_t q = 0; q <= r; ++q) {
      if (!runs[r].meets(runs[q]) || (q + 1 >= r && (ways[r] & ways[q]) != 0)) continue;
      for (uint32_t e = r * kRun; e < std::min(n, (r + 1) * kRun); ++e) {
        if (!edges[e].meets(runs[q])) continue;
        // The edge before e is its neighbour; of the last edge the first one is, too.
        const uint32_t last = std::min((q + 1) * kRun, e > 0 ? e - 1 : 0);
        for (uint32_t f = e == n - 1 && q == 0 ? 1 : q * kRun; f < last; ++f) {
          if (edges[e].meets(edges[f]) &&
              segmentsMeet(polygon[e], polygon[e + 1 < n ? e + 1 : 0], polygon[f],
                           polygon[f + 1]) &&
              !visit(e, f)) {
            return;
          }
        }
      }
    }
  }
}

/// Whether the path a, b, c goes back over itself at b.
bool turnsBack(Vec2 a, Vec2 b, Vec2 c) {
  return dot(b - a, c - b) <= 0 && ((b.x > a.x) != (c.x > b.x) || b.x == a.x || b.x == c.x) &&
         ((b.y > a.y) != (c.y > b.y) || b.y == a.y || b.y == c.y) && turnSign(a, b, c) == 0;
}

/// Calls visit(e, f) for pairs of edges that must not touch but do, while it returns true; a pair
/// may come more than once. False where more than most_pairs pairs had to be looked at.
template <typename Visit>
bool forEachFault(const std::vector<Vec2>& polygon, size_t most_pairs, Visit visit) {
  constexpr uint32_t kFew = 512;  // then runs are faster than a grid
  const auto n = static_cast<uint32_t>(polygon.size());
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t next = i + 1 < n ? i + 1 : 0, after = next + 1 < n ? next + 1 : 0;
    if (polygon[i] == polygon[next] || turnsBack(polygon[i], polygon[next], polygon[after])) {
      if (!visit(i, next)) return true;
    }
  }

  if (n <= kFew && most_pairs >= kFew * kFew) {
    forEachMeeting(polygon, visit);
    return true;
  }

  std::vector<EdgeGrid::Edge> edges(n);
  for (uint32_t i = 0; i < n; ++i) edges[i] = {i, i + 1 < n ? i + 1 : 0};
  const EdgeGrid grid(polygon, edges);
  for (uint32_t cell = 0; cell < grid.cellCount(); ++cell) {
    const EdgeGrid::Range here = grid.edgesIn(cell);
    const size_t pairs = here.size() * here.size() / 2;
    if (pairs > most_pairs) return false;
    most_pairs -= pairs;
    for (size_t i = 1; i < here.size(); ++i) {
      const uint32_t e = here[i];
      for (size_t j = 0; j < i; ++j) {
        const uint32_t f = here[j];  // f < e
        if (f + 1 == e || (f == 0 && e == n - 1)) continue;
        if (segmentsMeet(polygon[e], polygon[edges[e][1]], polygon[f], polygon[f + 1])) {
          if (!visit(e, f)) return true;
        }
      }
    }
  }
  return true;
}

}  // namespace

double signedArea(const std::vector<Vec2>& polygon) {
  if (polygon.size() < 3) return 0;
  const Vec2 origin = polygon[0];
  double doubled = 0;
  for (size_t i = 1; i + 1 < polygon.size(); ++i) {
    doubled += cross(polygon[i] - origin, polygon[i + 1] - origin);
  }
  return doubled / 2;
}

double perimeter(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (size_t i = 0, n = polygon.size(); i < n; ++i) {
    sum += distance(polygon[i], polygon[i + 1 < n ? i + 1 : 0]);
  }
  return sum;
}

Vec2 areaCentroid(const std::vector<Vec2>& polygon) {
  if (polygon.empty()) return {};
  const Vec2 origin = polygon[0];
  Vec2 sum;
  double doubled = 0;
  for (size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - origin, b = polygon[i + 1] - origin;
    const double area = cross(a, b);
    sum = sum + (a + b) * area;
    doubled += area;
  }
  return doubled != 0 ? origin + sum / (3 * doubled) : origin;
}

bool isSimple(const std::vector<Vec2>& polygon, size_t most_pairs) {
  bool simple = polygon.size() >= 3;
  for (Vec2 point : polygon) simple = simple && std::isfinite(point.x) && std::isfinite(point.y);
  if (simple) {
    const bool complete = forEachFault(polygon, most_pairs, [&](uint32_t, uint32_t) {
      simple = false;
      return false;
    });
    simple = simple && complete;
  }
  return simple;
}

std::vector<char> faultyEdges(const std::vector<Vec2>& polygon) {
  std::vector<char> faulty(polygon.size(), 0);
  forEachFault(polygon, SIZE_MAX, [&](uint32_t e, uint32_t f) {
    faulty[e] = faulty[f] = 1;
    return true;
  });
  return faulty;
}

bool contains(const std::vector<Vec2>& polygon, Vec2 point) {
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[j], b = polygon[i];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if ((turnSign(a, b, point) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

double distanceToBorder(const std::vector<Vec2>& polygon, Vec2 point) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    best = std::min(best, distanceToSegment(polygon[j], polygon[i], point));
  }
  return best;
}

double distanceToSegment(Vec2 a, Vec2 b, Vec2 point) { return SegmentDistance(a, b).to(point); }

}  // namespace marrow
