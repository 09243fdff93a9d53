// Closed meshes for tests of everything that merges them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/box.h"
#include "base/frame.h"
#include "solid/merge.h"
#include "support/meshes.h"
#include "support/random.h"

namespace marrow {

inline Mesh boxMesh(Vec3 low, Vec3 high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(
        {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

/// A box whose faces are grids of squares.
inline Mesh gridBoxMesh(Vec3 low, Vec3 high, int steps) {
  Mesh mesh;
  std::map<std::array<int, 3>, uint32_t> known;
  const auto at = [&](const std::array<int, 3>& place) {
    const auto [it, is_new] =
        known.try_emplace(place, static_cast<uint32_t>(mesh.positions.size()));
    const Vec3 size = high - low;
    if (is_new) {
      mesh.positions.push_back(low + Vec3{size.x * place[0], size.y * place[1], size.z * place[2]} /
                                         static_cast<double>(steps));
    }
    return it->second;
  };
  for (size_t axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < steps; ++i) {
      for (int k = 0; k < steps; ++k) {
        for (const int side : {0, steps}) {
          const auto corner = [&](int u, int v) {
            std::array<int, 3> place{};
            place[axis] = side;
            place[(axis + 1) % 3] = u;
            place[(axis + 2) % 3] = v;
            return at(place);
          };
          const uint32_t a = corner(i, k), b = corner(i + 1, k), c = corner(i + 1, k + 1),
                         d = corner(i, k + 1);
          if (side == 0) {
            mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
          } else {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
          }
        }
      }
    }
  }
  return mesh;
}

/// An octahedron whose triangles were divided in four `levels` times.
inline Mesh sphereMesh(Vec3 centre, double radius, int levels) {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto [it, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                    static_cast<uint32_t>(mesh.positions.size()));
      if (is_new) {
        const Vec3 sum = mesh.positions[a] + mesh.positions[b];
        mesh.positions.push_back(sum / length(sum));
      }
      return it->second;
    };
    std::vector<std::array<uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Vec3& p : mesh.positions) p = centre + p * radius;
  return mesh;
}

/// A ring around z.
inline Mesh torusMesh(Vec3 centre, double radius, double thickness, int around, int across) {
  Mesh mesh;
  const auto at = [&](int i, int j) {
    return static_cast<uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2 * kPi * i / around, b = 2 * kPi * j / across;
      const double far = radius + thickness * std::cos(b);
      mesh.positions.push_back(centre +
                               Vec3{far * std::cos(a), far * std::sin(a), thickness * std::sin(b)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

template <typename Map>
Mesh mapped(Mesh mesh, const Map& map) {
  for (Vec3& p : mesh.positions) p = map(p);
  return mesh;
}

inline Mesh moved(const Mesh& mesh, Vec3 by) {
  return mapped(mesh, [by](Vec3 p) { return p + by; });
}

/// Its triangles face inward.
inline Mesh mirroredInX(const Mesh& mesh) {
  return mapped(mesh, [](Vec3 p) { return Vec3{-p.x, p.y, p.z}; });
}

/// With ids 0, 1, 2 …
inline MergedMesh merged(const std::vector<Mesh>& meshes, const MergeOptions& options = {}) {
  std::vector<SolidInput> inputs;
  for (const Mesh& mesh : meshes) {
    inputs.push_back({&mesh, {}, static_cast<uint32_t>(inputs.size())});
  }
  return mergeSolids(inputs, options);
}

/// Pairs of triangles one of which an edge of the other visibly passes through: by solving for the
/// point where they meet, not by the signs that the code under test looks at.
inline size_t visibleCrossings(const Mesh& mesh) {
  struct Span {
    double low, high;
    uint32_t triangle;
  };
  std::vector<Span> spans;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto x = std::minmax({mesh.positions[a].x, mesh.positions[b].x, mesh.positions[c].x});
    spans.push_back({x.first, x.second, t});
  }
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  const auto passes = [&](uint32_t from, uint32_t through) {
    const auto& edges = mesh.triangles[from];
    const auto& corners = mesh.triangles[through];
    const Vec3 o = mesh.positions[corners[0]], u = mesh.positions[corners[1]] - o,
               v = mesh.positions[corners[2]] - o;
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t a = edges[i], b = edges[(i + 1) % 3];
      if (std::find(corners.begin(), corners.end(), a) != corners.end() ||
          std::find(corners.begin(), corners.end(), b) != corners.end()) {
        continue;
      }
      const Vec3 start = mesh.positions[a], way = mesh.positions[b] - start;
      const Vec3 side = cross(way, v);
      const double det = dot(u, side);
      const Vec3 back = start - o;
      // Where what rounding does to the point could take it across the margin, nothing is said.
      constexpr double kMargin = 1e-4, kRounding = 1e-15;
      const double far = std::max({length(back), length(u), length(v), length(way)});
      const double products =
          std::max({length(way) * length(u), length(way) * length(v), length(u) * length(v)});
      if (!(std::fabs(det) * kMargin > kRounding * far * products)) continue;
      const double s = dot(back, side) / det, t = dot(way, cross(back, u)) / det,
                   along = dot(v, cross(back, u)) / det;
      if (s > kMargin && t > kMargin && s + t < 1 - kMargin && along > kMargin &&
          along < 1 - kMargin) {
        return true;
      }
    }
    return false;
  };
  size_t count = 0;
  for (size_t i = 0; i < spans.size(); ++i) {
    for (size_t j = i + 1; j < spans.size() && spans[j].low <= spans[i].high; ++j) {
      const auto apart = [&](double Vec3::*axis) {
        const auto range = [&](uint32_t t) {
          const auto& [a, b, c] = mesh.triangles[t];
          return std::minmax(
              {mesh.positions[a].*axis, mesh.positions[b].*axis, mesh.positions[c].*axis});
        };
        const auto one = range(spans[i].triangle), other = range(spans[j].triangle);
        return one.second < other.first || other.second < one.first;
      };
      if (apart(&Vec3::y) || apart(&Vec3::z)) continue;
      if (passes(spans[i].triangle, spans[j].triangle) ||
          passes(spans[j].triangle, spans[i].triangle)) {
        ++count;
      }
    }
  }
  return count;
}

/// The volume of a union of boxes, by counting the cells of the grid that their faces make.
inline double unionOfBoxes(const std::vector<Box3>& boxes) {
  std::vector<double> cuts[3];
  for (const Box3& box : boxes) {
    for (const Vec3 p : {box.low, box.high}) {
      cuts[0].push_back(p.x);
      cuts[1].push_back(p.y);
      cuts[2].push_back(p.z);
    }
  }
  for (auto& cut : cuts) std::sort(cut.begin(), cut.end());
  double volume = 0;
  for (size_t i = 0; i + 1 < cuts[0].size(); ++i) {
    for (size_t j = 0; j + 1 < cuts[1].size(); ++j) {
      for (size_t k = 0; k + 1 < cuts[2].size(); ++k) {
        const Vec3 size = {cuts[0][i + 1] - cuts[0][i], cuts[1][j + 1] - cuts[1][j],
                           cuts[2][k + 1] - cuts[2][k]};
        const Vec3 middle = Vec3{cuts[0][i], cuts[1][j], cuts[2][k]} + size / 2;
        for (const Box3& box : boxes) {
          if (!box.has(middle)) continue;
          volume += size.x * size.y * size.z;
          break;
        }
      }
    }
  }
  return volume;
}

}  // namespace marrow
