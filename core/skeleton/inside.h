// Does a segment stay inside a polygon?
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/box.h"

namespace marrow {

/// What bones must stay in: the polygon, the outline it was made from where there is one, and that
/// one's mirror image where bones are mirrored.
struct Region {
  const std::vector<Vec2>& polygon;
  const std::vector<Vec2>* outline = nullptr;
  const std::vector<Vec2>* image = nullptr;
};

/// a, b: points inside the polygon. False also where the segment touches the border. O(n).
bool segmentInside(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b);
bool segmentInside(const Region& region, Vec2 a, Vec2 b);

/// segmentInside for each of these segments, which are pairs of indices of points: for many short
/// ones.
bool segmentsInside(const std::vector<Vec2>& polygon, const std::vector<Vec2>& points,
                    const std::vector<std::array<uint32_t, 2>>& segments);

/// The edges of a region that segments within a box can meet: for many segments in a small part of
/// it.
class NearEdges {
 public:
  NearEdges(const Region& region, const Box2& box);
  /// Those of others that a smaller box leaves.
  void narrow(const NearEdges& others, const Box2& box);
  NearEdges() = default;

  /// segmentInside of the region, for a and b in the box.
  bool isClear(Vec2 a, Vec2 b) const;

 private:
  struct Edge {
    Vec2 p, q;
  };
  void add(const std::vector<Vec2>& polygon);
  bool isNear(const Edge& edge) const;

  Box2 box_;
  std::vector<Edge> edges_;
};

/// And comes nowhere nearer to it than `clearance`, which a and b may not either. O(n).
bool segmentClear(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b, double clearance);

}  // namespace marrow
