#include "sketch/contour_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sketch/polygon.h"

namespace marrow {
namespace {

/// A place on a closed polygon: on the side from vertex `side` to the next, 0 … 1 along it.
struct Place {
  size_t side = 0;
  double t = 0;
  double away = std::numeric_limits<double>::infinity();
  Vec2 point;
};

Vec2 after(const std::vector<Vec2>& polygon, size_t i) { return polygon[(i + 1) % polygon.size()]; }

Place nearestPlace(const std::vector<Vec2>& polygon, Vec2 p) {
  Place nearest;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], along = after(polygon, i) - a;
    const double squared = dot(along, along);
    const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
    const Vec2 point = a + along * t;
    const double away = distance(p, point);
    if (away < nearest.away) nearest = {i, t, away, point};
  }
  return nearest;
}

/// The polygon from one place forwards to another, both included.
std::vector<Vec2> stretch(const std::vector<Vec2>& polygon, const Place& from, const Place& to) {
  std::vector<Vec2> points{from.point};
  const bool wraps = to.side < from.side || (to.side == from.side && to.t < from.t);
  const size_t sides = (to.side + (wraps ? polygon.size() : 0)) - from.side;
  for (size_t k = 1; k <= sides; ++k) points.push_back(polygon[(from.side + k) % polygon.size()]);
  points.push_back(to.point);
  return points;
}

double distanceTo(const std::vector<Vec2>& line, Vec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 1; i < line.size(); ++i) {
    nearest = std::min(nearest, distanceToSegment(line[i - 1], line[i], p));
  }
  return nearest;
}

/// Mean distance of evenly spread points of one line from the other.
double meanDistance(const std::vector<Vec2>& line, const std::vector<Vec2>& other) {
  constexpr int kSamples = 24;
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  const double step = length / kSamples;
  if (!(step > 0)) return distanceTo(other, line.front());
  double sum = 0, next = step / 2, run = 0;
  int count = 0;
  for (size_t i = 1; i < line.size(); ++i) {
    const double side = distance(line[i - 1], line[i]);
    for (; next <= run + side && count < kSamples; next += step, ++count) {
      sum += distanceTo(other, lerp(line[i - 1], line[i], (next - run) / side));
    }
    run += side;
  }
  return count > 0 ? sum / count : 0;
}

/// How far two lines are from each other, both ways.
double apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return meanDistance(a, b) + meanDistance(b, a);
}

}  // namespace

std::optional<std::vector<Vec2>> redrawn(const std::vector<Vec2>& outline,
                                         const std::vector<Vec2>& stroke, double reach) {
  if (outline.size() < 3 || stroke.size() < 2) return std::nullopt;
  const Place begin = nearestPlace(outline, stroke.front());
  const Place end = nearestPlace(outline, stroke.back());
  if (std::min(begin.away, end.away) > reach) return std::nullopt;
  if (begin.side == end.side && begin.t == end.t) return std::nullopt;
  const std::vector<Vec2> forwards = stretch(outline, begin, end);
  const std::vector<Vec2> backwards = stretch(outline, end, begin);
  // What is kept goes on from the stroke's end to its beginning.
  const bool replaces_forwards = apart(forwards, stroke) <= apart(backwards, stroke);
  std::vector<Vec2> result = stroke;
  if (replaces_forwards) {
    result.insert(result.end(), backwards.begin(), backwards.end());
  } else {
    result.insert(result.end(), forwards.rbegin(), forwards.rend());
  }
  return result;
}

std::vector<Vec2> dragged(const std::vector<Vec2>& outline, Vec2 grabbed, Vec2 move, double reach) {
  constexpr double kStepsInReach = 12;
  if (outline.size() < 3 || !(reach > 0)) return outline;
  const Place place = nearestPlace(outline, grabbed);
  const double around = perimeter(outline);
  const double step = reach / kStepsInReach;

  std::vector<Vec2> result;
  double along = -place.t * distance(outline[place.side], after(outline, place.side));
  const auto add = [&](Vec2 p, double at) {
    const double away = std::min(std::fabs(at), around - std::fabs(at)) / reach;
    const double left = away < 1 ? 1 - away * away : 0;
    result.push_back(p + move * (left * left));
  };
  for (size_t k = 0; k < outline.size(); ++k) {
    const Vec2 a = outline[(place.side + k) % outline.size()];
    const Vec2 b = outline[(place.side + k + 1) % outline.size()];
    const double side = distance(a, b);
    const bool near = along < reach || along + side > around - reach;
    const int pieces = near ? static_cast<int>(std::min(std::ceil(side / step), 64.0)) : 1;
    for (int i = 0; i < std::max(pieces, 1); ++i) {
      const double t = static_cast<double>(i) / std::max(pieces, 1);
      // The grabbed place itself stays a point, or a corner would be cut off.
      if (k == 0 && i > 0 && place.t > t - 1.0 / pieces && place.t < t) add(place.point, 0);
      add(lerp(a, b, t), along + side * t);
    }
    if (k == 0 && place.t > 1 - 1.0 / std::max(pieces, 1) && place.t < 1) add(place.point, 0);
    along += side;
  }
  return result;
}

}  // namespace marrow
