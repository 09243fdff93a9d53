#include "skeleton/straight_skeleton.h"

#include <algorithm>
#include <cstdint>

#include "sketch/polygon.h"

namespace marrow {

const char* toString(StraightSkeleton::Kind kind) {
  switch (kind) {
    case StraightSkeleton::Kind::border:
      return "border";
    case StraightSkeleton::Kind::peripheral:
      return "peripheral";
    case StraightSkeleton::Kind::skeleton:
      return "skeleton";
  }
  return "";
}

const char* toString(StraightSkeleton::Method method) {
  return method == StraightSkeleton::Method::wavefront ? "wavefront" : "cgal";
}

namespace {

// CGAL needs half a second for 1,000 vertices and four times as much for twice as many.
constexpr size_t kManyForCgal = 300;
constexpr double kJolt = 1e-9;  // × the polygon's size: below what the self-check tolerates

/// The polygon with each vertex moved by too little to see, so that what coincided does no longer.
std::vector<Vec2> jolted(const std::vector<Vec2>& polygon) {
  const double by = kJolt * perimeter(polygon) / 4;
  std::vector<Vec2> moved = polygon;
  uint32_t state = 1;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 8388608.0 - 1;
  };
  for (Vec2& p : moved) {
    const double x = next();
    p = p + Vec2{x, next()} * by;
  }
  return moved;
}

}  // namespace

Result<StraightSkeleton> straightSkeleton(const std::vector<Vec2>& polygon,
                                          const StraightSkeletonOptions& options) {
  auto skeleton = straightSkeletonByWavefront(polygon);
  if (skeleton || skeleton.status() == Status::tooFewPoints || !options.allow_fallback) {
    return skeleton;
  }
  if (!isSimple(polygon) || signedArea(polygon) <= 0) return Status::notAPolygon;
  if (polygon.size() > kManyForCgal) {
    skeleton = straightSkeletonByWavefront(jolted(polygon));
    if (skeleton) {
      std::copy(polygon.begin(), polygon.end(), skeleton->nodes.begin());
      if (inconsistency(polygon, *skeleton).empty()) return skeleton;
    }
  }
  return straightSkeletonByCgal(polygon);
}

}  // namespace marrow
