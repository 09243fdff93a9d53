#include "skeleton/limb_joints.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace marrow {
namespace {

constexpr double kMostLevel = std::numeric_limits<double>::max();

// Limbs longer than so many of their radii have a joint,
constexpr double kLong = 3;
// in this part of their length around the middle; in the narrowest place of it, where that is
constexpr double kAside = 0.3;
// narrower than this part of what is on both sides of it.
constexpr double kNarrow = 0.75;
// What bends nearer to the middle of a junction's ball than this part of its radius does not count.
constexpr double kInBall = 0.9;
// How long they stay as the threshold grows, × the usual one.
constexpr double kMouthLevel = 4;
constexpr double kMiddleLevel = 3;
constexpr double kCrowdedLevel = 0.2;
constexpr double kBelow = 0.98;

class LimbJoints {
 public:
  LimbJoints(const std::vector<BranchSample>& samples, double usual, std::vector<double>& levels)
      : samples_(samples), usual_(usual), levels_(levels), last_(samples.size() - 1) {}

  void run(const BranchEnd& start, const BranchEnd& end) {
    const double length = samples_[last_].along;
    const double from_start = start.junction ? start.radius : 0;
    const double from_end = end.junction ? end.radius : 0;
    body_ = meanRadius(from_start, length - from_end);
    size_t first = 0, last = last_;
    first = mouth(start, false);
    last = mouth(end, true);
    if (first >= last) {
      first = 0;
      last = last_;
    }
    if (first > 0) raise(first, kMouthLevel);
    if (last < last_) raise(last, kMouthLevel);
    mouths_ = {first, last};
    addMiddle(first, last, first == 0 && start.junction ? start.radius : 0,
              last == last_ && end.junction ? end.radius : 0);
    thinOut(start, end);
  }

 private:
  double along(size_t i) const { return samples_[i].along; }

  double meanRadius(double from, double to) const {
    double sum = 0;
    int count = 0;
    for (const BranchSample& sample : samples_) {
      if (sample.along < from || sample.along > to) continue;
      sum += sample.radius;
      ++count;
    }
    return count ? sum / count : 0;
  }

  /// The sample of a limb's joint at the body; that of the end, where it has none.
  size_t mouth(const BranchEnd& end, bool from_end) const {
    if (!end.mouth) return from_end ? last_ : 0;
    size_t best = 1;
    for (size_t i = 1; i < last_; ++i) {
      if (distance(samples_[i].point, *end.mouth) < distance(samples_[best].point, *end.mouth))
        best = i;
    }
    return best;
  }

  void raise(size_t i, double times) { levels_[i] = std::max(levels_[i], times * usual_); }

  /// Between two joints; what lies in the balls of junctions there is not of the limb.
  void addMiddle(size_t first, size_t last, double ball_first, double ball_last) {
    const double from = along(first) + ball_first / 2, to = along(last) - ball_last / 2;
    const double length = to - from;
    if (!(length > kLong * meanRadius(from, to))) return;
    // The longest stretch between its bends.
    double low = from, high = from, last_bend = from;
    for (size_t i = first + 1; i <= last; ++i) {
      const bool bends = i < last && levels_[i] > usual_ && along(i) > from && along(i) < to;
      if (i < last && !bends) continue;
      const double here = i < last ? along(i) : to;
      if (bends && here > from + kAside * length && here < to - kAside * length) return;
      if (here - last_bend > high - low) {
        low = last_bend;
        high = here;
      }
      last_bend = here;
    }
    const double centre = (low + high) / 2, aside = kAside * (high - low);
    size_t middle = 0, narrow = 0;
    for (size_t i = first + 1; i < last; ++i) {
      const double here = std::abs(along(i) - centre);
      if (here > (high - low) / 2 - aside) continue;
      if (middle == 0 || here < std::abs(along(middle) - centre)) middle = i;
      if (narrow == 0 || samples_[i].radius < samples_[narrow].radius) narrow = i;
    }
    if (middle == 0) return;
    double before = 0, after = 0;
    for (size_t i = first; i <= last; ++i) {
      if (along(i) < low || along(i) > high) continue;
      double& side = i < narrow ? before : after;
      side = std::max(side, samples_[i].radius);
    }
    const bool narrows = samples_[narrow].radius < kNarrow * std::min(before, after);
    raise(narrows ? narrow : middle, kMiddleLevel);
  }

  void thinOut(const BranchEnd& start, const BranchEnd& end) {
    std::vector<size_t> order;
    for (size_t i = 1; i < last_; ++i) {
      if (levels_[i] > usual_) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return rank(a) > rank(b); });
    std::vector<size_t> kept;
    const double length = along(last_);
    for (const size_t i : order) {
      const double radius = std::max(samples_[i].radius, body_);
      bool crowded = isCrowded(along(i), start, radius, levels_[i]) ||
                     isCrowded(length - along(i), end, radius, levels_[i]);
      for (const size_t other : kept) {
        crowded = crowded || std::abs(along(i) - along(other)) < radius;
      }
      // What is needed to stay inside comes back by keepInside.
      if (crowded) {
        levels_[i] = std::min(kCrowdedLevel * levels_[i], kBelow * usual_);
      } else {
        kept.push_back(i);
      }
    }
  }

  /// Too near to an end for a joint of that radius and level.
  bool isCrowded(double away, const BranchEnd& end, double radius, double level) const {
    if (!end.junction) return away < radius;
    return away < kInBall * end.radius && level < kMouthLevel * usual_;
  }

  /// Mouths before all that is not needed to stay inside.
  double rank(size_t i) const {
    const bool is_mouth = i == mouths_[0] || i == mouths_[1];
    return is_mouth ? std::max(levels_[i], kMostLevel) : levels_[i];
  }

  const std::vector<BranchSample>& samples_;
  double usual_;
  std::vector<double>& levels_;
  size_t last_;
  std::array<size_t, 2> mouths_{};
  double body_ = 0;
};

}  // namespace

void addLimbJoints(const std::vector<BranchSample>& samples, const BranchEnd& start,
                   const BranchEnd& end, double usual, std::vector<double>& levels) {
  if (samples.size() < 3) return;
  LimbJoints(samples, usual, levels).run(start, end);
}

}  // namespace marrow
