// Closed meshes for the tests of volumes and weights, made without sines, so that every platform
// makes the same ones.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "document/evaluation.h"
#include "support/creatures.h"
#include "surface/mesh.h"
#include "weights/handles.h"

namespace marrow {

inline void append(Mesh& mesh, const Mesh& other) {
  const uint32_t first = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

template <typename Map>
Mesh mapped(Mesh mesh, Map&& map) {
  for (Vec3& p : mesh.positions) p = map(p);
  return mesh;
}

inline Mesh insideOut(Mesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

inline Mesh box(Vec3 low, Vec3 high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(
        {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  for (const auto& [a, b, c, d] : {std::array<uint32_t, 4>{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

/// Around a polyline without sharp turns; the ends are flat, half a radius beyond the last points.
inline Mesh tube(std::vector<Vec3> middle, double radius, int sides = 12) {
  const size_t n = middle.size();
  const auto unit = [](Vec3 v) { return v / length(v); };
  middle.front() = middle.front() - unit(middle[1] - middle[0]) * (radius / 2);
  middle.back() = middle.back() + unit(middle[n - 1] - middle[n - 2]) * (radius / 2);
  const std::vector<Vec2> circle = unitCircle(sides);
  const uint32_t count = static_cast<uint32_t>(circle.size());
  Mesh mesh;
  Vec3 side{0.36, 0.48, 0.8};
  for (size_t i = 0; i < n; ++i) {
    const Vec3 along = unit(middle[std::min(i + 1, n - 1)] - middle[i > 0 ? i - 1 : 0]);
    side = unit(side - along * dot(side, along));
    const Vec3 up = cross(along, side);
    for (const Vec2 p : circle) {
      mesh.positions.push_back(middle[i] + (side * p.x + up * p.y) * radius);
    }
  }
  const auto at = [&](size_t ring, uint32_t i) {
    return static_cast<uint32_t>(ring) * count + i % count;
  };
  for (size_t ring = 0; ring + 1 < n; ++ring) {
    for (uint32_t i = 0; i < count; ++i) {
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  for (const size_t ring : {size_t{0}, n - 1}) {
    const uint32_t centre = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.push_back(middle[ring]);
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t a = at(ring, i), b = at(ring, i + 1);
      mesh.triangles.push_back(ring == 0 ? std::array<uint32_t, 3>{centre, b, a}
                                         : std::array<uint32_t, 3>{centre, a, b});
    }
  }
  return mesh;
}

/// Points from a to b, both among them.
inline std::vector<Vec3> straight(Vec3 a, Vec3 b, int steps) {
  std::vector<Vec3> points;
  for (int i = 0; i <= steps; ++i) points.push_back(lerp(a, b, static_cast<double>(i) / steps));
  return points;
}

/// One bone from each point to the next.
inline std::vector<Segment> chain(const std::vector<Vec3>& points) {
  std::vector<Segment> bones;
  for (size_t i = 0; i + 1 < points.size(); ++i) bones.push_back({points[i], points[i + 1]});
  return bones;
}

/// All parts of a character, as they lie in each other.
inline Mesh bodyOf(const Evaluation& character) {
  Mesh body;
  for (const PlacedPart& placed : character.placed()) {
    const EvaluatedPart& part = character.parts()[placed.source];
    if (!part.part) continue;
    append(body, mapped(part.part->mesh, [&](Vec3 p) { return placed.frame.toWorld(p); }));
  }
  return body;
}

}  // namespace marrow
