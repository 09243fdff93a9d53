#include "sketch/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sketch/polygon.h"

namespace marrow {
namespace {

/// Whether candidate a beats candidate b: clearly larger, or as large and first in the plane, so
/// that symmetric shapes do not depend on the order of their vertices.
bool beats(double value_a, Vec2 a, double value_b, Vec2 b) {
  constexpr double kSame = 1e-12;
  if (value_a > value_b * (1 + kSame)) return true;
  if (value_a < value_b * (1 - kSame)) return false;
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

uint32_t farthestFrom(const std::vector<Vec2>& polygon, Vec2 from) {
  uint32_t best = 0;
  double best_distance = -1;
  for (uint32_t i = 0; i < polygon.size(); ++i) {
    const double here = distance(polygon[i], from);
    if (best_distance < 0 || beats(here, polygon[i], best_distance, polygon[best])) {
      best = i;
      best_distance = here;
    }
  }
  return best;
}

std::pair<uint32_t, uint32_t> mutuallyFarthest(const std::vector<Vec2>& polygon) {
  uint32_t a = farthestFrom(polygon, areaCentroid(polygon)), b = farthestFrom(polygon, polygon[a]);
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds; ++round) {
    const uint32_t back = farthestFrom(polygon, polygon[b]);
    if (back == a) break;
    a = b;
    b = back;
  }
  return {std::min(a, b), std::max(a, b)};
}

struct Farthest {
  uint32_t index = 0;
  double miss = -1;
};

/// The vertex strictly between two others, cyclically, that is farthest from their chord.
Farthest farthestBetween(const std::vector<Vec2>& polygon, uint32_t from, uint32_t to) {
  const auto n = static_cast<uint32_t>(polygon.size());
  const Vec2 a = polygon[from], b = polygon[to], way = b - a;
  const double squared = dot(way, way);
  const SegmentDistance chord(a, b);
  // Vertices whose foot is on the chord, nearer to it than `near`, surely miss by less than the
  // best so far: by far more than all rounding.
  const double rounding =
      1e-14 * (std::fabs(a.x) + std::fabs(a.y) + std::fabs(b.x) + std::fabs(b.y));
  double near_squared = -1;  // near² × squared
  Farthest best;
  for (uint32_t i = from + 1 < n ? from + 1 : 0; i != to; i = i + 1 < n ? i + 1 : 0) {
    const Vec2 p = polygon[i] - a;
    const double along = dot(p, way), across = cross(way, p);
    if (across * across < near_squared && along >= 0 && along <= squared) continue;
    const double miss = chord.to(polygon[i]);
    if (best.miss >= 0 && !beats(miss, polygon[i], best.miss, polygon[best.index])) continue;
    best = {i, miss};
    const double near = (1 - 1e-9) * miss - rounding;
    near_squared = near > 0 ? near * near * squared : -1;
  }
  return best;
}

void split(const std::vector<Vec2>& polygon, uint32_t from, uint32_t to, double tolerance,
           std::vector<char>& kept) {
  std::vector<std::pair<uint32_t, uint32_t>> stretches{{from, to}};
  while (!stretches.empty()) {
    const auto [a, b] = stretches.back();
    stretches.pop_back();
    const Farthest farthest = farthestBetween(polygon, a, b);
    if (farthest.miss <= tolerance) continue;
    kept[farthest.index] = 1;
    stretches.push_back({a, farthest.index});
    stretches.push_back({farthest.index, b});
  }
}

/// Takes out, least needed first, the vertices whose absence stays within the tolerance.
void dropNeedless(const std::vector<Vec2>& polygon, double tolerance, std::vector<uint32_t>& kept) {
  const auto missWithout = [&](size_t i) {
    const size_t n = kept.size();
    return farthestBetween(polygon, kept[(i + n - 1) % n], kept[(i + 1) % n]).miss;
  };
  std::vector<double> misses(kept.size());
  for (size_t i = 0; i < kept.size(); ++i) misses[i] = missWithout(i);
  while (kept.size() > 3) {
    size_t least = 0;
    for (size_t i = 1; i < kept.size(); ++i) {
      if (beats(misses[least], polygon[kept[least]], misses[i], polygon[kept[i]])) least = i;
    }
    if (misses[least] > tolerance) break;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(least));
    misses.erase(misses.begin() + static_cast<std::ptrdiff_t>(least));
    const size_t n = kept.size();
    misses[least % n] = missWithout(least % n);
    misses[(least + n - 1) % n] = missWithout((least + n - 1) % n);
  }
}

/// Where chords cross, takes the vertices back that lie farthest from them, until none cross.
void untangleChords(const std::vector<Vec2>& polygon, std::vector<uint32_t>& kept) {
  for (bool again = true; again;) {
    again = false;
    std::vector<Vec2> chords;
    for (const uint32_t i : kept) chords.push_back(polygon[i]);
    const std::vector<char> faulty = faultyEdges(chords);
    std::vector<uint32_t> finer;
    for (size_t k = 0; k < kept.size(); ++k) {
      finer.push_back(kept[k]);
      if (!faulty[k]) continue;
      const Farthest farthest =
          farthestBetween(polygon, kept[k], kept[k + 1 < kept.size() ? k + 1 : 0]);
      if (farthest.miss < 0) continue;
      finer.push_back(farthest.index);
      again = true;
    }
    kept = std::move(finer);
  }
}

}  // namespace

std::vector<uint32_t> simplify(const std::vector<Vec2>& polygon, double tolerance) {
  std::vector<char> kept(polygon.size(), 0);
  const auto [a, b] = mutuallyFarthest(polygon);
  kept[a] = kept[b] = 1;
  split(polygon, a, b, tolerance, kept);
  split(polygon, b, a, tolerance, kept);

  std::vector<uint32_t> indices;
  const auto n = static_cast<uint32_t>(polygon.size());
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t i = a + k < n ? a + k : a + k - n;
    if (kept[i]) indices.push_back(i);
  }
  if (indices.size() == 2) {
    const Farthest left = farthestBetween(polygon, a, b), right = farthestBetween(polygon, b, a);
    if (left.miss >= right.miss) {
      indices.insert(indices.begin() + 1, left.index);
    } else {
      indices.push_back(right.index);
    }
  }
  dropNeedless(polygon, tolerance, indices);
  untangleChords(polygon, indices);
  return indices;
}

}  // namespace marrow
