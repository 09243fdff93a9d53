// The union of solids: one closed surface without self-intersections around all of them. Parts that
// touch nothing stay components of their own; what lies inside others is gone.
//
// The points are brought onto a fine lattice and moved a little there, at random and outward, each
// part by another amount. That changes no coordinate by more than a few 10⁻⁹ of the model's size,
// and brings parts that touch, coincide or nearly coincide into general position, where the union
// is decided exactly (solid/cut.h). Only + − × ÷ and square roots: the same bits everywhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/frame.h"
#include "base/timing.h"
#include "surface/mesh.h"

namespace marrow {

struct SolidInput {
  const Mesh* mesh = nullptr;  // closed, in the part's own coordinates; facing either way
  Frame frame;                 // places it in the model
  uint32_t id = 0;             // the caller's; told of each triangle
  bool foreign = false;        // not one of our own meshes: left out where it crosses itself, which
                               // is asked of no other, or pinches itself together in a point
};

struct MergeOptions {
  bool collapse_slivers = true;  // along the seams, where that keeps the mesh valid
};

struct MergedMesh {
  struct LeftOut {
    uint32_t id;
    std::string why;  // a clause, such as "it has a hole"
  };

  Mesh mesh;                               // in model units; empty where there is nothing to merge
  std::vector<uint32_t> part_of_triangle;  // ids
  /// Unit normals at the corners of each triangle: those of its own part's smooth surface, also at
  /// the seams; a foreign one is smooth but for sharp edges (see cornerNormals).
  std::vector<std::array<Vec3, 3>> corner_normals;
  std::vector<char> on_seam;  // one per vertex: whether several parts meet there
  std::vector<LeftOut> left_out;
  size_t shapes = 0;    // meshes that differ, however often each is placed
  size_t distinct = 0;  // solids that were merged; of several in the same place the last one counts
  size_t pairs = 0;     // of those, that come near each other
  size_t examined = 0;  // triangles that come near another solid
  size_t crossings = 0;  // pairs of triangles of different parts that passed through each other
  size_t self_intersections = 0;  // 0, but for models so far from the origin that rounding shows
  int attempts = 0;               // at general position
  Timings timings;                // stages: prepare, cut, fill, clean, check, finish
};

/// O(n log n) for n triangles, and a little for each pair of them that cross. Parts that are not
/// closed, or that cannot be merged, are left out and named; the rest is merged.
MergedMesh mergeSolids(const std::vector<SolidInput>& solids, const MergeOptions& options = {},
                       Clock clock = nullptr);

}  // namespace marrow
