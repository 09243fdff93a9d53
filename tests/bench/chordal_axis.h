// A rival to measure against: the chordal axis of a polygon, from its constrained Delaunay
// triangulation by CGAL.  [Prasad 1997; Igarashi et al. 1999]
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow::bench {

struct ChordalAxis {
  std::vector<Vec2> points;
  std::vector<std::array<uint32_t, 2>> edges;
};

/// Joins the midpoints of the triangulation's inner edges: across triangles with one border edge,
/// to the opposite corner where there are two, to the centroid where there is none.
/// polygon: simple.
ChordalAxis chordalAxis(const std::vector<Vec2>& polygon);

}  // namespace marrow::bench
