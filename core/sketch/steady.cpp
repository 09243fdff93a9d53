#include "sketch/steady.h"

#include <algorithm>
#include <cmath>

#include "sketch/polygon.h"
#include "sketch/simplify.h"

namespace marrow {
namespace {

constexpr double kFiner = 3;    // samples a step
constexpr double kFewest = 12;  // samples
constexpr double kMiss = 0.02;  // of the step: how far the curve may be missed
constexpr double kMissOfMany = 0.2;
constexpr size_t kMany = 1000;
constexpr double kBevel = 0.02;     // of the step: how far a bevelled corner is cut
constexpr double kSharpTurn = 0.5;  // cosine of the sharpest turn inward that is left: 60°

Vec2 unit(Vec2 v) { return v / length(v); }

/// Unit vectors from `from` to `to`, turned by less than half a turn, in even steps of at most 60°;
/// without `from`.
void fan(Vec2 from, Vec2 to, std::vector<Vec2>& found) {
  if (dot(from, to) >= kSharpTurn) {
    found.push_back(to);
    return;
  }
  // Nearly opposite ones have no sum to speak of; what is between them turns clockwise.
  const Vec2 sum = from + to;
  const Vec2 middle = dot(sum, sum) > 1e-12 ? unit(sum) : -perpendicular(from);
  fan(from, middle, found);
  fan(middle, to, found);
}

}  // namespace

std::vector<Vec2> steadyCurve(const ArcCurve& curve, double step) {
  const auto& points = curve.points();
  const Vec2 middle = areaCentroid(points);
  size_t start = 0;
  for (size_t i = 1; i < points.size(); ++i) {
    if (distance(points[i], middle) > distance(points[start], middle)) start = i;
  }
  const double count = std::max(kFewest, std::floor(kFiner * curve.length() / step + 0.5));
  const double spacing = curve.length() / count;
  std::vector<Vec2> means;
  means.reserve(static_cast<size_t>(count));
  for (double i = 0; i < count; ++i) {
    const double arc = curve.arcAt(start) + i * spacing;
    means.push_back(curve.mean(arc - step, arc + step));
  }
  // And once more.
  const size_t n = means.size();
  const size_t reach = std::min((n - 1) / 2, static_cast<size_t>(step / spacing + 0.5));
  std::vector<Vec2> smooth(n);
  Vec2 sum;
  for (size_t k = 0; k <= 2 * reach; ++k) sum = sum + means[(n - reach + k) % n];
  for (size_t i = 0; i < n; ++i) {
    smooth[i] = sum / static_cast<double>(2 * reach + 1);
    sum = sum + means[(i + reach + 1) % n] - means[(i + n - reach) % n];
  }
  return smooth;
}

std::vector<Vec2> fewVertices(const std::vector<Vec2>& samples, double step) {
  std::vector<uint32_t> kept = simplify(samples, kMiss * step);
  if (kept.size() > kMany) kept = simplify(samples, kMissOfMany * step);
  std::vector<Vec2> few;
  few.reserve(kept.size());
  for (const uint32_t i : kept) few.push_back(samples[i]);
  return few;
}

std::vector<Vec2> bevelled(const std::vector<Vec2>& polygon, double step) {
  const double cut = kBevel * step;
  const size_t n = polygon.size();
  std::vector<Vec2> result, normals;
  result.reserve(n + n / 4);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 before = polygon[i > 0 ? i - 1 : n - 1], p = polygon[i],
               after = polygon[i + 1 < n ? i + 1 : 0];
    const Vec2 in = p - before, out = after - p;
    const double lengths = length(in) * length(out);
    if (cross(in, out) >= 0 || !(lengths > 0) || dot(in, out) >= kSharpTurn * lengths) {
      result.push_back(p);
      continue;
    }
    const Vec2 first = unit(perpendicular(in));
    normals.assign(1, first);
    fan(first, unit(perpendicular(out)), normals);
    for (const Vec2 normal : normals) result.push_back(p + normal * cut);
  }
  return result;
}

}  // namespace marrow
