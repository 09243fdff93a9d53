#include "solid/quality.h"

#include <algorithm>
#include <array>

#include "sketch/turn_sign.h"
#include "solid/box_tree.h"
#include "solid/exact_orientation.h"

namespace marrow {
namespace {

using Corners = std::array<Vec3, 3>;

Vec2 without(Vec3 p, int axis) {
  return axis == 0 ? Vec2{p.y, p.z} : (axis == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y});
}

bool within(Vec2 a, Vec2 b, Vec2 p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool segmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const int abc = turnSign(a, b, c), abd = turnSign(a, b, d), cda = turnSign(c, d, a),
            cdb = turnSign(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) ||
         (cda == 0 && within(c, d, a)) || (cdb == 0 && within(c, d, b));
}

/// All in one plane.
bool meetInPlane(Vec3 p, Vec3 q, const Corners& t) {
  for (const int axis : {0, 1, 2}) {
    const Vec2 a = without(t[0], axis), b = without(t[1], axis), c = without(t[2], axis);
    const int sense = turnSign(a, b, c);
    if (sense == 0) continue;
    const Vec2 from = without(p, axis), to = without(q, axis);
    if (turnSign(a, b, from) * sense >= 0 && turnSign(b, c, from) * sense >= 0 &&
        turnSign(c, a, from) * sense >= 0) {
      return true;
    }
    return segmentsMeet(from, to, a, b) || segmentsMeet(from, to, b, c) ||
           segmentsMeet(from, to, c, a);
  }
  return false;  // no triangle, but a line
}

/// Whether a segment and a triangle have a point in common.
bool meet(Vec3 p, Vec3 q, const Corners& t) {
  const int from = exactOrientation(t[0], t[1], t[2], p),
            to = exactOrientation(t[0], t[1], t[2], q);
  if (from * to > 0) return false;
  if (from == 0 && to == 0) return meetInPlane(p, q, t);
  const int ab = exactOrientation(p, q, t[0], t[1]), bc = exactOrientation(p, q, t[1], t[2]),
            ca = exactOrientation(p, q, t[2], t[0]);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

class IntersectionCounter {
 public:
  explicit IntersectionCounter(const Mesh& mesh) : mesh_(mesh) {}

  static constexpr size_t kBatch = 4096;

  size_t run() const {
    size_t count = 0;
    std::vector<uint32_t> all(mesh_.triangles.size());
    for (uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    treeOf(all).pairs([&](uint32_t t, uint32_t u) { count += cross(t, u) ? 1 : 0; });
    return count;
  }

  bool any() const {
    constexpr size_t kMostNear = 200;
    std::vector<uint32_t> all(mesh_.triangles.size());
    for (uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    size_t left = kMostNear * all.size();
    bool found = false;
    treeOf(all).pairsWhile([&] { return !found && left > 0; },
                           [&](uint32_t t, uint32_t u) {
                             left -= left > 0 ? 1 : 0;
                             found = found || cross(t, u);
                           });
    return found || left == 0;
  }

  std::vector<std::pair<uint32_t, uint32_t>> run(const std::vector<char>& marked) const {
    std::vector<uint32_t> chosen;
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (marked[t]) chosen.push_back(t);
    }
    std::vector<std::pair<uint32_t, uint32_t>> found;
    const auto look = [&](uint32_t t, uint32_t u) {
      if (cross(t, u)) found.push_back({t, u});
    };
    const BoxTree tree = treeOf(chosen);
    tree.pairs([&](uint32_t i, uint32_t j) { look(chosen[i], chosen[j]); });
    // The others a few at a time: most of them are nowhere near, and a tree of all is large.
    std::vector<uint32_t> others;
    const auto lookAtOthers = [&] {
      tree.pairs(treeOf(others), [&](uint32_t i, uint32_t j) { look(chosen[i], others[j]); });
      others.clear();
    };
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (marked[t] || !boxOf(t).meets(tree.box())) continue;
      others.push_back(t);
      if (others.size() == kBatch) lookAtOthers();
    }
    if (!others.empty()) lookAtOthers();
    return found;
  }

 private:
  Box3 boxOf(uint32_t t) const {
    Box3 box;
    for (const uint32_t corner : mesh_.triangles[t]) box.include(mesh_.positions[corner]);
    return box;
  }

  BoxTree treeOf(const std::vector<uint32_t>& triangles) const {
    std::vector<Box3> boxes;
    boxes.reserve(triangles.size());
    for (const uint32_t t : triangles) boxes.push_back(boxOf(t));
    return BoxTree(std::move(boxes));
  }

  Corners corners(uint32_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
  }

  bool cross(uint32_t t, uint32_t u) const {
    const auto &one = mesh_.triangles[t], &other = mesh_.triangles[u];
    int shared = 0;
    size_t at_one = 0, at_other = 0;      // a shared corner
    size_t free_one = 3, free_other = 3;  // a corner that is not: the sum of the indices
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < 3; ++j) {
        if (one[i] != other[j]) continue;
        ++shared;
        at_one = i;
        at_other = j;
        free_one -= i;
        free_other -= j;
      }
    }
    const Corners a = corners(t), b = corners(u);
    if (shared == 0) return farCross(a, b);
    if (shared == 1) {
      // All but the shared corner on one side of the other's plane: there is nothing to ask.
      const auto leaves = [](const Corners& own, size_t at, const Corners& plane) {
        return exactOrientation(plane[0], plane[1], plane[2], own[(at + 1) % 3]) *
                   exactOrientation(plane[0], plane[1], plane[2], own[(at + 2) % 3]) >
               0;
      };
      if (leaves(a, at_one, b) || leaves(b, at_other, a)) return false;
      return meet(a[(at_one + 1) % 3], a[(at_one + 2) % 3], b) ||
             meet(b[(at_other + 1) % 3], b[(at_other + 2) % 3], a);
    }
    return shared > 2 || folded(a, b, free_one, free_other);
  }

  static bool farCross(const Corners& a, const Corners& b) {
    const auto apart = [](const Corners& plane, const Corners& t) {
      const int first = exactOrientation(plane[0], plane[1], plane[2], t[0]);
      return first != 0 && first == exactOrientation(plane[0], plane[1], plane[2], t[1]) &&
             first == exactOrientation(plane[0], plane[1], plane[2], t[2]);
    };
    if (apart(a, b) || apart(b, a)) return false;
    for (size_t i = 0; i < 3; ++i) {
      if (meet(a[i], a[(i + 1) % 3], b) || meet(b[i], b[(i + 1) % 3], a)) return true;
    }
    return false;
  }

  /// Triangles with a common edge that lie on each other.
  static bool folded(const Corners& a, const Corners& b, size_t free_a, size_t free_b) {
    const Vec3 p = a[free_a], from = a[(free_a + 1) % 3], to = a[(free_a + 2) % 3], q = b[free_b];
    if (exactOrientation(from, to, p, q) != 0) return false;
    for (const int axis : {0, 1, 2}) {
      const int side = turnSign(without(from, axis), without(to, axis), without(p, axis));
      if (side == 0) continue;
      return side == turnSign(without(from, axis), without(to, axis), without(q, axis));
    }
    return false;
  }

  const Mesh& mesh_;
};

/// Vertices that are joined by edges.
size_t countComponents(const Mesh& mesh, size_t& used) {
  std::vector<uint32_t> above(mesh.positions.size());
  for (uint32_t v = 0; v < above.size(); ++v) above[v] = v;
  const auto root = [&](uint32_t v) {
    while (above[v] != v) v = above[v] = above[above[v]];
    return v;
  };
  std::vector<char> is_used(above.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      is_used[triangle[i]] = 1;
      const uint32_t a = root(triangle[i]), b = root(triangle[(i + 1) % 3]);
      above[std::max(a, b)] = std::min(a, b);
    }
  }
  size_t components = 0;
  used = 0;
  for (uint32_t v = 0; v < above.size(); ++v) {
    used += is_used[v] ? 1 : 0;
    components += is_used[v] && above[v] == v ? 1 : 0;
  }
  return components;
}

}  // namespace

bool isClosed(const Mesh& mesh) {
  // The points that edges go to, by where they come from.
  std::vector<uint32_t> first(mesh.positions.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (corner >= mesh.positions.size()) return false;
      ++first[corner + 1];
    }
  }
  for (size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<uint32_t> filled(first.begin(), first.end() - 1), ends(first.back());
  for (const auto& triangle : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) ends[filled[triangle[i]]++] = triangle[(i + 1) % 3];
  }
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    std::sort(ends.begin() + first[v], ends.begin() + first[v + 1]);
  }
  const auto count = [&](uint32_t from, uint32_t to) {
    const auto [low, high] =
        std::equal_range(ends.begin() + first[from], ends.begin() + first[from + 1], to);
    return high - low;
  };
  for (const auto& triangle : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      if (a == b || count(a, b) != 1 || count(b, a) != 1) return false;
    }
  }
  return !mesh.triangles.empty();
}

double signedVolume(const Mesh& mesh) { return signedVolume(mesh.positions, mesh.triangles); }

double signedVolume(const std::vector<Vec3>& positions,
                    const std::vector<std::array<uint32_t, 3>>& triangles) {
  if (positions.empty()) return 0;
  const Vec3 origin = positions[0];
  double volume = 0;
  for (const auto& [a, b, c] : triangles) {
    volume += dot(positions[a] - origin, cross(positions[b] - origin, positions[c] - origin));
  }
  return volume / 6;
}

size_t countSelfIntersections(const Mesh& mesh) { return IntersectionCounter(mesh).run(); }

bool hasSelfIntersection(const Mesh& mesh) {
  return !mesh.triangles.empty() && IntersectionCounter(mesh).any();
}

std::vector<std::pair<uint32_t, uint32_t>> selfIntersections(const Mesh& mesh,
                                                             const std::vector<char>& marked) {
  return IntersectionCounter(mesh).run(marked);
}

SolidReport inspectSolid(const Mesh& mesh) {
  const MeshReport surface = inspect(mesh);
  SolidReport report;
  report.closed = surface.closed;
  report.manifold = surface.manifold;
  report.volume = surface.volume;
  report.area = surface.area;
  report.degenerate = surface.degenerate;
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (corner >= mesh.positions.size()) return report;
    }
  }
  size_t used = 0;
  report.components = countComponents(mesh, used);
  // Euler: V − E + F = 2 (components − genus), with E = 3/2 F.
  const auto euler = static_cast<int64_t>(used) - static_cast<int64_t>(mesh.triangles.size()) / 2;
  report.genus = static_cast<int>(static_cast<int64_t>(report.components) - euler / 2);
  report.self_intersections = countSelfIntersections(mesh);
  return report;
}

}  // namespace marrow
