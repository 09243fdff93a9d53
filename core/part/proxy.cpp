#include "part/proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/box.h"

namespace marrow {
namespace {

// Of a cut through a junction only this many inscribed radii to either side count: beyond, the
// plane runs along another limb.
constexpr double kSideReach = 1.5;
constexpr int kMostCells = 64;  // per side of the grid

/// Finds triangles near a place: buckets by where the middle of a triangle is, seen from above.
class TriangleGrid {
 public:
  explicit TriangleGrid(const Mesh& mesh) {
    Box2 box;
    for (const Vec3& p : mesh.positions) box.include(Vec2{p.x, p.y});
    origin_ = box.low;
    const double width = box.size().x, height = box.size().y;
    const size_t count = mesh.triangles.size();
    const double wanted = std::sqrt(width * height / (0.25 * static_cast<double>(count)));
    cell_ = std::max(wanted, std::max(width, height) / kMostCells);
    if (!(cell_ > 0)) cell_ = 1;
    columns_ = static_cast<size_t>(width / cell_) + 1;
    rows_ = static_cast<size_t>(height / cell_) + 1;

    std::vector<uint32_t> cells(count);
    starts_.assign(columns_ * rows_ + 1, 0);
    Vec2 largest;
    for (size_t t = 0; t < count; ++t) {
      const auto& triangle = mesh.triangles[t];
      const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]],
                 &c = mesh.positions[triangle[2]];
      const Box2 triangle_box = boxOf(std::array{Vec2{a.x, a.y}, Vec2{b.x, b.y}, Vec2{c.x, c.y}});
      largest = most(largest, triangle_box.size());
      const Vec2 middle = triangle_box.middle() - origin_;
      const size_t column = static_cast<size_t>(middle.x / cell_);
      const size_t row = static_cast<size_t>(middle.y / cell_);
      cells[t] = static_cast<uint32_t>(row * columns_ + column);
      ++starts_[cells[t] + 1];
    }
    half_ = (largest + Vec2{cell_, cell_}) * 0.5;
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    items_.resize(count);
    std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (size_t t = 0; t < count; ++t) items_[next[cells[t]]++] = static_cast<uint32_t>(t);
  }

  /// Calls `visit` with every triangle that may meet the segment that goes from `point` by `reach`
  /// to either side across the unit vector `normal`.
  template <typename Visit>
  void forEachNear(Vec2 point, Vec2 normal, double reach, Visit visit) const {
    const double across = half_.x * std::abs(normal.x) + half_.y * std::abs(normal.y);
    const double along = half_.x * std::abs(normal.y) + half_.y * std::abs(normal.x) + reach;
    for (size_t row = 0; row < rows_; ++row) {
      const double y = origin_.y + (static_cast<double>(row) + 0.5) * cell_ - point.y;
      const double x = origin_.x + 0.5 * cell_ - point.x;
      double first = 0, last = static_cast<double>(columns_) - 1;
      narrow(normal.x * cell_, normal.x * x + normal.y * y, across, first, last);
      narrow(-normal.y * cell_, -normal.y * x + normal.x * y, along, first, last);
      if (!(first <= last)) continue;
      const size_t from = starts_[row * columns_ + static_cast<size_t>(first)];
      const size_t to = starts_[row * columns_ + static_cast<size_t>(last) + 1];
      for (size_t i = from; i < to; ++i) visit(items_[i]);
    }
  }

 private:
  /// Keeps the columns c with |slope · c + offset| ≤ limit.
  static void narrow(double slope, double offset, double limit, double& first, double& last) {
    if (std::abs(slope) * (last + 1) < 1e-9 * limit) {
      if (std::abs(offset) > 1.01 * limit) last = -1;
      return;
    }
    const double a = (-limit - offset) / slope, b = (limit - offset) / slope;
    first = std::max(first, std::ceil(std::min(a, b) - 1e-6));
    last = std::min(last, std::floor(std::max(a, b) + 1e-6));
  }

  Vec2 origin_, half_;  // half_: how far a triangle goes beyond the middle of its cell
  double cell_;
  size_t columns_, rows_;
  std::vector<uint32_t> starts_, items_;
};

/// Cuts a mesh by vertical planes.
class Slicer {
 public:
  explicit Slicer(const Mesh& mesh) : mesh_(mesh), grid_(mesh) {}

  /// The mean distance from `point` to the part of the contour around it that is no further than
  /// `reach` to either side; 0 where no contour is around it.
  double meanDistance(Vec2 point, Vec2 normal, double reach) {
    collect(point, normal, reach);
    link();
    const double far = std::numeric_limits<double>::infinity();
    uint32_t above = kNone, below = kNone;
    double nearest_above = far, nearest_below = far;
    for (uint32_t i = 0; i < pieces_.size(); ++i) {
      const Vec2 a = pieces_[i].from, b = pieces_[i].to;
      if ((a.x < 0) == (b.x < 0)) continue;
      const double height = -cross(a, b) / (b.x - a.x);
      if (height >= 0 && height < nearest_above) {
        above = i;
        nearest_above = height;
      } else if (height < 0 && -height < nearest_below) {
        below = i;
        nearest_below = -height;
      }
    }
    if (above == kNone || below == kNone) return 0;
    // Inside the solid, the contour runs to the left above the point and to the right below it.
    if (pieces_[above].to.x > pieces_[above].from.x) return 0;
    if (pieces_[below].to.x < pieces_[below].from.x) return 0;

    Sum sum;
    for (const uint32_t start : {above, below}) {
      for (uint32_t i = start; i != kNone; i = find(pieces_[i].to_edge).leaving) {
        if (!add(pieces_[i], reach, sum)) break;
      }
      for (uint32_t i = find(pieces_[start].from_edge).arriving; i != kNone;
           i = find(pieces_[i].from_edge).arriving) {
        if (!add(pieces_[i], reach, sum)) break;
      }
    }
    return sum.weight > 0 ? sum.weighted / sum.weight : 0;
  }

 private:
  /// What a triangle adds to the contour, in the plane's frame around the point: x to the side,
  /// y up. The solid is on its left.
  struct Piece {
    Vec2 from, to;
    uint64_t from_edge = 0, to_edge = 0;  // of the mesh
    bool seen = false;
  };
  /// A mesh edge that the plane cuts.
  struct Crossing {
    uint64_t edge = kNoEdge;
    uint32_t arriving = kNone, leaving = kNone;
  };
  struct Sum {
    double weighted = 0, weight = 0;
  };
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  static constexpr uint64_t kNoEdge = ~uint64_t{0};

  void collect(Vec2 point, Vec2 normal, double reach) {
    pieces_.clear();
    const Vec2 side = perpendicular(normal);
    grid_.forEachNear(point, normal, reach, [&](uint32_t t) {
      const auto& triangle = mesh_.triangles[t];
      double ahead[3];
      for (int k = 0; k < 3; ++k) {
        const Vec3& p = mesh_.positions[triangle[k]];
        ahead[k] = normal.x * (p.x - point.x) + normal.y * (p.y - point.y);
      }
      if ((ahead[0] >= 0) == (ahead[1] >= 0) && (ahead[1] >= 0) == (ahead[2] >= 0)) return;
      Piece piece;
      for (int k = 0; k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        if ((ahead[k] >= 0) == (ahead[next] >= 0)) continue;
        // Always from the lower index, so that both triangles of an edge find the same place.
        const bool forward = triangle[k] < triangle[next];
        const int low = forward ? k : next, high = forward ? next : k;
        const Vec3& p = mesh_.positions[triangle[low]];
        const Vec3& q = mesh_.positions[triangle[high]];
        const Vec3 at = p + (q - p) * (ahead[low] / (ahead[low] - ahead[high]));
        const Vec2 place{side.x * (at.x - point.x) + side.y * (at.y - point.y), at.z};
        const uint64_t edge = static_cast<uint64_t>(triangle[low]) << 32 | triangle[high];
        (ahead[k] >= 0 ? piece.from : piece.to) = place;
        (ahead[k] >= 0 ? piece.from_edge : piece.to_edge) = edge;
      }
      if (std::min(piece.from.x, piece.to.x) > reach) return;
      if (std::max(piece.from.x, piece.to.x) < -reach) return;
      pieces_.push_back(piece);
    });
  }

  /// Where `edge` is in the table, or the free place for it.
  size_t slotOf(uint64_t edge) const {
    size_t slot = static_cast<size_t>((edge * 0x9E3779B97F4A7C15u) >> 32) & (table_.size() - 1);
    while (table_[slot].edge != edge && table_[slot].edge != kNoEdge) {
      slot = (slot + 1) & (table_.size() - 1);
    }
    return slot;
  }
  const Crossing& find(uint64_t edge) const { return table_[slotOf(edge)]; }

  void link() {
    size_t size = 16;
    while (size < 3 * pieces_.size()) size *= 2;
    table_.assign(size, Crossing{});
    for (uint32_t i = 0; i < pieces_.size(); ++i) {
      Crossing& from = table_[slotOf(pieces_[i].from_edge)];
      from.edge = pieces_[i].from_edge;
      from.leaving = i;
      Crossing& to = table_[slotOf(pieces_[i].to_edge)];
      to.edge = pieces_[i].to_edge;
      to.arriving = i;
    }
  }

  /// a, moved towards b where it is further to the side than `reach`.
  static Vec2 shortened(Vec2 a, Vec2 b, double reach) {
    const double limit = std::clamp(a.x, -reach, reach);
    return limit == a.x ? a : lerp(a, b, (limit - a.x) / (b.x - a.x));
  }

  /// False where the piece was counted before.
  static bool add(Piece& piece, double reach, Sum& sum) {
    if (piece.seen) return false;
    piece.seen = true;
    const Vec2 a = shortened(piece.from, piece.to, reach);
    const Vec2 b = shortened(piece.to, piece.from, reach);
    const double weight = distance(a, b);
    sum.weighted += weight * 0.5 * (length(a) + length(b));
    sum.weight += weight;
    return true;
  }

  const Mesh& mesh_;
  TriangleGrid grid_;
  std::vector<Piece> pieces_;
  std::vector<Crossing> table_;
};

}  // namespace

std::vector<double> proxyRadii(const PartSkeleton& skeleton, const Mesh& mesh) {
  const auto& joints = skeleton.joints;
  std::vector<double> sums(joints.size()), counts(joints.size());
  if (!mesh.triangles.empty()) {
    Slicer slicer(mesh);
    for (const auto& bone : skeleton.bones) {
      const Vec2 along = joints[bone[1]].position - joints[bone[0]].position;
      if (!(dot(along, along) > 0)) continue;
      for (const uint32_t end : bone) {
        const double mean = slicer.meanDistance(joints[end].position, along / length(along),
                                                kSideReach * joints[end].radius);
        if (!(mean > 0)) continue;
        sums[end] += mean;
        counts[end] += 1;
      }
    }
  }
  std::vector<double> radii(joints.size());
  for (size_t i = 0; i < joints.size(); ++i) {
    radii[i] = counts[i] > 0 ? sums[i] / counts[i] : joints[i].radius;
  }
  return radii;
}

}  // namespace marrow
