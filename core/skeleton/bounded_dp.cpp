#include "skeleton/bounded_dp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.h"
#include "skeleton/inside.h"

namespace marrow {
namespace {

// Where the line across the branch looks into another limb, this many inscribed radii of it count.
constexpr double kSectionLimit = 1.1;
// Nearer than this many radii to another joint an error counts for less, in proportion: a bone
// that is shorter than its balls are wide is of little use.
constexpr double kBoneRoom = 1.5;
// The part of a section, from the axis on, in which a bone may cross it: it keeps to the middle.
constexpr double kCorridor = 0.5;
// Errors that differ by less than this part are equal: a branch that is its own mirror image is
// split at both places.
constexpr double kTie = 1e-9;
// Samples that are looked at together, with the edges near them.
constexpr size_t kChunk = 8;
// Long straight edges get more points for the spline, this many steps apart, so that it rounds off
// a corner near it and leaves the rest straight.
constexpr double kSplineSpan = 3;
constexpr int kSplineSteps = 4;  // per span; the curve's length is measured on them

/// Barry and Goldman's pyramid for a Catmull–Rom span with knots t[0..3], between t[1] and t[2].
Vec2 splinePoint(const Vec2 (&p)[4], const double (&t)[4], double at) {
  const auto mix = [&](Vec2 a, Vec2 b, double from, double to) {
    return (a * (to - at) + b * (at - from)) / (to - from);
  };
  const Vec2 a1 = mix(p[0], p[1], t[0], t[1]);
  const Vec2 a2 = mix(p[1], p[2], t[1], t[2]);
  const Vec2 a3 = mix(p[2], p[3], t[2], t[3]);
  const Vec2 b1 = mix(a1, a2, t[0], t[2]);
  const Vec2 b2 = mix(a2, a3, t[1], t[3]);
  return mix(b1, b2, t[1], t[2]);
}

/// The polyline with its edges divided evenly into parts of at most `longest`.
std::vector<Vec2> divided(const std::vector<Vec2>& line, double longest) {
  std::vector<Vec2> points{line[0]};
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const int parts =
        static_cast<int>(std::ceil(std::min(distance(line[i], line[i + 1]) / longest, 100.0)));
    for (int k = 1; k < parts; ++k) points.push_back(lerp(line[i], line[i + 1], 1.0 * k / parts));
    points.push_back(line[i + 1]);
  }
  return points;
}

/// Points on the centripetal Catmull–Rom spline through `axis`.
std::vector<Vec2> splineThrough(const std::vector<Vec2>& axis) {
  const size_t n = axis.size();
  std::vector<Vec2> curve{axis[0]};
  curve.reserve((n - 1) * kSplineSteps + 1);
  for (size_t i = 0; i + 1 < n; ++i) {
    const Vec2 p[4] = {i > 0 ? axis[i - 1] : 2 * axis[0] - axis[1], axis[i], axis[i + 1],
                       i + 2 < n ? axis[i + 2] : 2 * axis[n - 1] - axis[n - 2]};
    double t[4] = {0, 0, 0, 0};
    for (int k = 1; k < 4; ++k) t[k] = t[k - 1] + std::sqrt(distance(p[k - 1], p[k]));
    for (int k = 1; k < kSplineSteps; ++k) {
      curve.push_back(splinePoint(p, t, t[1] + (t[2] - t[1]) * k / kSplineSteps));
    }
    curve.push_back(axis[i + 1]);
  }
  return curve;
}

/// Points at even distances along a polyline; with_corners adds the polyline's own.
std::vector<BranchSample> walk(const std::vector<Vec2>& line, double step, bool with_corners) {
  double total = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) total += distance(line[i], line[i + 1]);
  step = std::max(step, total / kMaxSamples);
  const size_t count = step > 0 ? static_cast<size_t>(std::ceil(total / step - 1e-6)) : 1;
  step = total / std::max<size_t>(count, 1);

  std::vector<BranchSample> samples;
  samples.reserve(count + 1 + (with_corners ? line.size() : 0));
  const auto put = [&](Vec2 point, double along) {
    BranchSample sample;
    sample.point = point;
    sample.along = along;
    samples.push_back(sample);
  };
  put(line[0], 0);
  double start = 0;
  size_t next = 1;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = distance(line[i], line[i + 1]);
    for (; next < count && next * step < start + length; ++next) {
      const double t = (next * step - start) / length;
      // A sample that all but falls on a corner leaves the place to it.
      if (with_corners && (t * length < 0.1 * step || (1 - t) * length < 0.1 * step)) continue;
      put(lerp(line[i], line[i + 1], t), next * step);
    }
    start += length;
    if (with_corners && i + 2 < line.size()) put(line[i + 1], start);
  }
  put(line.back(), total);
  return samples;
}

/// A polygon's edges, made ready to be measured from many points.
struct Edge {
  Vec2 start, end, along;
  double inverse;  // of the squared length

  Vec2 footFrom(Vec2 from) const {  // from: the point to the edge's start
    return from + along * std::clamp(-dot(from, along) * inverse, 0.0, 1.0);
  }
};

std::vector<Edge> edgesOf(const std::vector<Vec2>& polygon) {
  std::vector<Edge> edges(polygon.size());
  Vec2 start = polygon.back();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 along = polygon[i] - start;
    edges[i] = {start, polygon[i], along, 1 / dot(along, along)};
    start = polygon[i];
  }
  return edges;
}

/// Fills in what the polygon says about a sample; edges: those that matter there.
void measure(const std::vector<Edge>& edges, Vec2 tangent, BranchSample& sample) {
  const double far = std::numeric_limits<double>::infinity();
  sample.normal = perpendicular(tangent);
  double left = far, right = far, nearest = far;
  for (const Edge& edge : edges) {
    const Vec2 from = edge.start - sample.point, to = edge.end - sample.point;
    const double behind = dot(from, tangent), ahead = dot(to, tangent);
    const Vec2 foot = edge.footFrom(from);
    nearest = std::min(nearest, dot(foot, foot));
    if ((behind < 0) == (ahead < 0)) continue;
    const double offset =
        dot(from, sample.normal) + dot(edge.along, sample.normal) * (behind / (behind - ahead));
    if (offset > 0) {
      left = std::min(left, offset);
    } else {
      right = std::min(right, -offset);
    }
  }
  sample.radius = std::sqrt(nearest);
  sample.left = std::min(left, kSectionLimit * sample.radius);
  sample.right = std::min(right, kSectionLimit * sample.radius);
}

/// The samples from `first` to before `last`; edges: those that matter to them.
void measure(const std::vector<Edge>& edges, std::vector<BranchSample>& samples, size_t first,
             size_t last) {
  constexpr size_t kFew = 7, kPart = 5, kParts = 4;
  const Vec2 middle = samples[(first + last) / 2].point;
  double reach = 0, nearest = std::numeric_limits<double>::infinity();
  for (size_t i = first; i < last; ++i) {
    reach = std::max(reach, distance(middle, samples[i].point));
  }
  std::vector<double> distances(edges.size());
  for (size_t i = 0; i < edges.size(); ++i) {
    const Vec2 foot = edges[i].footFrom(edges[i].start - middle);
    distances[i] = dot(foot, foot);
    nearest = std::min(nearest, distances[i]);
  }
  // What is further away is not the nearest to any of them, nor within a section that counts.
  const double limit = 1.001 * (reach + kSectionLimit * (std::sqrt(nearest) + reach));
  std::vector<Edge> near;
  near.reserve(edges.size());
  for (size_t i = 0; i < edges.size(); ++i) {
    if (distances[i] <= limit * limit) near.push_back(edges[i]);
  }
  if (last - first > kFew) {
    const size_t part = std::max(kPart, (last - first + kParts - 1) / kParts);
    for (size_t i = first; i < last; i += part) {
      measure(near, samples, i, std::min(i + part, last));
    }
    return;
  }
  for (size_t i = first; i < last; ++i) {
    Vec2 tangent =
        samples[std::min(i + 1, samples.size() - 1)].point - samples[i > 0 ? i - 1 : 0].point;
    if (!(dot(tangent, tangent) > 0)) tangent = samples[i + 1].point - samples[i].point;
    measure(near, tangent / length(tangent), samples[i]);
  }
}

Box2 boxOf(const std::vector<BranchSample>& samples, size_t first, size_t last) {
  Box2 box;
  for (size_t i = first; i <= last; ++i) box.include(samples[i].point);
  return box;
}

NearEdges edgesAround(const Region& region, const std::vector<BranchSample>& samples) {
  return NearEdges(region, boxOf(samples, 0, samples.size() - 1));
}

/// The samples follow one another from inside to inside, so where no step touches the border, none
/// is outside.
bool staysInside(const Region& region, const std::vector<BranchSample>& samples) {
  const NearEdges around = edgesAround(region, samples);
  NearEdges near;
  for (size_t first = 0; first + 1 < samples.size(); first += kChunk) {
    const size_t last = std::min(first + kChunk, samples.size() - 1);
    near.narrow(around, boxOf(samples, first, last));
    for (size_t i = first; i < last; ++i) {
      if (!near.isClear(samples[i].point, samples[i + 1].point)) return false;
    }
  }
  return true;
}

struct Split {
  size_t first, last;  // the same sample, or the outer two of several with the same error
  double error;
};

/// The sample between `first` and `last` with the largest error E_i = E_p + α_s E_s.
Split largestError(const std::vector<BranchSample>& samples, size_t first, size_t last,
                   double shape_weight) {
  const BranchSample &a = samples[first], &b = samples[last];
  const Vec2 chord = b.point - a.point;
  const double chord_length = length(chord);
  const double span = b.along - a.along;
  const double left_slope = (b.left - a.left) / span, right_slope = (b.right - a.right) / span;
  const double left_scale = 1 / std::sqrt(1 + left_slope * left_slope);
  const double right_scale = 1 / std::sqrt(1 + right_slope * right_slope);
  Split best{first + 1, first + 1, -1};
  for (size_t i = first + 1; i < last; ++i) {
    const BranchSample& s = samples[i];
    const Vec2 away = s.point - a.point;
    const double axis_error =
        chord_length > 0 ? std::abs(cross(chord, away)) / chord_length : length(away);
    const double along = s.along - a.along;
    const double shape_error = std::abs(s.left - a.left - left_slope * along) * left_scale +
                               std::abs(s.right - a.right - right_slope * along) * right_scale;
    const double room = std::min(along, span - along) / (kBoneRoom * s.radius);
    const double error = (axis_error + shape_weight * shape_error) * std::min(room, 1.0);
    if (error > best.error * (1 + kTie)) {
      best = {i, i, error};
    } else if (error >= best.error * (1 - kTie)) {
      best.last = i;
    }
  }
  return best;
}

/// Inside the region Ω, at a distance from its border, and inside the polygon.
bool boneFits(const NearEdges& around, const std::vector<BranchSample>& samples, size_t first,
              size_t last) {
  const Vec2 a = samples[first].point, chord = samples[last].point - a;
  for (size_t i = first + 1; i < last; ++i) {
    const BranchSample& s = samples[i];
    const double across = cross(chord, s.normal);
    if (!(across > 0)) return false;  // the branch turns back on the bone
    const double offset = -cross(chord, s.point - a) / across;
    if (offset > kCorridor * s.left || -offset > kCorridor * s.right) return false;
  }
  return around.isClear(a, samples[last].point);
}

}  // namespace

std::vector<BranchSample> sampleBranch(const Region& region, const std::vector<Vec2>& axis,
                                       double step) {
  if (axis.size() > 2) {
    std::vector<BranchSample> samples =
        walk(splineThrough(divided(axis, kSplineSpan * step)), step, false);
    if (staysInside(region, samples)) {
      measure(edgesOf(region.polygon), samples, 0, samples.size());
      return samples;
    }
  }
  std::vector<BranchSample> samples = walk(axis, step, true);
  measure(edgesOf(region.polygon), samples, 0, samples.size());
  return samples;
}

std::vector<double> branchLevels(const Region& region, const std::vector<BranchSample>& samples,
                                 const BoundedDpOptions& options) {
  // An interval between two samples, and the one that it is a piece of.
  struct Interval {
    size_t first, last;
    double epsilon;  // that it is measured with
    size_t parent;   // in `divided`
  };
  struct Divided {
    double error;
    bool fits;
    size_t parent;
  };
  constexpr size_t kNone = std::numeric_limits<size_t>::max();
  constexpr double kAlways = std::numeric_limits<double>::infinity();
  const double shrink = std::clamp(options.shrink, 0.0, 1.0);
  const double floor = std::isnan(options.epsilon) ? kAlways : options.epsilon;

  const NearEdges around = edgesAround(region, samples);
  std::vector<double> levels(samples.size());
  levels.front() = levels.back() = kAlways;
  std::vector<Divided> divided;
  std::vector<Interval> todo{{0, samples.size() - 1, floor, kNone}};
  while (!todo.empty()) {
    const Interval interval = todo.back();
    todo.pop_back();
    if (interval.last - interval.first < 2) continue;
    const Split split = largestError(samples, interval.first, interval.last, options.shape_weight);
    const bool fits = boneFits(around, samples, interval.first, interval.last);
    double epsilon = interval.epsilon;
    if (!(split.error > epsilon)) {
      if (fits) continue;
      epsilon = std::max(split.error, epsilon * shrink);
    }
    // The largest threshold of the whole branch with which this interval is divided.
    double level = fits ? split.error : kAlways;
    for (size_t i = interval.parent; i != kNone; i = divided[i].parent) {
      if (divided[i].fits) {
        level = std::min(level, divided[i].error);
      } else if (level > divided[i].error) {
        level /= shrink;
      }
    }
    // Rounding must not lose what is kept.
    if (!(level > floor)) level = std::nextafter(floor, kAlways);
    levels[split.first] = levels[split.last] = level;
    divided.push_back({split.error, fits, interval.parent});
    const size_t self = divided.size() - 1;
    todo.push_back({split.last, interval.last, epsilon, self});
    if (split.first < split.last) todo.push_back({split.first, split.last, epsilon, self});
    todo.push_back({interval.first, split.first, epsilon, self});
  }
  return levels;
}

std::vector<size_t> boundedDp(const Region& region, const std::vector<BranchSample>& samples,
                              const BoundedDpOptions& options) {
  const std::vector<double> levels = branchLevels(region, samples, options);
  std::vector<size_t> kept;
  for (size_t i = 0; i < levels.size(); ++i) {
    if (isKept(levels[i], options.epsilon)) kept.push_back(i);
  }
  return kept;
}

}  // namespace marrow
