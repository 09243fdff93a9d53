#include "sketch/arc_curve.h"

#include <algorithm>
#include <utility>

namespace marrow {

ArcCurve::ArcCurve(std::vector<Vec2> points) : points_(std::move(points)) {
  const size_t n = points_.size();
  starts_.reserve(n + 1);
  integrals_.reserve(n + 1);
  starts_.push_back(0);
  integrals_.push_back({});
  for (size_t i = 0; i < n; ++i) {
    const Vec2 a = points_[i], b = points_[i + 1 < n ? i + 1 : 0];
    const double step = distance(a, b);
    starts_.push_back(starts_.back() + step);
    integrals_.push_back(integrals_.back() + (a + b) * (step / 2));
  }

  per_bucket_ = static_cast<double>(n) / length();
  buckets_.resize(n);
  uint32_t edge = 0;
  for (size_t bucket = 0; bucket < n; ++bucket) {
    while (edge + 1 < n && starts_[edge + 1] * per_bucket_ <= static_cast<double>(bucket)) ++edge;
    buckets_[bucket] = edge;
  }
}

double ArcCurve::wrap(double arc) const {
  if (arc >= 0 && arc < length()) return arc;
  arc -= std::floor(arc / length()) * length();
  return arc >= 0 && arc < length() ? arc : 0;
}

size_t ArcCurve::find(double arc) const {
  const size_t bucket = std::min(static_cast<size_t>(arc * per_bucket_), size() - 1);
  size_t edge = buckets_[bucket];
  while (edge > 0 && starts_[edge] > arc) --edge;
  while (edge + 1 < size() && starts_[edge + 1] <= arc) ++edge;
  return edge;
}

Vec2 ArcCurve::at(double arc) const {
  arc = wrap(arc);
  const size_t edge = find(arc);
  const double step = starts_[edge + 1] - starts_[edge];
  const double t = step > 0 ? (arc - starts_[edge]) / step : 0;
  return lerp(points_[edge], points_[edge + 1 < size() ? edge + 1 : 0], t);
}

Vec2 ArcCurve::integralOn(size_t edge, double arc) const {
  const double into = arc - starts_[edge], step = starts_[edge + 1] - starts_[edge];
  const Vec2 a = points_[edge], b = points_[edge + 1 < size() ? edge + 1 : 0];
  const Vec2 middle = step > 0 ? lerp(a, b, into / step / 2) : a;
  return integrals_[edge] + middle * into;
}

Vec2 ArcCurve::integral(double arc) const {
  if (arc >= 0 && arc < length()) return integralOn(find(arc), arc);
  double turns = std::floor(arc / length());
  arc -= turns * length();
  if (!(arc >= 0)) arc = 0;
  if (arc >= length()) {  // a hair before a whole turn
    arc = 0;
    ++turns;
  }
  return integralOn(find(arc), arc) + integrals_.back() * turns;
}

Vec2 ArcCurve::mean(double from, double to) const {
  const double start = wrap(from);
  const size_t edge = find(start);
  if (start + (to - from) <= starts_[edge + 1]) return at(start + (to - from) / 2);
  if (start != from || !(to < length())) return (integral(to) - integral(from)) / (to - from);
  size_t last = edge;
  while (last + 1 < size() && starts_[last + 1] <= to) ++last;
  return (integralOn(last, to) - integralOn(edge, from)) / (to - from);
}

}  // namespace marrow
