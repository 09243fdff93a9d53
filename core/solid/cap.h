// A cap for a hole in a surface  [Barequet & Sharir 1995, for short holes]
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// Adds triangles that close the hole. False, and nothing added, where it is neither flat (no
/// corner further from its mean plane than a tenth of its size) nor of at most `small`, or has more
/// corners than anybody would cap, or a cap would run along edges that are there already.
/// loop: its vertices, each once, in the direction in which the cap's border runs.
/// edges: of the mesh, the lower vertex first, sorted.
bool fillHole(Mesh& mesh, const std::vector<uint32_t>& loop,
              const std::vector<std::pair<uint32_t, uint32_t>>& edges, double small);

}  // namespace marrow
