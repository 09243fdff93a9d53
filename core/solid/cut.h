// Where the surfaces of solids pass through each other, and what of them lies outside all others.
//
// In general position, surfaces meet in two ways: an edge pierces a triangle, and three triangles
// meet in a point. Both are decided exactly, and everything else follows from counting: along an
// edge each piercing leads into one solid more or out of it; a segment, where two triangles cross,
// joins two piercings. So what is left is closed, whatever rounding does to the new points. The
// idea of building the solid's boundary from such counts is Smith's ["Towards robust inexact
// geometric computation", 2009].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "solid/lattice.h"

namespace marrow {

/// Closed surfaces of lattice points, one after the other.
struct Soup {
  std::vector<Vec3> points;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> part_of_triangle;
  std::vector<uint32_t> part_of_point;
};

struct OpenEdge {
  uint32_t triangle, from, to;  // a triangle of the soup, points of the cut; the triangle's left
};

/// The surface of the union.
struct Cut {
  /// A point where an edge a–b pierces a triangle, or three triangles meet.
  struct Origin {
    uint32_t a = 0, b = 0;    // points of the soup; both 0 where three triangles meet
    double share = 0;         // of the way from a to b
    uint32_t triangles[3]{};  // the pierced one; all three
  };

  std::vector<Vec3> points;       // the soup's, then the new ones; no whole numbers any more
  std::vector<Origin> origins;    // of the new ones
  std::vector<uint32_t> whole;    // triangles of the soup that stay as they are
  std::vector<OpenEdge> borders;  // around what stays of the others, triangle by triangle
  size_t crossings = 0;           // pairs of triangles that pass through each other
  size_t pairs = 0;               // of parts whose boxes meet
  size_t examined = 0;            // triangles whose boxes meet that of another part

  bool ok = true;  // false: not in general position, by these two parts
  uint32_t part = 0, other = 0;
};

Cut cutSurfaces(const Soup& soup);

}  // namespace marrow
