#include "solid/clean.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace marrow {
namespace {

constexpr uint32_t kNone = ~0u;
constexpr double kShort = 0.25;  // edge ÷ root of twice the mean triangle of the parts there
constexpr double kFlat = 0.02;   // roundness of a triangle that is worth turning an edge for
constexpr double kRound = 0.05;  // … that is good enough
constexpr double kFacing = 0.5;  // cosine between a triangle and what it is a piece of
constexpr double kNudge = 0.3;   // how far a point may be moved to keep the volume ÷ edge
constexpr double kTiny = 3e-4;   // an edge, as kShort, whose volume is not worth that
constexpr double kLevel = 1e-3;  // distance from a plane ÷ edge in it
constexpr int kRounds = 3;

using Triangle = std::array<uint32_t, 3>;

class Cleaner {
 public:
  Cleaner(const Soup& soup, std::vector<Vec3>& points, std::vector<Triangle>& triangles,
          std::vector<uint32_t>& sources, const std::vector<char>& frozen)
      : soup_(soup), points_(points), triangles_(triangles), sources_(sources), frozen_(frozen) {}

  void run() {
    findZone();
    for (int round = 0; round < kRounds && collapseShort(); ++round) {
    }
    turnFlat();
    size_t kept = 0;
    for (size_t t = 0; t < triangles_.size(); ++t) {
      if (!isAlive(static_cast<uint32_t>(t))) continue;
      triangles_[kept] = triangles_[t];
      sources_[kept++] = sources_[t];
    }
    triangles_.resize(kept);
    sources_.resize(kept);
  }

 private:
  bool isNew(uint32_t p) const { return p >= soup_.points.size(); }
  bool isAlive(uint32_t t) const { return triangles_[t][0] != kNone; }
  static bool has(const Triangle& t, uint32_t p) { return t[0] == p || t[1] == p || t[2] == p; }

  std::vector<uint32_t>& fan(uint32_t p) { return fans_[zone_[p]]; }

  /// Measures the parts, and makes fans for the points of triangles that have a new point.
  void findZone() {
    sizes_.assign(soup_.part_of_point.empty() ? 0 : soup_.part_of_point.back() + 1, 0);
    std::vector<double> counts(sizes_.size(), 0);
    for (size_t t = 0; t < soup_.triangles.size(); ++t) {
      const auto& [a, b, c] = soup_.triangles[t];
      const uint32_t part = soup_.part_of_triangle[t];
      sizes_[part] +=
          length(cross(soup_.points[b] - soup_.points[a], soup_.points[c] - soup_.points[a]));
      ++counts[part];
    }
    for (size_t part = 0; part < sizes_.size(); ++part) sizes_[part] /= std::max(counts[part], 1.0);
    zone_.assign(points_.size(), kNone);
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& corners = triangles_[t];
      if (!isNew(corners[0]) && !isNew(corners[1]) && !isNew(corners[2])) continue;
      seam_.push_back(t);
      for (const uint32_t p : corners) {
        if (zone_[p] != kNone) continue;
        zone_[p] = static_cast<uint32_t>(fans_.size());
        fans_.emplace_back();
      }
    }
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const uint32_t p : triangles_[t]) {
        if (zone_[p] != kNone) fan(p).push_back(t);
      }
    }
    kinds_.resize(fans_.size());
    for (uint32_t p = 0; p < points_.size(); ++p) {
      if (zone_[p] == kNone) continue;
      auto& parts = kinds_[zone_[p]];
      for (const uint32_t t : fan(p)) parts.push_back(soup_.part_of_triangle[sources_[t]]);
      std::sort(parts.begin(), parts.end());
      parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    }
  }

  Vec3 sourceNormal(uint32_t t) const {
    const auto& [a, b, c] = soup_.triangles[sources_[t]];
    return cross(soup_.points[b] - soup_.points[a], soup_.points[c] - soup_.points[a]);
  }

  /// Area ÷ squared edges, 0.14 for the roundest; negative where it faces another way than what it
  /// is a piece of.
  double roundness(const Triangle& corners, uint32_t source_of) const {
    return roundness(points_[corners[0]], points_[corners[1]], points_[corners[2]], source_of);
  }
  double roundness(Vec3 a, Vec3 b, Vec3 c, uint32_t source_of) const {
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const double edges = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
    if (!(edges > 0)) return 0;
    const Vec3 normal = -cross(ab, ca), true_normal = sourceNormal(source_of);
    const double size = length(normal);
    const bool faces = dot(normal, true_normal) >= kFacing * size * length(true_normal);
    return (faces ? size : -size) / (2 * edges);
  }

  struct Edge {
    double squared;
    uint32_t a, b;
  };

  bool collapseShort() {
    std::vector<Edge> edges;
    for (const uint32_t t : seam_) {
      if (!isAlive(t)) continue;
      const double limit = kShort * kShort * sizes_[soup_.part_of_triangle[sources_[t]]];
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
        if (!isNew(a) && !isNew(b)) continue;
        const Vec3 way = points_[b] - points_[a];
        if (dot(way, way) < limit) edges.push_back({dot(way, way), std::min(a, b), std::max(a, b)});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
      if (x.squared != y.squared) return x.squared < y.squared;
      return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    bool any = false;
    for (const Edge& edge : edges) any = collapse(edge.a, edge.b) || any;
    return any;
  }

  /// The other corners of the triangles around p, ascending.
  std::vector<uint32_t> neighbours(uint32_t p) {
    std::vector<uint32_t> around;
    for (const uint32_t t : fan(p)) {
      for (const uint32_t corner : triangles_[t]) {
        if (corner != p) around.push_back(corner);
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  bool collapse(uint32_t a, uint32_t b) {
    if (zone_[a] == kNone || zone_[b] == kNone) return false;
    if (fan(a).empty() || fan(b).empty()) return false;
    const std::vector<uint32_t> around_a = neighbours(a), around_b = neighbours(b);
    if (!std::binary_search(around_a.begin(), around_a.end(), b)) return false;
    std::vector<uint32_t> common;
    std::set_intersection(around_a.begin(), around_a.end(), around_b.begin(), around_b.end(),
                          std::back_inserter(common));
    if (common.size() != 2) return false;
    // A point with three neighbours goes, unless what is left would lie on a triangle.
    const auto hasCommon = [&](uint32_t p) {
      return std::any_of(fan(p).begin(), fan(p).end(), [&](uint32_t t) {
        return has(triangles_[t], common[0]) && has(triangles_[t], common[1]);
      });
    };
    if (around_a.size() < 4 && hasCommon(b)) return false;
    if (around_b.size() < 4 && hasCommon(a)) return false;

    const Vec3 way = points_[b] - points_[a];
    double finest = -1;
    for (const uint32_t p : {a, b}) {
      for (const uint32_t t : fan(p)) {
        if (frozen_[sources_[t]]) return false;
        const double size = sizes_[soup_.part_of_triangle[sources_[t]]];
        if (finest < 0 || size < finest) finest = size;
      }
    }
    // Short for the finest mesh there: small parts on large ones keep their shape.
    if (!(dot(way, way) < kShort * kShort * finest)) return false;
    const bool is_tiny = dot(way, way) < kTiny * kTiny * finest;
    // A point where more parts meet does not go to one where fewer do.
    const Union a_gone = mayMerge(a, b) ? unite(a, b, is_tiny) : Union{};
    const Union b_gone = mayMerge(b, a) ? unite(b, a, is_tiny) : Union{};
    if (a_gone.roundness < 0 && b_gone.roundness < 0) return false;
    const bool is_a = a_gone.roundness >= b_gone.roundness;
    const uint32_t gone = is_a ? a : b, stays = is_a ? b : a;
    points_[stays] = is_a ? a_gone.at : b_gone.at;
    for (const uint32_t t : fan(gone)) {
      Triangle& corners = triangles_[t];
      if (has(corners, stays)) {
        for (const uint32_t p : corners) {
          if (p != gone && zone_[p] != kNone) {
            auto& others = fan(p);
            others.erase(std::find(others.begin(), others.end(), t));
          }
        }
        corners = {kNone, kNone, kNone};
      } else {
        std::replace(corners.begin(), corners.end(), gone, stays);
        fan(stays).push_back(t);
        seam_.push_back(t);
      }
    }
    fan(gone).clear();
    return true;
  }

  bool mayMerge(uint32_t gone, uint32_t stays) {
    const auto &few = kinds_[zone_[gone]], &many = kinds_[zone_[stays]];
    return std::includes(many.begin(), many.end(), few.begin(), few.end());
  }

  struct Union {
    double roundness = -1;  // the worst around it; negative where that is not good enough
    Vec3 at;
  };

  /// Puts `gone` at `stays`, and that a little outward or inward, so that the volume is the same;
  /// that of tiny edges is not worth it where it would take too far.
  Union unite(uint32_t gone, uint32_t stays, bool is_tiny) {
    const Vec3 from = points_[stays], edge = points_[gone] - from;
    double missing = 0;  // six times the volume
    Vec3 area{};         // twice that around the two
    const auto add = [&](uint32_t t) {
      const auto [a, b, c] = wedge(t, has(triangles_[t], gone) ? gone : stays);
      area = area + cross(points_[b] - from, points_[c] - from);
      if (a == gone) missing += dot(edge, cross(points_[b] - from, points_[c] - from));
    };
    double before = 1, after = 1;
    for (const uint32_t t : fan(gone)) {
      before = std::min(before, roundness(triangles_[t], t));
      if (!has(triangles_[t], stays)) add(t);
    }
    for (const uint32_t t : fan(stays)) {
      before = std::min(before, roundness(triangles_[t], t));
      if (!has(triangles_[t], gone)) add(t);
    }
    const Vec3 move = area * (missing / dot(area, area));
    Vec3 at = from + move;
    if (!(dot(move, move) <= kNudge * kNudge * dot(edge, edge))) {
      if (!is_tiny) return {};
      at = from;
    }
    for (const uint32_t middle : {gone, stays}) {
      for (const uint32_t t : fan(middle)) {
        if (has(triangles_[t], middle == gone ? stays : gone)) continue;
        const Triangle corners = wedge(t, middle);
        after = std::min(after, roundness(at, points_[corners[1]], points_[corners[2]], t));
      }
    }
    return {after >= std::min(before, kRound) ? after : -1, at};
  }

  /// A triangle's corners, beginning with one of them.
  Triangle wedge(uint32_t t, uint32_t first) const {
    const auto& [a, b, c] = triangles_[t];
    if (a == first) return {a, b, c};
    return b == first ? Triangle{b, c, a} : Triangle{c, a, b};
  }

  void turnFlat() {
    const size_t count = seam_.size();
    for (size_t i = 0; i < count; ++i) {
      const uint32_t t = seam_[i];
      if (isAlive(t) && roundness(triangles_[t], t) < kFlat) turnLongest(t);
    }
  }

  void turnLongest(uint32_t t) {
    const Triangle corners = triangles_[t];
    size_t longest = 0;
    double most_squared = -1;
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 way = points_[corners[(i + 1) % 3]] - points_[corners[i]];
      if (dot(way, way) > most_squared) {
        most_squared = dot(way, way);
        longest = i;
      }
    }
    const uint32_t a = corners[longest], b = corners[(longest + 1) % 3],
                   c = corners[(longest + 2) % 3];
    if (zone_[a] == kNone || zone_[b] == kNone || zone_[c] == kNone) return;
    uint32_t other = kNone;
    for (const uint32_t u : fan(a)) {
      if (u != t && has(triangles_[u], b)) other = u;
    }
    if (other == kNone || sources_[other] != sources_[t] || frozen_[sources_[t]]) return;
    uint32_t d = kNone;
    for (const uint32_t p : triangles_[other]) {
      if (p != a && p != b) d = p;
    }
    if (d == c || zone_[d] == kNone) return;
    // Nearly within a plane, so that the volume stays.
    const Vec3 normal = cross(points_[b] - points_[a], points_[c] - points_[a]);
    const double off = dot(normal, points_[d] - points_[a]);
    if (off * off > kLevel * kLevel * dot(normal, normal) * most_squared) return;
    for (const uint32_t u : fan(c)) {
      if (has(triangles_[u], d)) return;
    }
    const Triangle one = {a, d, c}, two = {d, b, c};
    const double before = std::min(roundness(corners, t), roundness(triangles_[other], other));
    const double after = std::min(
        {roundness(one, t), roundness(two, t), roundness(one, other), roundness(two, other)});
    if (!(after > before) || after <= 0) return;
    triangles_[t] = one;
    triangles_[other] = two;
    auto& of_a = fan(a);
    auto& of_b = fan(b);
    of_a.erase(std::find(of_a.begin(), of_a.end(), other));
    of_b.erase(std::find(of_b.begin(), of_b.end(), t));
    fan(c).push_back(other);
    fan(d).push_back(t);
  }

  const Soup& soup_;
  std::vector<Vec3>& points_;
  std::vector<Triangle>& triangles_;
  std::vector<uint32_t>& sources_;
  const std::vector<char>& frozen_;
  std::vector<double> sizes_;                 // of the parts: twice the area of their mean triangle
  std::vector<uint32_t> seam_;                // triangles that have a new point
  std::vector<uint32_t> zone_;                // of each point, its index in the next two
  std::vector<std::vector<uint32_t>> fans_;   // the triangles around it
  std::vector<std::vector<uint32_t>> kinds_;  // the parts that meet there
};

}  // namespace

void collapseSlivers(const Soup& soup, std::vector<Vec3>& points, std::vector<Triangle>& triangles,
                     std::vector<uint32_t>& sources, const std::vector<char>& frozen) {
  Cleaner(soup, points, triangles, sources, frozen).run();
}

}  // namespace marrow
