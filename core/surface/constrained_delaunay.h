// Constrained Delaunay triangulation of a simple polygon, grown point by point inside it.
//
// Why not CGAL's: nothing outside the polygon is ever built, the border needs no recovery, and the
// caller knows where each point goes, so that a point costs a short walk and a few flips.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Half-edge e belongs to triangle e / 3 and runs from corner(e) to corner(next(e)), the triangle
/// on its left. Border edge k runs from point k to point k + 1.
class ConstrainedDelaunay {
 public:
  static constexpr uint32_t kNone = ~0u;

  /// border: n ≥ 3 points, simple, counter-clockwise; they become points 0 … n − 1.
  /// False where the border cannot be triangulated: it crosses itself, runs clockwise or has no
  /// area. O(n · reflex vertices).
  bool start(const std::vector<Vec2>& border, size_t expected_points);

  /// Inserts a point near triangle `hint`. The triangle that got it, or kNone where the point is
  /// not inside the polygon. Flips only what is surely not Delaunay.
  uint32_t insert(Vec2 point, uint32_t hint);

  static uint32_t next(uint32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static uint32_t previous(uint32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }
  uint32_t corner(uint32_t e) const { return corners_[e]; }
  /// The half-edge on the other side; kNone on the border.
  uint32_t twin(uint32_t e) const {
    return twins_[e] < 0 ? kNone : static_cast<uint32_t>(twins_[e]);
  }
  /// The half-edge that is border edge k.
  uint32_t borderEdge(uint32_t k) const { return border_edges_[k]; }
  uint32_t borderCount() const { return static_cast<uint32_t>(border_edges_.size()); }
  uint32_t edgeCount() const { return static_cast<uint32_t>(corners_.size()); }

  const std::vector<Vec2>& points() const { return points_; }
  std::vector<std::array<uint32_t, 3>> triangles() const;

 private:
  static constexpr uint32_t kTooFar = kNone - 1;

  bool clipEars();
  void addTriangle(uint32_t a, uint32_t b, uint32_t c);
  void link(uint32_t e, int32_t other);
  bool flip(uint32_t e);
  uint32_t walk(Vec2 point, uint32_t triangle) const;
  uint32_t search(Vec2 point) const;

  std::vector<Vec2> points_;
  std::vector<uint32_t> corners_;       // of half-edges
  std::vector<int32_t> twins_;          // of half-edges; ~k for border edge k
  std::vector<uint32_t> border_edges_;  // half-edges
  std::vector<uint32_t> stack_;         // half-edges to look at
};

}  // namespace marrow
