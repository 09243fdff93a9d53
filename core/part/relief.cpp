#include "part/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/box.h"

namespace marrow {

Relief::Relief(const Mesh& mesh, const std::vector<double>& depths, bool even) {
  if (mesh.positions.empty()) return;
  Box2 box;
  for (const Vec3 p : mesh.positions) box.include(Vec2{p.x, p.y});
  for (const double depth : depths) highest_ = std::max(highest_, depth);
  for (const double depth : depths) lowest_ = std::min(lowest_, depth);
  low_ = box.low;
  high_ = box.high;
  if (!(high_.x > low_.x && high_.y > low_.y)) return;
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  heights_.assign(kSide * kSide, even ? 0 : -kNothing);
  if (!even) depths_.assign(kSide * kSide, kNothing);
  const Vec2 cell{(high_.x - low_.x) / kSide, (high_.y - low_.y) / kSide};
  const auto inCells = [&](uint32_t vertex) {
    const Vec3 p = mesh.positions[vertex];
    return Vec2{(p.x - low_.x) / cell.x - 0.5, (p.y - low_.y) / cell.y - 0.5};
  };
  const auto clamped = [](double value) {
    return static_cast<int>(std::min(std::max(value, 0.0), static_cast<double>(kSide - 1)));
  };
  for (auto [i, j, k] : mesh.triangles) {
    const bool upper = cross(inCells(j) - inCells(i), inCells(k) - inCells(i)) > 0;
    if (!upper) {
      if (even) continue;
      std::swap(j, k);
    }
    const Vec2 a = inCells(i), b = inCells(j), c = inCells(k);
    const double whole = cross(b - a, c - a);
    if (!(whole > 0)) continue;
    const int left = clamped(std::ceil(std::min({a.x, b.x, c.x})));
    const int right = clamped(std::floor(std::max({a.x, b.x, c.x})));
    const int lower = clamped(std::ceil(std::min({a.y, b.y, c.y})));
    const int above = clamped(std::floor(std::max({a.y, b.y, c.y})));
    for (int y = lower; y <= above; ++y) {
      for (int x = left; x <= right; ++x) {
        const Vec2 p{static_cast<double>(x), static_cast<double>(y)};
        const double s = cross(c - b, p - b), t = cross(a - c, p - c), u = cross(b - a, p - a);
        if (s < 0 || t < 0 || u < 0) continue;
        const auto height =
            static_cast<float>((s * depths[i] + t * depths[j] + u * depths[k]) / whole);
        const auto place = static_cast<size_t>(y * kSide + x);
        if (upper) {
          heights_[place] = std::max(heights_[place], height);
        } else {
          depths_[place] = std::min(depths_[place], height);
        }
      }
    }
  }
}

double Relief::at(const std::vector<float>& lattice, Vec2 p) const {
  if (lattice.empty()) return 0;
  if (!(p.x > low_.x && p.x < high_.x && p.y > low_.y && p.y < high_.y)) return 0;
  const auto x = static_cast<size_t>((p.x - low_.x) / (high_.x - low_.x) * kSide);
  const auto y = static_cast<size_t>((p.y - low_.y) / (high_.y - low_.y) * kSide);
  return lattice[std::min<size_t>(y, kSide - 1) * kSide + std::min<size_t>(x, kSide - 1)];
}

Relief Relief::flipped() const {
  if (depths_.empty()) return *this;
  Relief other = *this;
  other.highest_ = -lowest_;
  other.lowest_ = -highest_;
  for (float& height : other.heights_) height = -height;
  for (float& depth : other.depths_) depth = -depth;
  std::swap(other.heights_, other.depths_);
  return other;
}

}  // namespace marrow
