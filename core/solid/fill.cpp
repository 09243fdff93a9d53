#include "solid/fill.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

namespace marrow {
namespace {

using Ring = std::vector<PlanarPoint>;

constexpr double kOnEdge = 1e-12;   // distance from an edge ÷ its length
constexpr size_t kManyWays = 4096;  // between a ring and a hole, not to be tried all

double turned(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

double signedArea(const Ring& ring) {
  double doubled = 0;
  for (size_t i = 1; i + 1 < ring.size(); ++i) {
    doubled += turned(ring[0].at, ring[i].at, ring[i + 1].at);
  }
  return doubled;
}

bool contains(const Ring& ring, Vec2 p) {
  bool inside = false;
  for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 a = ring[j].at, b = ring[i].at;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) {
      inside = !inside;
    }
  }
  return inside;
}

/// Whether c lies in the triangle or on its border.
bool covers(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  const auto beyond = [p](Vec2 from, Vec2 to) {
    return turned(from, to, p) < -kOnEdge * dot(to - from, to - from);
  };
  return !beyond(a, b) && !beyond(b, c) && !beyond(c, a);
}

bool properlyCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return (turned(a, b, c) > 0) != (turned(a, b, d) > 0) &&
         (turned(c, d, a) > 0) != (turned(c, d, b) > 0);
}

/// Whether the way from a ring's point begins inside: a point that bridges start from is in the
/// ring more than once, each time with another part of what is around it.
bool beginsInside(const Ring& ring, size_t i, Vec2 to) {
  const Vec2 v = ring[i].at, before = ring[(i + ring.size() - 1) % ring.size()].at,
             next = ring[(i + 1) % ring.size()].at;
  if (turned(before, v, next) > 0) return turned(v, next, to) > 0 && turned(v, to, before) > 0;
  return !(turned(v, before, to) >= 0 && turned(v, to, next) >= 0);
}

/// Joins a hole to the ring around it by the shortest bridge there and back that crosses nothing.
void bridge(Ring& ring, const Ring& hole, const std::vector<Ring>& others) {
  struct Way {
    double squared;
    size_t outer, inner;
  };
  const auto isBlocked = [](const Ring& by, const PlanarPoint& a, const PlanarPoint& b) {
    for (size_t i = 0, j = by.size() - 1; i < by.size(); j = i++) {
      const PlanarPoint &c = by[j], &d = by[i];
      if (c.id == a.id || c.id == b.id || d.id == a.id || d.id == b.id) continue;
      if (properlyCross(a.at, b.at, c.at, d.at)) return true;
    }
    return false;
  };
  std::vector<Way> ways;
  // All, or those from its rightmost point: nothing but the ring is beyond, so one of them is free.
  size_t first = 0, end = hole.size();
  if (ring.size() * hole.size() > kManyWays) {
    for (size_t j = 1; j < hole.size(); ++j) {
      if (hole[j].at.x > hole[first].at.x) first = j;
    }
    end = first + 1;
  }
  ways.reserve(ring.size() * (end - first));
  for (size_t i = 0; i < ring.size(); ++i) {
    for (size_t j = first; j < end; ++j) {
      const Vec2 way = hole[j].at - ring[i].at;
      ways.push_back({dot(way, way), i, j});
    }
  }
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
    if (a.squared != b.squared) return a.squared < b.squared;
    return a.outer != b.outer ? a.outer < b.outer : a.inner < b.inner;
  });
  Way best = ways.front();  // where rounding leaves none that is free
  for (const Way& way : ways) {
    const PlanarPoint &a = ring[way.outer], &b = hole[way.inner];
    bool is_blocked = !beginsInside(ring, way.outer, b.at) ||
                      !beginsInside(hole, way.inner, a.at) || isBlocked(ring, a, b) ||
                      isBlocked(hole, a, b);
    for (size_t k = 0; k < others.size() && !is_blocked; ++k)
      is_blocked = isBlocked(others[k], a, b);
    if (is_blocked) continue;
    best = way;
    break;
  }
  const auto at = ring.begin() + static_cast<std::ptrdiff_t>(best.outer);
  Ring joined(ring.begin(), at + 1);
  for (size_t j = 0; j <= hole.size(); ++j) joined.push_back(hole[(best.inner + j) % hole.size()]);
  joined.insert(joined.end(), at, ring.end());
  ring = std::move(joined);
}

/// Cuts ears off a ring, each time the roundest one that is known.
class EarCutter {
 public:
  EarCutter(Ring& ring, std::vector<std::array<uint32_t, 3>>& triangles)
      : ring_(ring), triangles_(triangles) {}

  void run() {
    round_.resize(ring_.size());
    is_covered_.assign(ring_.size(), 0);
    for (size_t i = 0; i < ring_.size(); ++i) round_[i] = roundness(i);
    while (ring_.size() > 3) cut(chooseEar());
    triangles_.push_back({ring_[0].id, ring_[1].id, ring_[2].id});
  }

 private:
  size_t before(size_t i) const { return i > 0 ? i - 1 : ring_.size() - 1; }
  size_t behind(size_t i) const { return i + 1 < ring_.size() ? i + 1 : 0; }

  double roundness(size_t i) const {
    const Vec2 a = ring_[before(i)].at, b = ring_[i].at, c = ring_[behind(i)].at;
    const double edges = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
    return edges > 0 ? turned(a, b, c) / edges : 0;
  }

  bool isEar(size_t i) const {
    const PlanarPoint &a = ring_[before(i)], &b = ring_[i], &c = ring_[behind(i)];
    if (a.id == c.id) return false;
    for (const PlanarPoint& p : ring_) {
      if (p.id == a.id || p.id == b.id || p.id == c.id) continue;
      if (covers(a.at, b.at, c.at, p.at)) return false;
    }
    return true;
  }

  size_t chooseEar() {
    const size_t none = ring_.size();
    for (bool is_fresh = false;;) {
      size_t best = none;
      for (size_t i = 0; i < ring_.size(); ++i) {
        if (!is_covered_[i] && round_[i] > 0 && (best == none || round_[i] > round_[best]))
          best = i;
      }
      if (best == none) {
        if (is_fresh) break;
        // What covered them may have been cut off since.
        std::fill(is_covered_.begin(), is_covered_.end(), 0);
        is_fresh = true;
      } else if (isEar(best)) {
        return best;
      } else {
        is_covered_[best] = 1;
      }
    }
    // Rounding has left none: the least bad one whose ends are not one point.
    size_t best = none;
    for (size_t i = 0; i < ring_.size(); ++i) {
      if (ring_[before(i)].id == ring_[behind(i)].id) continue;
      if (best == none || round_[i] > round_[best]) best = i;
    }
    return best == none ? 0 : best;
  }

  void cut(size_t ear) {
    triangles_.push_back({ring_[before(ear)].id, ring_[ear].id, ring_[behind(ear)].id});
    const auto at = static_cast<std::ptrdiff_t>(ear);
    ring_.erase(ring_.begin() + at);
    round_.erase(round_.begin() + at);
    is_covered_.erase(is_covered_.begin() + at);
    const size_t next = ear < ring_.size() ? ear : 0;
    for (const size_t i : {next, before(next)}) {
      round_[i] = roundness(i);
      is_covered_[i] = 0;
    }
  }

  Ring& ring_;
  std::vector<std::array<uint32_t, 3>>& triangles_;
  std::vector<double> round_;
  std::vector<char> is_covered_;  // found to hold another point
};

}  // namespace

bool fillRegion(std::vector<Border> borders, std::vector<std::array<uint32_t, 3>>& triangles) {
  std::vector<Ring> rings, holes;
  for (Border& border : borders) {
    const bool is_ring = border.outer || borders.size() == 1 || signedArea(border.points) > 0;
    (is_ring ? rings : holes).push_back(std::move(border.points));
  }
  if (rings.empty()) return false;
  // Rightmost holes first, so that later ones may see them as a part of the ring.
  const auto right = [](const Ring& ring) {
    double x = ring[0].at.x;
    for (const PlanarPoint& p : ring) x = std::max(x, p.at.x);
    return x;
  };
  std::stable_sort(holes.begin(), holes.end(),
                   [&](const Ring& a, const Ring& b) { return right(a) > right(b); });
  while (!holes.empty()) {
    const Ring hole = std::move(holes.front());
    holes.erase(holes.begin());
    size_t around = rings.size();
    for (size_t i = 0; i < rings.size(); ++i) {
      if (!contains(rings[i], hole[0].at)) continue;
      if (around == rings.size() || signedArea(rings[i]) < signedArea(rings[around])) around = i;
    }
    if (around == rings.size()) return false;
    bridge(rings[around], hole, holes);
  }
  for (Ring& ring : rings) {
    if (ring.size() < 3) return false;
    EarCutter(ring, triangles).run();
  }
  return true;
}

}  // namespace marrow
