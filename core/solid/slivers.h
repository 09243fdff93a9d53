// Triangles without area in closed surfaces: what merging takes for a surface that crosses itself.
#pragma once

#include <cstddef>

#include "surface/mesh.h"

namespace marrow {

/// Flips the longest side of each triangle that is lower than 10⁻⁵ of it, which moves the surface
/// by no more than that. How many are left, where a flip would not help. mesh: closed, 2-manifold.
size_t flipSlivers(Mesh& mesh);

}  // namespace marrow
