// When the wavefront's reflex vertices run into other edges.
//
// Where there are few edges, all are looked at. Otherwise time is cut into periods, each long
// enough for a good part of the edges to vanish. What every edge and every reflex vertex may pass
// within the period is known at its start, and indexed; a vertex is then compared only with what
// lies in its way, and an edge that becomes longer than was foreseen only with the vertices whose
// way it lies in. Nothing goes far in a short time, and what has vanished by the end of a period is
// never looked at again.

#include <algorithm>
#include <cmath>

#include "skeleton/wavefront.h"

namespace marrow {
namespace {

constexpr double kLongest = 1;      // nothing is left of the polygon by then
constexpr double kMargin = 1e-9;    // above the tolerances of places, but for fast vertices
constexpr double kOverlap = 1e-9;   // of two periods, so that nothing falls between them
constexpr size_t kFewLines = 64;    // up to so many, all edges are looked at
constexpr size_t kManyLines = 400;  // periods are shorter from here, as they cost less than
                                    // what they save
constexpr size_t kRun = SlabHierarchy::kRun;

template <typename Vertex>
double marginOf(const Vertex& v) {
  return kMargin + v.tolerance();
}

}  // namespace

double Wavefront::timeLeft() const {
  return std::min(period_end_ + kOverlap, now_ + kLongest) - now_;
}

// Where the wavefront edge passes until it is gone or the period ends.
Sweep Wavefront::sweptBy(uint32_t edge) const {
  const Vertex &start = vertices_[edge], &end = vertices_[start.next];
  const double gone = std::max(start.edge_time, now_) + kOverlap;
  const double until = std::min(now_ + timeLeft(), gone);
  return {{start.at(now_), start.at(until), marginOf(start)},
          {end.at(now_), end.at(until), marginOf(end)},
          until};
}

// Whether a place on the line of the wavefront edge is between the edge's ends at that time.
bool Wavefront::passes(Vec2 place, uint32_t edge, double time) const {
  const Vertex &start = vertices_[edge], &end = vertices_[start.next];
  const Line& line = lines_[start.out];
  const double along = line.along(place);
  return along >= line.along(start.at(time)) - start.tolerance() &&
         along <= line.along(end.at(time)) + end.tolerance();
}

void Wavefront::expectSplitEvent(uint32_t v, uint32_t edge, double wait) {
  vertices_[v].split_target = edge;
  vertices_[v].split_time = std::max(now_ + wait, now_);
  push(vertices_[v].split_time, v, kSplit);
}

void Wavefront::expectFirstSplits() {
  if (reflex_count_ == 0) return;
  const auto n = static_cast<uint32_t>(n_);
  if (n > kFewLines) {
    lines_left_.resize(n);
    for (uint32_t i = 0; i < n; ++i) lines_left_[i] = i;
    startPeriod();
  } else {
    for (uint32_t i = 0; i < n; ++i) expectFirstSplit(i);
  }
}

void Wavefront::expectFirstSplit(uint32_t v) {
  Vertex& vertex = vertices_[v];
  if (!vertex.reflex) return;
  if (indexed_ && vertex.way == kNone) newcomers_.push_back(v);
  double wait;
  const uint32_t edge = nextEdgeReached(v, wait);
  if (edge != kNone) expectSplitEvent(v, edge, wait);
}

// All splits are looked for anew.
void Wavefront::startPeriod() {
  if (period_end_ < kNever) now_ = std::max(now_, period_end_);
  period_end_ = kNever;
  indexed_ = false;
  if (reflex_count_ == 0) return;
  keepCurrentEvents();
  keepLinesLeft();
  if (lines_left_.size() > kFewLines) buildIndex();
  for (const uint32_t line : lines_left_) {
    for (uint32_t v = lines_[line].first_vertex; v != kNone; v = vertices_[v].sibling) {
      expectFirstSplit(v);
    }
  }
}

void Wavefront::keepCurrentEvents() {
  size_t count = 0;
  for (const Event& event : events_) {
    if (event.other == kSplit || !vertices_[event.vertex].alive || !isCurrent(event)) continue;
    events_[count++] = event;
  }
  events_.resize(count);
  std::make_heap(events_.begin(), events_.end());
}

void Wavefront::keepLinesLeft() {
  size_t count = 0;
  for (const uint32_t line : lines_left_) {
    uint32_t* link = &lines_[line].first_vertex;
    while (*link != kNone) {
      Vertex& vertex = vertices_[*link];
      if (vertex.alive) {
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
}

void Wavefront::buildIndex() {
  indexed_ = true;
  const size_t count = lines_left_.size();
  line_runs_.assign((count + kRun - 1) / kRun, LineRun{});
  edges_.reset(count);
  walkers_.clear();
  newcomers_.clear();
  times_.clear();
  for (size_t i = 0; i < count; ++i) {
    const Line& line = lines_[lines_left_[i]];
    LineRun& run = line_runs_[i / kRun];
    const size_t k = i % kRun;
    run.x[k] = line.normal.x;
    run.y[k] = line.normal.y;
    run.offset[k] = line.offset;
    for (uint32_t v = line.first_vertex; v != kNone; v = vertices_[v].sibling) {
      const Vertex& vertex = vertices_[v];
      if (vertex.edge_time < kNever) times_.push_back(vertex.edge_time);
      edges_.orient(i, vertices_[vertex.next].at(now_) - vertex.at(now_));
      if (vertex.reflex) walkers_.push_back(v);
    }
  }
  if (times_.size() > count / 8) {
    const size_t part = times_.size() / (count > kManyLines ? 3 : 2);
    const auto end = times_.begin() + static_cast<std::ptrdiff_t>(part);
    std::nth_element(times_.begin(), end, times_.end());
    period_end_ = *end * (1 + 1e-6) + kOverlap;
    if (!events_.empty()) period_end_ = std::max(period_end_, events_.front().time);
  }
  for (size_t i = 0; i < count; ++i) {
    for (uint32_t v = lines_[lines_left_[i]].first_vertex; v != kNone; v = vertices_[v].sibling) {
      const Vertex& vertex = vertices_[v];
      edges_.include(i, sweptBy(v), marginOf(vertex) + marginOf(vertices_[vertex.next]));
    }
  }
  ways_.reset(walkers_.size());
  for (size_t i = 0; i < walkers_.size(); ++i) {
    vertices_[walkers_[i]].way = static_cast<uint32_t>(i);
    ways_.orient(i, vertices_[walkers_[i]].velocity);
  }
}

// The first edge that v runs into, of all of its loop but its own two; or else it may expect to be
// looked at again.
uint32_t Wavefront::nextEdgeReached(uint32_t v, double& wait) {
  Vertex& vertex = vertices_[v];
  vertex.split_time = kNever;
  if (indexed_) return nextEdgeReachedNearby(v, wait);
  const Vec2 place = vertex.at(now_);
  uint32_t target = kNone;
  wait = kNever;
  for (uint32_t edge = vertex.next; edge != vertex.previous; edge = vertices_[edge].next) {
    if (reaches(vertex, place, edge, wait)) target = edge;
  }
  return target;
}

uint32_t Wavefront::nextEdgeReachedNearby(uint32_t v, double& wait) {
  const Vertex& vertex = vertices_[v];
  const Vec2 place = vertex.at(now_);
  wait = timeLeft();
  // Not beyond its end, as far as that is known now.
  const double end =
      std::min(vertices_[vertex.previous].edge_time, vertex.edge_time) - now_ + kOverlap;
  const bool ends = end > 0 && end < wait;
  if (ends) wait = end;

  uint32_t target = kNone;
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
  edges_.visit(way, [&](size_t first) {
    // Whether the vertex gets as far as the lines, as in reaches().
    const LineRun& run = line_runs_[first / kRun];
    double apart[kRun];
    for (size_t k = 0; k < kRun; ++k) {
      const double gap = run.x[k] * place.x + run.y[k] * place.y - run.offset[k] - now_;
      const double closing = 1 - (run.x[k] * vertex.velocity.x + run.y[k] * vertex.velocity.y);
      apart[k] = std::max(-kSamePlace - gap, gap - wait * closing);
    }
    for (size_t k = 0; k < kRun; ++k) {
      if (apart[k] > 0) continue;
      for (uint32_t edge = lines_[lines_left_[first + k]].first_vertex; edge != kNone;
           edge = vertices_[edge].sibling) {
        if (look(edge)) way = {place, place + vertex.velocity * wait, margin};
      }
    }
  });
  if (vertex.way != kNone) ways_.include(vertex.way, way, margin);
  if (target != kNone) {
    last_target_ = target;
  } else if (ends) {
    expectSplitEvent(v, kNone, wait);
  }
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
  const Line& line = lines_[vertices_[edge].out];
  if (old_speed > -kNever && old_speed < kNever) {
    // Only what lies between where the end goes and where it would have gone.
    const Way& way = ends ? swept.end : swept.start;
    const Vec2 old_velocity = line.normal + line.direction() * old_speed;
    const Way old_way{way.a, way.a + old_velocity * (swept.until - now_), marginOf(fresh)};
    swept = {way, old_way, swept.until};
  }
  edges_.include(line.rank, swept, marginOf(vertices_[edge]) + marginOf(vertices_[end]));
  const auto lookIfThere = [&](uint32_t u) {
    const Vertex& vertex = vertices_[u];
    if (vertex.alive && vertex.loop == fresh.loop && u != edge && u != end) look(u);
  };
  ways_.visit(swept, [&](size_t first) {
    const size_t last = std::min(first + kRun, walkers_.size());
    for (size_t i = first; i < last; ++i) lookIfThere(walkers_[i]);
  });
  for (const uint32_t u : newcomers_) lookIfThere(u);
}

}  // namespace marrow
