// A hierarchy of bounding volumes for thin things that lie askew, where boxes along x and y would
// be mostly empty: each has a slab in a direction of its own, too.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/box.h"

namespace marrow {

/// The way from a to b, and a margin around it.
struct Way {
  Vec2 a, b;
  Box2 box;

  Way(Vec2 start, Vec2 end, double margin) : a(start), b(end) {
    const Vec2 by{margin, margin};
    box = {least(a, b) - by, most(a, b) + by};
  }
  double leastAlong(Vec2 axis) const { return std::min(dot(axis, a), dot(axis, b)); }
  double mostAlong(Vec2 axis) const { return std::max(dot(axis, a), dot(axis, b)); }
};

/// What a segment passes whose ends go two ways.
struct Sweep {
  Way start, end;
  double until;  // when they are at the ends of their ways
  Box2 box;

  Sweep(const Way& v, const Way& w, double t) : start(v), end(w), until(t), box(v.box) {
    box.include(w.box);
  }
  double leastAlong(Vec2 axis) const {
    return std::min(start.leastAlong(axis), end.leastAlong(axis));
  }
  double mostAlong(Vec2 axis) const { return std::max(start.mostAlong(axis), end.mostAlong(axis)); }
};

/// Over things that come in an order in which neighbours are near each other, as the edges of a
/// polygon do: runs of eight have a volume, runs of eight of these, and so on. Volumes grow, and
/// shrink only by a reset.
class SlabHierarchy {
 public:
  static constexpr size_t kRun = 8;

  /// Empty volumes for `count` things. O(count).
  void reset(size_t count) {
    count_ = count;
    size_t size = 0, runs = (count + kRun - 1) / kRun;
    starts_.clear();
    for (;;) {
      starts_.push_back(size);
      const size_t groups = (runs + kRun - 1) / kRun;
      size += groups;
      if (groups <= 1) break;
      runs = groups;
    }
    starts_.push_back(size);
    groups_.assign(size, Group{});
  }

  /// Where thing i extends farthest to, before anything is included: slabs go along the longest.
  void orient(size_t i, Vec2 extent) {
    for (size_t level = 0; level + 1 < starts_.size(); ++level) {
      i /= kRun;
      Group& group = groups_[starts_[level] + i / kRun];
      const size_t k = i % kRun;
      const Vec2 old{group.across_x[k], group.across_y[k]};
      if (dot(extent, extent) <= dot(old, old)) return;
      group.across_x[k] = -extent.y;
      group.across_y[k] = extent.x;
    }
  }

  /// All volumes around thing i become large enough for a way or sweep, whose box has the margin
  /// around it. O(log count).
  template <typename Swept>
  void include(size_t i, const Swept& swept, double margin) {
    for (size_t level = 0; level + 1 < starts_.size(); ++level) {
      i /= kRun;
      Group& group = groups_[starts_[level] + i / kRun];
      const size_t k = i % kRun;
      const Vec2 across{group.across_x[k], group.across_y[k]};
      const double by = margin * (std::fabs(across.x) + std::fabs(across.y));
      group.low_x[k] = std::min(group.low_x[k], swept.box.low.x);
      group.low_y[k] = std::min(group.low_y[k], swept.box.low.y);
      group.high_x[k] = std::max(group.high_x[k], swept.box.high.x);
      group.high_y[k] = std::max(group.high_y[k], swept.box.high.y);
      group.low[k] = std::min(group.low[k], swept.leastAlong(across) - by);
      group.high[k] = std::max(group.high[k], swept.mostAlong(across) + by);
    }
  }

  /// Calls visit(i) for the first things i of all runs where all volumes around them may meet what
  /// is swept. Visit may make that smaller.
  template <typename Swept, typename Visit>
  void visit(const Swept& swept, const Visit& visit) const {
    if (count_ > 0) visitGroup(starts_.size() - 2, 0, swept, visit);
  }

 private:
  // Eight side by side, so that they can be looked at together.
  struct Group {
    double low_x[kRun], low_y[kRun], high_x[kRun], high_y[kRun];
    double across_x[kRun], across_y[kRun];  // the slab's normal, of any length
    double low[kRun], high[kRun];

    Group() {
      constexpr double kMost = std::numeric_limits<double>::max();
      for (size_t k = 0; k < kRun; ++k) {
        low_x[k] = low_y[k] = low[k] = kMost;
        high_x[k] = high_y[k] = high[k] = -kMost;
        across_x[k] = across_y[k] = 0;
      }
    }
  };

  template <typename Swept, typename Visit>
  void visitGroup(size_t level, size_t i, const Swept& swept, const Visit& visit) const {
    const Group& group = groups_[starts_[level] + i];
    double apart[kRun];
    for (size_t k = 0; k < kRun; ++k) {
      const Vec2 across{group.across_x[k], group.across_y[k]};
      const double x =
          std::max(group.low_x[k] - swept.box.high.x, swept.box.low.x - group.high_x[k]);
      const double y =
          std::max(group.low_y[k] - swept.box.high.y, swept.box.low.y - group.high_y[k]);
      const double slab = std::max(swept.leastAlong(across) - group.high[k],
                                   group.low[k] - swept.mostAlong(across));
      apart[k] = std::max(std::max(x, y), slab);
    }
    for (size_t k = 0; k < kRun; ++k) {
      if (apart[k] > 0) continue;
      if (level > 0) {
        visitGroup(level - 1, i * kRun + k, swept, visit);
      } else {
        visit((i * kRun + k) * kRun);
      }
    }
  }

  std::vector<size_t> starts_;  // of the levels among the groups, and where all end
  size_t count_ = 0;
  std::vector<Group> groups_;  // of the runs, of the runs of runs …
};

}  // namespace marrow
