#include "sketch/edge_grid.h"

namespace marrow {

EdgeGrid::EdgeGrid(const std::vector<Vec2>& points, const std::vector<Edge>& edges,
                   double cells_per_edge) {
  Vec2 high;
  low_ = high = points.empty() ? Vec2{} : points[0];
  for (const Vec2& p : points) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double total_length = 0;
  for (const Edge& e : edges) total_length += distance(points[e[0]], points[e[1]]);

  const Vec2 size = high - low_;
  const double count = std::max<double>(1, static_cast<double>(edges.size()));
  const double cell =
      std::max({std::sqrt(size.x) * std::sqrt(size.y) / std::sqrt(2 * count),
                std::max(size.x, size.y) / (2 * count), total_length / (cells_per_edge * count)});
  if (cell > 0) {
    per_cell_ = 1 / cell;
    columns_ = static_cast<int>(size.x * per_cell_) + 1;
    rows_ = static_cast<int>(size.y * per_cell_) + 1;
  }

  starts_.assign(cellCount() + 1, 0);
  for (const Edge& e : edges) {
    walk(points[e[0]], points[e[1]], [&](uint32_t cell_index, double) {
      ++starts_[cell_index];
      return true;
    });
  }
  uint32_t sum = 0;
  for (uint32_t& start : starts_) start = (sum += start);
  edges_.resize(sum);
  for (size_t i = edges.size(); i-- > 0;) {
    walk(points[edges[i][0]], points[edges[i][1]], [&](uint32_t cell_index, double) {
      edges_[--starts_[cell_index]] = static_cast<uint32_t>(i);
      return true;
    });
  }
}

}  // namespace marrow
