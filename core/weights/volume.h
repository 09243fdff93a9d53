// The body as a mesh of cubes, for what spreads through it and not through the air.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "surface/mesh.h"

namespace marrow {

struct VolumeOptions {
  double target_vertices = 2900;  // met to about an eighth, where the shape allows
  /// A vertex of the lattice, else the middle of the mesh's box. A point of the plane of symmetry,
  /// where that is along the axes, gives twins the same volume.
  std::optional<Vec3> centre;
};

/// Cells of a cubic lattice, those that the body reaches into. Where two pieces of the body share a
/// cube without touching each other in it, each has a cell of its own there; cells share corners
/// only where the body goes on from one to the other [Nesme et al. 2009].
struct Volume {
  double spacing = 0;  // of the lattice
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 8>> cells;  // corner at x + 2 y + 4 z
  std::vector<uint32_t> pieces;                // per vertex: which connected piece it is of
  uint32_t piece_count = 0;

  /// Where a point lies: between the corners of a cell.
  struct Place {
    uint32_t cell = 0;
    std::array<double, 8> shares{};  // not negative, sum 1
  };
  /// The place of the point, or of the nearest part of the body within `reach` voxels, quarters of
  /// the spacing. Between two sheets it is the one that holds `inward`, a point below the surface
  /// there. Of a point farther away, and of one that is not finite: none.
  std::optional<Place> locate(Vec3 point, Vec3 inward, int reach = 8) const;
  std::optional<Place> locate(Vec3 point) const { return locate(point, point); }

  // For locate: the grid of cubes, the cells of each, and the voxels of each cell.
  Vec3 origin;
  int nx = 0, ny = 0, nz = 0;
  std::vector<uint32_t> starts;
  std::vector<uint64_t> masks;
};

/// Of a closed mesh, or of several in one, which count as their union. Errors: meshFailed where the
/// mesh has no triangles to work with.
Result<Volume> makeVolume(const Mesh& mesh, const VolumeOptions& options = {});

}  // namespace marrow
