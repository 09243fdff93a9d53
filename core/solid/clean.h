// Tidies what a union leaves along its seams.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Collapses short edges between points of which at least one is at `first_new` or later, where
/// the surface stays closed and manifold and no triangle turns over.
void collapseSlivers(const std::vector<Vec3>& points, size_t first_new,
                     std::vector<std::array<uint32_t, 3>>& triangles,
                     std::vector<uint32_t>& part_of_triangle);

}  // namespace marrow
