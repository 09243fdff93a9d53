// Triangle meshes as plain arrays; adjacency is derived, never stored.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"

namespace marrow {

struct Mesh {
  std::vector<Vec3> positions;                     // model units
  std::vector<std::array<uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

/// Side 3t + k is that of triangle t from its corner k to the next; this is the one after it.
inline uint32_t nextSide(uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }

struct MeshReport {
  bool closed = false;    // no edge has one triangle only
  bool manifold = false;  // every edge at most two, every vertex one fan, orientation consistent
  double volume = 0;      // signed, cubic model units; positive when triangles face outward
  double area = 0;        // square model units
  int degenerate = 0;     // triangles with a repeated corner or no area
};
MeshReport inspect(const Mesh& mesh);

/// Everything wrong with a mesh that should be a closed, outward solid; empty when nothing is.
std::vector<std::string> validate(const Mesh& mesh);

/// Unit normals, one per vertex: the triangles' there, weighted by sine of angle ÷ (product of the
/// two edges' lengths), which is exact on spheres [Max 1999]. (0, 0, 1) where a vertex has no
/// triangle.
std::vector<Vec3> vertexNormals(const Mesh& mesh);

}  // namespace marrow
