// Vertices in the same place.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// For each position the first one in the same place. O(n log n).
std::vector<uint32_t> samePlaces(const std::vector<Vec3>& positions);

/// For each position the first one that is no further than `reach`, among those that stay. reach:
/// positive, and no less than 10⁻⁶ of the largest coordinate. O(n) where few lie close together.
std::vector<uint32_t> nearPlaces(const std::vector<Vec3>& positions, double reach);

}  // namespace marrow
