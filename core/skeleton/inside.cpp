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
         (!region.outline || segmentInside(*region.outline, a, b));
}

NearEdges::NearEdges(const Region& region, Vec2 low, Vec2 high) {
  setBox(low, high);
  add(region.polygon);
  if (region.outline) add(*region.outline);
}

void NearEdges::narrow(const NearEdges& others, Vec2 low, Vec2 high) {
  setBox(low, high);
  edges_.clear();
  for (const Edge& edge : others.edges_) {
    if (isNear(edge)) edges_.push_back(edge);
  }
}

void NearEdges::setBox(Vec2 low, Vec2 high) {
  // Wide enough for what rounding takes for a touch.
  const double slack = 1e-6 * distance(low, high);
  low_ = low - Vec2{slack, slack};
  high_ = high + Vec2{slack, slack};
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
  return std::max(edge.p.x, edge.q.x) >= low_.x && std::min(edge.p.x, edge.q.x) <= high_.x &&
         std::max(edge.p.y, edge.q.y) >= low_.y && std::min(edge.p.y, edge.q.y) <= high_.y;
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
