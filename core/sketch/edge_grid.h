// Which edges come near each other: edges sorted into the cells of a uniform grid.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// An edge is in every cell it touches, with some slack, so that two edges that meet share the cell
/// in which they meet.
class EdgeGrid {
 public:
  using Edge = std::array<uint32_t, 2>;  // indices of its two ends in the points

  struct Range {
    const uint32_t* first;
    const uint32_t* last;
    const uint32_t* begin() const { return first; }
    const uint32_t* end() const { return last; }
    size_t size() const { return static_cast<size_t>(last - first); }
    uint32_t operator[](size_t i) const { return first[i]; }
  };

  /// cells_per_edge: about how many cells an edge is in, at most; O(n) memory.
  EdgeGrid(const std::vector<Vec2>& points, const std::vector<Edge>& edges,
           double cells_per_edge = 4);

  uint32_t cellCount() const { return static_cast<uint32_t>(columns_ * rows_); }
  uint32_t cellAt(Vec2 point) const {
    return static_cast<uint32_t>(clampTo((point.y - low_.y) * per_cell_, rows_) * columns_ +
                                 clampTo((point.x - low_.x) * per_cell_, columns_));
  }
  /// The indices of the edges in a cell, growing.
  Range edgesIn(uint32_t cell) const {
    return {edges_.data() + starts_[cell], edges_.data() + starts_[cell + 1]};
  }

  /// Calls visit(cell, left_at) for each cell that the segment ab touches, in order from a to b,
  /// while it returns true. left_at: where the segment leaves the cell, 0 at a, 1 at b; not a
  /// number where it runs along the cell's border.
  template <typename Visit>
  void walk(Vec2 a, Vec2 b, Visit visit) const {
    const Vec2 from = (a - low_) * per_cell_;
    const Vec2 way = (b - a) * per_cell_;
    const double to_y = from.y + way.y;
    const int first_row = clampTo((way.y < 0 ? from.y + kSlack : from.y - kSlack), rows_);
    const int last_row = clampTo((way.y < 0 ? to_y - kSlack : to_y + kSlack), rows_);
    const int row_step = way.y < 0 ? -1 : 1, column_step = way.x < 0 ? -1 : 1;
    for (int row = first_row; row != last_row + row_step; row += row_step) {
      double t0 = 0, t1 = 1, row_left_at = 2;
      if (first_row != last_row) {
        t0 = (row - kSlack - from.y) / way.y;
        t1 = (row + 1 + kSlack - from.y) / way.y;
        if (t0 > t1) std::swap(t0, t1);
        t0 = std::max(t0, 0.0);
        t1 = std::min(t1, 1.0);
        if (row != last_row) row_left_at = (row + (row_step > 0 ? 1 : 0) - from.y) / way.y;
      }
      const double x0 = from.x + t0 * way.x, x1 = from.x + t1 * way.x;
      const int first = clampTo(way.x < 0 ? x0 + kSlack : x0 - kSlack, columns_);
      const int last = clampTo(way.x < 0 ? x1 - kSlack : x1 + kSlack, columns_);
      for (int column = first; column != last + column_step; column += column_step) {
        double left_at = row_left_at;
        if (column != last) {
          left_at = std::min(left_at, (column + (column_step > 0 ? 1 : 0) - from.x) / way.x);
        }
        if (!visit(static_cast<uint32_t>(row * columns_ + column), left_at)) return;
      }
    }
  }

 private:
  static constexpr double kSlack = 1e-6;  // in cells; far above the rounding of the lines above

  static int clampTo(double value, int count) {
    return value <= 0 ? 0 : static_cast<int>(std::min(value, count - 1.0));
  }

  Vec2 low_;
  double per_cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<uint32_t> starts_, edges_;
};

}  // namespace marrow
