#include "tools/draw_tool.h"

#include <algorithm>
#include <utility>

namespace marrow {
namespace {

// How far a pointer may tremble in a click.
double slop_px(PointerKind kind) { return kind == PointerKind::mouse ? 3 : 7; }

}  // namespace

void DrawTool::begin(const PointerEvent& event, const Camera& camera, ViewSize size) {
  camera_ = camera;
  size_ = size;
  kind_ = event.kind;
  pointer_ = event.id;
  active_ = true;
  is_stroke_ = false;
  started_ms_ = event.time_ms;
  travelled_px_ = 0;
  first_px_ = last_px_ = event.position_px;
  points_.clear();
  pressures_.clear();
  add(event);
}

void DrawTool::move(const PointerEvent& event) {
  const double step = distance(event.position_px, last_px_);
  if (step < kMinStep_px) return;
  travelled_px_ += step;
  last_px_ = event.position_px;
  add(event);
  if (distance(event.position_px, first_px_) > slop_px(kind_)) is_stroke_ = true;
}

std::vector<Vec2> DrawTool::end() {
  active_ = false;
  return std::move(points_);
}

std::vector<Vec2> DrawTool::previewPoints() const {
  if (points_.size() <= kPreviewPoints) return points_;
  std::vector<Vec2> thinned;
  thinned.reserve(kPreviewPoints);
  for (size_t i = 0; i < kPreviewPoints; ++i) {
    thinned.push_back(points_[i * (points_.size() - 1) / (kPreviewPoints - 1)]);
  }
  return thinned;
}

void DrawTool::add(const PointerEvent& event) {
  const auto [right, up, back] = camera_.axes();
  const Vec3 model = camera_.underPixel(event.position_px, size_);
  points_.push_back({dot(right, model), dot(up, model)});
  pressures_.push_back(std::clamp(event.pressure, 0.0, 1.0));
}

}  // namespace marrow
