#include "skeleton/bounded_dp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

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
// A line is averaged over this part of the local radius to either side.
constexpr double kSmooth = 0.5;

/// An open polyline by arc length.
class Line {
 public:
  explicit Line(const std::vector<Vec2>& points) : points_(points) {
    starts_.reserve(points.size());
    integrals_.reserve(points.size());
    starts_.push_back(0);
    integrals_.push_back({});
    for (size_t i = 0; i + 1 < points.size(); ++i) {
      const double step = distance(points[i], points[i + 1]);
      starts_.push_back(starts_.back() + step);
      integrals_.push_back(integrals_.back() + (points[i] + points[i + 1]) * (step / 2));
    }
  }
  double length() const { return starts_.back(); }
  double arcAt(size_t i) const { return starts_[i]; }
  /// The edge that holds this place; going up from `edge`.
  size_t edgeAt(double arc, size_t edge = 0) const {
    while (edge + 2 < starts_.size() && starts_[edge + 1] <= arc) ++edge;
    return edge;
  }
  double into(size_t edge, double arc) const {
    const double step = starts_[edge + 1] - starts_[edge];
    return step > 0 ? std::clamp((arc - starts_[edge]) / step, 0.0, 1.0) : 0;
  }
  Vec2 at(size_t edge, double arc) const {
    return lerp(points_[edge], points_[edge + 1], into(edge, arc));
  }
  Vec2 integral(size_t edge, double arc) const {
    return integrals_[edge] + (points_[edge] + at(edge, arc)) * ((arc - starts_[edge]) / 2);
  }

 private:
  const std::vector<Vec2>& points_;
  std::vector<double> starts_;
  std::vector<Vec2> integrals_;
};

BranchSample sampleAt(Vec2 point, double along, double radius) {
  BranchSample sample;
  sample.point = point;
  sample.along = along;
  sample.radius = radius;
  return sample;
}

void setLengths(std::vector<BranchSample>& samples) {
  for (size_t i = 1; i < samples.size(); ++i) {
    samples[i].along = samples[i - 1].along + distance(samples[i - 1].point, samples[i].point);
  }
}

size_t countOf(double length, double step) {
  step = std::max(step, length / kMaxSamples);
  return step > 0 ? std::max<size_t>(2, static_cast<size_t>(std::ceil(length / step - 1e-6))) : 1;
}

/// Even samples of the line, averaged over about half the radius there, less towards its ends.
std::vector<BranchSample> smoothed(const std::vector<Vec2>& points,
                                   const std::vector<double>& radii, double step) {
  const Line line(points);
  const double total = line.length();
  const size_t count = countOf(total, step);
  std::vector<BranchSample> samples;
  samples.reserve(count + 1);
  size_t edge = 0, low = 0;
  for (size_t i = 0; i <= count; ++i) {
    const double arc = total * static_cast<double>(i) / static_cast<double>(count);
    edge = line.edgeAt(arc, edge);
    const double t = line.into(edge, arc);
    const double radius = radii[edge] + (radii[edge + 1] - radii[edge]) * t;
    const double wide = std::min({kSmooth * radius, arc, total - arc});
    Vec2 point = line.at(edge, arc);
    if (wide > 1e-9 * total) {
      low = line.edgeAt(arc - wide, 0);
      const size_t high = line.edgeAt(arc + wide, edge);
      point = (line.integral(high, arc + wide) - line.integral(low, arc - wide)) / (2 * wide);
    }
    samples.push_back(sampleAt(point, arc, radius));
  }
  samples.front().point = points.front();
  samples.back().point = points.back();
  setLengths(samples);
  return samples;
}

std::vector<BranchSample> smoothedTwice(const AxisLine& line, size_t first, size_t last,
                                        double step) {
  std::vector<Vec2> points(line.points.begin() + static_cast<long>(first),
                           line.points.begin() + static_cast<long>(last) + 1);
  std::vector<double> radii(line.radii.begin() + static_cast<long>(first),
                            line.radii.begin() + static_cast<long>(last) + 1);
  const std::vector<BranchSample> once = smoothed(points, radii, step);
  points.clear();
  radii.clear();
  for (const BranchSample& sample : once) {
    points.push_back(sample.point);
    radii.push_back(sample.radius);
  }
  return smoothed(points, radii, step);
}

/// Points at even distances along a polyline, and the polyline's own.
std::vector<BranchSample> walk(const std::vector<Vec2>& points, const std::vector<double>& radii,
                               double step) {
  const Line line(points);
  const double total = line.length();
  const size_t count = countOf(total, step);
  step = total / static_cast<double>(count);
  std::vector<BranchSample> samples;
  samples.push_back(sampleAt(points[0], 0, radii[0]));
  size_t next = 1;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const double start = line.arcAt(i), length = line.arcAt(i + 1) - start;
    for (; next < count && static_cast<double>(next) * step < start + length; ++next) {
      const double t = (static_cast<double>(next) * step - start) / length;
      // A sample that all but falls on a corner leaves the place to it.
      if (t * length < 0.1 * step || (1 - t) * length < 0.1 * step) continue;
      samples.push_back(sampleAt(lerp(points[i], points[i + 1], t),
                                 static_cast<double>(next) * step,
                                 radii[i] + (radii[i + 1] - radii[i]) * t));
    }
    samples.push_back(sampleAt(points[i + 1], line.arcAt(i + 1), radii[i + 1]));
  }
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

std::vector<BranchSample> sampleBranch(const Region& region, const AxisLine& line, double step) {
  std::vector<size_t> ends = line.corners;
  ends.push_back(line.points.size() - 1);
  std::vector<BranchSample> samples;
  double length = 0;
  for (size_t i = 0; i + 1 < line.points.size(); ++i) {
    length += distance(line.points[i], line.points[i + 1]);
  }
  step = std::max(step, length / kMaxSamples);
  size_t first = 0;
  for (const size_t last : ends) {
    if (last <= first) continue;
    const auto piece = smoothedTwice(line, first, last, step);
    samples.insert(samples.end(), piece.begin() + (samples.empty() ? 0 : 1), piece.end());
    first = last;
  }
  setLengths(samples);
  if (!staysInside(region, samples)) samples = walk(line.points, line.radii, step);
  measure(edgesOf(region.polygon), samples, 0, samples.size());
  return samples;
}

BranchSample mirrored(const BranchSample& sample, const MirrorLine& mirror) {
  BranchSample image = sample;
  image.point = mirror.mirrored(sample.point);
  // Left and right change places.
  image.normal = mirror.through - mirror.mirrored(mirror.through + sample.normal);
  std::swap(image.left, image.right);
  return image;
}

std::vector<BranchSample> sampleMirroredBranch(const Region& region, const AxisLine& line,
                                               double step, const MirrorLine& mirror) {
  const std::vector<BranchSample> whole = sampleBranch(region, line, step);
  // The second half, from its first sample beyond the line on, and where that is met.
  const bool left = mirror.side(line.points.back()) > 0;
  size_t first = whole.size();
  while (first > 0 && (mirror.side(whole[first - 1].point) > 0) == left) --first;
  std::vector<BranchSample> samples;
  for (size_t k = whole.size(); k-- > first;) {
    samples.push_back(mirrored(whole[k], mirror));
    // Walked the other way.
    samples.back().normal = -samples.back().normal;
    std::swap(samples.back().left, samples.back().right);
  }
  const BranchSample& nearest = whole[std::min(first, whole.size() - 1)];
  BranchSample middle = nearest;
  middle.point = mirror.foot(nearest.point);
  samples.push_back(middle);
  samples.insert(samples.end(), whole.begin() + static_cast<long>(first), whole.end());
  setLengths(samples);
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

void keepInside(const Region& region, const std::vector<BranchSample>& samples,
                std::vector<double>& levels) {
  const NearEdges around = edgesAround(region, samples);
  std::vector<size_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return levels[a] > levels[b]; });
  std::set<size_t> kept{0, samples.size() - 1};
  // The samples that a bone needs to stay inside are kept with it.
  const auto mend = [&](size_t first, size_t last, double level) {
    std::vector<std::array<size_t, 2>> todo{{first, last}};
    while (!todo.empty()) {
      const size_t a = todo.back()[0], b = todo.back()[1];
      todo.pop_back();
      if (b - a < 2 || around.isClear(samples[a].point, samples[b].point)) continue;
      // High levels first; but not beside what is kept already, where there is another place.
      const auto rank = [&](size_t i) {
        const double near =
            std::min(samples[i].along - samples[a].along, samples[b].along - samples[i].along);
        return std::pair{near >= samples[i].radius, levels[i]};
      };
      size_t middle = largestError(samples, a, b, 1).first;
      for (size_t i = a + 1; i < b; ++i) {
        if (rank(i) > rank(middle)) middle = i;
      }
      levels[middle] = std::max(levels[middle], level);
      kept.insert(middle);
      todo.push_back({a, middle});
      todo.push_back({middle, b});
    }
  };
  mend(0, samples.size() - 1, levels.front());
  for (const size_t i : order) {
    if (!(levels[i] > 0)) break;
    const auto [at, is_new] = kept.insert(i);
    if (!is_new) continue;
    mend(*std::prev(at), i, levels[i]);
    mend(i, *std::next(kept.find(i)), levels[i]);
  }
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
