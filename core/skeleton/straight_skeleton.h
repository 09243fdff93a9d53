// Outline polygon → straight skeleton
// [RS §3.1, Algorithm 3; Aichholzer & Aurenhammer 1996; Felkel & Obdržálek 1998]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace marrow {

struct StraightSkeleton {
  enum class Method : uint8_t { wavefront, cgal };
  enum class Kind : uint8_t {
    border,      // an edge of the polygon
    peripheral,  // touches a vertex of the polygon
    skeleton,    // inner
  };
  /// An edge between two nodes. Border edge i (0 ≤ i < n) comes first and runs from vertex i to
  /// vertex i + 1. For the others `left` and `right` are the border edges whose faces they part,
  /// seen when going from a to b.
  struct Edge {
    uint32_t a, b;
    Kind kind;
    uint32_t left, right;
  };

  std::vector<Vec2> nodes;    // the polygon's n vertices first, in its order, then the inner nodes
  std::vector<double> times;  // one per node: distance to its defining border edges, model units;
                              // 0 on the border; the inscribed radius there
  std::vector<Edge> edges;    // n border edges, then the arcs; the arcs form a tree over all nodes
  Method method = Method::wavefront;  // who made it
};

const char* toString(StraightSkeleton::Kind kind);
const char* toString(StraightSkeleton::Method method);

struct StraightSkeletonOptions {
  // Where the wavefront's self-check fails, ask CGAL (a large polygon is jolted by a billionth of
  // its size first, and the wavefront tried again).
  bool allow_fallback = true;
};

/// polygon: n ≥ 3 vertices, simple, counter-clockwise, no repeated vertex.
/// Coincident nodes are merged: 2n − 3 arcs in general position, fewer where events coincide.
/// On ordinary input O(n log n), and for each of r reflex vertices what lies in its way: about
/// n^1.1 for smooth outlines, n^1.3 where r = n / 2 spikes are as long as the polygon is wide. At
/// worst O(r n log n). Errors: tooFewPoints, notAPolygon, skeletonFailed.
Result<StraightSkeleton> straightSkeleton(const std::vector<Vec2>& polygon,
                                          const StraightSkeletonOptions& options = {});

/// Our wavefront alone; skeletonFailed where its self-check does not hold.
Result<StraightSkeleton> straightSkeletonByWavefront(const std::vector<Vec2>& polygon);

/// CGAL's create_interior_straight_skeleton_2, same conventions: the oracle and the fallback.
Result<StraightSkeleton> straightSkeletonByCgal(const std::vector<Vec2>& polygon);

/// What is inconsistent in `skeleton`, empty when nothing is: a tree, every node at its time's
/// distance from its faces' edges, every face closed and monotone along its edge. O(n).
std::string inconsistency(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton);

}  // namespace marrow
