#include "sketch/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/box.h"
#include "sketch/arc_curve.h"
#include "sketch/polygon.h"
#include "sketch/resample.h"
#include "sketch/simplify.h"
#include "sketch/steady.h"
#include "sketch/stroke_ends.h"
#include "sketch/tidy.h"
#include "sketch/untangle.h"

namespace marrow {
namespace {

// Beyond this a coordinate's square may leave the range of double.
constexpr double kLargest = 1e100;
// What is thinner than this, of its own length, encloses nothing.
constexpr double kThinnest = 1e-7;
// Strokes with more samples are put on a lattice of 2^kCoarseBits: far finer than a screen, and no
// cluster of samples can then make the search for crossings slow.
constexpr size_t kManySamples = 4096;
constexpr int kCoarseBits = 16;
constexpr size_t kMostWork = 10000000;  // edges looked at on the way around
constexpr int kCoarserBits = 3;
constexpr int kCoarsestBits = 10;
// More vertices than these are lines closer than a screen can show, nothing that anybody has drawn
// on purpose: on ever coarser lattices what is close grows together.
constexpr size_t kMostDense = 6000;
constexpr size_t kMostInPolygon = 1200;
constexpr int kMostBits = 9;
constexpr int kFewestBits = 5;

constexpr double kStepsAcross = 0.2;  // × OutlineOptions::samples, over the shape's diameter
constexpr double kMostFiner = 8;      // × OutlineOptions::samples, for thin shapes
constexpr double kPixelsPerStep = 4;  // at least, where samples lie on whole pixels
constexpr int kStepHalvings = 4;
constexpr double kLeastSteadiness = 1. / 64;
// More alike than this a shape and its mirror image are meant to be the same.
constexpr double kAlike = 0.86;
constexpr double kAlikeMemory = 0.03;   // less for what was so a moment ago, more for what was not
constexpr double kMirroredMiss = 0.02;  // as in fewVertices
constexpr double kOnLine = 1e-9;        // × the shape's diameter
constexpr double kSpikeBySteps = 0.04;  // thinner spikes than this go,
constexpr double kSpikeByWidth = 0.05;  // if they are that thin beside the shape as well

bool isUsable(Vec2 p) {
  return std::fabs(p.x) <= kLargest && std::fabs(p.y) <= kLargest;  // false for NaN as well
}

void dropRepeats(std::vector<Vec2>& points) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
}

bool hasThreeDistinct(const std::vector<Vec2>& points) {
  for (const Vec2& p : points) {
    if (p != points[0] && p != points[1]) return true;
  }
  return false;
}

/// The plane moved and scaled by a power of two so that the stroke's box lies in [0, 1]²: nothing
/// overflows there, and scaling the stroke by a power of two changes no bit.
class Frame {
 public:
  explicit Frame(const Box2& box) : origin_(box.low) {
    std::frexp(std::max(box.size().x, box.size().y), &exponent_);
    exponent_ = std::max(exponent_, -kMostExponent);
    scale_ = std::ldexp(1.0, exponent_);
    inverse_ = std::ldexp(1.0, -exponent_);
  }
  Vec2 toLocal(Vec2 p) const { return (p - origin_) * inverse_; }
  /// About how far apart the numbers are in which the model holds these points.
  double resolution(const Box2& box) const {
    const double largest = std::max(
        {std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
    return std::ldexp(largest, -52 - exponent_);
  }
  Vec2 toModel(Vec2 p) const { return origin_ + p * scale_; }
  std::vector<Vec2> toModel(const std::vector<Vec2>& points) const {
    std::vector<Vec2> moved;
    moved.reserve(points.size());
    for (const Vec2& p : points) moved.push_back(toModel(p));
    return moved;
  }

 private:
  static constexpr int kMostExponent = 1000;  // whose power of two and its inverse are numbers

  Vec2 origin_;
  int exponent_ = 0;
  double scale_ = 1, inverse_ = 1;  // 2^exponent and 2^−exponent
};

std::vector<Vec2> snapped(const std::vector<Vec2>& points, int bits) {
  const double scale = std::ldexp(1.0, bits);
  std::vector<Vec2> lattice;
  lattice.reserve(points.size());
  for (const Vec2& p : points) {
    lattice.push_back({std::floor(p.x * scale + 0.5), std::floor(p.y * scale + 0.5)});
  }
  return lattice;
}

std::vector<Vec2> unsnapped(std::vector<Vec2> lattice, int bits) {
  const double scale = std::ldexp(1.0, -bits);
  for (Vec2& p : lattice) p = p * scale;
  return lattice;
}

/// About the largest distance of two points, however the shape is turned.
double diameterOf(const std::vector<Vec2>& loop) {
  const auto farthest = [&](Vec2 from) {
    Vec2 best = loop[0];
    double most = distance(best, from);
    for (const Vec2& p : loop) {
      const double here = distance(p, from);
      if (!(here > most)) continue;
      best = p;
      most = here;
    }
    return best;
  };
  const Vec2 a = farthest(areaCentroid(loop)), b = farthest(a);
  return distance(b, farthest(b));
}

/// Twice the area over the perimeter: the width of a long strip, the radius of a disc.
double meanWidth(const std::vector<Vec2>& loop) {
  return 2 * std::fabs(signedArea(loop)) / perimeter(loop);
}

bool isThin(const std::vector<Vec2>& loop) {
  const double diameter = diameterOf(loop);
  return !(std::fabs(signedArea(loop)) > kThinnest * diameter * diameter);
}

/// The side of the pixels on whose corners all samples lie, or 0 where the samples are not dense
/// or not on pixels.
double pixelSize(const std::vector<Vec2>& stroke) {
  constexpr size_t kFewSamples = 32;
  constexpr double kDense = 4;  // pixels from sample to sample, on average
  constexpr double kOff = 0.02;
  if (stroke.size() < kFewSamples) return 0;
  double pixel = 0, length_of_stroke = 0;
  for (size_t i = 1; i < stroke.size(); ++i) {
    const Vec2 step = stroke[i] - stroke[i - 1];
    length_of_stroke += length(step);
    for (const double d : {std::fabs(step.x), std::fabs(step.y)}) {
      if (d > 1e-9 && (pixel == 0 || d < pixel)) pixel = d;
    }
  }
  if (length_of_stroke > kDense * pixel * static_cast<double>(stroke.size())) return 0;
  for (size_t i = 1; i < stroke.size(); ++i) {
    const Vec2 step = (stroke[i] - stroke[i - 1]) / pixel;
    for (const double d : {step.x, step.y}) {
      if (std::fabs(d - std::floor(d + 0.5)) > kOff) return 0;
    }
  }
  return pixel;
}

struct Loop {
  std::vector<Vec2> points;  // counter-clockwise, local frame
  bool crossed_itself = false;
};

Loop closedLoop(const std::vector<Vec2>& stroke) {
  const bool many = stroke.size() > kManySamples;
  int bits = many ? kCoarseBits : kLatticeBits;
  std::vector<Vec2> lattice = snapped(stroke, bits);
  dropRepeats(lattice);
  Loop loop;
  loop.crossed_itself = !isSimple(lattice, kMostWork);
  if (!loop.crossed_itself) {
    loop.points = many ? unsnapped(std::move(lattice), bits) : stroke;
    if (signedArea(loop.points) < 0) std::reverse(loop.points.begin(), loop.points.end());
  } else {
    // Where no work suffices, a coarser lattice leaves fewer different edges.
    auto outer = outerBoundary(lattice, kMostWork);
    while (!outer) {
      bits = std::min(bits, kCoarseBits) - kCoarserBits;
      lattice = snapped(stroke, bits);
      dropRepeats(lattice);
      outer = outerBoundary(lattice, bits > kCoarsestBits ? kMostWork : SIZE_MAX);
    }
    loop.points = unsnapped(std::move(*outer), bits);
  }
  dropRepeats(loop.points);
  return loop;
}

bool isGood(const std::vector<Vec2>& polygon) {
  return isSimple(polygon) && signedArea(polygon) > 0;
}

/// What both outlines are made from.
struct Source {
  std::vector<Vec2> loop;  // local frame
  Frame frame;
  double step;
  double near;  // closer to a line than this is on it
};

struct LocalAndModel {
  std::vector<Vec2> local, model;
};

LocalAndModel finished(const Source& source, const std::vector<Vec2>& polygon) {
  LocalAndModel both;
  const std::vector<uint32_t> kept = withoutCollinear(polygon, source.near);
  both.local.reserve(kept.size());
  for (const uint32_t i : kept) both.local.push_back(polygon[i]);
  both.model = source.frame.toModel(both.local);
  return isGood(both.model) ? both : LocalAndModel{};
}

/// Without spikes, and with the steps that suit the shape.
Source sourceOf(std::vector<Vec2> loop, const OutlineOptions& options, double pixel,
                const Frame& frame, double resolution) {
  double length_of_loop = perimeter(loop), width = meanWidth(loop);
  const double samples = std::max(8, options.samples);
  std::vector<Vec2> smooth = withoutSpikes(
      loop, std::min(kSpikeBySteps * length_of_loop / samples, kSpikeByWidth * width));
  if (smooth.size() < loop.size() && isGood(smooth) && !isThin(smooth)) {
    loop = std::move(smooth);
    length_of_loop = perimeter(loop);
    width = meanWidth(loop);
  }

  const double diameter = diameterOf(loop);
  const double even_step = length_of_loop / samples;
  const double step = std::max(std::min(kPixelsPerStep * pixel, length_of_loop / 40),
                               std::min({even_step, diameter / (kStepsAcross * samples),
                                         std::max(width, even_step / kMostFiner)}));
  const double near = std::max(kOnLine * diameter, 4 * resolution);
  return {std::move(loop), frame, step, near};
}

LocalAndModel makeDense(const Source& source) {
  const ArcCurve curve(source.loop);
  double step = source.step;
  for (int halving = 0; halving <= kStepHalvings; ++halving, step /= 2) {
    LocalAndModel dense = finished(source, resample(curve, step));
    if (!dense.model.empty()) return dense;
  }
  LocalAndModel dense = finished(source, source.loop);
  return dense.model.empty() ? finished(source, convexHull(source.loop)) : dense;
}

/// Simple, or nothing.
std::vector<Vec2> polygonOf(const Source& source, const std::vector<Vec2>& vertices, double step) {
  return finished(source, bevelled(vertices, step)).model;
}

struct Steady {
  std::vector<Vec2> samples;  // local frame
  std::vector<Vec2> polygon;  // model units
  double step;
};

/// As smooth as it may be with a simple polygon.
Steady makeSteady(const Source& source, const LocalAndModel& dense, double steadiness) {
  const ArcCurve curve(source.loop);
  Steady steady;
  steady.step = source.step * std::max(steadiness, kLeastSteadiness);
  for (int halving = 0; halving <= kStepHalvings; ++halving, steady.step /= 2) {
    steady.samples = steadyCurve(curve, steady.step);
    if (!(steadiness > 0)) break;
    steady.polygon = polygonOf(source, fewVertices(steady.samples, steady.step), steady.step);
    if (!steady.polygon.empty()) return steady;
  }
  steady.polygon = polygonOf(source, dense.local, source.step);
  if (steady.polygon.empty()) steady.polygon = dense.model;
  return steady;
}

/// One half's vertices, and their images: bevelled, in model units. Empty where that is not simple.
std::vector<Vec2> symmetricPolygon(const Source& source, const MirrorFit& fit, double step) {
  const std::vector<Vec2> whole = mirroredWhole(fit);
  const size_t half = whole.size() / 2;
  std::vector<uint32_t> kept = simplify(whole, kMirroredMiss * step);
  std::sort(kept.begin(), kept.end());
  std::vector<Vec2> few{whole[0]};
  for (const uint32_t i : kept) {
    if (i > 0 && i < half) few.push_back(whole[i]);
  }
  const size_t own = few.size();
  few.push_back(whole[half]);
  for (size_t i = own; i-- > 1;) few.push_back(fit.line.mirrored(few[i]));
  return polygonOf(source, few, step);
}

/// The skeleton's polygon, symmetric where that is wanted or seen.
void setPolygon(const Source& source, const LocalAndModel& dense, const OutlineOptions& options,
                Outline& outline) {
  Steady steady = makeSteady(source, dense, options.steadiness);
  outline.polygon = std::move(steady.polygon);
  outline.mirror.reset();
  const auto fit = findMirrorLine(steady.samples);
  outline.likeness = fit ? fit->overlap : 0;
  double alike = kAlike;
  if (options.was_symmetric) alike += *options.was_symmetric ? -kAlikeMemory : kAlikeMemory;
  if (!fit || !options.symmetric.value_or(fit->overlap >= alike)) return;
  std::vector<Vec2> polygon = symmetricPolygon(source, *fit, steady.step);
  if (polygon.empty()) return;
  outline.polygon = std::move(polygon);
  outline.mirror = MirrorLine{source.frame.toModel(fit->line.through), fit->line.along};
}

}  // namespace

Result<Outline> makeOutline(const std::vector<Vec2>& stroke, const OutlineOptions& options) {
  std::vector<Vec2> points;
  points.reserve(stroke.size());
  std::copy_if(stroke.begin(), stroke.end(), std::back_inserter(points), isUsable);
  dropRepeats(points);
  if (points.size() < 3 || !hasThreeDistinct(points)) return Status::tooFewPoints;

  const Box2 box = boxOf(points);
  const Frame frame(box);
  for (Vec2& p : points) p = frame.toLocal(p);
  dropRepeats(points);
  if (points.size() < 3) return Status::noArea;

  const double pixel = pixelSize(points);
  Loop loop = closedLoop(trimOvershoot(points));
  if (loop.points.size() < 3 || isThin(loop.points)) return Status::noArea;

  Outline outline;
  LocalAndModel dense;
  for (int bits = kMostBits;; --bits) {
    const Source source = sourceOf(loop.points, options, pixel, frame, frame.resolution(box));
    dense = makeDense(source);
    if (dense.model.empty()) return Status::noArea;
    setPolygon(source, dense, options, outline);
    const bool few = dense.model.size() <= kMostDense && outline.polygon.size() <= kMostInPolygon;
    if (few || bits < kFewestBits) break;
    auto coarser = outerBoundary(snapped(loop.points, bits));
    if (!coarser || coarser->size() < 3) break;
    loop.points = unsnapped(std::move(*coarser), bits);
  }
  outline.dense = std::move(dense.model);
  outline.perimeter = perimeter(outline.dense);
  outline.crossed_itself = loop.crossed_itself;
  return outline;
}

}  // namespace marrow
