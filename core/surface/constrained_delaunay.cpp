#include "surface/constrained_delaunay.h"

#include <algorithm>

#include "sketch/turn_sign.h"
#include "surface/in_circle.h"

namespace marrow {
namespace {

/// What is left of a polygon while ears are cut off, with its reflex vertices at hand.
class Remainder {
 public:
  explicit Remainder(const std::vector<Vec2>& points)
      : points_(points),
        previous_(points.size()),
        next_(points.size()),
        place_(points.size(), ConstrainedDelaunay::kNone) {
    const uint32_t n = static_cast<uint32_t>(points.size());
    for (uint32_t i = 0; i < n; ++i) {
      previous_[i] = i == 0 ? n - 1 : i - 1;
      next_[i] = i + 1 == n ? 0 : i + 1;
    }
    for (uint32_t i = 0; i < n; ++i) {
      if (isConvex(i)) continue;
      place_[i] = static_cast<uint32_t>(reflex_.size());
      reflex_.push_back({points[i], i});
    }
  }

  uint32_t previous(uint32_t i) const { return previous_[i]; }
  uint32_t next(uint32_t i) const { return next_[i]; }

  /// True where the triangle at i is inside what is left and touches no other vertex.
  bool isEar(uint32_t i) const {
    if (place_[i] != ConstrainedDelaunay::kNone) return false;
    const uint32_t p = previous_[i], n = next_[i];
    const Vec2 a = points_[p], b = points_[i], c = points_[n];
    const double left = std::min({a.x, b.x, c.x}), right = std::max({a.x, b.x, c.x});
    const double low = std::min({a.y, b.y, c.y}), high = std::max({a.y, b.y, c.y});
    for (const Reflex& r : reflex_) {
      if (r.at.x < left || r.at.x > right || r.at.y < low || r.at.y > high) continue;
      if (r.index == p || r.index == n) continue;
      if (turnSign(c, a, r.at) >= 0 && turnSign(a, b, r.at) >= 0 && turnSign(b, c, r.at) >= 0) {
        return false;
      }
    }
    return true;
  }

  void cut(uint32_t i) {
    const uint32_t p = previous_[i], n = next_[i];
    next_[p] = n;
    previous_[n] = p;
    for (const uint32_t neighbour : {p, n}) {
      if (place_[neighbour] == ConstrainedDelaunay::kNone || !isConvex(neighbour)) continue;
      const uint32_t hole = place_[neighbour];
      place_[reflex_.back().index] = hole;
      reflex_[hole] = reflex_.back();
      reflex_.pop_back();
      place_[neighbour] = ConstrainedDelaunay::kNone;
    }
  }

 private:
  struct Reflex {
    Vec2 at;
    uint32_t index;
  };

  bool isConvex(uint32_t i) const {
    return turnSign(points_[previous_[i]], points_[i], points_[next_[i]]) > 0;
  }

  const std::vector<Vec2>& points_;
  std::vector<uint32_t> previous_, next_;
  std::vector<Reflex> reflex_;
  std::vector<uint32_t> place_;  // in reflex_, kNone for convex vertices
};

}  // namespace

bool ConstrainedDelaunay::start(const std::vector<Vec2>& border, size_t expected_points) {
  points_.clear();
  points_.reserve(expected_points);
  points_ = border;
  corners_.clear();
  twins_.clear();
  corners_.reserve(6 * expected_points);
  twins_.reserve(6 * expected_points);
  border_edges_.assign(border.size(), kNone);
  stack_.clear();
  if (border.size() < 3 || !clipEars()) return false;

  for (uint32_t e = 0; e < edgeCount(); ++e) {
    if (twins_[e] > static_cast<int32_t>(e)) stack_.push_back(e);
  }
  while (!stack_.empty()) {
    const uint32_t e = stack_.back();
    stack_.pop_back();
    const int32_t other = twins_[e];
    if (other < 0 || !flip(e)) continue;
    for (const uint32_t f : {e, static_cast<uint32_t>(other)}) {
      stack_.push_back(f);
      stack_.push_back(next(f));
    }
  }
  return true;
}

bool ConstrainedDelaunay::clipEars() {
  const uint32_t n = static_cast<uint32_t>(points_.size());
  Remainder rest(points_);
  std::vector<int32_t> outside(n);  // beyond the edge that starts at a vertex
  for (uint32_t i = 0; i < n; ++i) outside[i] = ~static_cast<int32_t>(i);

  uint32_t at = 0, left = n, refused = 0;
  while (left > 3) {
    if (!rest.isEar(at)) {
      if (++refused > left) return false;
      at = rest.next(at);
      continue;
    }
    refused = 0;
    const uint32_t before = rest.previous(at), after = rest.next(at);
    const uint32_t e = edgeCount();
    addTriangle(before, at, after);
    link(e, outside[before]);
    link(e + 1, outside[at]);
    outside[before] = static_cast<int32_t>(e + 2);
    rest.cut(at);
    --left;
    // Skipping a vertex keeps the ears from becoming a fan of needles.
    at = rest.next(after);
  }
  const uint32_t b = rest.next(at), c = rest.next(b);
  if (turnSign(points_[at], points_[b], points_[c]) <= 0) return false;
  const uint32_t e = edgeCount();
  addTriangle(at, b, c);
  link(e, outside[at]);
  link(e + 1, outside[b]);
  link(e + 2, outside[c]);
  return true;
}

void ConstrainedDelaunay::addTriangle(uint32_t a, uint32_t b, uint32_t c) {
  corners_.insert(corners_.end(), {a, b, c});
  twins_.insert(twins_.end(), 3, -1);
}

void ConstrainedDelaunay::link(uint32_t e, int32_t other) {
  twins_[e] = other;
  if (other >= 0) {
    twins_[static_cast<uint32_t>(other)] = static_cast<int32_t>(e);
  } else {
    border_edges_[static_cast<uint32_t>(~other)] = e;
  }
}

/// Replaces the edge between two triangles by the other diagonal where that is surely better. Then
/// e and its old twin are the first edges, from their old apexes on, of the two new triangles.
bool ConstrainedDelaunay::flip(uint32_t e) {
  const uint32_t f = static_cast<uint32_t>(twins_[e]);
  const uint32_t e_previous = previous(e), f_previous = previous(f);
  const uint32_t p = corners_[e_previous], q = corners_[f_previous];
  if (!surelyInCircle(points_[corners_[e]], points_[corners_[f]], points_[p], points_[q])) {
    return false;
  }
  corners_[e] = q;
  corners_[f] = p;
  link(e, twins_[f_previous]);
  link(f, twins_[e_previous]);
  link(e_previous, static_cast<int32_t>(f_previous));
  return true;
}

uint32_t ConstrainedDelaunay::insert(Vec2 point, uint32_t hint) {
  uint32_t t = walk(point, hint);
  if (t == kTooFar) t = search(point);
  if (t == kNone) return kNone;

  const uint32_t p = static_cast<uint32_t>(points_.size());
  points_.push_back(point);
  const uint32_t e = 3 * t;
  const uint32_t a = corners_[e], b = corners_[e + 1], c = corners_[e + 2];
  const int32_t beyond_bc = twins_[e + 1], beyond_ca = twins_[e + 2];
  const uint32_t f = edgeCount(), g = f + 3;
  corners_[e + 2] = p;
  addTriangle(b, c, p);
  addTriangle(c, a, p);
  link(f, beyond_bc);
  link(g, beyond_ca);
  link(e + 1, static_cast<int32_t>(f + 2));
  link(f + 1, static_cast<int32_t>(g + 2));
  link(g + 1, static_cast<int32_t>(e + 2));

  // The new point stays the apex of every edge on the stack.
  stack_.insert(stack_.end(), {e, f, g});
  while (!stack_.empty()) {
    const uint32_t edge = stack_.back();
    stack_.pop_back();
    const int32_t other = twins_[edge];
    if (other < 0 || !flip(edge)) continue;
    stack_.push_back(edge);
    stack_.push_back(next(static_cast<uint32_t>(other)));
  }
  return t;
}

/// From triangle to triangle towards the point; kTooFar where the border is in the way.
uint32_t ConstrainedDelaunay::walk(Vec2 point, uint32_t triangle) const {
  uint32_t entered = kNone;
  for (uint32_t steps = 0; steps < edgeCount(); ++steps) {
    uint32_t leave = kNone;
    for (uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e) {
      if (e == entered) continue;
      if (turnSign(points_[corners_[e]], points_[corners_[next(e)]], point) < 0) {
        leave = e;
        break;
      }
    }
    if (leave == kNone) return triangle;
    if (twins_[leave] < 0) return kTooFar;
    entered = static_cast<uint32_t>(twins_[leave]);
    triangle = entered / 3;
  }
  return kTooFar;
}

uint32_t ConstrainedDelaunay::search(Vec2 point) const {
  for (uint32_t e = 0; e < edgeCount(); e += 3) {
    const Vec2 a = points_[corners_[e]], b = points_[corners_[e + 1]], c = points_[corners_[e + 2]];
    if (turnSign(a, b, point) >= 0 && turnSign(b, c, point) >= 0 && turnSign(c, a, point) >= 0) {
      return e / 3;
    }
  }
  return kNone;
}

std::vector<std::array<uint32_t, 3>> ConstrainedDelaunay::triangles() const {
  std::vector<std::array<uint32_t, 3>> result(corners_.size() / 3);
  for (size_t t = 0; t < result.size(); ++t) {
    result[t] = {corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]};
  }
  return result;
}

}  // namespace marrow
