#include "weights/volume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/box.h"
#include "weights/voxels.h"

namespace marrow {
namespace {

constexpr int kPer = Voxels::kPerCell;
constexpr double kMostCells = 128;  // along the longest side of the box

/// The voxels of a cell with one coordinate 0 or 3.
constexpr uint64_t kLowX = 0x1111111111111111, kHighX = kLowX << 3;
constexpr uint64_t kLowY = 0x000f000f000f000f, kHighY = kLowY << 12;
constexpr uint64_t kLowZ = 0x000000000000ffff, kHighZ = kLowZ << 48;

/// The voxels of a cube that can be reached from its lowest one that is inside, through faces that
/// are no walls.
uint64_t flood(uint64_t inside, const Voxels& voxels, size_t cube) {
  const uint64_t x = ~(voxels.walls[0][cube] | kHighX), y = ~(voxels.walls[1][cube] | kHighY),
                 z = ~voxels.walls[2][cube];
  uint64_t reached = inside & (~inside + 1), before = 0;
  while (reached != before) {
    before = reached;
    reached |= (reached & x) << 1 | (reached >> 1 & x) | (reached & y) << 4 | (reached >> 4 & y) |
               (reached & z) << 16 | (reached >> 16 & z);
    reached &= inside;
  }
  return reached;
}

class Sets {
 public:
  explicit Sets(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
  uint32_t find(uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  /// The lower one is found for both.
  void unite(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) {
      parents_[b] = a;
    } else {
      parents_[a] = b;
    }
  }

 private:
  std::vector<uint32_t> parents_;
};

/// Joins the corners that two cells have in common, the second one next to the first along an axis.
void glue(uint32_t a, uint32_t b, uint32_t axis, Sets& corners) {
  for (uint32_t corner = 0; corner < 8; ++corner) {
    if (corner & axis) corners.unite(8 * a + corner, 8 * b + (corner ^ axis));
  }
}

/// Calls found(cell, next, axis) for all cells that touch a neighbour's voxels, the neighbour being
/// the next along the axis: 1, 2 or 4 for x, y or z.
template <typename Found>
void forNeighbours(const Volume& volume, const Voxels& voxels, Found&& found) {
  struct Side {
    const std::vector<uint64_t>& walls;
    size_t cube;  // how far the neighbour is
    uint32_t axis;
    int shift;
    uint64_t low, high;
  };
  const size_t row = static_cast<size_t>(volume.nx), layer = row * static_cast<size_t>(volume.ny);
  const Side sides[] = {{voxels.walls[0], 1, 1, 3, kLowX, kHighX},
                        {voxels.walls[1], row, 2, 12, kLowY, kHighY},
                        {voxels.walls[2], layer, 4, 48, kLowZ, kHighZ}};
  const size_t cubes = volume.starts.size() - 1;
  for (size_t cube = 0; cube < cubes; ++cube) {
    for (uint32_t cell = volume.starts[cube]; cell < volume.starts[cube + 1]; ++cell) {
      // The outermost cubes are empty: nobody's neighbour is on the other side of the grid.
      for (const Side& side : sides) {
        const size_t beside = cube + side.cube;
        const uint64_t face = (volume.masks[cell] & side.high & ~side.walls[cube]) >> side.shift;
        if (!face || beside >= cubes) continue;
        for (uint32_t next = volume.starts[beside]; next < volume.starts[beside + 1]; ++next) {
          if (face & volume.masks[next] & side.low) found(cell, next, side.axis);
        }
      }
    }
  }
}

/// The cells of each cube; no vertices yet.
Volume splitCubes(const Voxels& voxels) {
  Volume volume;
  volume.spacing = voxels.spacing;
  volume.origin = voxels.origin;
  volume.nx = voxels.nx;
  volume.ny = voxels.ny;
  volume.nz = voxels.nz;
  volume.starts.reserve(voxels.masks.size() + 1);
  for (size_t cube = 0; cube < voxels.masks.size(); ++cube) {
    volume.starts.push_back(static_cast<uint32_t>(volume.masks.size()));
    for (uint64_t inside = voxels.masks[cube]; inside;) {
      volume.masks.push_back(flood(inside, voxels, cube));
      inside &= ~volume.masks.back();
    }
  }
  volume.starts.push_back(static_cast<uint32_t>(volume.masks.size()));
  return volume;
}

int bitsOf(uint64_t mask) {
  int count = 0;
  for (; mask; mask &= mask - 1) ++count;
  return count;
}

/// Takes away the cells of pieces of hardly any voxels, which break off sharp edges; not the last.
void dropCrumbs(const Voxels& voxels, Volume& volume) {
  constexpr int kCrumb = 16;  // voxels, a quarter of a cell
  const uint32_t count = static_cast<uint32_t>(volume.masks.size());
  Sets pieces(count);
  forNeighbours(volume, voxels,
                [&](uint32_t cell, uint32_t next, uint32_t) { pieces.unite(cell, next); });
  std::vector<int> sizes(count, 0);
  for (uint32_t cell = 0; cell < count; ++cell) {
    sizes[pieces.find(cell)] += bitsOf(volume.masks[cell]);
  }
  if (count == 0 || *std::max_element(sizes.begin(), sizes.end()) < kCrumb) return;
  uint32_t kept = 0, cell = 0;
  for (size_t cube = 0; cube + 1 < volume.starts.size(); ++cube) {
    volume.starts[cube] = kept;
    for (const uint32_t end = volume.starts[cube + 1]; cell < end; ++cell) {
      if (sizes[pieces.find(cell)] >= kCrumb) volume.masks[kept++] = volume.masks[cell];
    }
  }
  volume.starts.back() = kept;
  volume.masks.resize(kept);
}

Volume meshOfCells(const Voxels& voxels) {
  Volume volume = splitCubes(voxels);
  dropCrumbs(voxels, volume);
  const uint32_t cell_count = static_cast<uint32_t>(volume.masks.size());
  Sets corners(8 * size_t{cell_count}), pieces(cell_count);
  forNeighbours(volume, voxels, [&](uint32_t cell, uint32_t next, uint32_t axis) {
    glue(cell, next, axis, corners);
    pieces.unite(cell, next);
  });

  std::vector<uint32_t> numbers(8 * size_t{cell_count}), piece_numbers(cell_count);
  volume.cells.resize(cell_count);
  const size_t nx = static_cast<size_t>(volume.nx), ny = static_cast<size_t>(volume.ny);
  size_t cube = 0;
  for (uint32_t c = 0; c < cell_count; ++c) {
    while (volume.starts[cube + 1] <= c) ++cube;
    const uint32_t piece = pieces.find(c);
    if (piece == c) piece_numbers[c] = volume.piece_count++;
    const size_t x = cube % nx, y = cube / nx % ny, z = cube / nx / ny;
    for (uint32_t corner = 0; corner < 8; ++corner) {
      const uint32_t own = 8 * c + corner, first = corners.find(own);
      if (first == own) {
        numbers[own] = static_cast<uint32_t>(volume.vertices.size());
        const Vec3 steps{static_cast<double>(x + (corner & 1)),
                         static_cast<double>(y + (corner >> 1 & 1)),
                         static_cast<double>(z + (corner >> 2))};
        volume.vertices.push_back(volume.origin + steps * volume.spacing);
        volume.pieces.push_back(piece_numbers[piece]);
      }
      volume.cells[c][corner] = numbers[first];
    }
  }
  return volume;
}

/// About how many vertices a body of this volume and area has, in cells of this size.
double expected(double volume, double area, double h) { return (volume / h + area) / (h * h); }

/// The size of cells for which that is `target`.
double spacingFor(double volume, double area, double target) {
  double low = 0, high = std::sqrt(area / target) + std::sqrt(volume / target / std::sqrt(area));
  while (expected(volume, area, high) > target) high *= 2;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (expected(volume, area, middle) > target ? low : high) = middle;
  }
  return high;
}

/// The same mesh in a box of longest side 1 around the origin, without what can't be used.
struct Normalised {
  Mesh mesh;
  Vec3 centre;
  double size = 0;  // of the box
  double volume = 0, area = 0;
};

std::optional<Normalised> normalise(const Mesh& mesh) {
  Normalised unit;
  Box3 box;
  for (const auto& triangle : mesh.triangles) {
    bool usable = true;
    for (const uint32_t v : triangle) {
      usable = usable && v < mesh.positions.size() &&
               std::isfinite(dot(mesh.positions[v], Vec3{1, 1, 1}));
    }
    if (!usable) continue;
    for (const uint32_t v : triangle) box.include(mesh.positions[v]);
    unit.mesh.triangles.push_back(triangle);
  }
  if (box.isEmpty()) return {};
  const Vec3 size = box.high / 2 - box.low / 2;
  unit.size = 2 * std::max({size.x, size.y, size.z});
  if (!(unit.size > 0) || !std::isfinite(unit.size)) return {};
  unit.centre = box.low + size;
  unit.mesh.positions.reserve(mesh.positions.size());
  for (const Vec3 p : mesh.positions) {
    unit.mesh.positions.push_back((p - unit.centre) / unit.size);
  }
  for (const auto& [a, b, c] : unit.mesh.triangles) {
    const Vec3 p = unit.mesh.positions[a], q = unit.mesh.positions[b], r = unit.mesh.positions[c];
    unit.volume += dot(p, cross(q, r)) / 6;
    unit.area += length(cross(q - p, r - p)) / 2;
  }
  unit.volume = std::fabs(unit.volume);
  if (!(unit.area > 0) || !std::isfinite(unit.area) || !std::isfinite(unit.volume)) return {};
  return unit;
}

}  // namespace

Result<Volume> makeVolume(const Mesh& mesh, const VolumeOptions& options) {
  const auto unit = normalise(mesh);
  if (!unit) return {Status::meshFailed, "There is no body to spread weights through."};
  Vec3 centre;
  if (options.centre) centre = (*options.centre - unit->centre) / unit->size;
  // Far away it would only cost digits.
  const Vec3 away{std::floor(centre.x + 0.5), std::floor(centre.y + 0.5),
                  std::floor(centre.z + 0.5)};
  if (!(dot(away, away) < 1e6)) centre = {};

  // Not a number is none of both.
  const double target = options.target_vertices > 50 ? std::min(options.target_vertices, 1e5) : 50;
  // Limbs that are thin for the lattice take more; how much is seen when it is there.
  double scale = 1 + 140 / target, spacing = 0;
  Volume volume;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const double next = std::max({spacingFor(scale * unit->volume, scale * unit->area, target),
                                  1 / kMostCells, spacing / 2});
    if (next == spacing) break;
    spacing = next;
    volume = meshOfCells(voxelise(unit->mesh, spacing, centre));
    const double count = static_cast<double>(volume.vertices.size());
    if (std::fabs(count / target - 1) <= 0.12) break;
    scale = count / expected(unit->volume, unit->area, spacing);
  }
  if (volume.cells.empty()) return {Status::meshFailed, "The body holds nothing."};

  for (Vec3& p : volume.vertices) p = unit->centre + p * unit->size;
  volume.origin = unit->centre + volume.origin * unit->size;
  volume.spacing *= unit->size;
  return volume;
}

std::optional<Volume::Place> Volume::locate(Vec3 point, Vec3 inward, int reach) const {
  const double voxel = spacing / kPer;
  const Vec3 at = (inward - origin) / voxel;
  const double far = kPer * 1024;
  if (!(at.x > -far && at.y > -far && at.z > -far && at.x < far && at.y < far && at.z < far)) {
    return {};
  }
  const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y)),
            z = static_cast<int>(std::floor(at.z));
  double best = HUGE_VAL;
  uint32_t found = 0;
  const auto look = [&](int vx, int vy, int vz) {
    if (vx < 0 || vy < 0 || vz < 0 || vx >= kPer * nx || vy >= kPer * ny || vz >= kPer * nz) return;
    const Vec3 apart = Vec3{vx + 0.5, vy + 0.5, vz + 0.5} - at;
    const double d = dot(apart, apart);
    if (!(d < best)) return;
    const size_t cube =
        static_cast<size_t>(vx >> 2) +
        static_cast<size_t>(nx) *
            (static_cast<size_t>(vy >> 2) + static_cast<size_t>(ny) * static_cast<size_t>(vz >> 2));
    const uint64_t bit = uint64_t{1} << Voxels::voxelBit(vx, vy, vz);
    for (uint32_t c = starts[cube]; c < starts[cube + 1]; ++c) {
      if (!(masks[c] & bit)) continue;
      best = d;
      found = c;
    }
  };
  // Shells around the voxel, till none can hold a nearer one.
  for (int r = 0; r <= reach; ++r) {
    const double nearest = r - 0.5;
    if (r > 0 && best < nearest * nearest) break;
    for (int dz = -r; dz <= r; ++dz) {
      for (int dy = -r; dy <= r; ++dy) {
        const bool face = dz == -r || dz == r || dy == -r || dy == r;
        for (int dx = -r; dx <= r; dx += face || r == 0 ? 1 : 2 * r) look(x + dx, y + dy, z + dz);
      }
    }
  }
  if (best == HUGE_VAL) return {};

  const Vec3 low = vertices[cells[found][0]];
  const auto within = [](double t) { return std::min(std::max(t, 0.0), 1.0); };
  const Vec3 t{within((point.x - low.x) / spacing), within((point.y - low.y) / spacing),
               within((point.z - low.z) / spacing)};
  Place place;
  place.cell = found;
  for (uint32_t corner = 0; corner < 8; ++corner) {
    place.shares[corner] =
        (corner & 1 ? t.x : 1 - t.x) * (corner & 2 ? t.y : 1 - t.y) * (corner & 4 ? t.z : 1 - t.z);
  }
  return place;
}

}  // namespace marrow
