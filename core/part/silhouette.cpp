#include "part/silhouette.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/box.h"
#include "sketch/simplify.h"

namespace marrow {
namespace {

constexpr int kPixels = 1000;            // along the shadow's longer side
constexpr double kTolerance_px = 0.8;    // staircases become lines
constexpr size_t kMostCorners = 20'000;  // of the border, before it is simplified
constexpr double kNearlyAsLong = 0.75;

/// Which pixels' middles the shadow covers, with an empty frame around them.
class Shadow {
 public:
  explicit Shadow(const Mesh& mesh) {
    Box2 box;
    for (const auto& triangle : mesh.triangles) {
      for (const uint32_t v : triangle) box.include(flat(mesh.positions[v]));
    }
    if (box.isEmpty() || !(box.longerSide() > 0)) return;
    pixel_ = box.longerSide() / kPixels;
    const auto count = [&](double size) { return static_cast<int>(std::ceil(size / pixel_)) + 2; };
    columns_ = std::min(count(box.size().x), kPixels + 3);
    rows_ = std::min(count(box.size().y), kPixels + 3);
    low_ = box.low - Vec2{pixel_, pixel_};
    // Where covered runs of each row begin and end, to be summed up.
    std::vector<int> changes(size(), 0);
    for (const auto& [a, b, c] : mesh.triangles) {
      add(flat(mesh.positions[a]), flat(mesh.positions[b]), flat(mesh.positions[c]), changes);
    }
    covered_.assign(size(), 0);
    for (int row = 0; row < rows_; ++row) {
      int depth = 0;
      for (int column = 0; column < columns_; ++column) {
        depth += changes[at(column, row)];
        covered_[at(column, row)] = depth > 0;
      }
    }
  }

  double pixel() const { return pixel_; }

  /// Around the largest piece, counter-clockwise, by the middles of the pixels' sides.
  std::vector<Vec2> border() {
    keepLargestPiece();
    if (covered_.empty()) return {};
    int column = 0, row = 0;
    while (row < rows_ && !covered_[at(column, row)]) {
      if (++column == columns_) column = 0, ++row;
    }
    if (row == rows_) return {};
    // From corner to corner of the pixels, the piece on the left.
    const int first_x = column, first_y = row;
    int x = first_x, y = first_y, dx = 1, dy = 0;
    std::vector<Vec2> points;
    do {
      points.push_back(low_ + Vec2{x + 0.5 * dx, y + 0.5 * dy} * pixel_);
      x += dx;
      y += dy;
      // The pixels ahead, to the left and to the right of the way on.
      const bool left = isCovered(x + (dx - dy - 1) / 2, y + (dy + dx - 1) / 2);
      const bool right = isCovered(x + (dx + dy - 1) / 2, y + (dy - dx - 1) / 2);
      if (!left) {
        std::swap(dx, dy);
        dx = -dx;
      } else if (right) {
        std::swap(dx, dy);
        dy = -dy;
      }
    } while (x != first_x || y != first_y || dx != 1);
    return points;
  }

 private:
  static Vec2 flat(Vec3 p) { return {p.x, p.y}; }
  size_t size() const { return static_cast<size_t>(columns_) * static_cast<size_t>(rows_); }
  size_t at(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns_) + static_cast<size_t>(column);
  }
  bool isCovered(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ && covered_[at(column, row)];
  }

  void add(Vec2 a, Vec2 b, Vec2 c, std::vector<int>& changes) const {
    const auto inPixels = [&](Vec2 p) { return (p - low_) / pixel_ - Vec2{0.5, 0.5}; };
    const Vec2 corners[3] = {inPixels(a), inPixels(b), inPixels(c)};
    const double lowest = std::min({corners[0].y, corners[1].y, corners[2].y});
    const double highest = std::max({corners[0].y, corners[1].y, corners[2].y});
    const int first = std::max(static_cast<int>(std::ceil(lowest)), 0);
    const int last = std::min(static_cast<int>(std::floor(highest)), rows_ - 1);
    for (int row = first; row <= last; ++row) {
      double left = columns_, right = -1;
      for (int k = 0; k < 3; ++k) {
        const Vec2 p = corners[k], q = corners[(k + 1) % 3];
        if (std::min(p.y, q.y) > row || std::max(p.y, q.y) < row) continue;
        const double t = p.y == q.y ? 0 : (row - p.y) / (q.y - p.y);
        for (const double x : {p.x + (q.x - p.x) * t, p.y == q.y ? q.x : p.x + (q.x - p.x) * t}) {
          left = std::min(left, x);
          right = std::max(right, x);
        }
      }
      const int from = std::max(static_cast<int>(std::ceil(left)), 0);
      const int to = std::min(static_cast<int>(std::floor(right)), columns_ - 2);
      if (from > to) continue;
      ++changes[at(from, row)];
      --changes[at(to + 1, row)];
    }
  }

  /// Pixels that share a side belong together; the first of equally large pieces stays.
  void keepLargestPiece() {
    std::vector<int> piece(covered_.size(), 0);
    std::vector<std::pair<int, int>> todo;
    int count = 0, largest = 0;
    size_t most = 0;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (!covered_[at(column, row)] || piece[at(column, row)]) continue;
        piece[at(column, row)] = ++count;
        todo.push_back({column, row});
        size_t pixels = 0;
        while (!todo.empty()) {
          const auto [x, y] = todo.back();
          todo.pop_back();
          ++pixels;
          for (const auto& [i, j] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
            if (!isCovered(i, j) || piece[at(i, j)]) continue;
            piece[at(i, j)] = count;
            todo.push_back({i, j});
          }
        }
        if (pixels <= most) continue;
        most = pixels;
        largest = count;
      }
    }
    for (size_t i = 0; i < covered_.size(); ++i) covered_[i] = covered_[i] && piece[i] == largest;
  }

  double pixel_ = 1;
  int columns_ = 0, rows_ = 0;
  Vec2 low_;
  std::vector<char> covered_;
};

std::vector<Box3> flatBoxes(const Mesh& mesh) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    Box3 box;
    for (const uint32_t v : triangle) {
      box.include(Vec3{mesh.positions[v].x, mesh.positions[v].y, 0});
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

Result<std::vector<Vec2>> silhouetteOf(const Mesh& mesh) {
  Shadow shadow(mesh);
  std::vector<Vec2> border = shadow.border();
  if (border.size() < 8) return Status::noArea;
  // A border as ragged as this is noise; some of its corners say enough.
  if (border.size() > kMostCorners) {
    const size_t step = border.size() / kMostCorners + 1;
    for (size_t i = 0; i * step < border.size(); ++i) border[i] = border[i * step];
    border.resize((border.size() + step - 1) / step);
  }
  std::vector<Vec2> outline;
  for (const uint32_t i : simplify(border, kTolerance_px * shadow.pixel()))
    outline.push_back(border[i]);
  return outline;
}

DepthRays::DepthRays(const Mesh& mesh) : mesh_(mesh), tree_(flatBoxes(mesh)) {}

std::optional<DepthSpan> DepthRays::at(Vec2 p) const {
  // Of an edge, both triangles must say the same.
  const auto side = [&](uint32_t a, uint32_t b) {
    const Vec3 low = mesh_.positions[std::min(a, b)], high = mesh_.positions[std::max(a, b)];
    const double s = cross(Vec2{high.x - low.x, high.y - low.y}, Vec2{p.x - low.x, p.y - low.y});
    return (s >= 0) == (a < b);
  };
  struct Hit {
    double z;
    int step;  // +1: into the body
  };
  std::vector<Hit> hits;
  Box3 place;
  place.include(Vec3{p.x, p.y, 0});
  tree_.pairs(BoxTree({place}), [&](uint32_t triangle, uint32_t) {
    const auto [i, j, k] = mesh_.triangles[triangle];
    const bool left = side(i, j);
    if (side(j, k) != left || side(k, i) != left) return;
    const Vec3 a = mesh_.positions[i], b = mesh_.positions[j], c = mesh_.positions[k];
    const Vec3 normal = cross(b - a, c - a);
    if (normal.z == 0) return;
    const double z = a.z - (normal.x * (p.x - a.x) + normal.y * (p.y - a.y)) / normal.z;
    const double low = std::min({a.z, b.z, c.z}), high = std::max({a.z, b.z, c.z});
    hits.push_back({std::clamp(z, low, high), left ? -1 : 1});
  });
  std::sort(hits.begin(), hits.end(),
            [](const Hit& a, const Hit& b) { return a.z != b.z ? a.z < b.z : a.step > b.step; });
  std::vector<DepthSpan> spans;
  int inside = 0;
  for (const Hit& hit : hits) {
    if (inside == 0 && hit.step > 0) spans.push_back({hit.z, hit.z});
    inside += hit.step;
    if (!spans.empty()) spans.back().high = hit.z;
    inside = std::max(inside, 0);
  }
  double longest = 0;
  for (const DepthSpan& span : spans) longest = std::max(longest, span.half());
  for (size_t i = spans.size(); i-- > 0;) {
    if (spans[i].half() > 0 && spans[i].half() >= kNearlyAsLong * longest) return spans[i];
  }
  return std::nullopt;
}

}  // namespace marrow
