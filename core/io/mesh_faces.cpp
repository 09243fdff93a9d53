// Faces with more than three corners.
#include <algorithm>
#include <cmath>

#include "io/mesh_readers.h"
#include "sketch/polygon.h"
#include "surface/constrained_delaunay.h"

namespace marrow {
namespace {

// Corners of a face. Looking for ears takes the cube of their number.
constexpr size_t kMostForEars = 64, kMostForDelaunay = 4000;

/// Along the largest coordinate of its normal, counter-clockwise.
std::vector<Vec2> projected(const Mesh& mesh, const std::vector<uint32_t>& corners, Vec3 normal) {
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const uint32_t corner : corners) {
    const Vec3 p = mesh.positions[corner];
    Vec2 q;
    if (z >= x && z >= y) {
      q = normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x};
    } else if (y >= x) {
      q = normal.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z};
    } else {
      q = normal.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y};
    }
    flat.push_back(q);
  }
  return flat;
}

/// Finds the corners that can be cut off one by one. Two may be in the same place, where a bridge
/// joins a hole to the border.
class Ears {
 public:
  explicit Ears(const std::vector<Vec2>& flat) : flat_(flat) {
    for (uint32_t i = 0; i < flat.size(); ++i) left_.push_back(i);
  }

  /// Triangles of the polygon's indices.
  std::vector<std::array<uint32_t, 3>> cut() {
    std::vector<std::array<uint32_t, 3>> triangles;
    while (left_.size() > 3) {
      size_t ear = 0;
      while (ear < left_.size() && !isEar(ear)) ++ear;
      if (ear == left_.size()) ear = 0;  // no simple polygon: any cut is as good as another
      triangles.push_back({at(ear + left_.size() - 1), at(ear), at(ear + 1)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  uint32_t at(size_t i) const { return left_[i % left_.size()]; }

  bool isEar(size_t i) const {
    const size_t n = left_.size();
    const Vec2 a = flat_[at(i + n - 1)], b = flat_[at(i)], c = flat_[at(i + 1)];
    if (!(cross(b - a, c - a) > 0)) return false;
    for (size_t k = 2; k + 1 < n; ++k) {
      const Vec2 p = flat_[at(i + k)];
      if (p == a || p == c) continue;  // an edge from there would have to cross one of the ear's
      if (p == b) {
        for (const Vec2 q : {flat_[at(i + k + n - 1)], flat_[at(i + k + 1)]}) {
          if (cross(b - a, q - b) > 0 && cross(c - b, q - b) > 0) return false;
        }
        continue;
      }
      if (cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0) {
        return false;
      }
    }
    return true;
  }

  const std::vector<Vec2>& flat_;
  std::vector<uint32_t> left_;
};

}  // namespace

void addFace(Mesh& mesh, const std::vector<uint32_t>& corners) {
  const size_t n = corners.size();
  if (n < 3) return;
  if (n == 3) {
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const Vec3 first = mesh.positions[corners[0]];
  Vec3 normal;
  for (size_t i = 1; i + 1 < n; ++i) {
    normal =
        normal + cross(mesh.positions[corners[i]] - first, mesh.positions[corners[i + 1]] - first);
  }
  std::vector<std::array<uint32_t, 3>> cut;
  if (n <= kMostForEars) {
    cut = Ears(projected(mesh, corners, normal)).cut();
  } else if (n <= kMostForDelaunay) {
    const std::vector<Vec2> flat = projected(mesh, corners, normal);
    ConstrainedDelaunay delaunay;
    if (isSimple(flat) && delaunay.start(flat, n)) cut = delaunay.triangles();
  }
  for (const auto& [a, b, c] : cut) {
    mesh.triangles.push_back({corners[a], corners[b], corners[c]});
  }
  if (!cut.empty()) return;
  for (size_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
}

}  // namespace marrow
