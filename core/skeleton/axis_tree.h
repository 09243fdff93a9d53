// The inner arcs of a straight skeleton as a tree, and what each arc's side adds to the shape.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "skeleton/straight_skeleton.h"

namespace marrow {

/// Seen from the node with the largest ball.
class AxisTree {
 public:
  static constexpr uint32_t kNone = 0xFFFFFFFF;

  struct Node {
    Vec2 point;
    double radius = 0;  // inscribed
    uint32_t parent = kNone;
    double to_parent = 0;
    double tip = 0;                   // the longest arc from here to a convex corner of the polygon
    double reach = 0;                 // the longest way to such a corner, away from the root
    uint32_t onward = kNone;          // the child on that way; none: an arc to a corner
    Vec2 corner;                      // where that way ends
    uint32_t first = 0, count = 0;    // of `around`
    uint32_t before = 0, behind = 0;  // border edges beside the arc from the parent, ccw around it
  };

  /// polygon: what the skeleton is of; has to outlive the tree.
  AxisTree(const std::vector<Vec2>& polygon, const StraightSkeleton& skeleton);

  uint32_t root() const { return order_.front(); }
  const Node& operator[](uint32_t i) const { return nodes_[i]; }

  struct Range {
    const uint32_t *from, *to;
    const uint32_t* begin() const { return from; }
    const uint32_t* end() const { return to; }
  };
  /// Its children and its parent.
  Range neighbours(uint32_t i) const {
    const uint32_t* first = around_.data() + nodes_[i].first;
    return {first, first + nodes_[i].count};
  }

  /// How far the child's side reaches beyond the ball of its parent.
  double proud(uint32_t child) const {
    const Node& node = nodes_[child];
    return node.to_parent + node.reach - nodes_[node.parent].radius;
  }

  /// How much of a limb of its own the child's side is: 1 and more where it is one. By how far it
  /// reaches beyond the ball of its parent, against the shape's size and the ball's, and by how far
  /// it bulges beyond the tangents to that ball where it leaves it: the corner of a block reaches
  /// far and bulges not at all, a blunt limb reaches less far and bulges. O(border of that side).
  double significance(uint32_t child) const;

  /// From now on limbs that had these ends count for more, and what was no limb for less. O(ends ×
  /// nodes). To be said before significance is asked for.
  void remember(const std::vector<Vec2>& ends);

 private:
  void addArcs(const StraightSkeleton& skeleton);
  void grow(const StraightSkeleton& skeleton);
  double bulge(uint32_t child) const;

  const std::vector<Vec2>& polygon_;
  double size_ = 0;  // of the shape: about its diameter
  std::vector<Node> nodes_;
  std::vector<uint32_t> around_, arcs_;       // neighbours, and the skeleton's edges to them
  std::vector<uint32_t> order_;               // parents before children
  std::vector<double> memory_;                // by node: what its significance is multiplied by
  mutable std::vector<double> significance_;  // by node; below 0: not asked for yet
};

}  // namespace marrow
