#include "skeleton/limb_joints.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace marrow {
namespace {

constexpr double kAlways = std::numeric_limits<double>::infinity();

// A limb is thinner than this part of the ball that it leaves.
constexpr double kThinner = 0.8;
// Its mouth lies between these parts of the ball's radius from the ball's middle,
constexpr double kMouthFrom = 0.45;
constexpr double kMouthTo = 0.9;
// as soon as the limb is nearly as thin as it is on the whole.
constexpr double kNearlyThin = 1.25;
// Limbs longer than so many of their radii have a joint,
constexpr double kLong = 3;
// in this part of their length around the middle; in the narrowest place of it, where that is
constexpr double kAside = 0.2;
// narrower than this part of what is on both sides of it.
constexpr double kNarrow = 0.75;
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
    const double body = body_ = meanRadius(from_start, length - from_end);
    size_t first = 0, last = last_;
    if (start.junction) first = mouth(start, body, false);
    if (end.junction) last = mouth(end, body, true);
    if (first >= last) {
      first = 0;
      last = last_;
    }
    if (first > 0) raise(first, kMouthLevel);
    if (last < last_) raise(last, kMouthLevel);
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

  /// The sample at which a limb leaves the ball of a junction; of the junction itself, where it is
  /// none.
  size_t mouth(const BranchEnd& end, double body, bool from_end) const {
    const size_t none = from_end ? last_ : 0;
    if (!(body > 0) || body > kThinner * end.radius) return none;
    const double length = along(last_);
    for (size_t k = 1; k < last_; ++k) {
      const size_t i = from_end ? last_ - k : k;
      const double away = from_end ? length - along(i) : along(i);
      if (away < kMouthFrom * end.radius) continue;
      if (length - away < body) return none;
      if (away >= kMouthTo * end.radius || samples_[i].radius <= kNearlyThin * body) return i;
    }
    return none;
  }

  void raise(size_t i, double times) { levels_[i] = std::max(levels_[i], times * usual_); }

  /// Between two joints; what lies in the balls of junctions there is not of the limb.
  void addMiddle(size_t first, size_t last, double ball_first, double ball_last) {
    const double from = along(first) + ball_first / 2, to = along(last) - ball_last / 2;
    const double length = to - from;
    if (!(length > kLong * meanRadius(from, to))) return;
    const double low = from + kAside * length, high = to - kAside * length;
    size_t middle = 0, narrow = 0;
    for (size_t i = first + 1; i < last; ++i) {
      if (along(i) < low || along(i) > high) continue;
      if (levels_[i] > usual_) return;  // it bends
      const double here = std::abs(along(i) - (low + high) / 2);
      if (middle == 0 || here < std::abs(along(middle) - (low + high) / 2)) middle = i;
      if (narrow == 0 || samples_[i].radius < samples_[narrow].radius) narrow = i;
    }
    if (middle == 0) return;
    double before = 0, after = 0;
    for (size_t i = first; i <= last; ++i) {
      double& side = i < narrow ? before : after;
      if (along(i) >= from - ball_first / 2 && along(i) <= to + ball_last / 2) {
        side = std::max(side, samples_[i].radius);
      }
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
                     [&](size_t a, size_t b) { return levels_[a] > levels_[b]; });
    std::vector<size_t> kept;
    const double length = along(last_);
    for (const size_t i : order) {
      const double radius = std::max(samples_[i].radius, body_);
      bool crowded = false;
      if (levels_[i] < kMouthLevel * usual_) {
        crowded = along(i) < (start.junction ? kMouthTo * start.radius : radius) ||
                  length - along(i) < (end.junction ? kMouthTo * end.radius : radius);
      }
      for (const size_t other : kept) {
        crowded = crowded || std::abs(along(i) - along(other)) < radius;
      }
      if (crowded && levels_[i] < kAlways) {
        levels_[i] = std::min(kCrowdedLevel * levels_[i], kBelow * usual_);
      } else {
        kept.push_back(i);
      }
    }
  }

  const std::vector<BranchSample>& samples_;
  double usual_;
  std::vector<double>& levels_;
  size_t last_;
  double body_ = 0;
};

}  // namespace

void addLimbJoints(const std::vector<BranchSample>& samples, const BranchEnd& start,
                   const BranchEnd& end, double usual, std::vector<double>& levels) {
  if (samples.size() < 3) return;
  LimbJoints(samples, usual, levels).run(start, end);
}

}  // namespace marrow
