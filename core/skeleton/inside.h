// Does a segment stay inside a polygon?
#pragma once

#include <vector>

#include "base/vec.h"

namespace marrow {

/// What bones must stay in: the polygon, and the outline it was simplified from where there is one.
struct Region {
  const std::vector<Vec2>& polygon;
  const std::vector<Vec2>* outline = nullptr;
};

/// a, b: points inside the polygon. False also where the segment touches the border. O(n).
bool segmentInside(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b);
bool segmentInside(const Region& region, Vec2 a, Vec2 b);

/// The edges of a region that segments within a box can meet: for many segments in a small part of
/// it.
class NearEdges {
 public:
  NearEdges(const Region& region, Vec2 low, Vec2 high);
  /// Those of others that a smaller box leaves.
  void narrow(const NearEdges& others, Vec2 low, Vec2 high);
  NearEdges() = default;

  /// segmentInside of the region, for a and b in the box.
  bool isClear(Vec2 a, Vec2 b) const;

 private:
  struct Edge {
    Vec2 p, q;
  };
  void setBox(Vec2 low, Vec2 high);
  void add(const std::vector<Vec2>& polygon);
  bool isNear(const Edge& edge) const;

  Vec2 low_, high_;
  std::vector<Edge> edges_;
};

/// And comes nowhere nearer to it than `clearance`, which a and b may not either. O(n).
bool segmentClear(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b, double clearance);

}  // namespace marrow
