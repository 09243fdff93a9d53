#include "skeleton/straight_skeleton.h"

#include <cmath>

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

Result<StraightSkeleton> straightSkeleton(const std::vector<Vec2>& polygon,
                                          const StraightSkeletonOptions& options) {
  auto skeleton = straightSkeletonByWavefront(polygon);
  if (skeleton || skeleton.status() == Status::tooFewPoints || !options.allow_fallback) {
    return skeleton;
  }
  if (!isSimple(polygon) || signedArea(polygon) <= 0) return Status::notAPolygon;
  return straightSkeletonByCgal(polygon);
}

}  // namespace marrow
