#include "sketch/stroke_ends.h"

#include <algorithm>
#include <cstddef>

namespace marrow {
namespace {

constexpr double kLongestTail = 0.12;  // of the stroke's length, either end
constexpr size_t kMostCandidates = 64;
constexpr double kMuchCloser = 0.4;  // × the gap between the ends
constexpr double kCutCost = 0.6;     // gap that must be saved for each unit cut off
// A gap this many samples wide is the pen's, not the distance of two samples.
constexpr double kWideGap = 2.5;

struct Candidate {
  size_t index;
  double cut_off;  // length of the stroke beyond it
};

/// Places at which a tail may be cut, from the end inwards; index i counts from that end.
template <typename PointAt>
std::vector<Candidate> candidates(PointAt point_at, size_t count, double longest,
                                  double& widest_sample) {
  std::vector<Candidate> all{{0, 0}};
  double cut_off = 0;
  for (size_t i = 1; i < count; ++i) {
    const double sample = distance(point_at(i - 1), point_at(i));
    cut_off += sample;
    if (cut_off > longest) break;
    widest_sample = std::max(widest_sample, sample);
    all.push_back({i, cut_off});
  }
  const size_t stride = (all.size() + kMostCandidates - 1) / kMostCandidates;
  std::vector<Candidate> some;
  for (size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

}  // namespace

std::vector<Vec2> trimOvershoot(const std::vector<Vec2>& stroke) {
  const size_t n = stroke.size();
  double length_of_stroke = 0;
  for (size_t i = 1; i < n; ++i) length_of_stroke += distance(stroke[i - 1], stroke[i]);
  const double gap = distance(stroke.front(), stroke.back());
  const double longest = kLongestTail * length_of_stroke;
  if (n < 6 || gap > 2 * longest) return stroke;

  double widest_sample = 0;
  const auto head = candidates([&](size_t i) { return stroke[i]; }, n / 3, longest, widest_sample);
  const auto tail =
      candidates([&](size_t i) { return stroke[n - 1 - i]; }, n / 3, longest, widest_sample);
  if (gap < kWideGap * widest_sample) return stroke;

  double least_cost = gap;
  size_t first = 0, last = n - 1;
  for (const Candidate& a : head) {
    for (const Candidate& b : tail) {
      const double cut_cost = kCutCost * (a.cut_off + b.cut_off);
      if (cut_cost >= least_cost) break;
      const double closed = distance(stroke[a.index], stroke[n - 1 - b.index]);
      if (closed > kMuchCloser * gap || closed + cut_cost >= least_cost) continue;
      least_cost = closed + cut_cost;
      first = a.index;
      last = n - 1 - b.index;
    }
  }
  return {stroke.begin() + static_cast<std::ptrdiff_t>(first),
          stroke.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

}  // namespace marrow
