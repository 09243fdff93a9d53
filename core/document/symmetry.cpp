#include "document/symmetry.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"
#include "document/placement.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kParallel = 0.97;      // of the cosine between normals: 14°
constexpr double kBehind = 0.5;         // of area ÷ perimeter: half the half width of a limb
constexpr double kAcross = 1. / 8;      // of the extent
constexpr double kUpright = 1e-3;       // of the cosine between normals
constexpr double kEndsApart = 1. / 20;  // of the stroke's length
constexpr double kLengthy = 1.2;        // wider than high by this factor: seen from the side

}  // namespace

std::optional<Plane> symmetryPlane(const Document& document) {
  if (document.symmetry) return document.symmetry;
  if (document.parts.empty() || document.parts[0]->stroke.empty()) return std::nullopt;
  const PartSource& body = *document.parts[0];
  const Box2 box = boxOf(body.stroke);
  const bool from_side = box.size().x > kLengthy * box.size().y;
  const Vec3 normal = from_side ? body.frame.z() : body.frame.x;
  const auto plane = normalised({normal, 0});
  if (!plane) return std::nullopt;
  return normalised({plane->normal, -dot(plane->normal, body.frame.toWorld(box.middle()))});
}

bool isOffPlane(const std::vector<Vec2>& stroke, const Frame& frame, const Plane& plane) {
  if (stroke.empty()) return false;
  if (std::fabs(dot(frame.z(), plane.normal)) >= kParallel * frame.scale()) {
    const double away = std::fabs(distance(plane, frame.toWorld(boxOf(stroke).middle())));
    return away * perimeter(stroke) > kBehind * std::fabs(signedArea(stroke)) * frame.scale();
  }
  double low = 0, high = 0;
  for (size_t i = 0; i < stroke.size(); ++i) {
    const double side = distance(plane, frame.toWorld(stroke[i]));
    low = i == 0 ? side : std::min(low, side);
    high = i == 0 ? side : std::max(high, side);
  }
  return std::min(-low, high) < kAcross * (high - low);
}

std::optional<std::vector<Vec2>> completedByMirror(const std::vector<Vec2>& stroke,
                                                   const Frame& frame, const Plane& plane,
                                                   double reach) {
  if (stroke.size() < 3) return std::nullopt;
  if (!(std::fabs(dot(frame.z(), plane.normal)) <= kUpright * frame.scale())) return std::nullopt;
  // The line in the drawing's plane: dot(normal, p) + offset = 0, in the drawing's units.
  const Vec2 slope{dot(plane.normal, frame.x), dot(plane.normal, frame.y)};
  const Vec2 normal = slope / length(slope);
  const double offset = distance(plane, frame.origin) / length(slope);
  const double near = reach / frame.scale();
  const auto away = [&](Vec2 p) { return dot(normal, p) + offset; };

  double low = 0, high = 0, length_along = 0;
  for (size_t i = 0; i < stroke.size(); ++i) {
    low = std::min(low, away(stroke[i]));
    high = std::max(high, away(stroke[i]));
    if (i > 0) length_along += distance(stroke[i - 1], stroke[i]);
  }
  const double side = high > -low ? 1 : -1;
  if (!(std::max(high, -low) > near) || std::min(high, -low) > near) return std::nullopt;
  const Vec2 first = stroke.front(), last = stroke.back();
  if (std::fabs(away(first)) > near || std::fabs(away(last)) > near) return std::nullopt;
  if (!(distance(first, last) > std::max(2 * near, kEndsApart * length_along))) {
    return std::nullopt;
  }

  std::vector<Vec2> outline, image;
  for (size_t i = 0; i < stroke.size(); ++i) {
    const double own = away(stroke[i]);
    const bool end = i == 0 || i + 1 == stroke.size();
    const bool on_line = end || own * side <= 0;
    outline.push_back(on_line ? stroke[i] - normal * own : stroke[i]);
    if (!on_line) image.push_back(stroke[i] - normal * (2 * own));
  }
  outline.insert(outline.end(), image.rbegin(), image.rend());
  return outline;
}

}  // namespace marrow
