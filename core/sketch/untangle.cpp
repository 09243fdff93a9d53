#include "sketch/untangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sketch/edge_grid.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

__extension__ typedef __int128 Int128;

constexpr uint32_t kNone = UINT32_MAX;
// Fine cells make the look ahead along an edge short where long edges lie thick.
constexpr double kCellsPerEdge = 16;

struct Lattice {
  int64_t x, y;
};

Lattice operator-(Lattice a, Lattice b) { return {a.x - b.x, a.y - b.y}; }
Lattice operator-(Lattice a) { return {-a.x, -a.y}; }
int64_t cross(Lattice a, Lattice b) { return a.x * b.y - a.y * b.x; }
int64_t dot(Lattice a, Lattice b) { return a.x * b.x + a.y * b.y; }
int64_t orient(Lattice a, Lattice b, Lattice c) { return cross(b - a, c - a); }

/// Where on an edge, from 0 at its first end to 1 at its second.
struct Fraction {
  int64_t num = 0, den = 1;  // den > 0

  static Fraction of(int64_t num, int64_t den) {
    return den < 0 ? Fraction{-num, -den} : Fraction{num, den};
  }
  double value() const { return static_cast<double>(num) / static_cast<double>(den); }
};

int compare(Fraction a, Fraction b) {
  const Int128 left = static_cast<Int128>(a.num) * b.den;
  const Int128 right = static_cast<Int128>(b.num) * a.den;
  return left < right ? -1 : (left > right ? 1 : 0);
}

/// A vertex of the arrangement: a vertex of the curve, or else the crossing on the lowest-numbered
/// edge through it. The same point always has the same name.
struct Node {
  uint32_t vertex = kNone;
  uint32_t edge = kNone;
  Fraction at;

  friend bool operator==(const Node& a, const Node& b) {
    return a.vertex == b.vertex && a.edge == b.edge && a.at.num == b.at.num && a.at.den == b.at.den;
  }
  friend bool operator<(const Node& a, const Node& b) {
    if (a.vertex != b.vertex) return a.vertex < b.vertex;
    if (a.edge != b.edge) return a.edge < b.edge;
    if (a.at.num != b.at.num) return a.at.num < b.at.num;
    return a.at.den < b.at.den;
  }
};

/// The order of directions when turning counter-clockwise from `reference`, which itself is last.
class TurnOrder {
 public:
  explicit TurnOrder(Lattice reference) : reference_(reference) {}

  bool operator()(Lattice a, Lattice b) const {
    const int sector_a = sector(a), sector_b = sector(b);
    if (sector_a != sector_b) return sector_a < sector_b;
    return cross(a, b) > 0;
  }

 private:
  int sector(Lattice d) const {
    const int64_t side = cross(reference_, d);
    if (side > 0) return 0;
    if (side < 0) return 2;
    return dot(reference_, d) < 0 ? 1 : 3;
  }

  Lattice reference_;
};

/// The curve as a set of undirected edges between distinct points: where it overlaps itself exactly
/// nothing is left of that.
struct Drawing {
  std::vector<Vec2> points;                // sorted by x, then y; distinct
  std::vector<Lattice> lattice;            // the same
  std::vector<EdgeGrid::Edge> edges;       // sorted, distinct, first end < second end
  std::vector<uint32_t> starts, incident;  // the edges at each point

  explicit Drawing(const std::vector<Vec2>& curve);
};

Drawing::Drawing(const std::vector<Vec2>& curve) {
  const size_t n = curve.size();
  std::vector<uint32_t> order(n), id(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    if (curve[a].x != curve[b].x) return curve[a].x < curve[b].x;
    if (curve[a].y != curve[b].y) return curve[a].y < curve[b].y;
    return a < b;
  });
  for (const uint32_t i : order) {
    if (points.empty() || points.back() != curve[i]) points.push_back(curve[i]);
    id[i] = static_cast<uint32_t>(points.size() - 1);
  }
  for (const Vec2& p : points) {
    lattice.push_back({static_cast<int64_t>(p.x), static_cast<int64_t>(p.y)});
  }

  for (size_t i = 0; i < n; ++i) {
    const uint32_t a = id[i], b = id[i + 1 < n ? i + 1 : 0];
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  starts.assign(points.size() + 1, 0);
  for (const auto& e : edges) ++starts[e[0]], ++starts[e[1]];
  uint32_t sum = 0;
  for (uint32_t& start : starts) start = (sum += start);
  incident.resize(sum);
  for (size_t i = edges.size(); i-- > 0;) {
    for (const uint32_t end : edges[i]) incident[--starts[end]] = static_cast<uint32_t>(i);
  }
}

/// Walks along the unbounded face, which stays on the right.
class Walk {
 public:
  explicit Walk(const Drawing& drawing)
      : drawing_(drawing), grid_(drawing.points, drawing.edges, kCellsPerEdge) {}

  /// The nodes passed, in order; the first is not repeated at the end. None where it takes more
  /// than `most_work` looks at an edge.
  std::vector<Node> run(size_t most_work) {
    std::vector<Node> passed;
    Node node;
    node.vertex = 0;  // leftmost, of those the lowest: everything left of it is outside
    turn(node, Lattice{-1, 0});
    const Lattice first_way = way();
    do {
      passed.push_back(node);
      const Lattice came_along = way();
      node = advance();
      turn(node, -came_along);
      if (work_ > most_work) return {};
    } while (!(node == passed[0] && cross(way(), first_way) == 0 && dot(way(), first_way) > 0));
    return passed;
  }

 private:
  Lattice end(uint32_t edge, int which) const {
    return drawing_.lattice[drawing_.edges[edge][static_cast<size_t>(which)]];
  }
  Vec2 place(uint32_t edge, double at) const {
    const auto& e = drawing_.edges[edge];
    return lerp(drawing_.points[e[0]], drawing_.points[e[1]], at);
  }
  Lattice way() const {
    const Lattice along = end(edge_, 1) - end(edge_, 0);
    return forward_ ? along : -along;
  }

  /// Where along the current edge one of its points lies.
  Fraction along(Lattice point) const {
    const Lattice a = end(edge_, 0), d = end(edge_, 1) - a;
    return d.x != 0 ? Fraction::of(point.x - a.x, d.x) : Fraction::of(point.y - a.y, d.y);
  }

  /// From the current place to the next node on the current edge.
  Node advance() {
    const uint32_t goal = drawing_.edges[edge_][forward_ ? 1 : 0];
    hit_ = {goal, forward_ ? Fraction{1, 1} : Fraction{0, 1}};
    through_.clear();
    overlapping_.clear();
    const Lattice a = end(edge_, 0), b = end(edge_, 1);
    const double start = at_.value(), whole = forward_ ? 1 - start : start;
    const Vec2 here = place(edge_, start);
    grid_.walk(here, drawing_.points[goal], [&](uint32_t cell, double left_at) {
      const EdgeGrid::Range others = grid_.edgesIn(cell);
      for (const uint32_t other : others) {
        if (other != edge_) meet(a, b, other);
      }
      work_ += others.size();
      constexpr double kSafe = 1e-9;
      return !(std::fabs(hit_.at.value() - start) + kSafe < left_at * whole);
    });

    Node node;
    if (hit_.vertex != kNone) {
      node.vertex = hit_.vertex;
      return node;
    }
    uint32_t partner = through_[0];
    node.edge = edge_;
    for (const uint32_t other : overlapping_) {
      const Fraction from = along(end(other, 0)), to = along(end(other, 1));
      if (other < node.edge && compare(from, hit_.at) * compare(hit_.at, to) > 0) {
        node.edge = other;
      }
    }
    for (const uint32_t other : through_) {
      if (other >= node.edge) continue;
      node.edge = other;
      partner = edge_;
    }
    node.at = crossing(node.edge, partner);
    const int64_t divisor = std::gcd(node.at.num, node.at.den);
    node.at.num /= divisor;
    node.at.den /= divisor;
    return node;
  }

  /// Notes where the current edge ab meets another one, if that comes first.
  void meet(Lattice a, Lattice b, uint32_t other) {
    const Lattice c = end(other, 0), d = end(other, 1);
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
      return;
    }
    const int64_t side_c = orient(a, b, c), side_d = orient(a, b, d);
    if ((side_c > 0 && side_d > 0) || (side_c < 0 && side_d < 0)) return;
    if (side_c == 0) offer(along(c), drawing_.edges[other][0], other);
    if (side_d == 0) offer(along(d), drawing_.edges[other][1], other);
    if (side_c == 0 && side_d == 0) overlapping_.push_back(other);
    if (side_c == 0 || side_d == 0) return;
    const int64_t side_a = orient(c, d, a), side_b = orient(c, d, b);
    if ((side_a > 0) == (side_b > 0) || side_a == 0 || side_b == 0) return;
    offer(Fraction::of(side_a, side_a - side_b), kNone, other);
  }

  /// A node on the current edge, by a vertex of the curve or by a crossing with `other`.
  void offer(Fraction at, uint32_t vertex, uint32_t other) {
    const int from_here = compare(at, at_);
    if (forward_ ? from_here <= 0 : from_here >= 0) return;
    const int order = forward_ ? compare(at, hit_.at) : compare(hit_.at, at);
    if (order > 0) return;
    if (order < 0) {
      hit_ = {vertex, at};
      through_.clear();
    } else if (hit_.vertex == kNone) {
      hit_.vertex = vertex;
    }
    if (vertex == kNone) through_.push_back(other);
  }

  /// Leaves a node on the first way counter-clockwise from `back`, the one we came from.
  void turn(const Node& node, Lattice back) {
    const TurnOrder earlier(back);
    uint32_t best = kNone;
    bool best_forward = true;
    Lattice best_way{};
    const auto consider = [&](uint32_t edge, bool forward) {
      const Lattice along = end(edge, 1) - end(edge, 0);
      const Lattice leaving = forward ? along : -along;
      if (best == kNone || earlier(leaving, best_way)) {
        best = edge;
        best_forward = forward;
        best_way = leaving;
      }
    };

    if (node.vertex == kNone) {
      through_.push_back(edge_);
      for (const uint32_t edge : through_) {
        consider(edge, true);
        consider(edge, false);
      }
    } else {
      const uint32_t v = node.vertex;
      for (uint32_t i = drawing_.starts[v]; i < drawing_.starts[v + 1]; ++i) {
        const uint32_t edge = drawing_.incident[i];
        consider(edge, drawing_.edges[edge][0] == v);
      }
      const Lattice point = drawing_.lattice[v];
      const EdgeGrid::Range near = grid_.edgesIn(grid_.cellAt(drawing_.points[v]));
      work_ += near.size();
      for (const uint32_t edge : near) {
        const Lattice a = end(edge, 0), b = end(edge, 1);
        if (drawing_.edges[edge][0] == v || drawing_.edges[edge][1] == v) continue;
        if (orient(a, b, point) != 0 || dot(point - a, point - b) > 0) continue;
        consider(edge, true);
        consider(edge, false);
      }
    }

    if (node.vertex == kNone) at_ = best == edge_ ? hit_.at : crossing(best, edge_);
    edge_ = best;
    forward_ = best_forward;
    if (node.vertex != kNone) at_ = along(drawing_.lattice[node.vertex]);
  }

  /// Where `edge` properly crosses `other`.
  Fraction crossing(uint32_t edge, uint32_t other) const {
    const Lattice c = end(other, 0), d = end(other, 1);
    const int64_t from = orient(c, d, end(edge, 0)), to = orient(c, d, end(edge, 1));
    return Fraction::of(from, from - to);
  }

  struct Hit {
    uint32_t vertex;
    Fraction at;  // on the current edge
  };

  const Drawing& drawing_;
  const EdgeGrid grid_;
  uint32_t edge_ = 0;    // where we are: on this edge,
  bool forward_ = true;  // towards its second end,
  Fraction at_;          // here
  Hit hit_{};
  size_t work_ = 0;
  std::vector<uint32_t> through_;      // edges that properly cross the current one at the hit
  std::vector<uint32_t> overlapping_;  // edges on the same line as the current one
};

/// Cuts a closed walk at the nodes it passes more than once; the piece with the largest area.
std::vector<Vec2> largestPiece(const std::vector<Node>& nodes, const std::vector<Vec2>& places) {
  const size_t n = nodes.size();
  std::vector<uint32_t> order(n), id(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    if (nodes[a] < nodes[b]) return true;
    return nodes[a] == nodes[b] && a < b;
  });
  for (size_t i = 0; i < n; ++i) {
    id[order[i]] = i > 0 && nodes[order[i]] == nodes[order[i - 1]] ? id[order[i - 1]]
                                                                   : static_cast<uint32_t>(i);
  }

  std::vector<Vec2> best, stack;
  std::vector<uint32_t> stack_ids, position(n, kNone);
  double best_area = 0;
  const auto close = [&](size_t from) {
    std::vector<Vec2> piece(stack.begin() + static_cast<std::ptrdiff_t>(from), stack.end());
    const double area = signedArea(piece);
    if (area > best_area) {
      best_area = area;
      best = std::move(piece);
    }
    for (size_t i = from; i < stack.size(); ++i) position[stack_ids[i]] = kNone;
    stack.resize(from);
    stack_ids.resize(from);
  };
  for (size_t i = 0; i < n; ++i) {
    if (position[id[i]] != kNone) close(position[id[i]]);
    position[id[i]] = static_cast<uint32_t>(stack.size());
    stack.push_back(places[i]);
    stack_ids.push_back(id[i]);
  }
  close(0);
  return best;
}

}  // namespace

std::optional<std::vector<Vec2>> outerBoundary(const std::vector<Vec2>& curve, size_t most_work) {
  const Drawing drawing(curve);
  if (drawing.edges.size() < 3) return std::vector<Vec2>{};
  const std::vector<Node> nodes = Walk(drawing).run(most_work);
  if (nodes.empty()) return std::nullopt;
  std::vector<Vec2> places;
  places.reserve(nodes.size());
  for (const Node& node : nodes) {
    if (node.vertex != kNone) {
      places.push_back(drawing.points[node.vertex]);
    } else {
      const auto& e = drawing.edges[node.edge];
      places.push_back(lerp(drawing.points[e[0]], drawing.points[e[1]], node.at.value()));
    }
  }
  return largestPiece(nodes, places);
}

}  // namespace marrow
