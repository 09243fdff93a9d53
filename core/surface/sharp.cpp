#include "surface/sharp.h"

#include <algorithm>
#include <utility>

#include "surface/fans.h"

namespace marrow {
namespace {

constexpr double kSharp = 0.766;      // cosine of 40°
constexpr double kSameNormal = 1e-6;  // 1 − cosine; closer ones share a vertex
constexpr uint32_t kNone = ~0u;

/// Corners of triangles that share a normal.
Sets smoothFans(const Mesh& mesh, const std::vector<Vec3>& faces) {
  // The other vertex of each side and its number, by the lower vertex.
  std::vector<size_t> end(mesh.positions.size() + 1, 0);
  const auto eachSide = [&](const auto& visit) {
    for (uint32_t side = 0; side < 3 * mesh.triangles.size(); ++side) {
      const auto& triangle = mesh.triangles[side / 3];
      const auto [low, high] = std::minmax(triangle[side % 3], triangle[(side + 1) % 3]);
      visit(low, high, side);
    }
  };
  eachSide([&](uint32_t low, uint32_t, uint32_t) { ++end[low + 1]; });
  for (size_t v = 0; v + 1 < end.size(); ++v) end[v + 1] += end[v];
  std::vector<std::pair<uint32_t, uint32_t>> sides(3 * mesh.triangles.size());
  eachSide([&](uint32_t low, uint32_t high, uint32_t side) { sides[end[low]++] = {high, side}; });

  Sets fans(sides.size());
  for (size_t v = 0, begin = 0; v < mesh.positions.size(); begin = end[v++]) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin),
              sides.begin() + static_cast<std::ptrdiff_t>(end[v]));
    for (size_t i = begin + 1; i < end[v]; ++i) {
      const auto [high, one] = sides[i - 1];
      const auto [other_high, other] = sides[i];
      if (high != other_high) continue;
      const Vec3 a = faces[one / 3], b = faces[other / 3];
      const bool flat = dot(a, a) == 0 || dot(b, b) == 0;  // without area there is no turn to see
      if (!flat && dot(a, b) < kSharp) continue;
      fans.join(one, nextSide(other));
      fans.join(nextSide(one), other);
    }
  }
  return fans;
}

}  // namespace

std::vector<std::array<Vec3, 3>> cornerNormals(const Mesh& mesh) {
  std::vector<Vec3> faces;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.positions[i];
    const Vec3 face = cross(mesh.positions[j] - a, mesh.positions[k] - a);
    const double size = length(face);
    faces.push_back(size > 0 ? face / size : Vec3{});
  }
  Sets fans = smoothFans(mesh, faces);
  const Mesh split = splitByFans(mesh, fans);
  const std::vector<Vec3> normals = vertexNormals(split);
  std::vector<std::array<Vec3, 3>> found;
  found.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : split.triangles)
    found.push_back({normals[a], normals[b], normals[c]});
  return found;
}

SplitVertices splitByNormals(const Mesh& mesh,
                             const std::vector<std::array<Vec3, 3>>& corner_normals) {
  SplitVertices split;
  std::vector<uint32_t> first(mesh.positions.size(), kNone);  // copy of each vertex
  std::vector<uint32_t> after;                                // each copy, another one
  split.vertices.reserve(mesh.positions.size());
  split.normals.reserve(mesh.positions.size());
  after.reserve(mesh.positions.size());
  split.triangles.reserve(mesh.triangles.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<uint32_t, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh.triangles[t][k];
      const Vec3 normal = corner_normals[t][k];
      uint32_t copy = first[vertex], last = kNone;
      while (copy != kNone && !(dot(split.normals[copy], normal) > 1 - kSameNormal)) {
        last = copy;
        copy = after[copy];
      }
      if (copy == kNone) {
        copy = static_cast<uint32_t>(split.vertices.size());
        (last == kNone ? first[vertex] : after[last]) = copy;
        split.vertices.push_back(vertex);
        split.normals.push_back(normal);
        after.push_back(kNone);
      }
      corners[k] = copy;
    }
    split.triangles.push_back(corners);
  }
  return split;
}

}  // namespace marrow
