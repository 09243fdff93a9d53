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
#include "skeleton/slab_hierarchy.h"
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
constexpr double kMargin = 1e-9;        // above the tolerances of places, but for fast vertices
constexpr double kOverlap = 1e-9;       // of two periods
constexpr double kMergeNodes = 1e-9;    // arcs shorter than this join one node to another
constexpr size_t kRun = SlabHierarchy::kRun;
constexpr uint32_t kFew = 64;  // edges: up to so many are all looked at

// A border edge: its moving line is {x : dot(normal, x) = offset + t}.
struct Line {
  Vec2 normal;
  double offset;
  uint32_t first_vertex = 0xffffffff;  // of those whose wavefront edges are part of it: siblings
  uint32_t rank = 0;                   // among the lines that have any

  /// Position along the edge.
  double along(Vec2 p) const { return normal.y * p.x - normal.x * p.y; }
  Vec2 direction() const { return {normal.y, -normal.x}; }
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
  double edge_time;       // when its wavefront edge will have shrunk to nothing
  uint32_t loop;          // the same for all of one loop
  uint32_t way;           // among the ways that are looked up
  uint32_t sibling;       // another whose wavefront edge is part of the same border edge
  bool alive, reflex, stuck;
  bool expected;  // whether the event at edge_time is among the events

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

// The lines of a run of edges side by side; where there are fewer, they are out of reach.
struct LineRun {
  double x[kRun], y[kRun], offset[kRun];

  LineRun() {
    for (size_t k = 0; k < kRun; ++k) {
      x[k] = y[k] = 0;
      offset[k] = 1e9;
    }
  }
};

class Wavefront {
 public:
  explicit Wavefront(const std::vector<Vec2>& polygon);
  bool run();
  StraightSkeleton result();

 private:
  void mergeNodes();
  uint32_t addNode(Vec2 place, double time);
  uint32_t addVertex(uint32_t in, uint32_t out, Vec2 place, uint32_t node, uint32_t loop);
  void link(uint32_t v, uint32_t w) {
    vertices_[v].next = w;
    vertices_[w].previous = v;
  }
  void retire(uint32_t v, uint32_t node);
  bool isAt(uint32_t v, Vec2 place) const;

  void push(double time, uint32_t vertex, uint32_t other);
  void timeEdgeEvent(uint32_t v);
  void expectEdgeEvent(uint32_t v);
  void expectFirstSplit(uint32_t v);
  void expectSplitEvent(uint32_t v, uint32_t edge, double wait);
  void startPeriod();
  double timeLeft() const { return std::min(period_end_ + kOverlap, now_ + kLongest) - now_; }
  Sweep sweptBy(uint32_t edge) const;
  bool passes(Vec2 place, uint32_t edge, double time) const;
  bool reaches(const Vertex& v, Vec2 place, uint32_t edge, double& wait) const;
  uint32_t nextEdgeReached(uint32_t v, double& wait);
  void lookForNewSplits(uint32_t v, bool ends, double old_speed);
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
  Vec2 center_;
  double unit_ = 1;

  std::vector<Line> lines_;
  std::vector<Vertex> vertices_;
  std::vector<Event> events_;
  double now_ = 0, period_end_ = kNever;
  bool indexed_ = false;
  uint32_t reflex_count_ = 0;  // living ones
  uint32_t loop_count_ = 1;
  uint32_t last_target_ = kNone;
  bool lost_ = false;

  // What may run into what until the period ends; for each line that still has wavefront edges.
  SlabHierarchy edges_;               // where they will pass
  SlabHierarchy ways_;                // of the reflex vertices that they start from
  std::vector<uint32_t> lines_left_;  // in their order
  std::vector<uint32_t> walkers_, newcomers_;
  std::vector<LineRun> line_runs_;
  std::vector<double> scratch_;

  StraightSkeleton skeleton_;  // as it grows; inner nodes and times in our coordinates
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
  if (n > kFew && reflex_count_ > 0) {
    lines_left_.resize(n);
    for (uint32_t i = 0; i < n; ++i) lines_left_[i] = i;
    startPeriod();
  } else {
    for (uint32_t i = 0; i < n; ++i) expectFirstSplit(i);
  }
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

void Wavefront::expectSplitEvent(uint32_t v, uint32_t edge, double wait) {
  vertices_[v].split_target = edge;
  vertices_[v].split_time = std::max(now_ + wait, now_);
  push(vertices_[v].split_time, v, kSplit);
}

// Whether a place on the line of the wavefront edge is between the edge's ends at that time.
bool Wavefront::passes(Vec2 place, uint32_t edge, double time) const {
  const Vertex &start = vertices_[edge], &end = vertices_[start.next];
  const Line& line = lines_[start.out];
  const double along = line.along(place);
  return along >= line.along(start.at(time)) - start.tolerance() &&
         along <= line.along(end.at(time)) + end.tolerance();
}

// Whether reflex vertex v, at `place` now, runs into the wavefront edge sooner than in `wait`, if
// everything goes on as it does now. Updates `wait`.
inline bool Wavefront::reaches(const Vertex& v, Vec2 place, uint32_t edge, double& wait) const {
  const Vertex& start = vertices_[edge];
  const Line& line = lines_[start.out];
  const double gap = dot(line.normal, place) - line.offset - now_;
  const double closing = 1 - dot(line.normal, v.velocity);
  if (gap < -kSamePlace || closing < kStandsStill || gap >= wait * closing) return false;
  const double until = std::max(gap / closing, 0.0);
  if (!passes(place + v.velocity * until, edge, now_ + until)) return false;
  wait = until;
  return true;
}

double marginOf(const Vertex& v) { return kMargin + v.tolerance(); }

// Where the wavefront edge passes until it is gone or the period ends.
Sweep Wavefront::sweptBy(uint32_t edge) const {
  const Vertex &start = vertices_[edge], &end = vertices_[start.next];
  const double gone = std::max(start.edge_time, now_) + kOverlap;
  const double until = std::min(now_ + timeLeft(), gone);
  return {{start.at(now_), start.at(until), marginOf(start)},
          {end.at(now_), end.at(until), marginOf(end)},
          until};
}

// Looks for all split events until the end of a period in which about half of the edges will
// vanish. In a short time nothing goes far, so that little can run into little; what has vanished
// by the end need never be looked at again.
void Wavefront::startPeriod() {
  now_ = period_end_ < kNever ? std::max(now_, period_end_) : now_;
  period_end_ = kNever;
  indexed_ = false;
  if (reflex_count_ == 0) return;

  // All splits are looked for anew, and what is out of date among the edge events may go.
  scratch_.clear();
  size_t kept = 0;
  for (const Event& event : events_) {
    if (event.other == kSplit || !vertices_[event.vertex].alive ||
        vertices_[event.vertex].next != event.other) {
      continue;
    }
    events_[kept++] = event;
  }
  events_.resize(kept);
  std::make_heap(events_.begin(), events_.end());

  size_t count = 0;
  for (const uint32_t line : lines_left_) {
    uint32_t* link = &lines_[line].first_vertex;
    while (*link != kNone) {
      Vertex& vertex = vertices_[*link];
      if (vertex.alive) {
        if (vertex.edge_time < kNever) scratch_.push_back(vertex.edge_time);
        link = &vertex.sibling;
      } else {
        *link = vertex.sibling;
      }
    }
    if (lines_[line].first_vertex == kNone) continue;
    lines_[line].rank = static_cast<uint32_t>(count);
    lines_left_[count++] = line;
  }
  lines_left_.resize(count);

  if (count > kFew) {
    indexed_ = true;
    if (scratch_.size() > count / 8) {
      const auto middle =
          scratch_.begin() + static_cast<long>(scratch_.size() / (count > 400 ? 3 : 2));
      std::nth_element(scratch_.begin(), middle, scratch_.end());
      period_end_ = *middle * (1 + 1e-6) + kOverlap;
    }
    edges_.reset(count);
    walkers_.clear();
    newcomers_.clear();
    for (size_t i = 0; i < count; ++i) {
      for (uint32_t v = lines_[lines_left_[i]].first_vertex; v != kNone; v = vertices_[v].sibling) {
        const Vertex& vertex = vertices_[v];
        edges_.orient(i, vertices_[vertex.next].at(now_) - vertex.at(now_));
        if (vertex.reflex) walkers_.push_back(v);
      }
    }
    line_runs_.assign((count + kRun - 1) / kRun, LineRun{});
    for (size_t i = 0; i < count; ++i) {
      const Line& line = lines_[lines_left_[i]];
      LineRun& run = line_runs_[i / kRun];
      const size_t k = i % kRun;
      run.x[k] = line.normal.x;
      run.y[k] = line.normal.y;
      run.offset[k] = line.offset;
    }
    ways_.reset(walkers_.size());
    for (size_t i = 0; i < walkers_.size(); ++i) {
      vertices_[walkers_[i]].way = static_cast<uint32_t>(i);
      ways_.orient(i, vertices_[walkers_[i]].velocity);
    }
    for (size_t i = 0; i < count; ++i) {
      for (uint32_t v = lines_[lines_left_[i]].first_vertex; v != kNone; v = vertices_[v].sibling) {
        const Vertex& vertex = vertices_[v];
        edges_.include(i, sweptBy(v), marginOf(vertex) + marginOf(vertices_[vertex.next]));
      }
    }
  }
  for (const uint32_t line : lines_left_) {
    for (uint32_t v = lines_[line].first_vertex; v != kNone; v = vertices_[v].sibling) {
      vertices_[v].split_time = kNever;
      expectFirstSplit(v);
    }
  }
}

// The first edge that v runs into, of all of its loop but its own two.
uint32_t Wavefront::nextEdgeReached(uint32_t v, double& wait) {
  const Vertex& vertex = vertices_[v];
  const Vec2 place = vertex.at(now_);
  uint32_t target = kNone;
  vertices_[v].split_time = kNever;
  if (!indexed_) {
    wait = kNever;
    for (uint32_t edge = vertex.next; edge != vertex.previous; edge = vertices_[edge].next) {
      if (reaches(vertex, place, edge, wait)) target = edge;
    }
    return target;
  }
  wait = timeLeft();
  // Not beyond its end, as far as that is known now.
  const double end =
      std::min(vertices_[vertex.previous].edge_time, vertex.edge_time) - now_ + kOverlap;
  const bool ends = end > 0 && end < wait;
  if (ends) wait = end;
  const double horizon = now_ + wait;
  const auto look = [&](uint32_t edge) {
    const Vertex& start = vertices_[edge];
    if (start.alive && start.loop == vertex.loop && edge != v && edge != vertex.previous &&
        reaches(vertex, place, edge, wait)) {
      target = edge;
      return true;
    }
    return false;
  };
  // Neighbours often run into the same edge: a first guess.
  if (last_target_ != kNone) {
    look(last_target_);
    look(vertices_[last_target_].previous);
  }
  const double margin = marginOf(vertex);
  Way way{place, place + vertex.velocity * wait, margin};
  const auto lookAtRun = [&](size_t first) {
    // Whether the vertex gets as far as the lines, as in reaches().
    const LineRun& run = line_runs_[first / kRun];
    const Vec2 from = place, velocity = vertex.velocity;
    const double time = now_, within = wait;
    double apart[kRun];
    for (size_t k = 0; k < kRun; ++k) {
      const double gap = run.x[k] * from.x + run.y[k] * from.y - run.offset[k] - time;
      const double closing = 1 - (run.x[k] * velocity.x + run.y[k] * velocity.y);
      apart[k] = std::max(-kSamePlace - gap, gap - within * closing);
    }
    for (size_t k = 0; k < kRun; ++k) {
      if (apart[k] > 0) continue;
      for (uint32_t e = lines_[lines_left_[first + k]].first_vertex; e != kNone;
           e = vertices_[e].sibling) {
        if (look(e)) way = {place, place + vertex.velocity * wait, margin};
      }
    }
  };
  edges_.visit(way, lookAtRun);
  if (vertex.way != kNone) {
    ways_.include(vertex.way, way, margin);
  } else {
    newcomers_.push_back(v);
  }
  if (target != kNone) last_target_ = target;
  if (target == kNone && ends) expectSplitEvent(v, kNone, horizon - now_);
  return target;
}

// The new vertex v ends an edge, or starts it. Where it retreats more slowly than what was there
// before, reflex vertices may run into what is left of the edge then.
void Wavefront::lookForNewSplits(uint32_t v, bool ends, double old_speed) {
  if (reflex_count_ == 0) return;
  const Vertex& fresh = vertices_[v];
  const double speed = ends ? endSpeed(fresh) : startSpeed(fresh);
  if (ends ? speed <= old_speed : speed >= old_speed) return;
  const uint32_t edge = ends ? fresh.previous : v, end = ends ? v : fresh.next;
  const auto look = [&](uint32_t u) {
    const Vertex& vertex = vertices_[u];
    double wait = vertex.split_time - now_;
    if (indexed_) wait = std::min(wait, timeLeft());
    if (reaches(vertex, vertex.at(now_), edge, wait)) expectSplitEvent(u, edge, wait);
  };
  if (!indexed_) {
    for (uint32_t u = vertices_[end].next; u != edge; u = vertices_[u].next) {
      if (vertices_[u].reflex) look(u);
    }
    return;
  }
  Sweep swept = sweptBy(edge);
  if (old_speed > -kNever && old_speed < kNever) {
    // Only what lies between where the end goes and where it would have gone.
    const Line& line = lines_[vertices_[edge].out];
    const Vec2 old_velocity = line.normal + line.direction() * old_speed;
    const Way& way = ends ? swept.end : swept.start;
    const double time = swept.until - now_;
    swept = {way, {way.a, way.a + old_velocity * time, marginOf(fresh)}, swept.until};
  }
  edges_.include(lines_[vertices_[edge].out].rank, swept,
                 marginOf(vertices_[edge]) + marginOf(vertices_[end]));
  ways_.visit(swept, [&](size_t first) {
    const size_t last = std::min(first + kRun, walkers_.size());
    for (size_t i = first; i < last; ++i) {
      const uint32_t u = walkers_[i];
      const Vertex& vertex = vertices_[u];
      if (!vertex.alive || u == edge || u == end || vertex.loop != fresh.loop) continue;
      look(u);
    }
  });
  for (const uint32_t u : newcomers_) {
    const Vertex& vertex = vertices_[u];
    if (!vertex.alive || u == edge || u == end || vertex.loop != fresh.loop) continue;
    look(u);
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
