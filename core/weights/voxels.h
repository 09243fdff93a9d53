// The inside of a closed mesh on a regular grid of cells, each of 4 × 4 × 4 voxels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// Which voxels are inside. A cell is a cube, and one bit of its mask is one voxel: x + 4 y + 16 z.
struct Voxels {
  static constexpr int kPerCell = 4;

  double spacing = 0;           // edge of a cell
  Vec3 origin;                  // lowest corner of the grid
  int nx = 0, ny = 0, nz = 0;   // cells
  std::vector<uint64_t> masks;  // of cell x + nx (y + ny z)
  /// Along x, y and z: the voxels between whose centre and the next one's the body ends and begins
  /// again. Two such voxels do not touch, however narrow the gap.
  std::array<std::vector<uint64_t>, 3> walls;

  size_t cell(int x, int y, int z) const {
    return static_cast<size_t>(x) +
           static_cast<size_t>(nx) *
               (static_cast<size_t>(y) + static_cast<size_t>(ny) * static_cast<size_t>(z));
  }
  /// In voxels, anywhere.
  bool has(int x, int y, int z) const {
    if (x < 0 || y < 0 || z < 0 || x >= 4 * nx || y >= 4 * ny || z >= 4 * nz) return false;
    return masks[cell(x >> 2, y >> 2, z >> 2)] >> voxelBit(x, y, z) & 1;
  }
  static int voxelBit(int x, int y, int z) { return (x & 3) + 4 * (y & 3) + 16 * (z & 3); }
};

/// A voxel is inside where the mesh winds around its centre, so that several closed meshes in one
/// count as their union; where the body is thinner than about two voxels, those that its surface
/// goes through are too, so that nothing falls apart. Gaps of any width stay open, as walls between
/// voxels where they are narrower than those. `centre` is a corner of cells. Triangles with corners
/// that are missing or not finite are left out; so are columns of voxels that the mesh does not
/// close. Empty without triangles. O(triangles + voxels they cover + cells).
Voxels voxelise(const Mesh& mesh, double spacing, Vec3 centre);

}  // namespace marrow
