// Boxes along the axes, in the plane and in space. New ones are empty: their low is above their
// high.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "base/vec.h"

namespace marrow {

inline Vec2 least(Vec2 a, Vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
inline Vec2 most(Vec2 a, Vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }
inline Vec3 least(Vec3 a, Vec3 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vec3 most(Vec3 a, Vec3 b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

struct Box2 {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec2 low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};

  void include(Vec2 p) {
    low = least(low, p);
    high = most(high, p);
  }
  void include(const Box2& box) {
    low = least(low, box.low);
    high = most(high, box.high);
  }
  bool isEmpty() const { return !(low.x <= high.x); }
  Vec2 size() const { return high - low; }
  double longerSide() const { return std::max(high.x - low.x, high.y - low.y); }
  Vec2 middle() const { return (low + high) / 2; }
  /// Touching counts, here and below.
  bool has(Vec2 p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
  bool meets(const Box2& box) const {
    return low.x <= box.high.x && box.low.x <= high.x && low.y <= box.high.y && box.low.y <= high.y;
  }
};

struct Box3 {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

  void include(Vec3 p) {
    low = least(low, p);
    high = most(high, p);
  }
  bool isEmpty() const { return !(low.x <= high.x); }
  Vec3 size() const { return high - low; }
  Vec3 middle() const { return (low + high) / 2; }
  bool has(Vec3 p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z &&
           p.z <= high.z;
  }
  bool meets(const Box3& box) const {
    return low.x <= box.high.x && box.low.x <= high.x && low.y <= box.high.y &&
           box.low.y <= high.y && low.z <= box.high.z && box.low.z <= high.z;
  }
};

inline Box3 boxOf(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3 p : points) box.include(p);
  return box;
}
/// Of any points that are Vec2.
template <typename Points>
Box2 boxOf(const Points& points) {
  Box2 box;
  for (const Vec2 p : points) box.include(p);
  return box;
}

}  // namespace marrow
