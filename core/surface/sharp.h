// Normals of surfaces that have edges to be seen.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// Unit normals at the corners of each triangle, as of vertexNormals, but of those triangles alone
/// that are reached around the vertex without crossing a sharp edge: one at which the surface turns
/// by more than 40°. mesh: closed, 2-manifold. O(n log n).
std::vector<std::array<Vec3, 3>> cornerNormals(const Mesh& mesh);

/// A mesh's vertices, once for each normal that their triangles have there.
struct SplitVertices {
  std::vector<uint32_t> vertices;  // of the mesh
  std::vector<Vec3> normals;
  std::vector<std::array<uint32_t, 3>> triangles;  // the mesh's, by indices of those
};
SplitVertices splitByNormals(const Mesh& mesh,
                             const std::vector<std::array<Vec3, 3>>& corner_normals);

}  // namespace marrow
