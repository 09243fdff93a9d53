// What must hold for every tree of points in a polygon.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "base/vec.h"
#include "sketch/polygon.h"
#include "support/skeletons.h"

namespace marrow {

using Edges = std::vector<std::array<uint32_t, 2>>;

inline bool isTree(size_t nodes, const Edges& edges) {
  if (edges.empty() || edges.size() + 1 != nodes) return false;
  std::vector<uint32_t> root(nodes);
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& edge : edges) {
    if (edge[0] >= nodes || edge[1] >= nodes) return false;
    const uint32_t a = find(edge[0]), b = find(edge[1]);
    if (a == b) return false;
    root[a] = b;
  }
  return true;
}

/// How far the segment sticks out of the polygon, in the sense that matters for a tolerance: the
/// depth of its deepest crossing with an edge, or the distance of an end that is outside.
inline double overhang(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b) {
  double worst = 0;
  for (const Vec2 end : {a, b}) {
    if (!contains(polygon, end)) worst = std::max(worst, distanceToBorder(polygon, end));
  }
  for (size_t i = 0, n = polygon.size(); i < n; ++i) {
    const Vec2 p = polygon[i], q = polygon[(i + 1) % n];
    const double p_side = cross(b - a, p - a) / distance(a, b);
    const double q_side = cross(b - a, q - a) / distance(a, b);
    const double a_side = cross(q - p, a - p) / distance(p, q);
    const double b_side = cross(q - p, b - p) / distance(p, q);
    if (p_side * q_side >= 0 || a_side * b_side >= 0) continue;
    worst = std::max(worst, std::min({std::fabs(p_side), std::fabs(q_side), std::fabs(a_side),
                                      std::fabs(b_side)}));
  }
  return worst;
}

/// What is wrong with a tree that should lie in the polygon; empty when nothing is.
inline std::string treeFault(const std::vector<Vec2>& polygon, const std::vector<Vec2>& points,
                             const Edges& edges) {
  if (!isTree(points.size(), edges)) return "no tree";
  const double size = sizeOf(polygon);
  for (const auto& edge : edges) {
    const Vec2 a = points[edge[0]], b = points[edge[1]];
    if (!(distance(a, b) > 1e-12 * size)) return "an edge without length";
    const double out = overhang(polygon, a, b);
    if (!(out <= 1e-9 * size)) return "outside by " + std::to_string(out / size) + " of the size";
  }
  return {};
}

/// Every point of `a` has one of `b` within `tolerance`, and the other way round.
inline bool samePoints(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double tolerance) {
  const auto covers = [&](const std::vector<Vec2>& some, const std::vector<Vec2>& others) {
    return std::all_of(some.begin(), some.end(), [&](Vec2 p) {
      return std::any_of(others.begin(), others.end(),
                         [&](Vec2 q) { return distance(p, q) <= tolerance; });
    });
  };
  return a.size() == b.size() && covers(a, b) && covers(b, a);
}

}  // namespace marrow
