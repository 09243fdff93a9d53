#include "solid/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace marrow {
namespace {

constexpr double kCell = 8;  // of the reach: most places then have one cell to look at

struct Cell {
  int64_t x, y, z;
  bool operator==(const Cell& other) const { return x == other.x && y == other.y && z == other.z; }
};

struct Hash {
  size_t operator()(const Cell& cell) const {
    uint64_t h = 0;
    for (const int64_t c : {cell.x, cell.y, cell.z}) {
      h = (h ^ static_cast<uint64_t>(c)) * 0x9E3779B97F4A7C15u;
      h ^= h >> 29;
    }
    return static_cast<size_t>(h);
  }
};

}  // namespace

std::vector<uint32_t> samePlaces(const std::vector<Vec3>& positions) {
  std::vector<uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  std::sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) {
    const Vec3 a = positions[i], b = positions[j];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z != b.z ? a.z < b.z : i < j;
  });
  for (size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && positions[order[k]] == positions[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

std::vector<uint32_t> nearPlaces(const std::vector<Vec3>& positions, double reach) {
  const auto cellOf = [&](double coordinate) {
    return static_cast<int64_t>(std::floor(coordinate / (kCell * reach)));
  };
  // Those that stay are further apart than `reach`, so a cell holds few of them.
  std::unordered_map<Cell, std::vector<uint32_t>, Hash> cells;
  std::vector<uint32_t> first = samePlaces(positions);
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (first[i] != i) {
      first[i] = first[first[i]];
      continue;
    }
    const Vec3 p = positions[i];
    uint32_t nearest = i;
    for (int64_t x = cellOf(p.x - reach); x <= cellOf(p.x + reach); ++x) {
      for (int64_t y = cellOf(p.y - reach); y <= cellOf(p.y + reach); ++y) {
        for (int64_t z = cellOf(p.z - reach); z <= cellOf(p.z + reach); ++z) {
          const auto found = cells.find({x, y, z});
          if (found == cells.end()) continue;
          for (const uint32_t other : found->second) {
            if (distance(positions[other], p) <= reach) nearest = std::min(nearest, other);
          }
        }
      }
    }
    first[i] = nearest;
    if (nearest == i) cells[{cellOf(p.x), cellOf(p.y), cellOf(p.z)}].push_back(i);
  }
  return first;
}

}  // namespace marrow
