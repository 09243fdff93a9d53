#include "solid/fill.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

using Ring = std::vector<PlanarPoint>;

constexpr double kOnEdge = 1e-12;  // distance from an edge ÷ its length

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

/// Joins a hole to the ring around it by a bridge there and back.
void bridge(Ring& ring, const Ring& hole, const std::vector<Ring>& others) {
  const auto isBlocked = [&](const Ring& by, const PlanarPoint& a, const PlanarPoint& b) {
    for (size_t i = 0, j = by.size() - 1; i < by.size(); j = i++) {
      const PlanarPoint &c = by[j], &d = by[i];
      if (c.id == a.id || c.id == b.id || d.id == a.id || d.id == b.id) continue;
      if (properlyCross(a.at, b.at, c.at, d.at)) return true;
    }
    return false;
  };
  size_t best_outer = 0, best_inner = 0;
  double best = -1;
  for (const bool must_see : {true, false}) {
    for (size_t i = 0; i < ring.size(); ++i) {
      for (size_t j = 0; j < hole.size(); ++j) {
        const Vec2 way = hole[j].at - ring[i].at;
        const double far = dot(way, way);
        if (best >= 0 && far >= best) continue;
        if (must_see) {
          bool blocked = isBlocked(ring, ring[i], hole[j]) || isBlocked(hole, ring[i], hole[j]);
          for (size_t k = 0; k < others.size() && !blocked; ++k) {
            blocked = isBlocked(others[k], ring[i], hole[j]);
          }
          if (blocked) continue;
        }
        best = far;
        best_outer = i;
        best_inner = j;
      }
    }
    if (best >= 0) break;
  }
  Ring joined(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(best_outer) + 1);
  for (size_t j = 0; j <= hole.size(); ++j) {
    joined.push_back(hole[(best_inner + j) % hole.size()]);
  }
  joined.insert(joined.end(), ring.begin() + static_cast<std::ptrdiff_t>(best_outer), ring.end());
  ring = std::move(joined);
}

/// Cuts off the roundest ear, again and again.
void cutEars(Ring& ring, std::vector<std::array<uint32_t, 3>>& triangles) {
  const auto roundness = [&](size_t i) {
    const size_t n = ring.size();
    const Vec2 a = ring[(i + n - 1) % n].at, b = ring[i].at, c = ring[(i + 1) % n].at;
    const double edges = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
    return edges > 0 ? turned(a, b, c) / edges : 0;
  };
  const auto isEar = [&](size_t i) {
    const size_t n = ring.size();
    const PlanarPoint &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
    if (a.id == c.id) return false;
    for (const PlanarPoint& p : ring) {
      if (p.id == a.id || p.id == b.id || p.id == c.id) continue;
      if (covers(a.at, b.at, c.at, p.at)) return false;
    }
    return true;
  };
  std::vector<double> round(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) round[i] = roundness(i);
  std::vector<size_t> order;
  while (ring.size() > 3) {
    const size_t n = ring.size();
    order.resize(n);
    for (size_t i = 0; i < n; ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
      return round[a] != round[b] ? round[a] > round[b] : a < b;
    });
    size_t ear = n;
    for (const size_t i : order) {
      if (!(round[i] > 0)) break;
      if (isEar(i)) {
        ear = i;
        break;
      }
    }
    // Rounding has left none: the least bad one whose ends are not one point.
    for (size_t k = 0; k < n && ear == n; ++k) {
      if (ring[(order[k] + n - 1) % n].id != ring[(order[k] + 1) % n].id) ear = order[k];
    }
    if (ear == n) ear = order[0];
    triangles.push_back({ring[(ear + n - 1) % n].id, ring[ear].id, ring[(ear + 1) % n].id});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    round.erase(round.begin() + static_cast<std::ptrdiff_t>(ear));
    round[ear % (n - 1)] = roundness(ear % (n - 1));
    round[(ear + n - 2) % (n - 1)] = roundness((ear + n - 2) % (n - 1));
  }
  triangles.push_back({ring[0].id, ring[1].id, ring[2].id});
}

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
    cutEars(ring, triangles);
  }
  return true;
}

}  // namespace marrow
