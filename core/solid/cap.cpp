#include "solid/cap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.h"
#include "sketch/polygon.h"
#include "surface/constrained_delaunay.h"

namespace marrow {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;  // indices of the loop

constexpr double kFlat = 0.1;   // of the hole's size
constexpr double kLine = 1e-6;  // of the hole's size
constexpr size_t kShort = 64;   // corners
constexpr size_t kMostCorners = 4000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The cap of least area, for a few corners [Barequet & Sharir 1995].
Triangles leastArea(const std::vector<Vec3>& points) {
  const size_t n = points.size();
  std::vector<double> best(n * n, 0);
  std::vector<size_t> apex(n * n, 0);
  for (size_t span = 2; span < n; ++span) {
    for (size_t i = 0; i + span < n; ++i) {
      const size_t j = i + span;
      double least = kInfinity;
      for (size_t k = i + 1; k < j; ++k) {
        const double area = length(cross(points[k] - points[i], points[j] - points[i]));
        const double all = best[i * n + k] + best[k * n + j] + area;
        if (!(all < least)) continue;
        least = all;
        apex[i * n + j] = k;
      }
      best[i * n + j] = least;
    }
  }
  Triangles triangles;
  std::vector<std::pair<size_t, size_t>> todo{{0, n - 1}};
  while (!todo.empty()) {
    const auto [i, j] = todo.back();
    todo.pop_back();
    if (j - i < 2) continue;
    const size_t k = apex[i * n + j];
    triangles.push_back(
        {static_cast<uint32_t>(i), static_cast<uint32_t>(k), static_cast<uint32_t>(j)});
    todo.push_back({i, k});
    todo.push_back({k, j});
  }
  return triangles;
}

/// The cap without area of a hole whose corners lie on a line, there and back; empty for others.
Triangles zip(const std::vector<Vec3>& points, double size) {
  const size_t n = points.size();
  const auto furthest = [&](Vec3 p) {
    size_t found = 0;
    for (size_t i = 1; i < n; ++i) {
      if (distance(points[i], p) > distance(points[found], p)) found = i;
    }
    return found;
  };
  const size_t first = furthest(points[0]), last = furthest(points[first]);
  const Vec3 way = points[last] - points[first];
  if (first == last || !(length(way) > 0)) return {};
  for (const Vec3 p : points) {
    if (!(length(cross(way, p - points[first])) <= kLine * size * length(way))) return {};
  }
  // Two chains from the first corner to the last.
  std::vector<uint32_t> forth, back;
  for (size_t i = first; i != last; i = (i + 1) % n) forth.push_back(static_cast<uint32_t>(i));
  for (size_t i = first; i != last; i = (i + n - 1) % n) back.push_back(static_cast<uint32_t>(i));
  forth.push_back(static_cast<uint32_t>(last));
  back.push_back(static_cast<uint32_t>(last));
  const auto along = [&](uint32_t i) { return dot(points[i] - points[first], way); };
  const auto isBefore = [&](uint32_t i, uint32_t k) { return along(i) < along(k); };
  if (!std::is_sorted(forth.begin(), forth.end(), isBefore)) return {};
  if (!std::is_sorted(back.begin(), back.end(), isBefore)) return {};
  Triangles triangles;
  for (size_t i = 0, k = 0; i + 1 < forth.size() || k + 1 < back.size();) {
    const bool on_forth =
        k + 1 == back.size() || (i + 1 < forth.size() && isBefore(forth[i + 1], back[k + 1]));
    const uint32_t next = on_forth ? forth[i + 1] : back[k + 1];
    if (forth[i] != back[k] && next != forth[i] && next != back[k]) {
      triangles.push_back({forth[i], next, back[k]});
    }
    ++(on_forth ? i : k);
  }
  return triangles;
}

/// Whether a triangle of the cap has a side, other than the loop's own, that is an edge already.
bool meetsMesh(const Edges& edges, const std::vector<uint32_t>& loop, const Triangles& cap) {
  const auto n = static_cast<uint32_t>(loop.size());
  for (const auto& triangle : cap) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      if ((a + 1) % n == b || (b + 1) % n == a) continue;
      if (edges.has(loop[a], loop[b])) return true;
    }
  }
  return false;
}

}  // namespace

Edges edgesOf(const Mesh& mesh) {
  Edges edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    edges.add(a, b);
    edges.add(b, c);
    edges.add(c, a);
  }
  return edges;
}

bool fillHole(Mesh& mesh, const std::vector<uint32_t>& loop, Edges& edges, double small) {
  const size_t n = loop.size();
  if (n < 3 || n > kMostCorners) return false;
  std::vector<Vec3> points;
  Box3 box;
  Vec3 mean;
  for (const uint32_t v : loop) {
    points.push_back(mesh.positions[v]);
    box.include(points.back());
    mean = mean + points.back() / static_cast<double>(n);
  }
  Vec3 normal;  // as long as twice the area
  for (size_t i = 0; i < n; ++i) {
    normal = normal + cross(points[i] - mean, points[(i + 1) % n] - mean);
  }
  const double size = length(box.size()), area = length(normal);
  const Triangles zipped = zip(points, size);
  const bool is_small = size <= small;
  if (!is_small && zipped.empty()) {
    if (!(area > 0)) return false;
    for (const Vec3 p : points) {
      if (!(std::fabs(dot(normal / area, p - mean)) <= kFlat * size)) return false;
    }
  }

  Triangles cap;
  std::vector<Vec2> flat;
  if (area > 0) {
    const Vec3 z = normal / area;
    const Vec3 aside = std::fabs(z.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 x = cross(aside, z) / length(cross(aside, z)), y = cross(z, x);
    for (const Vec3 p : points) flat.push_back({dot(x, p - mean), dot(y, p - mean)});
  }
  ConstrainedDelaunay delaunay;
  if (!zipped.empty()) {
    cap = zipped;
  } else if (n <= kShort) {
    cap = leastArea(points);
  } else if (!flat.empty() && isSimple(flat, 16 * n) && delaunay.start(flat, n)) {
    cap = delaunay.triangles();
  }
  if (cap.size() + 2 == n && !meetsMesh(edges, loop, cap)) {
    for (const auto& [a, b, c] : cap) {
      mesh.triangles.push_back({loop[a], loop[b], loop[c]});
      edges.add(loop[a], loop[b]);
      edges.add(loop[b], loop[c]);
      edges.add(loop[c], loop[a]);
    }
    return true;
  }
  // A fan about the middle shares no side with anything.
  if (flat.empty()) return false;
  for (size_t i = 0; i < n; ++i) {
    if (!(cross(flat[i], flat[(i + 1) % n]) > 0)) return false;
  }
  const auto middle = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.push_back(mean);
  for (size_t i = 0; i < n; ++i) mesh.triangles.push_back({loop[i], loop[(i + 1) % n], middle});
  return true;
}

}  // namespace marrow
