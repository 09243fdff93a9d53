// Which triangles of a surface belong beside each other, and where it ends.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// For each side of a mesh's triangles (see nextSide) the one across it; kNoSide at a border.
using Across = std::vector<uint32_t>;
constexpr uint32_t kNoSide = ~0u;

/// Where more than two triangles meet at an edge, those that have the solid between them, by the
/// sides they face to, belong to each other. Nothing where that is not to be said.
/// No triangle has a corner twice.
std::optional<Across> pairSides(const Mesh& mesh);

/// Pairs the sides at borders with those of triangles that were added since; false where some are
/// left, or more than two meet.
bool pairAdded(const Mesh& mesh, Across& across);

/// The borders as loops of vertices, each vertex once in a loop, in the direction in which a cap's
/// border runs. Holes that meet at a vertex are told apart.
/// mesh: neighbours run along their common side in opposite directions.
std::vector<std::vector<uint32_t>> borderLoops(const Mesh& mesh, const Across& across);

}  // namespace marrow
