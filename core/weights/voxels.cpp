#include "weights/voxels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/box.h"

namespace marrow {
namespace {

constexpr int kPer = Voxels::kPerCell;

bool isFinite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The triangles that can be used, by their corners in voxels.
struct Corner {
  Vec3 at;
  uint32_t vertex;
};
using Corners = std::array<Corner, 3>;

/// Where the surface goes through a column of voxels.
struct Crossing {
  double height;
  int turn;  // 1: into the body, −1: out of it
};

/// Columns of voxels along an axis: what the mesh winds around of them. Their own x, y and z are
/// those of space turned on so often that z is along the axis.
class Columns {
 public:
  Columns(Voxels& voxels, int axis)
      : voxels_(voxels),
        axis_(axis),
        nx_(kPer * sizeAlong(axis + 1)),
        ny_(kPer * sizeAlong(axis + 2)),
        nz_(kPer * sizeAlong(axis)),
        starts_(static_cast<size_t>(nx_) * static_cast<size_t>(ny_) + 1, 0) {}

  /// Finds the walls across the columns; where asked to, fills what is inside.
  void scan(const std::vector<Corners>& triangles, bool fills) {
    std::vector<uint64_t>& walls = voxels_.walls[static_cast<size_t>(axis_)];
    walls.assign(voxels_.masks.size(), 0);
    forSpans(triangles, [&](size_t column, int begin, int end, bool is_next) {
      if (is_next) set(walls, column, begin - 1);
      for (int z = begin; fills && z < end; ++z) set(voxels_.masks, column, z);
    });
  }

 private:
  int sizeAlong(int axis) const {
    return axis % 3 == 0 ? voxels_.nx : axis % 3 == 1 ? voxels_.ny : voxels_.nz;
  }
  Corners turnedOn(Corners triangle) const {
    for (Corner& corner : triangle) {
      const Vec3 p = corner.at;
      corner.at = axis_ == 0 ? Vec3{p.y, p.z, p.x} : axis_ == 1 ? Vec3{p.z, p.x, p.y} : p;
    }
    return triangle;
  }

  void set(std::vector<uint64_t>& masks, size_t column, int z) const {
    const int x = static_cast<int>(column % static_cast<size_t>(nx_));
    const int y = static_cast<int>(column / static_cast<size_t>(nx_));
    const std::array<int, 3> at = axis_ == 0   ? std::array<int, 3>{z, x, y}
                                  : axis_ == 1 ? std::array<int, 3>{y, z, x}
                                               : std::array<int, 3>{x, y, z};
    masks[voxels_.cell(at[0] >> 2, at[1] >> 2, at[2] >> 2)] |=
        uint64_t{1} << Voxels::voxelBit(at[0], at[1], at[2]);
  }

  /// Calls found(column, begin, end, is_next) for all runs of voxels that have their centres inside
  /// one after the other; is_next: whether the run begins where the one before it ended, the body
  /// ending and beginning in between.
  template <typename Found>
  void forSpans(const std::vector<Corners>& triangles, Found&& found) {
    for (const Corners& triangle : triangles) {
      cross(turnedOn(triangle), [&](size_t column, Crossing) { ++starts_[column + 1]; });
    }
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    std::vector<Crossing> crossings(starts_.back());
    std::vector<uint32_t> ends(starts_.begin(), starts_.end() - 1);
    for (const Corners& triangle : triangles) {
      cross(turnedOn(triangle),
            [&](size_t column, Crossing crossing) { crossings[ends[column]++] = crossing; });
    }
    for (size_t column = 0; column + 1 < starts_.size(); ++column) {
      spansOf(crossings.data() + starts_[column], crossings.data() + ends[column],
              [&](int begin, int end, bool is_next) { found(column, begin, end, is_next); });
    }
  }

  /// Calls found(column, crossing) for every column whose centre the triangle lies over or under.
  /// Neighbours share an edge's crossings to the last bit, so that no column slips through.
  template <typename Found>
  void cross(const Corners& triangle, Found&& found) const {
    const auto [low, high] = std::minmax({triangle[0].at.y, triangle[1].at.y, triangle[2].at.y});
    const int last = std::min(ny_ - 1, static_cast<int>(std::floor(high)));
    for (int row = std::max(0, static_cast<int>(std::floor(low))); row <= last; ++row) {
      const double y = row + 0.5;
      Vec3 up, down;  // the edges that the row's line meets, by whether they go to larger y
      bool met = false;
      for (size_t i = 0; i < 3; ++i) {
        const Corner *a = &triangle[i], *b = &triangle[(i + 1) % 3];
        const bool upward = a->at.y <= y && y < b->at.y, downward = b->at.y <= y && y < a->at.y;
        if (!upward && !downward) continue;
        met = true;
        if (b->vertex < a->vertex) std::swap(a, b);
        (upward ? up : down) = lerp(a->at, b->at, (y - a->at.y) / (b->at.y - a->at.y));
      }
      if (!met || up.x == down.x) continue;
      const bool top = up.x > down.x;
      const Vec3 left = top ? down : up, right = top ? up : down;
      // Centres x with left ≤ x < right.
      const int end = std::min(nx_, static_cast<int>(std::ceil(right.x - 0.5)));
      for (int x = std::max(0, static_cast<int>(std::ceil(left.x - 0.5))); x < end; ++x) {
        const double t = (x + 0.5 - left.x) / (right.x - left.x);
        found(static_cast<size_t>(x) + static_cast<size_t>(nx_) * static_cast<size_t>(row),
              Crossing{left.z + (right.z - left.z) * t, top ? -1 : 1});
      }
    }
  }

  /// Of one column; the centres z of a run are those with low ≤ z < high.
  template <typename Found>
  void spansOf(Crossing* begin, Crossing* end, Found&& found) const {
    if (begin == end) return;
    std::sort(begin, end, [](const Crossing& a, const Crossing& b) {
      return a.height != b.height ? a.height < b.height : a.turn > b.turn;
    });
    int all = 0;  // 0 where the mesh is closed; else what winds on for ever does not count
    for (const Crossing* c = begin; c != end; ++c) all += c->turn;
    int winding = 0, last = -1;  // where the run before ended
    for (const Crossing* c = begin; c + 1 != end; ++c) {
      winding += c->turn;
      if (winding == 0 || winding == all) continue;
      const double low = c->height;
      while (c + 2 != end && winding + c[1].turn != 0 && winding + c[1].turn != all) {
        winding += (++c)->turn;
      }
      const int first = std::max(0, static_cast<int>(std::ceil(low - 0.5)));
      const int past = std::min(nz_, static_cast<int>(std::ceil(c[1].height - 0.5)));
      if (first >= past) continue;
      found(first, past, first == last);
      last = past;
    }
  }

  Voxels& voxels_;
  int axis_;
  int nx_, ny_, nz_;
  std::vector<uint32_t> starts_;
};

struct VoxelIndex {
  int x, y, z;
};
VoxelIndex voxelAt(Vec3 p) {
  return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
          static_cast<int>(std::floor(p.z))};
}

/// Triangles by the cells that they go through, and whether rays leave the body by them.
class NearTriangles {
 public:
  /// outward: 1, or −1 where the mesh is inside out.
  NearTriangles(const Voxels& voxels, const std::vector<Corners>& triangles, double outward)
      : voxels_(voxels), triangles_(triangles), outward_(outward) {}

  void add(Vec3 point, uint32_t triangle) {
    const VoxelIndex at = voxelAt(point);
    if (!isInGrid(at)) return;
    const size_t cell = voxels_.cell(at.x >> 2, at.y >> 2, at.z >> 2);
    if (!found_.empty() && found_.back() == std::pair{cell, triangle}) return;
    found_.push_back({cell, triangle});
  }
  void finish() {
    starts_.assign(voxels_.masks.size() + 1, 0);
    for (const auto& [cell, triangle] : found_) ++starts_[cell + 1];
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    numbers_.resize(found_.size());
    std::vector<uint32_t> ends(starts_.begin(), starts_.end() - 1);
    for (const auto& [cell, triangle] : found_) numbers_[ends[cell]++] = triangle;
    found_ = {};
  }

  /// Whether a ray, of unit length a voxel, leaves the body before it is that far.
  bool leaves(Vec3 from, Vec3 way, double before) const {
    const Vec3 to = from + way * before;
    const VoxelIndex a = voxelAt(from), b = voxelAt(to);
    if (!isInGrid(a) || !isInGrid(b)) return false;
    // A triangle's points are up to a voxel apart.
    const auto low = [](int one, int other) { return std::max(std::min(one, other) - 1, 0) >> 2; };
    const auto high = [](int one, int other, int cells) {
      return std::min((std::max(one, other) + 1) >> 2, cells - 1);
    };
    for (int z = low(a.z, b.z); z <= high(a.z, b.z, voxels_.nz); ++z) {
      for (int y = low(a.y, b.y); y <= high(a.y, b.y, voxels_.ny); ++y) {
        for (int x = low(a.x, b.x); x <= high(a.x, b.x, voxels_.nx); ++x) {
          const size_t cell = voxels_.cell(x, y, z);
          for (uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
            if (leaves(from, way, before, triangles_[numbers_[i]])) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  bool isInGrid(VoxelIndex at) const {
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < kPer * voxels_.nx &&
           at.y < kPer * voxels_.ny && at.z < kPer * voxels_.nz;
  }
  /// [Möller & Trumbore 1997]
  bool leaves(Vec3 from, Vec3 way, double before, const Corners& triangle) const {
    constexpr double kFacing = 0.2;  // what it only grazes is a sharp edge's other side
    constexpr double kRounding = 1e-6;
    const Vec3 ab = triangle[1].at - triangle[0].at, ac = triangle[2].at - triangle[0].at;
    const Vec3 normal = cross(ab, ac) * outward_;
    if (!(dot(normal, way) > kFacing * length(normal))) return false;
    const Vec3 across = cross(way, ac), apart = from - triangle[0].at, up = cross(apart, ab);
    const double size = dot(ab, across);
    const double u = dot(apart, across) / size, v = dot(way, up) / size, t = dot(ac, up) / size;
    return u >= -kRounding && v >= -kRounding && u + v <= 1 + kRounding && t >= -kRounding &&
           t < before;
  }

  const Voxels& voxels_;
  const std::vector<Corners>& triangles_;
  double outward_;
  std::vector<std::pair<size_t, uint32_t>> found_;
  std::vector<uint32_t> starts_, numbers_;
};

/// Calls found(p) for points of a triangle that are up to a voxel apart.
template <typename Found>
void forPoints(const Corners& triangle, Found&& found) {
  const Vec3 a = triangle[0].at, ab = triangle[1].at - a, ac = triangle[2].at - a;
  const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(ac - ab, ac - ab)}));
  const int steps = 1 + static_cast<int>(longest);
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      found(a + ab * (static_cast<double>(i) / steps) + ac * (static_cast<double>(j) / steps));
    }
  }
}

/// Voxels that the surface of thin places goes through.
std::vector<VoxelIndex> thinPlaces(const Voxels& voxels, const std::vector<Corners>& triangles) {
  constexpr double kDepth = 1.5;  // the voxel there is inside, or the body may be thin
  constexpr double kThin = 2.5;   // voxels; at edges that are only sharp it is more
  struct Place {
    Vec3 point, inward;
  };
  double volume = 0;  // negative: the mesh is inside out
  for (const auto& [a, b, c] : triangles) volume += dot(a.at, cross(b.at, c.at));
  const double outward = volume < 0 ? -1 : 1;
  NearTriangles near(voxels, triangles, outward);
  std::vector<Place> places;
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Vec3 normal = cross(b.at - a.at, c.at - a.at);
    const double size = length(normal);
    if (!(size > 0)) continue;
    const Vec3 inward = normal * (-outward / size);
    forPoints(triangles[t], [&](Vec3 p) {
      near.add(p, t);
      const VoxelIndex below = voxelAt(p + inward * kDepth);
      if (!voxels.has(below.x, below.y, below.z)) places.push_back({p, inward});
    });
  }
  std::vector<VoxelIndex> found;
  if (places.empty()) return found;
  near.finish();
  for (const auto& [p, inward] : places) {
    if (!near.leaves(p, inward, kThin)) continue;
    // None that only touches the surface: it might touch another limb's.
    for (const double depth : {0.25, 0.5, 1.0}) found.push_back(voxelAt(p + inward * depth));
  }
  return found;
}

}  // namespace

Voxels voxelise(const Mesh& mesh, double spacing, Vec3 centre) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  Box3 box;
  const double voxel = spacing / kPer;
  for (const auto& triangle : mesh.triangles) {
    Corners corners;
    bool usable = true;
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t v = triangle[i];
      usable = usable && v < mesh.positions.size();
      if (!usable) break;
      corners[i] = {(mesh.positions[v] - centre) / voxel, v};
      usable = isFinite(corners[i].at);
    }
    if (!usable) continue;
    for (const Corner& corner : corners) box.include(corner.at);
    triangles.push_back(corners);
  }
  Voxels voxels;
  if (box.isEmpty()) return voxels;

  // A cell more than needed all around: nothing that is looked up near the surface is outside.
  const Vec3 low{std::floor(box.low.x / kPer) - 1, std::floor(box.low.y / kPer) - 1,
                 std::floor(box.low.z / kPer) - 1};
  voxels.spacing = spacing;
  voxels.origin = centre + low * spacing;
  voxels.nx = static_cast<int>(std::floor(box.high.x / kPer) - low.x) + 2;
  voxels.ny = static_cast<int>(std::floor(box.high.y / kPer) - low.y) + 2;
  voxels.nz = static_cast<int>(std::floor(box.high.z / kPer) - low.z) + 2;
  voxels.masks.assign(voxels.cell(0, 0, voxels.nz), 0);
  for (Corners& triangle : triangles) {
    for (Corner& corner : triangle) corner.at = corner.at - low * kPer;
  }

  for (int axis = 0; axis < 3; ++axis) Columns(voxels, axis).scan(triangles, axis == 2);
  for (const auto& [x, y, z] : thinPlaces(voxels, triangles)) {
    if (x < 0 || y < 0 || z < 0 || x >= kPer * voxels.nx || y >= kPer * voxels.ny ||
        z >= kPer * voxels.nz) {
      continue;
    }
    voxels.masks[voxels.cell(x >> 2, y >> 2, z >> 2)] |= uint64_t{1} << Voxels::voxelBit(x, y, z);
  }
  return voxels;
}

}  // namespace marrow
