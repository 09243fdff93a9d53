// Our own straight skeleton: the polygon's edges move inward at unit speed; the vertices between
// them (the wavefront) trace the arcs. For straight_skeleton.h alone; wavefront.cpp has what
// happens at an event, wavefront_splits.cpp finds out when reflex vertices run into something.
//
// Everything happens in coordinates where the polygon's size is about 1, so that the tolerances
// are lengths and times at once.
//
// Two kinds of events: a wavefront edge shrinks to nothing (edge event), or a reflex vertex runs
// into another edge (split event). Both end in one of two steps: a chain of vertices that meet in
// one point becomes one vertex (`collapse`), or two chains that meet exchange their ends (`split`).
// Vertex events are splits whose second chain is a vertex instead of the inside of an edge. Events
// that coincide are taken together by gathering everything that is at the same place at the same
// time, within a tolerance: regular shapes are the normal case, not the exception.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "skeleton/slab_hierarchy.h"
#include "skeleton/straight_skeleton.h"

namespace marrow {

class Wavefront {
 public:
  explicit Wavefront(const std::vector<Vec2>& polygon);
  /// Whether it came to an end.
  bool run();
  StraightSkeleton result();

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr uint32_t kNone = 0xffffffff;
  static constexpr uint32_t kSplit = 0xfffffffe;

  static constexpr double kSamePlace = 1e-12;    // closer than this is one point
  static constexpr double kStandsStill = 1e-13;  // closing speed below which two never meet

  // A border edge: its moving line is {x : dot(normal, x) = offset + t}.
  struct Line {
    Vec2 normal;
    double offset;
    uint32_t first_vertex = kNone;  // of those whose wavefront edges are part of it: siblings
    uint32_t rank = 0;              // among the lines that have any

    /// Position along the edge.
    double along(Vec2 p) const { return normal.y * p.x - normal.x * p.y; }
    Vec2 direction() const { return {normal.y, -normal.x}; }
  };

  // A wavefront vertex between the line that comes in and the one that goes out. It lives from its
  // creation to the event that ends it and is never changed in between, but for its neighbours and
  // what is expected of it. The wavefront edge from it to the next vertex goes by its name.
  struct Vertex {
    Vec2 place;   // at its creation
    double time;  // of its creation
    Vec2 velocity;
    double speed;
    uint32_t in, out;
    uint32_t previous, next;
    uint32_t node;          // where its arc begins
    uint32_t split_target;  // the edge that it is expected to run into, if it is reflex; may be
                            // gone; none where it is only to be looked for again
    double split_time;      // when; of its next split event
    double edge_time;       // when its wavefront edge will have shrunk to nothing
    uint32_t loop;          // the same for all of one loop
    uint32_t way;           // its number among the walkers
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

  // Neighbours in a loop, from the first to the last.
  struct Chain {
    uint32_t first, last;
  };

  // Eight lines side by side, so that they can be looked at together; where there are fewer, they
  // are out of reach.
  struct LineRun {
    static constexpr size_t kSize = SlabHierarchy::kRun;
    double x[kSize], y[kSize], offset[kSize];

    LineRun() {
      for (size_t k = 0; k < kSize; ++k) {
        x[k] = y[k] = 0;
        offset[k] = 1e9;
      }
    }
  };

  // Building blocks.
  uint32_t addNode(Vec2 place, double time);
  uint32_t addVertex(uint32_t in, uint32_t out, Vec2 place, uint32_t node, uint32_t loop);
  void link(uint32_t v, uint32_t w) {
    vertices_[v].next = w;
    vertices_[w].previous = v;
  }
  void retire(uint32_t v, uint32_t node);
  uint32_t retireChain(Chain chain, Vec2 place);
  void retireAt(Chain chain, uint32_t node);
  bool isAt(uint32_t v, Vec2 place) const;
  Chain gather(uint32_t first, uint32_t last, Vec2 place) const;
  bool isIn(uint32_t v, Chain chain) const;
  void mergeNodes();

  // What happens at an event.
  void handleEdge(uint32_t v, uint32_t w);
  void handleSplit(uint32_t v);
  void collapse(uint32_t first, uint32_t last, Vec2 place);
  void split(uint32_t v, uint32_t edge, Vec2 place);
  bool slide(uint32_t v, Chain& chain, Vec2& place);
  void arrive(uint32_t v, double end_speed, double start_speed);
  void goOn(uint32_t v, Vec2 place, double end_speed, double start_speed);
  void nameLoops(uint32_t a, uint32_t b);

  // Which events there will be.
  void push(double time, uint32_t vertex, uint32_t other);
  bool isCurrent(const Event& edge_event) const;
  void timeEdgeEvent(uint32_t v);
  void expectEdgeEvent(uint32_t v);
  double edgeEventTime(const Vertex& v, const Vertex& w) const;
  Vec2 meetingPlace(const Vertex& v, const Vertex& w) const;
  // How fast a vertex moves along the edge that ends in it, and along the one that starts there.
  // One that slides is at the other end at once.
  double endSpeed(const Vertex& v) const {
    return v.stuck ? -kNever : lines_[v.in].along(v.velocity);
  }
  double startSpeed(const Vertex& v) const {
    return v.stuck ? kNever : lines_[v.out].along(v.velocity);
  }

  // What reflex vertices run into.
  void expectFirstSplits();
  void expectFirstSplit(uint32_t v);
  void expectSplitEvent(uint32_t v, uint32_t edge, double wait);
  uint32_t nextEdgeReached(uint32_t v, double& wait);
  uint32_t nextEdgeReachedNearby(uint32_t v, double& wait);
  void lookForNewSplits(uint32_t v, bool ends, double old_speed);
  bool reaches(const Vertex& v, Vec2 place, uint32_t edge, double& wait) const;
  bool passes(Vec2 place, uint32_t edge, double time) const;
  void startPeriod();
  void keepCurrentEvents();
  void keepLinesLeft();
  void buildIndex();
  double timeLeft() const;
  Sweep sweptBy(uint32_t edge) const;

  size_t n_;
  Vec2 center_;
  double unit_ = 1;
  bool lost_ = false;

  std::vector<Line> lines_;
  std::vector<Vertex> vertices_;
  std::vector<Event> events_;
  double now_ = 0;
  uint32_t reflex_count_ = 0;  // living ones
  uint32_t loop_count_ = 1;

  // What may run into what until the period ends, where there is much.
  bool indexed_ = false;
  double period_end_ = kNever;
  std::vector<uint32_t> lines_left_;  // those that still have wavefront edges, in their order
  std::vector<LineRun> line_runs_;    // the same
  SlabHierarchy edges_;               // where the wavefront edges of each will pass
  std::vector<uint32_t> walkers_;     // the reflex vertices when the period began
  SlabHierarchy ways_;                // where they will pass, as far as has been looked
  std::vector<uint32_t> newcomers_;   // the reflex vertices since
  uint32_t last_target_ = kNone;
  std::vector<double> times_;  // for finding a period's end

  StraightSkeleton skeleton_;  // as it grows; inner nodes and times in our coordinates
};

// Whether reflex vertex v, at `place` now, runs into the wavefront edge sooner than in `wait`, if
// everything goes on as it does now. Updates `wait`.
inline bool Wavefront::reaches(const Vertex& v, Vec2 place, uint32_t edge, double& wait) const {
  const Line& line = lines_[vertices_[edge].out];
  const double gap = dot(line.normal, place) - line.offset - now_;
  const double closing = 1 - dot(line.normal, v.velocity);
  if (gap < -kSamePlace || closing < kStandsStill || gap >= wait * closing) return false;
  const double until = std::max(gap / closing, 0.0);
  if (!passes(place + v.velocity * until, edge, now_ + until)) return false;
  wait = until;
  return true;
}

}  // namespace marrow
