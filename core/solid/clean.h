// Tidies what a union leaves along its seams: needles and caps, where a seam passes close to a
// vertex or an edge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solid/cut.h"

namespace marrow {

/// Collapses short edges that have a new point (one that `soup` has not), and turns the longest
/// edges of flat triangles around there, where the surface stays closed and manifold and faces the
/// way it did. Points are moved a little so that the volume stays the same. `sources` says what
/// triangle of the soup each triangle is a piece of. Pieces of frozen ones, and what is around
/// them, stay as they are.
void collapseSlivers(const Soup& soup, std::vector<Vec3>& points,
                     std::vector<std::array<uint32_t, 3>>& triangles,
                     std::vector<uint32_t>& sources, const std::vector<char>& frozen);

}  // namespace marrow
