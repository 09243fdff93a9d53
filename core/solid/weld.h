// Vertices in the same place, and sets of what belongs together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// A union of sets of numbers from 0.
class Sets {
 public:
  explicit Sets(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), uint32_t{0});
  }
  uint32_t find(uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  /// The smaller number stands for both.
  void join(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parent_;
};

/// For each position the first one in the same place. O(n log n).
std::vector<uint32_t> samePlaces(const std::vector<Vec3>& positions);

/// For each position the first one that is no further than `reach`, among those that stay. reach:
/// positive, and no less than 10⁻⁶ of the largest coordinate. O(n) where few lie close together.
std::vector<uint32_t> nearPlaces(const std::vector<Vec3>& positions, double reach);

}  // namespace marrow
