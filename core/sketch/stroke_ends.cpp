#include "sketch/stroke_ends.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sketch/polygon.h"

namespace marrow {
namespace {

// With fewer samples, or with a gap no wider than from sample to sample, the line that closes the
// stroke is one of its edges like any other.
constexpr size_t kFewSamples = 24;
constexpr double kWideGap = 1.5;  // × the mean distance of two samples

/// A stroke seen from one of its ends.
class Tail {
 public:
  Tail(const std::vector<Vec2>& stroke, bool from_back) : stroke_(stroke), from_back_(from_back) {}

  Vec2 sample(size_t i) const { return stroke_[from_back_ ? stroke_.size() - 1 - i : i]; }

  /// The place this far from the end along the stroke, and the first sample beyond it.
  std::pair<Vec2, size_t> at(double arc) const {
    for (size_t i = 1; i < stroke_.size(); ++i) {
      const double step = distance(sample(i - 1), sample(i));
      if (arc < step) return {lerp(sample(i - 1), sample(i), arc / step), i};
      arc -= step;
    }
    return {sample(stroke_.size() - 1), stroke_.size()};
  }

  /// From a point to the nearest place within `reach` of the end.
  double distanceTo(Vec2 point, double reach) const {
    double best = distance(sample(0), point);
    for (size_t i = 1; i < stroke_.size() && reach > 0; ++i) {
      best = std::min(best, distanceToSegment(sample(i - 1), sample(i), point));
      reach -= distance(sample(i - 1), sample(i));
    }
    return best;
  }

  /// The direction towards the end, over a stretch from `arc` on.
  Vec2 outwards(double arc, double stretch) const {
    const Vec2 way = at(arc).first - at(arc + stretch).first;
    const double size = length(way);
    return size > 0 ? way / size : Vec2{};
  }

 private:
  const std::vector<Vec2>& stroke_;
  bool from_back_;
};

/// Where the end runs on beside the start, both going the same way, the closing line would run
/// back. Takes as much from either end as lets it go forward. Empty where nothing is to be taken.
/// stretch: the length over which directions are taken. surely: only if each end is close to the
/// other's flank.
std::vector<Vec2> withoutOverlap(const std::vector<Vec2>& stroke, double gap, double stretch,
                                 bool surely) {
  constexpr double kForward = 0.5, kSameWay = 0.3;    // cosines
  constexpr double kMostCut = 2, kCutStep = 1 / 16.;  // × the gap
  constexpr double kClose = 0.3;                      // × the gap
  const Tail head(stroke, false), tail(stroke, true);
  if (surely && (head.distanceTo(stroke.back(), 2 * gap) > kClose * gap ||
                 tail.distanceTo(stroke.front(), 2 * gap) > kClose * gap)) {
    return {};
  }
  for (double cut = 0; cut <= kMostCut * gap; cut += kCutStep * gap) {
    const auto [start, first] = head.at(cut);
    const auto [end, last] = tail.at(cut);
    const Vec2 from_start = -head.outwards(cut, stretch), to_end = tail.outwards(cut, stretch);
    const Vec2 closing = start - end;
    const double size = length(closing);
    const double by_start = dot(closing, from_start), by_end = dot(closing, to_end);
    if (cut == 0) {
      if (by_start >= 0 || by_end >= 0 || dot(from_start, to_end) < kSameWay) return {};
    } else if (std::min(by_start, by_end) >= kForward * size) {
      std::vector<Vec2> rest{start};
      rest.insert(rest.end(), stroke.begin() + static_cast<std::ptrdiff_t>(first),
                  stroke.end() - static_cast<std::ptrdiff_t>(last));
      rest.push_back(end);
      return rest;
    }
  }
  return {};
}

struct Candidate {
  size_t index;    // counted from its end
  double cut_off;  // length of the stroke beyond it
};

/// Samples at which a tail may be cut, from the end inwards.
std::vector<Candidate> candidates(const Tail& tail, size_t count, double longest) {
  constexpr size_t kMost = 64;
  std::vector<Candidate> all{{0, 0}};
  double cut_off = 0;
  for (size_t i = 1; i < count; ++i) {
    cut_off += distance(tail.sample(i - 1), tail.sample(i));
    if (cut_off > longest) break;
    all.push_back({i, cut_off});
  }
  const size_t stride = (all.size() + kMost - 1) / kMost;
  std::vector<Candidate> some;
  for (size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

/// Where one end comes close to the other's flank, the rest of that other one sticks out.
std::vector<Vec2> withoutSpur(const std::vector<Vec2>& stroke, double gap) {
  constexpr double kMuchCloser = 0.4;  // × the gap
  constexpr double kCutCost = 0.6;     // gap that must be saved for each unit cut off
  const Tail head(stroke, false), tail(stroke, true);
  const size_t n = stroke.size();
  const auto starts = candidates(head, n / 3, gap / kCutCost);
  const auto ends = candidates(tail, n / 3, gap / kCutCost);
  double least_cost = gap;
  size_t first = 0, last = 0;
  for (const Candidate& a : starts) {
    for (const Candidate& b : ends) {
      const double cut_cost = kCutCost * (a.cut_off + b.cut_off);
      if (cut_cost >= least_cost) break;
      const double closed = distance(head.sample(a.index), tail.sample(b.index));
      if (closed > kMuchCloser * gap || closed + cut_cost >= least_cost) continue;
      least_cost = closed + cut_cost;
      first = a.index;
      last = b.index;
    }
  }
  return {stroke.begin() + static_cast<std::ptrdiff_t>(first),
          stroke.end() - static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

std::vector<Vec2> trimOvershoot(const std::vector<Vec2>& stroke) {
  // Of the stroke's length. Wider, a side of the shape itself may be missing there.
  constexpr double kWidestOverlap = 0.15, kWidestSpur = 0.1;
  constexpr double kSmallOverlap = 0.03;
  constexpr double kStretch = 0.015;
  constexpr double kLongestEdge = 0.6;  // × the gap: then it is no ordinary edge
  const size_t n = stroke.size();
  if (n < kFewSamples) return stroke;
  double length_of_stroke = 0, longest_edge = 0;
  for (size_t i = 1; i < n; ++i) {
    const double edge = distance(stroke[i - 1], stroke[i]);
    length_of_stroke += edge;
    longest_edge = std::max(longest_edge, edge);
  }
  const double gap = distance(stroke.front(), stroke.back());
  if (gap < kWideGap * length_of_stroke / static_cast<double>(n - 1)) return stroke;
  if (gap <= kWidestOverlap * length_of_stroke) {
    std::vector<Vec2> closed =
        withoutOverlap(stroke, gap, std::min(gap, kStretch * length_of_stroke),
                       gap > kSmallOverlap * length_of_stroke);
    if (!closed.empty()) return closed;
  }
  if (gap <= kWidestSpur * length_of_stroke && longest_edge < kLongestEdge * gap) {
    return withoutSpur(stroke, gap);
  }
  return stroke;
}

}  // namespace marrow
