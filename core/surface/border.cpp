#include "surface/border.h"

#include <algorithm>
#include <numeric>

#include "sketch/polygon.h"
#include "sketch/turn_sign.h"

namespace marrow {
namespace {

constexpr double kLongest = 1.2;     // × spacing: edges that dropping vertices may make
constexpr double kTolerance = 0.1;   // × spacing: how far a dropped vertex may be from its edge
constexpr double kSplit = 1.5;       // × spacing: longer edges are split
constexpr size_t kMostDropped = 64;  // in a row; bounds the work
constexpr double kCoarser = 1.4;     // × spacing and tolerance while there are too many points
constexpr int kMostRounds = 30;
constexpr double kAreaChange = 0.05;  // of the area: dropping vertices may take or add no more

/// Of the vertices `kept` (ascending indices, the first is 0) those that stay.
std::vector<size_t> thinOut(const std::vector<Vec2>& outline, const std::vector<size_t>& kept,
                            double longest, double tolerance) {
  const size_t n = kept.size();
  std::vector<size_t> fewer;
  for (size_t from = 0; from < n;) {
    fewer.push_back(kept[from]);
    size_t to = from + 1;
    while (to < n && to - from < kMostDropped) {
      const Vec2 a = outline[kept[from]], b = outline[kept[(to + 1) % n]];
      if (distance(a, b) > longest) break;
      bool close = true;
      for (size_t k = from + 1; k <= to && close; ++k) {
        close = distanceToSegment(a, b, outline[kept[k]]) <= tolerance;
      }
      if (!close) break;
      ++to;
    }
    from = to;
  }
  return fewer;
}

bool touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const int c_side = turnSign(a, b, c), d_side = turnSign(a, b, d);
  if (c_side * d_side > 0) return false;
  const int a_side = turnSign(c, d, a), b_side = turnSign(c, d, b);
  if (a_side * b_side > 0) return false;
  if (c_side != 0 || d_side != 0) return true;
  return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <=
             std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
         std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <=
             std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

/// Edges, by their first vertex, that meet others than their neighbours at the common vertex.
std::vector<char> touchingEdges(const std::vector<Vec2>& polygon) {
  struct Edge {
    double left, right, low, high;
    size_t index;
  };
  const size_t n = polygon.size();
  std::vector<char> touching(n, 0);
  std::vector<Edge> edges(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % n];
    edges[i] = {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y), i};
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) {
    return e.left != f.left ? e.left < f.left : e.index < f.index;
  });
  for (size_t s = 0; s < n; ++s) {
    const Edge& e = edges[s];
    const Vec2 a = polygon[e.index], b = polygon[(e.index + 1) % n];
    for (size_t r = s + 1; r < n && edges[r].left <= e.right; ++r) {
      const Edge& f = edges[r];
      if (f.low > e.high || f.high < e.low) continue;
      const Vec2 c = polygon[f.index], d = polygon[(f.index + 1) % n];
      bool met;
      if ((e.index + 1) % n == f.index) {
        met = turnSign(a, b, d) == 0 && dot(b - a, d - c) < 0;
      } else if ((f.index + 1) % n == e.index) {
        met = turnSign(c, d, b) == 0 && dot(d - c, b - a) < 0;
      } else {
        met = touch(a, b, c, d);
      }
      if (met) touching[e.index] = touching[f.index] = 1;
    }
  }
  return touching;
}

std::vector<Vec2> pick(const std::vector<Vec2>& outline, const std::vector<size_t>& kept) {
  std::vector<Vec2> polygon;
  polygon.reserve(kept.size());
  for (const size_t i : kept) polygon.push_back(outline[i]);
  return polygon;
}

/// Brings vertices `kept` back into `fewer` of them where the thinned outline touches itself.
void makeSimple(const std::vector<Vec2>& outline, const std::vector<size_t>& kept,
                std::vector<size_t>& fewer) {
  const auto at = [&](size_t k) { return outline[kept[k < kept.size() ? k : 0]]; };
  while (fewer.size() < kept.size()) {
    const std::vector<char> touching = touchingEdges(pick(outline, fewer));
    std::vector<size_t> more;
    size_t from = 0;  // in `kept`
    for (size_t i = 0; i < fewer.size(); ++i) {
      size_t to = from + 1;
      while (to < kept.size() && (i + 1 == fewer.size() || kept[to] < fewer[i + 1])) ++to;
      more.push_back(fewer[i]);
      if (touching[i] && to - from > 1) {
        size_t farthest = from + 1;
        double most = -1;
        for (size_t k = from + 1; k < to; ++k) {
          const double off = distanceToSegment(at(from), at(to), at(k));
          if (off > most) {
            most = off;
            farthest = k;
          }
        }
        more.push_back(kept[farthest]);
      }
      from = to;
    }
    if (more.size() == fewer.size()) return;
    fewer = std::move(more);
  }
}

}  // namespace

std::vector<Vec2> fitBorder(const std::vector<Vec2>& outline, double spacing, size_t max_points) {
  const double area = signedArea(outline);
  std::vector<size_t> kept(outline.size());
  std::iota(kept.begin(), kept.end(), size_t{0});
  double wide = spacing;
  for (int round = 0; round == 0 || (kept.size() > max_points && round < kMostRounds); ++round) {
    std::vector<size_t> fewer = thinOut(outline, kept, kLongest * wide, kTolerance * wide);
    if (fewer.size() < kept.size()) {
      makeSimple(outline, kept, fewer);
      if (std::fabs(signedArea(pick(outline, fewer)) - area) > kAreaChange * area) break;
      kept = std::move(fewer);
    }
    wide *= kCoarser;
  }

  std::vector<Vec2> border;
  border.reserve(2 * kept.size());
  for (size_t i = 0; i < kept.size(); ++i) {
    const Vec2 a = outline[kept[i]], b = outline[kept[i + 1 < kept.size() ? i + 1 : 0]];
    border.push_back(a);
    const double pieces = distance(a, b) / spacing;
    if (!(pieces > kSplit)) continue;
    const int count = static_cast<int>(std::min(pieces + 0.5, double(max_points)));
    for (int k = 1; k < count; ++k) border.push_back(lerp(a, b, double(k) / count));
  }
  return border;
}

}  // namespace marrow
