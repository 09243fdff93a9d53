#include "weights/voxels.h"

#include <algorithm>
#include <array>
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

class Columns {
 public:
  explicit Columns(Voxels& voxels)
      : voxels_(voxels),
        nx_(kPer * voxels.nx),
        ny_(kPer * voxels.ny),
        starts_(static_cast<size_t>(nx_) * static_cast<size_t>(ny_) + 1, 0) {}

  void fill(const std::vector<Corners>& triangles) {
    for (const Corners& triangle : triangles) {
      cross(triangle, [&](size_t column, Crossing) { ++starts_[column + 1]; });
    }
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    std::vector<Crossing> crossings(starts_.back());
    std::vector<uint32_t> ends(starts_.begin(), starts_.end() - 1);
    for (const Corners& triangle : triangles) {
      cross(triangle,
            [&](size_t column, Crossing crossing) { crossings[ends[column]++] = crossing; });
    }
    for (size_t column = 0; column + 1 < starts_.size(); ++column) {
      fillColumn(column, crossings.data() + starts_[column], crossings.data() + ends[column]);
    }
  }

 private:
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

  void fillColumn(size_t column, Crossing* begin, Crossing* end) {
    if (begin == end) return;
    std::sort(begin, end, [](const Crossing& a, const Crossing& b) {
      return a.height != b.height ? a.height < b.height : a.turn > b.turn;
    });
    int all = 0;  // 0 where the mesh is closed; else what winds on for ever does not count
    for (const Crossing* c = begin; c != end; ++c) all += c->turn;
    int winding = 0;
    for (const Crossing* c = begin; c + 1 != end; ++c) {
      winding += c->turn;
      if (winding != 0 && winding != all) fillSpan(column, c[0].height, c[1].height);
    }
  }

  /// Centres z with low ≤ z < high.
  void fillSpan(size_t column, double low, double high) {
    const int x = static_cast<int>(column % static_cast<size_t>(nx_));
    const int y = static_cast<int>(column / static_cast<size_t>(nx_));
    const int end = std::min(kPer * voxels_.nz, static_cast<int>(std::ceil(high - 0.5)));
    for (int z = std::max(0, static_cast<int>(std::ceil(low - 0.5))); z < end; ++z) {
      voxels_.masks[voxels_.cell(x >> 2, y >> 2, z >> 2)] |= uint64_t{1}
                                                             << Voxels::voxelBit(x, y, z);
    }
  }

  Voxels& voxels_;
  int nx_, ny_;
  std::vector<uint32_t> starts_;
};

struct VoxelIndex {
  int x, y, z;
};
VoxelIndex voxelAt(Vec3 p) {
  return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
          static_cast<int>(std::floor(p.z))};
}

/// Voxels that the surface of thin places goes through.
std::vector<VoxelIndex> thinPlaces(const Voxels& voxels, const std::vector<Corners>& triangles) {
  constexpr double kDepth = 1.5;  // the voxel there is inside, or the body is thin
  double volume = 0;              // negative: the mesh is inside out
  for (const auto& [a, b, c] : triangles) volume += dot(a.at, cross(b.at, c.at));
  const double outward = volume < 0 ? -1 : 1;
  std::vector<VoxelIndex> found;
  constexpr std::array<double, 3> kDepths = {0.25, 0.5, 1.0};
  std::array<VoxelIndex, 3> last;  // neighbours mostly say the same
  last.fill({-1, -1, -1});
  for (const Corners& triangle : triangles) {
    const Vec3 a = triangle[0].at, ab = triangle[1].at - a, ac = triangle[2].at - a;
    const Vec3 normal = cross(ab, ac);
    const double size = length(normal);
    if (!(size > 0)) continue;
    const Vec3 inward = normal * (-outward / size);
    const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(ac - ab, ac - ab)}));
    const int steps = 1 + static_cast<int>(longest);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const Vec3 p =
            a + ab * (static_cast<double>(i) / steps) + ac * (static_cast<double>(j) / steps);
        const VoxelIndex below = voxelAt(p + inward * kDepth);
        if (voxels.has(below.x, below.y, below.z)) continue;
        // None that only touches the surface: it might touch another limb's.
        for (size_t k = 0; k < kDepths.size(); ++k) {
          const VoxelIndex at = voxelAt(p + inward * kDepths[k]);
          if (at.x == last[k].x && at.y == last[k].y && at.z == last[k].z) continue;
          last[k] = at;
          found.push_back(at);
        }
      }
    }
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

  Columns(voxels).fill(triangles);
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
