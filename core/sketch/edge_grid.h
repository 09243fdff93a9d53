// Which edges come near each other: edges sorted into the cells of a uniform grid.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// An edge is in every cell it touches, with some slack, so that two edges that meet share the cell
/// in which they meet. The cells are as large as the edges are long on average: O(n) memory.
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

  EdgeGrid(const std::vector<Vec2>& points, const std::vector<Edge>& edges);

  uint32_t cellCount() const { return columns_ * rows_; }
  uint32_t cellAt(Vec2 point) const {
    return clampTo((point.y - low_.y) * per_cell_, rows_) * columns_ +
           clampTo((point.x - low_.x) * per_cell_, columns_);
  }
  /// The indices of the edges in a cell, growing.
  Range edgesIn(uint32_t cell) const {
    return {edges_.data() + starts_[cell], edges_.data() + starts_[cell + 1]};
  }

  /// Calls visit(cell) for each cell that the segment ab touches.
  template <typename Visit>
  void forEachCell(Vec2 a, Vec2 b, Visit visit) const {
    const Vec2 from = (a - low_) * per_cell_;
    const Vec2 way = (b - a) * per_cell_;
    const double to_y = from.y + way.y;
    const uint32_t first_row = clampTo(std::min(from.y, to_y) - kSlack, rows_);
    const uint32_t last_row = clampTo(std::max(from.y, to_y) + kSlack, rows_);
    for (uint32_t row = first_row; row <= last_row; ++row) {
      double t0 = 0, t1 = 1;
      if (first_row != last_row) {
        t0 = (row - kSlack - from.y) / way.y;
        t1 = (row + 1 + kSlack - from.y) / way.y;
        if (t0 > t1) std::swap(t0, t1);
        t0 = std::max(t0, 0.0);
        t1 = std::min(t1, 1.0);
      }
      const double x0 = from.x + t0 * way.x, x1 = from.x + t1 * way.x;
      const uint32_t first = clampTo(std::min(x0, x1) - kSlack, columns_);
      const uint32_t last = clampTo(std::max(x0, x1) + kSlack, columns_);
      for (uint32_t column = first; column <= last; ++column) visit(row * columns_ + column);
    }
  }

 private:
  static constexpr double kSlack = 1e-6;  // in cells; far above the rounding of the lines above

  static uint32_t clampTo(double value, uint32_t count) {
    return value <= 0 ? 0 : static_cast<uint32_t>(std::min(value, count - 1.0));
  }

  Vec2 low_;
  double per_cell_ = 1;
  uint32_t columns_ = 1, rows_ = 1;
  std::vector<uint32_t> starts_, edges_;
};

}  // namespace marrow
