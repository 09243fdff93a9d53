#include "skeleton/inside.h"

#include <algorithm>
#include <limits>

namespace marrow {
namespace {

/// Does the edge pq meet the segment's line, and the segment the edge's line? Both also hold for
/// two that lie on one line far from each other, or seem to after rounding. along: b − a; whole:
/// its square; side_p, side_q: of the segment's line.
inline bool meets(Vec2 a, Vec2 b, Vec2 along, double whole, Vec2 p, Vec2 q, double side_p,
                  double side_q) {
  if (std::min(side_p, side_q) > 0 || std::max(side_p, side_q) < 0) return false;
  const double at_p = dot(along, p - a), at_q = dot(along, q - a);
  const double side_a = cross(q - p, a - p), side_b = cross(q - p, b - p);
  return std::max(at_p, at_q) >= 0 && std::min(at_p, at_q) <= whole &&
         std::min(side_a, side_b) <= 0 && std::max(side_a, side_b) >= 0;
}

/// A box wide enough for what rounding takes for a touch.
Box2 withSlack(const Box2& box) {
  const double slack = 1e-6 * length(box.size());
  return {box.low - Vec2{slack, slack}, box.high + Vec2{slack, slack}};
}

}  // namespace

bool segmentInside(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double whole = dot(along, along);
  Vec2 p = polygon.back();
  double side_p = cross(along, p - a);
  for (const Vec2 q : polygon) {
    const double side_q = cross(along, q - a);
    if (meets(a, b, along, whole, p, q, side_p, side_q)) return false;
    p = q;
    side_p = side_q;
  }
  return true;
}

bool segmentInside(const Region& region, Vec2 a, Vec2 b) {
  return segmentInside(region.polygon, a, b) &&
         (!region.outline || segmentInside(*region.outline, a, b)) &&
         (!region.image || segmentInside(*region.image, a, b));
}

bool segmentsInside(const std::vector<Vec2>& polygon, const std::vector<Vec2>& points,
                    const std::vector<std::array<uint32_t, 2>>& segments) {
  constexpr size_t kRun = 8;
  const size_t n = polygon.size();
  std::vector<Box2> runs((n + kRun - 1) / kRun);  // run r: the edges from vertex r·kRun on
  for (size_t i = 0; i < n; ++i) {
    runs[i / kRun].include(polygon[i]);
    runs[i / kRun].include(polygon[i + 1 < n ? i + 1 : 0]);
  }
  for (const auto& [from, to] : segments) {
    const Vec2 a = points[from], b = points[to], along = b - a;
    const double whole = dot(along, along);
    const Box2 around = withSlack({least(a, b), most(a, b)});
    for (size_t run = 0; run < runs.size(); ++run) {
      if (!runs[run].meets(around)) continue;
      Vec2 p = polygon[run * kRun];
      double side_p = cross(along, p - a);
      for (size_t i = run * kRun + 1; i <= std::min((run + 1) * kRun, n); ++i) {
        const Vec2 q = polygon[i < n ? i : 0];
        const double side_q = cross(along, q - a);
        if (meets(a, b, along, whole, p, q, side_p, side_q)) return false;
        p = q;
        side_p = side_q;
      }
    }
  }
  return true;
}

NearEdges::NearEdges(const Region& region, const Box2& box) : box_(withSlack(box)) {
  add(region.polygon);
  if (region.outline) add(*region.outline);
  if (region.image) add(*region.image);
}

void NearEdges::narrow(const NearEdges& others, const Box2& box) {
  box_ = withSlack(box);
  edges_.clear();
  for (const Edge& edge : others.edges_) {
    if (isNear(edge)) edges_.push_back(edge);
  }
}

void NearEdges::add(const std::vector<Vec2>& polygon) {
  Edge edge;
  edge.q = polygon.back();
  for (const Vec2 q : polygon) {
    edge.p = edge.q;
    edge.q = q;
    if (isNear(edge)) edges_.push_back(edge);
  }
}

bool NearEdges::isNear(const Edge& edge) const {
  return box_.meets({least(edge.p, edge.q), most(edge.p, edge.q)});
}

bool NearEdges::isClear(Vec2 a, Vec2 b) const {
  const Vec2 along = b - a;
  const double whole = dot(along, along);
  for (const Edge& edge : edges_) {
    if (meets(a, b, along, whole, edge.p, edge.q, cross(along, edge.p - a),
              cross(along, edge.q - a))) {
      return false;
    }
  }
  return true;
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
