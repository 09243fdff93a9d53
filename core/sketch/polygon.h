// Predicates and measures of closed polygons (last vertex joins the first, not repeated).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Positive for counter-clockwise, square model units.
double signedArea(const std::vector<Vec2>& polygon);
double perimeter(const std::vector<Vec2>& polygon);
/// The centre of gravity of the area; the first vertex where there is no area.
Vec2 areaCentroid(const std::vector<Vec2>& polygon);
/// No two edges touch, but for neighbours at their common vertex; all numbers finite. Exact; O(n)
/// in practice.
/// False also where more than most_pairs pairs of edges lie close together.
bool isSimple(const std::vector<Vec2>& polygon, size_t most_pairs = SIZE_MAX);
/// For each edge (from the vertex with its index to the next) whether it is one of those that
/// make isSimple() false.
std::vector<char> faultyEdges(const std::vector<Vec2>& polygon);
/// Strictly inside by the even-odd rule; points on the border may go either way. O(n).
bool contains(const std::vector<Vec2>& polygon, Vec2 point);
/// The smallest distance from `point` to the polygon's border. O(n).
double distanceToBorder(const std::vector<Vec2>& polygon, Vec2 point);
/// The smallest distance from `point` to the segment ab.
double distanceToSegment(Vec2 a, Vec2 b, Vec2 point);

/// distanceToSegment for many points and one segment.
class SegmentDistance {
 public:
  SegmentDistance(Vec2 a, Vec2 b) : a_(a), way_(b - a), squared_(dot(way_, way_)) {}
  double to(Vec2 point) const {
    if (!(squared_ > 0)) return distance(a_, point);
    const double t = std::min(1.0, std::max(0.0, dot(point - a_, way_) / squared_));
    return distance(a_ + way_ * t, point);
  }

 private:
  Vec2 a_, way_;
  double squared_;
};

}  // namespace marrow
