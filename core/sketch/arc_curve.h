// A closed polyline by arc length: places and means in constant time
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// points: at least two, neighbours distinct. Arc lengths are cyclic: any number is good.
class ArcCurve {
 public:
  explicit ArcCurve(std::vector<Vec2> points);

  const std::vector<Vec2>& points() const { return points_; }
  size_t size() const { return points_.size(); }
  double length() const { return starts_.back(); }
  /// The arc length at vertex i, 0 ≤ i ≤ size().
  double arcAt(size_t i) const { return starts_[i]; }
  /// The edge that holds this place, by its first vertex.
  size_t edgeAt(double arc) const { return find(wrap(arc)); }
  Vec2 at(double arc) const;
  /// The mean of all places between two arc lengths, from < to < from + length().
  Vec2 mean(double from, double to) const;

 private:
  double wrap(double arc) const;
  size_t find(double arc) const;
  Vec2 integral(double arc) const;
  Vec2 integralOn(size_t edge, double arc) const;

  std::vector<Vec2> points_;
  std::vector<double> starts_;   // arc length at each vertex, and the whole
  std::vector<Vec2> integrals_;  // ∫ place d(arc) up to each vertex, and the whole
  std::vector<uint32_t>
      buckets_;  // the first edge that reaches into each of size() equal stretches
  double per_bucket_ = 0;
};

}  // namespace marrow
