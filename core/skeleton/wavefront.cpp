// Our own straight skeleton: the polygon's edges move inward at unit speed; the vertices between
// them (the wavefront) trace the arcs. Declared in straight_skeleton.h.
//
// Everything happens in coordinates where the polygon's size is about 1, so that the tolerances
// below are lengths and times at once.
//
// Two kinds of events: a wavefront edge shrinks to nothing (edge event), or a reflex vertex runs
// into another edge (split event). Both end in one of two steps: a chain of vertices that meet in
// one point becomes one vertex (`collapse`), or two chains that meet exchange their ends (`split`).
// Vertex events are splits whose second chain is a vertex instead of the inside of an edge. Events
// that coincide are taken together by gathering everything that is at the same place at the same
// time, within a tolerance: regular shapes are the normal case, not the exception.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/box.h"
#include "skeleton/straight_skeleton.h"

namespace marrow {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr uint32_t kNone = 0xffffffff;
constexpr uint32_t kSplit = 0xfffffffe;

constexpr double kSamePlace = 1e-12;    // closer than this is one point
constexpr double kAntiparallel = 1e-9;  // sine below which two facing edges count as parallel
constexpr double kStraight = 1e-11;     // sine below which a vertex does not count as reflex
constexpr double kStandsStill = 1e-13;  // closing speed below which two things never meet
constexpr double kFast = 8;             // speed from which a vertex's place is not well conditioned
constexpr double kVeryFast = 1e4;       // speed from which times alone do not tell what is first
constexpr double kLongest = 1;          // nothing is left of the polygon by then
constexpr double kBlockMargin = 1e-9;   // above all tolerances of places
constexpr double kMergeNodes = 1e-9;    // arcs shorter than this join one node to another

// A border edge: its moving line is {x : dot(normal, x) = offset + t}.
struct Line {
  Vec2 normal;
  double offset;

  /// Position along the edge.
  double along(Vec2 p) const { return normal.y * p.x - normal.x * p.y; }
};

// A wavefront vertex between the line that comes in and the one that goes out. It lives from its
// creation to the event that ends it and is never changed in between, but for its neighbours. The
// wavefront edge from it to the next vertex goes by its name.
struct Vertex {
  Vec2 place;   // at its creation
  double time;  // of its creation
  Vec2 velocity;
  double speed;
  uint32_t in, out;
  uint32_t previous, next;
  uint32_t node;          // where its arc begins
  uint32_t split_target;  // the edge that it is expected to run into, if it is reflex; may be gone
  double split_time;      // when; of its next split event
  uint32_t loop;          // the same for all of one loop
  bool alive, reflex, stuck;

  Vec2 at(double t) const { return place + velocity * (t - time); }
  // How far `at` may be off: a fast vertex magnifies the rounding of the time.
  double tolerance() const { return kSamePlace + 4e-15 * speed; }
};

// Edge event: the wavefront edge from `vertex` to `other` shrinks to nothing.
// Split event: `vertex` may have reached another edge; `other` is kSplit.
struct Event {
  double time;
  uint32_t vertex, other;

  bool operator<(const Event& e) const {  // for a heap with the earliest on top
    if (time != e.time) return time > e.time;
    if (vertex != e.vertex) return vertex > e.vertex;
    return other > e.other;
  }
};

// A few neighbouring edges of the polygon.
struct Block {
  Vec2 low, high;         // around the places of its vertices
  Vec2 slowest, fastest;  // around their velocities, and standing still
};
constexpr uint32_t kBlock = 8;  // edges

class Wavefront {
 public:
  explicit Wavefront(const std::vector<Vec2>& polygon);
  bool run();
  StraightSkeleton result();

 private:
  uint32_t addNode(Vec2 place, double time);
  uint32_t addVertex(uint32_t in, uint32_t out, Vec2 place, uint32_t node, uint32_t loop);
  void link(uint32_t v, uint32_t w) {
    vertices_[v].next = w;
    vertices_[w].previous = v;
  }
  void retire(uint32_t v, uint32_t node);
  bool isAt(uint32_t v, Vec2 place) const;

  void push(double time, uint32_t vertex, uint32_t other);
  void expectEdgeEvent(uint32_t v);
  void expectFirstSplit(uint32_t v);
  void expectSplitEvent(uint32_t v, uint32_t edge, double wait);
  void expectAllSplits(const std::vector<Vec2>& points);
  bool reaches(const Vertex& v, Vec2 place, uint32_t edge, double& wait) const;
  uint32_t nextEdgeReached(uint32_t v, double& wait) const;
  void lookForNewSplits(uint32_t edge);
  double edgeEventTime(const Vertex& v, const Vertex& w) const;
  Vec2 meetingPlace(const Vertex& v, const Vertex& w) const;

  struct Chain {
    uint32_t first, last;
  };
  Chain gather(uint32_t first, uint32_t last, Vec2 place) const;
  bool isIn(uint32_t v, Chain chain) const;
  uint32_t retireChain(Chain chain, Vec2 place);
  void retireAt(Chain chain, uint32_t node);

  void collapse(uint32_t first, uint32_t last, Vec2 place);
  void arrive(uint32_t v, double end_speed, double start_speed);
  bool slide(uint32_t v, Chain& chain, Vec2& place);
  void handleEdge(uint32_t v, uint32_t w);
  void handleSplit(uint32_t v);
  void split(uint32_t v, uint32_t edge, Vec2 place);
  void nameLoops(uint32_t a, uint32_t b);
  void goOn(uint32_t v, Vec2 place, double end_speed, double start_speed);
  double endSpeed(const Vertex& v) const;
  double startSpeed(const Vertex& v) const;

  size_t n_;
  const std::vector<Vec2>& polygon_;
  Vec2 center_;
  double unit_ = 1;

  std::vector<Line> lines_;
  std::vector<Vertex> vertices_;
  std::vector<Event> events_;
  double now_ = 0;
  uint32_t reflex_count_ = 0;  // living ones
  uint32_t loop_count_ = 1;
  bool lost_ = false;

  std::vector<Vec2> places_;  // of the inner nodes; node n_ is the first
  std::vector<double> times_;
  std::vector<StraightSkeleton::Edge> arcs_;
};

// The velocity that keeps a point on both moving lines; nothing when they face each other.
bool velocityBetween(Vec2 in, Vec2 out, Vec2& velocity) {
  const double sine = cross(in, out), cosine = dot(in, out);
  if (cosine < 0) {
    if (std::fabs(sine) < kAntiparallel) return false;
    velocity = perpendicular(in - out) / sine;
  } else {
    velocity = (in + out) / (1 + cosine);
  }
  return true;
}

Wavefront::Wavefront(const std::vector<Vec2>& polygon) : n_(polygon.size()), polygon_(polygon) {
  const Box2 box = boxOf(polygon);
  center_ = box.middle();
  // A power of two, so that going there and back loses nothing.
  int exponent = 0;
  std::frexp(std::max(box.size().x, box.size().y), &exponent);
  unit_ = std::ldexp(1.0, exponent);

  const auto n = static_cast<uint32_t>(n_);
  std::vector<Vec2> points(n);
  for (uint32_t i = 0; i < n; ++i) points[i] = (polygon[i] - center_) / unit_;

  lines_.resize(n);
  vertices_.reserve(3 * n);
  events_.reserve(4 * n);
  places_.reserve(n);
  times_.reserve(n);
  arcs_.reserve(2 * n);
  for (uint32_t i = 0; i < n; ++i) {
    const Vec2 p = points[i], q = points[i + 1 == n ? 0 : i + 1];
    const double size = length(q - p);
    if (!(size > 0)) {
      lost_ = true;
      return;
    }
    Line& line = lines_[i];
    line.normal = perpendicular(q - p) / size;
    line.offset = dot(line.normal, p);
  }
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t v = addVertex(i == 0 ? n - 1 : i - 1, i, points[i], i, 0);
    if (i > 0) link(v - 1, v);
    lost_ = lost_ || vertices_[v].stuck;
  }
  link(n - 1, 0);
  if (lost_) return;
  for (uint32_t i = 0; i < n; ++i) expectEdgeEvent(i);
  expectAllSplits(points);
}

uint32_t Wavefront::addNode(Vec2 place, double time) {
  places_.push_back(place);
  times_.push_back(time);
  return static_cast<uint32_t>(n_ + places_.size() - 1);
}

uint32_t Wavefront::addVertex(uint32_t in, uint32_t out, Vec2 place, uint32_t node, uint32_t loop) {
  vertices_.emplace_back();  // filled where it is: copying what was just written is slow
  Vertex& v = vertices_.back();
  v.place = place;
  v.time = now_;
  v.in = in;
  v.out = out;
  v.node = node;
  v.previous = v.next = kNone;
  v.split_target = kNone;
  v.split_time = kNever;
  v.loop = loop;
  v.alive = true;
  const Vec2 a = lines_[in].normal, b = lines_[out].normal;
  v.stuck = !velocityBetween(a, b, v.velocity);
  if (v.stuck) v.velocity = {0, 0};
  v.speed = length(v.velocity);
  v.reflex = !v.stuck && cross(a, b) < -kStraight;
  if (v.reflex) ++reflex_count_;
  return static_cast<uint32_t>(vertices_.size() - 1);
}

// Ends v's life at a node and draws its arc.
void Wavefront::retire(uint32_t v, uint32_t node) {
  Vertex& vertex = vertices_[v];
  vertex.alive = false;
  if (vertex.reflex) --reflex_count_;
  if (vertex.node == node) return;
  const auto kind =
      vertex.node < n_ ? StraightSkeleton::Kind::peripheral : StraightSkeleton::Kind::skeleton;
  arcs_.emplace_back();
  StraightSkeleton::Edge& arc = arcs_.back();
  arc.a = vertex.node;
  arc.b = node;
  arc.kind = kind;
  arc.left = vertex.in;
  arc.right = vertex.out;
}

bool Wavefront::isAt(uint32_t v, Vec2 place) const {
  const Vertex& vertex = vertices_[v];
  return distance(vertex.at(now_), place) < vertex.tolerance();
}

void Wavefront::push(double time, uint32_t vertex, uint32_t other) {
  // As std::push_heap, without copying the event that was just written.
  time = std::max(time, now_);
  const Event event{time, vertex, other};
  size_t i = events_.size();
  events_.emplace_back();
  while (i > 0 && events_[(i - 1) / 2] < event) {
    events_[i] = events_[(i - 1) / 2];
    i = (i - 1) / 2;
  }
  events_[i].time = time;
  events_[i].vertex = vertex;
  events_[i].other = other;
}

// When the wavefront edge from v to w has shrunk to nothing.
double Wavefront::edgeEventTime(const Vertex& v, const Vertex& w) const {
  const Line& line = lines_[v.out];
  const double shrinking = line.along(v.velocity) - line.along(w.velocity);
  if (shrinking < kStandsStill) return kNever;
  if (std::max(v.speed, w.speed) < kFast) {
    return now_ + line.along(w.at(now_) - v.at(now_)) / shrinking;
  }
  // The place of a fast vertex is not well known; where the slower one meets the line on the fast
  // one's far side is.
  const bool follow_w = w.speed <= v.speed;
  const Vertex& followed = follow_w ? w : v;
  const Line& far = lines_[follow_w ? v.in : w.out];
  const double gap = dot(far.normal, followed.place) - far.offset - followed.time;
  const double closing = 1 - dot(far.normal, followed.velocity);
  return std::fabs(closing) < kStandsStill ? kNever : followed.time + gap / closing;
}

Vec2 Wavefront::meetingPlace(const Vertex& v, const Vertex& w) const {
  return v.speed < w.speed ? v.at(now_) : w.at(now_);
}

void Wavefront::expectEdgeEvent(uint32_t v) {
  const uint32_t w = vertices_[v].next;
  const double time = edgeEventTime(vertices_[v], vertices_[w]);
  if (time < kNever) push(time, v, w);
}

void Wavefront::expectSplitEvent(uint32_t v, uint32_t edge, double wait) {
  vertices_[v].split_target = edge;
  vertices_[v].split_time = std::max(now_ + wait, now_);
  push(vertices_[v].split_time, v, kSplit);
}

// Whether reflex vertex v, at `place` now, runs into the wavefront edge sooner than in `wait`, if
// everything goes on as it does now. Updates `wait`.
bool Wavefront::reaches(const Vertex& v, Vec2 place, uint32_t edge, double& wait) const {
  const Vertex &start = vertices_[edge], &end = vertices_[start.next];
  const Line& line = lines_[start.out];
  const double gap = dot(line.normal, place) - line.offset - now_;
  const double closing = 1 - dot(line.normal, v.velocity);
  if (gap < -kSamePlace || closing < kStandsStill || gap >= wait * closing) return false;
  const double until = std::max(gap / closing, 0.0), time = now_ + until;
  const double along = line.along(place + v.velocity * until);
  if (along < line.along(start.at(time)) - start.tolerance()) return false;
  if (along > line.along(end.at(time)) + end.tolerance()) return false;
  wait = until;
  return true;
}

// The first edge that v runs into, of all of its loop but its own two.
uint32_t Wavefront::nextEdgeReached(uint32_t v, double& wait) const {
  const Vertex& vertex = vertices_[v];
  const Vec2 place = vertex.at(now_);
  uint32_t target = kNone;
  wait = kNever;
  for (uint32_t edge = vertex.next; edge != vertex.previous; edge = vertices_[edge].next) {
    if (reaches(vertex, place, edge, wait)) target = edge;
  }
  return target;
}

// expectFirstSplit() for all reflex vertices of the polygon, which is most of what there is to look
// for. Edges are looked at in blocks; a block whose edges cannot touch the vertex's way before the
// soonest meeting known so far is passed over.
void Wavefront::expectAllSplits(const std::vector<Vec2>& points) {
  if (reflex_count_ == 0) return;
  const auto n = static_cast<uint32_t>(n_);
  std::vector<Block> blocks((n + kBlock - 1) / kBlock);
  for (uint32_t b = 0; b < blocks.size(); ++b) {
    const uint32_t first = b * kBlock, last = std::min(first + kBlock, n);
    Block block{points[first], points[first], {}, {}};
    for (uint32_t k = first; k <= last; ++k) {
      const uint32_t i = k == n ? 0 : k;
      block.low = {std::min(block.low.x, points[i].x), std::min(block.low.y, points[i].y)};
      block.high = {std::max(block.high.x, points[i].x), std::max(block.high.y, points[i].y)};
      const Vec2 velocity = vertices_[i].velocity;
      block.slowest = {std::min(block.slowest.x, velocity.x),
                       std::min(block.slowest.y, velocity.y)};
      block.fastest = {std::max(block.fastest.x, velocity.x),
                       std::max(block.fastest.y, velocity.y)};
    }
    blocks[b] = block;
  }

  uint32_t last_target = kNone;
  for (uint32_t v = 0; v < n; ++v) {
    const Vertex& vertex = vertices_[v];
    if (!vertex.reflex) continue;
    const uint32_t previous = vertex.previous;
    const Vec2 place = vertex.place;
    double wait = kLongest;
    uint32_t target = kNone;
    const auto look = [&](uint32_t edge) {
      if (edge != v && edge != previous && reaches(vertex, place, edge, wait)) target = edge;
    };
    // Neighbours often run into the same edge: a first guess.
    if (last_target != kNone) {
      look(last_target);
      look(vertices_[last_target].previous);
    }
    for (uint32_t b = 0; b < blocks.size(); ++b) {
      const Block& block = blocks[b];
      const Vec2 there = place + vertex.velocity * wait;
      const Vec2 low = block.low + block.slowest * wait, high = block.high + block.fastest * wait;
      if (std::min(place.x, there.x) > high.x + kBlockMargin ||
          std::max(place.x, there.x) < low.x - kBlockMargin ||
          std::min(place.y, there.y) > high.y + kBlockMargin ||
          std::max(place.y, there.y) < low.y - kBlockMargin) {
        continue;
      }
      const uint32_t end = std::min((b + 1) * kBlock, n);
      for (uint32_t edge = b * kBlock; edge < end; ++edge) look(edge);
    }
    if (target == kNone) continue;
    last_target = target;
    expectSplitEvent(v, target, wait);
  }
}

// Reflex vertices that did not expect this edge may run into it after all.
void Wavefront::lookForNewSplits(uint32_t edge) {
  if (reflex_count_ == 0) return;
  const uint32_t end = vertices_[edge].next;
  for (uint32_t v = vertices_[end].next; v != edge; v = vertices_[v].next) {
    const Vertex& vertex = vertices_[v];
    if (!vertex.reflex) continue;
    double wait = vertex.split_time - now_;
    if (reaches(vertex, vertex.at(now_), edge, wait)) expectSplitEvent(v, edge, wait);
  }
}

// All neighbours of first … last that are at `place` now.
Wavefront::Chain Wavefront::gather(uint32_t first, uint32_t last, Vec2 place) const {
  while (vertices_[last].next != first && isAt(vertices_[last].next, place)) {
    last = vertices_[last].next;
  }
  while (vertices_[first].previous != last && isAt(vertices_[first].previous, place)) {
    first = vertices_[first].previous;
  }
  return {first, last};
}

bool Wavefront::isIn(uint32_t v, Chain chain) const {
  for (uint32_t u = chain.first;; u = vertices_[u].next) {
    if (u == v) return true;
    if (u == chain.last) return false;
  }
}

// Ends the vertices of a chain at one node: one that is already here, or else a new one.
uint32_t Wavefront::retireChain(Chain chain, Vec2 place) {
  uint32_t node = kNone;
  for (uint32_t v = chain.first;; v = vertices_[v].next) {
    const Vertex& vertex = vertices_[v];
    if (vertex.node >= n_ && now_ - vertex.time < kSamePlace &&
        distance(vertex.place, place) < kSamePlace) {
      node = vertex.node;
      break;
    }
    if (v == chain.last) break;
  }
  if (node == kNone) node = addNode(place, now_);
  retireAt(chain, node);
  return node;
}

void Wavefront::retireAt(Chain chain, uint32_t node) {
  for (uint32_t v = chain.first;; v = vertices_[v].next) {
    retire(v, node);
    if (v == chain.last) return;
  }
}

// The vertices first … last, and whatever else is there, become one.
void Wavefront::collapse(uint32_t first, uint32_t last, Vec2 place) {
  Chain chain{first, last};
  for (;;) {
    chain = gather(chain.first, chain.last, place);
    const uint32_t before = vertices_[chain.first].previous, after = vertices_[chain.last].next;
    if (after == chain.first || before == after) {  // nothing else, or one more: all ends here
      if (before == after && after != chain.first) {
        const uint32_t other = after;
        const uint32_t node = retireChain(chain, place);
        retire(other, node);
      } else {
        retireChain(chain, place);
      }
      return;
    }
    const uint32_t in = vertices_[chain.first].in, out = vertices_[chain.last].out;
    const double end_speed = endSpeed(vertices_[chain.first]);
    const double start_speed = startSpeed(vertices_[chain.last]);
    const uint32_t node = retireChain(chain, place);
    const uint32_t v = addVertex(in, out, place, node, vertices_[before].loop);
    link(before, v);
    link(v, after);
    if (slide(v, chain, place)) continue;
    arrive(v, end_speed, start_speed);
    return;
  }
}

// A vertex between two edges that face each other has nowhere to go but along them, at once, to the
// nearer of its neighbours: a flat ridge.
bool Wavefront::slide(uint32_t v, Chain& chain, Vec2& place) {
  const Vertex& vertex = vertices_[v];
  if (!vertex.stuck) return false;
  const Vec2 before = vertices_[vertex.previous].at(now_), after = vertices_[vertex.next].at(now_);
  if (distance(after, place) <= distance(before, place)) {
    place = after;
    chain = {v, vertex.next};
  } else {
    place = before;
    chain = {vertex.previous, v};
  }
  return true;
}

// How fast a vertex moves along the edge that ends in it, and along the one that starts there. One
// that slides is at the other end at once.
double Wavefront::endSpeed(const Vertex& v) const {
  return v.stuck ? -kNever : lines_[v.in].along(v.velocity);
}
double Wavefront::startSpeed(const Vertex& v) const {
  return v.stuck ? kNever : lines_[v.out].along(v.velocity);
}

// A new vertex on its way. The speeds are those of the ends that its two edges had before: where a
// new end retreats more slowly, more of the edge will be there than was foreseen.
void Wavefront::arrive(uint32_t v, double end_speed, double start_speed) {
  expectEdgeEvent(vertices_[v].previous);
  expectEdgeEvent(v);
  expectFirstSplit(v);
  if (endSpeed(vertices_[v]) > end_speed) lookForNewSplits(vertices_[v].previous);
  if (startSpeed(vertices_[v]) < start_speed) lookForNewSplits(v);
}

void Wavefront::expectFirstSplit(uint32_t v) {
  if (!vertices_[v].reflex) return;
  double wait;
  const uint32_t edge = nextEdgeReached(v, wait);
  if (edge != kNone) expectSplitEvent(v, edge, wait);
}

// A very fast vertex meets both its neighbours at what is the same time to double precision: which
// one comes first is better told from how far away they are.
void Wavefront::handleEdge(uint32_t v, uint32_t w) {
  const bool v_is_fast = vertices_[v].speed > vertices_[w].speed;
  const Vertex &fast = vertices_[v_is_fast ? v : w], &slow = vertices_[v_is_fast ? w : v];
  if (fast.speed > kVeryFast) {
    const uint32_t third = v_is_fast ? fast.previous : fast.next;
    const Vertex& other = vertices_[third];
    const double time = v_is_fast ? edgeEventTime(other, fast) : edgeEventTime(fast, other);
    if (time < now_ + kSamePlace &&
        distance(other.at(now_), fast.place) < distance(slow.at(now_), fast.place)) {
      if (v_is_fast) {
        w = v;
        v = third;
      } else {
        v = w;
        w = third;
      }
    }
  }
  collapse(v, w, meetingPlace(vertices_[v], vertices_[w]));
}

void Wavefront::handleSplit(uint32_t v) {
  const Vertex& vertex = vertices_[v];
  const uint32_t target = vertex.split_target;
  double wait = kSamePlace;
  if (vertices_[target].alive && vertices_[target].loop == vertex.loop && target != v &&
      target != vertex.previous && reaches(vertex, vertex.at(now_), target, wait)) {
    split(v, target, vertex.at(now_));
    return;
  }
  const uint32_t edge = nextEdgeReached(v, wait);
  if (edge == kNone) {
    vertices_[v].split_time = kNever;
  } else if (wait < kSamePlace) {
    split(v, edge, vertices_[v].at(now_));
  } else {
    expectSplitEvent(v, edge, wait);
  }
}

// v and all that is with it meet the wavefront edge that starts at `edge`, inside or at an end.
void Wavefront::split(uint32_t v, uint32_t edge, Vec2 place) {
  const Chain mine = gather(v, v, place);
  if (mine.first != mine.last) {
    collapse(mine.first, mine.last, place);
    return;
  }
  const uint32_t line = vertices_[edge].out;
  uint32_t start = edge, end = vertices_[edge].next;  // what B follows and A goes on to
  uint32_t a_out = line, b_in = line;
  Chain theirs{kNone, kNone};
  if (isAt(start, place)) {
    theirs = gather(start, start, place);
  } else if (isAt(end, place)) {
    theirs = gather(end, end, place);
  }
  if (theirs.first != kNone) {
    if (isIn(v, theirs)) {
      collapse(theirs.first, theirs.last, place);
      return;
    }
    // Next to each other, with an edge of no length between them.
    if (vertices_[v].next == theirs.first) {
      collapse(v, theirs.last, place);
      return;
    }
    if (vertices_[theirs.last].next == v) {
      collapse(theirs.first, v, place);
      return;
    }
    start = vertices_[theirs.first].previous;
    end = vertices_[theirs.last].next;
    a_out = vertices_[theirs.last].out;
    b_in = vertices_[theirs.first].in;
  }
  const Vertex vertex = vertices_[v];
  const double their_start = startSpeed(vertices_[theirs.first == kNone ? start : theirs.last]);
  const double their_end = endSpeed(vertices_[theirs.first == kNone ? end : theirs.first]);
  const uint32_t node = retireChain({v, v}, place);
  if (theirs.first != kNone) retireAt(theirs, node);
  const uint32_t a = addVertex(vertex.in, a_out, place, node, vertex.loop);
  const uint32_t b = addVertex(b_in, vertex.out, place, node, vertex.loop);
  link(vertex.previous, a);
  link(a, end);
  link(start, b);
  link(b, vertex.next);
  nameLoops(a, b);
  goOn(a, place, endSpeed(vertex), their_start);
  goOn(b, place, their_end, startSpeed(vertex));
}

// A loop has become two: the shorter one gets a new name.
void Wavefront::nameLoops(uint32_t a, uint32_t b) {
  uint32_t u = vertices_[a].next, w = vertices_[b].next;
  while (u != a && w != b) {
    u = vertices_[u].next;
    w = vertices_[w].next;
  }
  const uint32_t shorter = u == a ? a : b, name = loop_count_++;
  for (w = shorter;; w = vertices_[w].next) {
    vertices_[w].loop = name;
    if (vertices_[w].next == shorter) return;
  }
}

// What becomes of a vertex that a split has made.
void Wavefront::goOn(uint32_t v, Vec2 place, double end_speed, double start_speed) {
  Chain chain;
  if (vertices_[v].next == vertices_[v].previous) {
    const uint32_t other = vertices_[v].next, node = vertices_[v].node;
    retire(v, node);
    retire(other, node);
  } else if (slide(v, chain, place)) {
    collapse(chain.first, chain.last, place);
  } else {
    arrive(v, end_speed, start_speed);
  }
}

bool Wavefront::run() {
  if (lost_) return false;
  const size_t limit = 1000 + 40 * n_;  // never seen above 6 n
  for (size_t count = 0; !events_.empty(); ++count) {
    if (count > limit) return false;
    std::pop_heap(events_.begin(), events_.end());
    const Event event = events_.back();
    events_.pop_back();
    if (!vertices_[event.vertex].alive) continue;
    if (event.other == kSplit) {
      if (event.time != vertices_[event.vertex].split_time) continue;
      now_ = std::max(now_, event.time);
      handleSplit(event.vertex);
    } else if (vertices_[event.vertex].next == event.other) {
      now_ = std::max(now_, event.time);
      handleEdge(event.vertex, event.other);
    }
  }
  for (const Vertex& v : vertices_) {
    if (v.alive) return false;
  }
  return true;
}

StraightSkeleton Wavefront::result() {
  // Nodes that an arc of no length joins are one.
  const size_t inner = places_.size();
  std::vector<uint32_t> same(n_ + inner);
  for (size_t i = 0; i < same.size(); ++i) same[i] = static_cast<uint32_t>(i);
  const auto root = [&](uint32_t i) {
    while (same[i] != i) i = same[i] = same[same[i]];
    return i;
  };
  for (const auto& arc : arcs_) {
    if (arc.kind != StraightSkeleton::Kind::skeleton) continue;
    if (distance(places_[arc.a - n_], places_[arc.b - n_]) >= kMergeNodes) continue;
    const uint32_t a = root(arc.a), b = root(arc.b);
    same[std::max(a, b)] = std::min(a, b);
  }

  StraightSkeleton out;
  out.method = StraightSkeleton::Method::wavefront;
  out.nodes.reserve(n_ + inner);
  out.times.reserve(n_ + inner);
  out.nodes = polygon_;
  out.times.assign(n_, 0.0);
  std::vector<uint32_t> index(n_ + inner);
  for (size_t i = 0; i < n_; ++i) index[i] = static_cast<uint32_t>(i);
  for (size_t i = n_; i < n_ + inner; ++i) {
    if (same[i] != i) continue;
    index[i] = static_cast<uint32_t>(out.nodes.size());
    out.nodes.push_back(places_[i - n_] * unit_ + center_);
    out.times.push_back(times_[i - n_] * unit_);
  }
  out.edges.resize(n_ + arcs_.size());
  StraightSkeleton::Edge* edge = out.edges.data();
  for (uint32_t i = 0; i < n_; ++i, ++edge) {
    edge->a = edge->left = edge->right = i;
    edge->b = i + 1 == n_ ? 0 : i + 1;
    edge->kind = StraightSkeleton::Kind::border;
  }
  for (const auto& arc : arcs_) {
    const uint32_t a = index[root(arc.a)], b = index[root(arc.b)];
    if (a == b) continue;
    *edge = arc;
    edge->a = a;
    edge->b = b;
    ++edge;
  }
  out.edges.resize(static_cast<size_t>(edge - out.edges.data()));
  return out;
}

}  // namespace

Result<StraightSkeleton> straightSkeletonByWavefront(const std::vector<Vec2>& polygon) {
  if (polygon.size() < 3) return Status::tooFewPoints;
  Wavefront wavefront(polygon);
  if (!wavefront.run()) return {Status::skeletonFailed, "the wavefront did not end"};
  StraightSkeleton skeleton = wavefront.result();
  std::string fault = inconsistency(polygon, skeleton);
  if (!fault.empty()) return {Status::skeletonFailed, std::move(fault)};
  return skeleton;
}

}  // namespace marrow
