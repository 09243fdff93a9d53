// The self-check of a straight skeleton, declared in straight_skeleton.h.

#include <algorithm>
#include <cmath>

#include "base/box.h"
#include "skeleton/straight_skeleton.h"

namespace marrow {
namespace {

constexpr double kTolerance = 1e-7;  // × the polygon's size

using Kind = StraightSkeleton::Kind;

}  // namespace

std::string inconsistency(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton) {
  const size_t n = polygon.size(), nodes = skeleton.nodes.size();
  if (n < 3 || nodes <= n || skeleton.times.size() != nodes || skeleton.edges.size() < n) {
    return "sizes do not fit";
  }
  const double tolerance = kTolerance * boxOf(polygon).longerSide();
  const auto* arcs = skeleton.edges.data() + n;
  const size_t arc_count = skeleton.edges.size() - n;
  if (arc_count > 2 * n - 3) return "more arcs than a polygon can have";

  std::vector<Vec2> directions(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 d = polygon[i + 1 == n ? 0 : i + 1] - polygon[i];
    directions[i] = d / length(d);
  }

  // All counts and walks in one piece of memory.
  std::vector<uint32_t> memory(2 * nodes + 2 * n + 1, 0);
  uint32_t* const degree = memory.data();
  uint32_t* const on_face = degree + nodes;
  uint32_t* const end = on_face + n + 1;
  uint32_t* const next = end + n;
  for (size_t i = 0; i < arc_count; ++i) {
    const auto& arc = arcs[i];
    if (arc.a >= nodes || arc.b >= nodes || arc.left >= n || arc.right >= n ||
        arc.left == arc.right) {
      return "an arc points nowhere";
    }
    if (arc.kind == Kind::border || (arc.kind == Kind::peripheral) != (arc.a < n || arc.b < n)) {
      return "an arc is of the wrong kind";
    }
    ++degree[arc.a];
    ++degree[arc.b];
    ++on_face[arc.left];
    ++on_face[arc.right];
    const Vec2 a = skeleton.nodes[arc.a], b = skeleton.nodes[arc.b];
    const double a_time = skeleton.times[arc.a], b_time = skeleton.times[arc.b];
    for (const uint32_t face : {arc.left, arc.right}) {
      const Vec2 start = polygon[face], direction = directions[face];
      if (!(std::fabs(cross(direction, a - start) - a_time) <= tolerance) ||
          !(std::fabs(cross(direction, b - start) - b_time) <= tolerance)) {
        return "a node's time is not its distance";
      }
    }
  }
  // As many as a tree has; that they hang together follows from the faces below: each is one path,
  // and two neighbours share the arc of the border vertex between them.
  if (arc_count + 1 != nodes) return "the arcs are no tree";
  for (size_t i = 0; i < nodes; ++i) {
    if (i < n ? degree[i] != 1 : degree[i] < 3) return "a node has the wrong degree";
  }

  // The half-edges around each face, sorted by face, then walked from the border edge's end to its
  // start: along the edge's direction out, back and out again at most, never below it.
  struct HalfEdge {
    uint32_t from, to;
  };
  uint32_t begin = 0;
  for (size_t face = 0; face <= n; ++face) {
    const uint32_t count = on_face[face];
    on_face[face] = begin;
    if (face < n) end[face] = begin;
    begin += count;
  }
  std::vector<HalfEdge> around(2 * arc_count);
  for (size_t i = 0; i < arc_count; ++i) {
    around[end[arcs[i].left]++] = {arcs[i].a, arcs[i].b};
    around[end[arcs[i].right]++] = {arcs[i].b, arcs[i].a};
  }
  constexpr uint32_t kNone = 0xffffffff;
  std::fill(next, next + nodes, kNone);
  for (uint32_t face = 0; face < n; ++face) {
    for (uint32_t i = on_face[face]; i < end[face]; ++i) {
      if (next[around[i].from] != kNone) return "a face touches itself";
      next[around[i].from] = around[i].to;
    }
    const Vec2 direction = directions[face];
    uint32_t node = face + 1 == n ? 0 : face + 1;
    double along = dot(direction, skeleton.nodes[node]);
    int turns = 0;  // even: going out, odd: going back
    for (uint32_t i = on_face[face]; i < end[face]; ++i) {
      node = next[node];
      if (node == kNone) return "a face is not closed";
      if (!(skeleton.times[node] >= 0)) return "a node lies outside";
      const double there = dot(direction, skeleton.nodes[node]);
      const double step = turns % 2 == 0 ? there - along : along - there;
      if (step < -tolerance) ++turns;
      along = there;
    }
    if (node != face) return "a face is not closed";
    if (turns > 2) return "a face is not monotone";
    for (uint32_t i = on_face[face]; i < end[face]; ++i) next[around[i].from] = kNone;
  }
  return {};
}

}  // namespace marrow
