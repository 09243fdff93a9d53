// How two straight skeletons of one polygon compare.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "skeleton/straight_skeleton.h"

namespace marrow {

inline double sizeOf(const std::vector<Vec2>& points) {
  Vec2 low = points[0], high = points[0];
  for (const Vec2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

/// What `a` has that `b` does not: a node or an arc, to within `tolerance`; empty if nothing.
/// Arcs shorter than twice the tolerance may be there or not.
inline std::string missingFrom(const StraightSkeleton& a, const StraightSkeleton& b, size_t n,
                               double tolerance) {
  const auto near = [&](Vec2 p, Vec2 q) { return distance(p, q) <= tolerance; };
  for (size_t i = n; i < a.nodes.size(); ++i) {
    bool found = false;
    for (size_t j = n; j < b.nodes.size() && !found; ++j) {
      found = near(a.nodes[i], b.nodes[j]) && std::fabs(a.times[i] - b.times[j]) <= tolerance;
    }
    if (!found) return "node " + std::to_string(i) + " at time " + std::to_string(a.times[i]);
  }
  for (size_t i = n; i < a.edges.size(); ++i) {
    const auto& e = a.edges[i];
    const Vec2 p = a.nodes[e.a], q = a.nodes[e.b];
    if (distance(p, q) < 2 * tolerance) continue;
    bool found = false;
    for (size_t j = n; j < b.edges.size() && !found; ++j) {
      const auto& f = b.edges[j];
      const Vec2 r = b.nodes[f.a], s = b.nodes[f.b];
      const bool same_way = near(p, r) && near(q, s) && e.left == f.left && e.right == f.right;
      const bool other_way = near(p, s) && near(q, r) && e.left == f.right && e.right == f.left;
      found = (same_way || other_way) && e.kind == f.kind;
    }
    if (!found) return "arc " + std::to_string(e.a) + " to " + std::to_string(e.b);
  }
  return {};
}

/// The polygon's offset at distance t, read off the skeleton: for every border edge the positions
/// along it, in order, where its pieces begin and end; pieces shorter than `tolerance` left out.
inline std::vector<std::vector<double>> offsetPieces(const std::vector<Vec2>& polygon,
                                                     const StraightSkeleton& skeleton, double t,
                                                     double tolerance) {
  const size_t n = polygon.size();
  std::vector<std::vector<double>> pieces(n);
  for (size_t i = n; i < skeleton.edges.size(); ++i) {
    const auto& e = skeleton.edges[i];
    const double ta = skeleton.times[e.a], tb = skeleton.times[e.b];
    if ((ta <= t) == (tb <= t)) continue;
    const Vec2 p = lerp(skeleton.nodes[e.a], skeleton.nodes[e.b], (t - ta) / (tb - ta));
    for (const uint32_t face : {e.left, e.right}) {
      const Vec2 d = polygon[(face + 1) % n] - polygon[face];
      pieces[face].push_back(dot(d, p - polygon[face]) / length(d));
    }
  }
  for (auto& at : pieces) {
    std::sort(at.begin(), at.end());
    std::vector<double> kept;
    for (size_t k = 0; k + 1 < at.size(); k += 2) {
      if (at[k + 1] - at[k] < tolerance) continue;
      if (!kept.empty() && at[k] - kept.back() < tolerance) {
        kept.back() = at[k + 1];  // pieces that touch
      } else {
        kept.push_back(at[k]);
        kept.push_back(at[k + 1]);
      }
    }
    at = kept;
  }
  return pieces;
}

/// Whether the two skeletons give the same offset polygon at distance t.
inline bool sameOffset(const std::vector<Vec2>& polygon, const StraightSkeleton& a,
                       const StraightSkeleton& b, double t, double tolerance) {
  const auto p = offsetPieces(polygon, a, t, 10 * tolerance);
  const auto q = offsetPieces(polygon, b, t, 10 * tolerance);
  for (size_t i = 0; i < p.size(); ++i) {
    // A piece just at the limit may be in one and not in the other: compare covered lengths.
    double pl = 0, ql = 0;
    for (size_t k = 0; k + 1 < p[i].size(); k += 2) pl += p[i][k + 1] - p[i][k];
    for (size_t k = 0; k + 1 < q[i].size(); k += 2) ql += q[i][k + 1] - q[i][k];
    if (std::fabs(pl - ql) > 40 * tolerance) return false;
    if (p[i].size() != q[i].size()) continue;
    for (size_t k = 0; k < p[i].size(); ++k) {
      if (std::fabs(p[i][k] - q[i][k]) > 20 * tolerance) return false;
    }
  }
  return true;
}

}  // namespace marrow
