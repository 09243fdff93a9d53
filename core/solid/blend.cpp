#include "solid/blend.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "solid/quality.h"

namespace marrow {
namespace {

constexpr double kStep = 0.5;  // of the way to the neighbours' middle
constexpr double kStepsMin = 6, kStepsMax = 40;
constexpr int kNormalsEvery = 4;  // steps
constexpr int kRepairs = 6;

class Blender {
 public:
  Blender(MergedMesh& merged, double radius) : merged_(merged), radius_(radius) {}

  void run() {
    findNeighbours();
    measureDistances();
    if (zone_.empty()) return;
    original_ = merged_.mesh.positions;
    smooth();
    repair();
    shade();
  }

 private:
  void findNeighbours() {
    const auto& triangles = merged_.mesh.triangles;
    first_.assign(merged_.mesh.positions.size() + 1, 0);
    for (const auto& triangle : triangles) {
      for (const uint32_t corner : triangle) ++first_[corner + 1];
    }
    for (size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    std::vector<uint32_t> filled(first_.begin(), first_.end() - 1);
    fans_.resize(first_.back());
    for (uint32_t t = 0; t < triangles.size(); ++t) {
      for (const uint32_t corner : triangles[t]) fans_[filled[corner]++] = t;
    }
  }

  /// Calls visit for each neighbour of v: on a closed surface, each is behind v in one triangle.
  template <typename Visit>
  void forNeighbours(uint32_t v, const Visit& visit) const {
    for (size_t i = first_[v]; i < first_[v + 1]; ++i) {
      const auto& [a, b, c] = merged_.mesh.triangles[fans_[i]];
      visit(a == v ? b : (b == v ? c : a));
    }
  }

  /// Along edges, from the seams as far as the radius.
  void measureDistances() {
    const auto& positions = merged_.mesh.positions;
    std::vector<double> far(positions.size(), radius_);
    using Entry = std::pair<double, uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (uint32_t v = 0; v < positions.size(); ++v) {
      for (size_t i = first_[v]; i < first_[v + 1]; ++i) {
        if (merged_.part_of_triangle[fans_[i]] == merged_.part_of_triangle[fans_[first_[v]]]) {
          continue;
        }
        far[v] = 0;
        queue.push({0, v});
        break;
      }
    }
    while (!queue.empty()) {
      const auto [distance_here, v] = queue.top();
      queue.pop();
      if (distance_here > far[v]) continue;
      forNeighbours(v, [&, here = distance_here, at = positions[v]](uint32_t u) {
        const double there = here + distance(at, positions[u]);
        if (there >= far[u]) return;
        far[u] = there;
        queue.push({there, u});
      });
    }
    weights_.assign(positions.size(), 0);
    for (uint32_t v = 0; v < positions.size(); ++v) {
      const double share = far[v] / radius_;
      if (share >= 1) continue;
      weights_[v] = (1 - share * share) * (1 - share * share);
      zone_.push_back(v);
    }
  }

  /// Twice the area around v, as a vector.
  Vec3 areaAround(uint32_t v) const {
    Vec3 area{};
    const auto& positions = merged_.mesh.positions;
    for (size_t i = first_[v]; i < first_[v + 1]; ++i) {
      const auto& [a, b, c] = merged_.mesh.triangles[fans_[i]];
      area = area + cross(positions[b] - positions[a], positions[c] - positions[a]);
    }
    return area;
  }

  int stepCount() const {
    double sum = 0, count = 0;
    for (const uint32_t v : zone_) {
      forNeighbours(v, [&](uint32_t u) {
        sum += distance(original_[v], original_[u]);
        ++count;
      });
    }
    const double edges = radius_ * count / sum;
    return static_cast<int>(std::min(std::max(2 * edges * edges, kStepsMin), kStepsMax));
  }

  Vec3 wayToMiddle(uint32_t v) const {
    Vec3 sum{};
    double count = 0;
    forNeighbours(v, [&](uint32_t u) {
      sum = sum + merged_.mesh.positions[u];
      ++count;
    });
    return sum / count - merged_.mesh.positions[v];
  }

  /// As from the neighbours on each side of a seam, were they equally many and equally far: else
  /// seams would drift to where the mesh is finer, and be ragged.
  Vec3 wayOffSeam(uint32_t v) const {
    const auto& positions = merged_.mesh.positions;
    Vec3 sum{};
    double nearest = -1, sides = 0;
    for (size_t i = first_[v]; i < first_[v + 1]; ++i) {
      const uint32_t part = merged_.part_of_triangle[fans_[i]];
      bool is_known = false;
      for (size_t j = first_[v]; j < i && !is_known; ++j) {
        is_known = merged_.part_of_triangle[fans_[j]] == part;
      }
      if (is_known) continue;
      Vec3 side{};
      double areas = 0;
      for (size_t j = i; j < first_[v + 1]; ++j) {
        if (merged_.part_of_triangle[fans_[j]] != part) continue;
        const auto& [a, b, c] = merged_.mesh.triangles[fans_[j]];
        const Vec3 middle = (positions[a] + positions[b] + positions[c]) / 3 - positions[v];
        const double area = length(cross(positions[b] - positions[a], positions[c] - positions[a]));
        side = side + middle * area;
        areas += area;
      }
      const double far = length(side);
      if (!(far > 0)) continue;
      sum = sum + side / far;
      if (nearest < 0 || far / areas < nearest) nearest = far / areas;
      ++sides;
    }
    return sides > 0 ? sum * (nearest / sides) : Vec3{};
  }

  void smooth() {
    auto& positions = merged_.mesh.positions;
    std::vector<Vec3> normals(zone_.size()), next(zone_.size());
    const int steps = stepCount();
    for (int step = 0; step < steps; ++step) {
      for (size_t i = 0; i < zone_.size(); ++i) {
        const uint32_t v = zone_[i];
        if (step % kNormalsEvery == 0) {
          const Vec3 area = areaAround(v);
          const double size = length(area);
          normals[i] = size > 0 ? area / size : Vec3{};
        }
        const Vec3 way = weights_[v] < 1 ? wayToMiddle(v) : wayOffSeam(v);
        const Vec3 move = way * (kStep * weights_[v]);
        next[i] = positions[v] + move - normals[i] * std::min(dot(move, normals[i]), 0.0);
      }
      for (size_t i = 0; i < zone_.size(); ++i) positions[zone_[i]] = next[i];
    }
  }

  /// Takes points back where the surface crosses itself, half the way and more around them each
  /// time, and all of them in the end.
  void repair() {
    auto& positions = merged_.mesh.positions;
    const auto& triangles = merged_.mesh.triangles;
    std::vector<char> moved(triangles.size(), 0);
    for (const uint32_t v : zone_) {
      for (size_t i = first_[v]; i < first_[v + 1]; ++i) moved[fans_[i]] = 1;
    }
    for (int round = 0; round < kRepairs; ++round) {
      const auto crossings = selfIntersections(merged_.mesh, moved);
      if (crossings.empty()) return;
      std::vector<char> chosen(positions.size(), 0);
      for (const auto& [t, u] : crossings) {
        for (const uint32_t triangle : {t, u}) {
          for (const uint32_t v : triangles[triangle]) chosen[v] = 1;
        }
      }
      for (int ring = 0; ring <= round; ++ring) {
        std::vector<char> wider = chosen;
        for (const uint32_t v : zone_) {
          if (chosen[v]) forNeighbours(v, [&](uint32_t u) { wider[u] = 1; });
        }
        chosen = std::move(wider);
      }
      for (const uint32_t v : zone_) {
        if (chosen[v])
          positions[v] = round < 2 ? lerp(positions[v], original_[v], 0.5) : original_[v];
      }
    }
    if (!selfIntersections(merged_.mesh, moved).empty()) positions = original_;
  }

  /// Towards the seams, the normals of the new surface.
  void shade() {
    const std::vector<Vec3> smooth = vertexNormals(merged_.mesh);
    for (size_t t = 0; t < merged_.mesh.triangles.size(); ++t) {
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t v = merged_.mesh.triangles[t][i];
        if (weights_[v] == 0) continue;
        Vec3& normal = merged_.corner_normals[t][i];
        const Vec3 mixed = lerp(normal, smooth[v], std::min(1.0, 2 * weights_[v]));
        const double size = length(mixed);
        normal = size > 0 ? mixed / size : smooth[v];
      }
    }
  }

  MergedMesh& merged_;
  const double radius_;
  std::vector<uint32_t> first_, fans_;  // the triangles around each vertex
  std::vector<double> weights_;         // 1 at the seams, 0 from the radius on
  std::vector<uint32_t> zone_;          // vertices with a weight
  std::vector<Vec3> original_;
};

}  // namespace

MergedMesh blendSeams(MergedMesh merged, const BlendOptions& options, Clock clock) {
  Stopwatch watch(clock, merged.timings);
  if (options.radius > 0) Blender(merged, options.radius).run();
  watch.lap("blend");
  return merged;
}

}  // namespace marrow
