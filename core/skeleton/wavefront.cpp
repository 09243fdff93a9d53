// What happens when the wavefront's edges vanish and its vertices meet.

#include "skeleton/wavefront.h"

#include <cmath>

#include "base/box.h"

namespace marrow {
namespace {

constexpr double kAntiparallel = 1e-9;  // sine below which two facing edges count as parallel
constexpr double kStraight = 1e-11;     // sine below which a vertex does not count as reflex
constexpr double kFast = 8;             // speed from which a vertex's place is not well conditioned
constexpr double kVeryFast = 1e4;       // speed from which times alone do not tell what is first
constexpr double kMergeNodes = 1e-9;    // arcs shorter than this join one node to another

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

}  // namespace

Wavefront::Wavefront(const std::vector<Vec2>& polygon) : n_(polygon.size()) {
  const Box2 box = boxOf(polygon);
  center_ = box.middle();
  // A power of two, so that going there and back loses nothing.
  int exponent = 0;
  std::frexp(std::max(box.size().x, box.size().y), &exponent);
  unit_ = std::ldexp(1.0, exponent);

  const auto n = static_cast<uint32_t>(n_);
  const auto pointOf = [&](uint32_t i) { return (polygon[i] - center_) / unit_; };
  lines_.resize(n);
  vertices_.reserve(3 * n);
  events_.reserve(4 * n);
  skeleton_.nodes.reserve(2 * n);
  skeleton_.nodes = polygon;
  skeleton_.times.reserve(2 * n);
  skeleton_.times.assign(n, 0.0);
  skeleton_.edges.reserve(3 * n);
  skeleton_.edges.resize(n);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t next = i + 1 == n ? 0 : i + 1;
    skeleton_.edges[i] = {i, next, StraightSkeleton::Kind::border, i, i};
    const Vec2 p = pointOf(i), q = pointOf(next);
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
    const uint32_t v = addVertex(i == 0 ? n - 1 : i - 1, i, pointOf(i), i, 0);
    if (i > 0) link(v - 1, v);
    lost_ = lost_ || vertices_[v].stuck;
  }
  link(n - 1, 0);
  if (lost_) return;
  for (uint32_t i = 0; i < n; ++i) timeEdgeEvent(i);
  for (uint32_t i = 0; i < n; ++i) expectEdgeEvent(i);
  expectFirstSplits();
}

uint32_t Wavefront::addNode(Vec2 place, double time) {
  skeleton_.nodes.push_back(place);
  skeleton_.times.push_back(time);
  return static_cast<uint32_t>(skeleton_.nodes.size() - 1);
}

uint32_t Wavefront::addVertex(uint32_t in, uint32_t out, Vec2 place, uint32_t node, uint32_t loop) {
  vertices_.emplace_back();  // filled where it is: copying what was just written is slow
  Vertex& v = vertices_.back();
  v.place = place;
  v.time = now_;
  v.in = in;
  v.out = out;
  v.node = node;
  v.previous = v.next = v.way = kNone;
  v.split_target = kNone;
  v.split_time = v.edge_time = kNever;
  v.loop = loop;
  v.sibling = lines_[out].first_vertex;
  lines_[out].first_vertex = static_cast<uint32_t>(vertices_.size() - 1);
  v.alive = true;
  v.expected = false;
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
  skeleton_.edges.emplace_back();
  StraightSkeleton::Edge& arc = skeleton_.edges.back();
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

// Whether the edge of an edge event still is what it was then.
bool Wavefront::isCurrent(const Event& edge_event) const {
  const Vertex& vertex = vertices_[edge_event.vertex];
  return vertex.next == edge_event.other && vertex.edge_time <= edge_event.time;
}

void Wavefront::timeEdgeEvent(uint32_t v) {
  Vertex& vertex = vertices_[v];
  vertex.edge_time = edgeEventTime(vertex, vertices_[vertex.next]);
  vertex.expected = false;
}

// An edge whose neighbour vanishes before it is another edge by then.
void Wavefront::expectEdgeEvent(uint32_t v) {
  Vertex& vertex = vertices_[v];
  if (vertex.expected || !(vertex.edge_time < kNever) ||
      vertex.edge_time > vertices_[vertex.previous].edge_time ||
      vertex.edge_time > vertices_[vertex.next].edge_time) {
    return;
  }
  vertex.expected = true;
  push(vertex.edge_time, v, vertex.next);
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

// A new vertex on its way. The speeds are those of the ends that its two edges had before: where a
// new end retreats more slowly, more of the edge will be there than was foreseen.
void Wavefront::arrive(uint32_t v, double end_speed, double start_speed) {
  const uint32_t before = vertices_[v].previous, after = vertices_[v].next;
  timeEdgeEvent(before);
  timeEdgeEvent(v);
  expectEdgeEvent(vertices_[before].previous);
  expectEdgeEvent(before);
  expectEdgeEvent(v);
  expectEdgeEvent(after);
  expectFirstSplit(v);
  lookForNewSplits(v, true, end_speed);
  lookForNewSplits(v, false, start_speed);
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
  if (target != kNone && vertices_[target].alive && vertices_[target].loop == vertex.loop &&
      target != v && target != vertex.previous && reaches(vertex, vertex.at(now_), target, wait)) {
    split(v, target, vertex.at(now_));
    return;
  }
  const uint32_t edge = nextEdgeReached(v, wait);
  if (edge == kNone) {
    // Nothing comes, or it is looked for again.
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
    while (!events_.empty() && events_.front().time > period_end_) startPeriod();
    if (events_.empty()) break;
    std::pop_heap(events_.begin(), events_.end());
    const Event event = events_.back();
    events_.pop_back();
    if (!vertices_[event.vertex].alive) continue;
    if (event.other == kSplit) {
      if (event.time != vertices_[event.vertex].split_time) continue;
      now_ = std::max(now_, event.time);
      handleSplit(event.vertex);
    } else if (isCurrent(event)) {
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
  mergeNodes();
  for (size_t i = n_; i < skeleton_.nodes.size(); ++i) {
    skeleton_.nodes[i] = skeleton_.nodes[i] * unit_ + center_;
    skeleton_.times[i] = skeleton_.times[i] * unit_;
  }
  return std::move(skeleton_);
}

// Nodes that an arc of no length joins are one.
void Wavefront::mergeNodes() {
  auto& [nodes, times, edges, method] = skeleton_;
  (void)method;
  std::vector<uint32_t> same;
  const auto root = [&](uint32_t i) {
    while (same[i] != i) i = same[i] = same[same[i]];
    return i;
  };
  for (size_t i = n_; i < edges.size(); ++i) {
    const auto& arc = edges[i];
    if (arc.kind != StraightSkeleton::Kind::skeleton) continue;
    const Vec2 across = nodes[arc.b] - nodes[arc.a];
    if (dot(across, across) >= kMergeNodes * kMergeNodes) continue;
    if (same.empty()) {
      same.resize(nodes.size());
      for (size_t k = 0; k < same.size(); ++k) same[k] = static_cast<uint32_t>(k);
    }
    const uint32_t a = root(arc.a), b = root(arc.b);
    same[std::max(a, b)] = std::min(a, b);
  }
  if (same.empty()) return;

  std::vector<uint32_t> index(nodes.size());
  size_t count = 0;
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (same[i] != i) continue;
    index[i] = static_cast<uint32_t>(count);
    nodes[count] = nodes[i];
    times[count++] = times[i];
  }
  nodes.resize(count);
  times.resize(count);
  count = n_;
  for (size_t i = n_; i < edges.size(); ++i) {
    StraightSkeleton::Edge arc = edges[i];
    arc.a = index[root(arc.a)];
    arc.b = index[root(arc.b)];
    if (arc.a != arc.b) edges[count++] = arc;
  }
  edges.resize(count);
}

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
