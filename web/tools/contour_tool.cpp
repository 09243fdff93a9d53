#include "tools/contour_tool.h"

#include <algorithm>
#include <cmath>

#include "sketch/contour_edit.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kHandleEvery_px = 46;
constexpr double kEdgeOn = 0.15;     // cosine between the plane's normal and the view
constexpr double kDragShare = 0.16;  // of the perimeter: how far a drag is felt
constexpr double kReach_px = 40;     // so near to the outline a stroke must begin or end
constexpr double kGrab_px = 12, kTouchGrab_px = 24;
constexpr size_t kMostHandles = 200;

}  // namespace

std::vector<Vec3> contourHandles(const Part& part, const Frame& frame, const Camera& camera) {
  const auto& outline = part.outline.dense;
  const double length = perimeter(outline);
  const double length_px = length * frame.scale() * camera.zoom;
  const auto count = static_cast<size_t>(
      std::clamp(length_px / kHandleEvery_px, 6.0, static_cast<double>(kMostHandles)));
  const double step = length / static_cast<double>(count);
  std::vector<Vec3> handles;
  double next = 0, along = 0;
  for (size_t i = 0; i < outline.size() && handles.size() < count; ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double side = distance(a, b);
    for (; next <= along + side && handles.size() < count; next += step) {
      handles.push_back(frame.toWorld(lerp(a, b, side > 0 ? (next - along) / side : 0)));
    }
    along += side;
  }
  return handles;
}

std::optional<Vec2> planePoint(Vec2 pixel, const Frame& frame, const Camera& camera,
                               ViewSize size) {
  const Vec3 back = camera.axes()[2], normal = frame.z() / frame.scale();
  const double facing = dot(back, normal);
  if (std::abs(facing) < kEdgeOn) return std::nullopt;
  const Vec3 from = camera.underPixel(pixel, size);
  const Vec3 world = from + back * (dot(frame.origin - from, normal) / facing);
  const Vec3 local = frame.toLocal(world);
  return Vec2{local.x, local.y};
}

bool ContourTool::begin(Vec2 pixel, const PlacedPart& placed, const EvaluatedPart& evaluated,
                        const Camera& camera, ViewSize size, bool drags, bool touch) {
  if (!evaluated.part) return false;
  const auto start = planePoint(pixel, placed.frame, camera, size);
  if (!start) return false;
  id_ = evaluated.source->id;
  frame_ = placed.frame;
  camera_ = camera;
  size_ = size;
  outline_ = evaluated.part->outline.dense;
  perimeter_ = perimeter(outline_);
  reach_ = kReach_px / (camera.zoom * placed.frame.scale());
  points_ = {*start};
  drags_ = drags;
  const double grab = (touch ? kTouchGrab_px : kGrab_px) / (camera.zoom * frame_.scale());
  if (drags && distanceToBorder(outline_, *start) > grab) return false;
  active_ = true;
  return true;
}

void ContourTool::move(Vec2 pixel) {
  const auto point = planePoint(pixel, frame_, camera_, size_);
  if (!point) return;
  if (drags_) points_.resize(1);
  points_.push_back(*point);
}

std::vector<Vec3> ContourTool::ink() const {
  std::vector<Vec3> ink;
  if (!active_ || drags_) return ink;
  for (const Vec2 p : points_) ink.push_back(frame_.toWorld(p));
  return ink;
}

std::optional<SetStroke> ContourTool::command() const {
  if (points_.size() < 2) return std::nullopt;
  if (drags_) {
    return SetStroke{id_, dragged(outline_, points_.front(), points_.back() - points_.front(),
                                  kDragShare * perimeter_)};
  }
  auto outline = redrawn(outline_, points_, reach_);
  if (!outline) return std::nullopt;
  return SetStroke{id_, std::move(*outline)};
}

}  // namespace marrow
