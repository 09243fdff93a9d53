// What makes a mesh a good solid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "surface/mesh.h"

namespace marrow {

struct SolidReport {
  bool closed = false, manifold = false;  // as in MeshReport
  double volume = 0, area = 0;
  int degenerate = 0;
  size_t components = 0;
  int genus = 0;  // handles, summed over the components; meaningful where closed and manifold
  size_t self_intersections = 0;
};
SolidReport inspectSolid(const Mesh& mesh);

/// Whether each edge is run through exactly once in each direction. O(triangles).
bool isClosed(const Mesh& mesh);

/// Positive where the triangles face outward.
double signedVolume(const Mesh& mesh);
double signedVolume(const std::vector<Vec3>& positions,
                    const std::vector<std::array<uint32_t, 3>>& triangles);

/// Pairs of triangles that have more in common than the corners and edges they share; decided
/// exactly. O(n log n) and a little for each pair that comes near.
size_t countSelfIntersections(const Mesh& mesh);
/// Whether there is any; true also where more than 200 pairs for each triangle come near, which no
/// mesh has that anybody made.
bool hasSelfIntersection(const Mesh& mesh);

/// These pairs, but only those of which at least one triangle is marked.
std::vector<std::pair<uint32_t, uint32_t>> selfIntersections(const Mesh& mesh,
                                                             const std::vector<char>& marked);

}  // namespace marrow
