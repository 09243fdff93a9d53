#include "tools/navigate_tool.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

// Fingers that pinch also turn a little; only a twist that is meant turns the model.
constexpr double kTwistSlop_rad = 0.2;

}  // namespace

void NavigateTool::add(const PointerEvent& event, Mode mode) {
  mode_ = mode;
  twist_rad_ = 0;
  twisting_ = false;
  if (!holds(event.id)) touches_.push_back({event.id, event.position_px});
  settled_ = touches_;
}

void NavigateTool::remove(int pointer) {
  touches_.erase(std::remove_if(touches_.begin(), touches_.end(),
                                [&](const Touch& touch) { return touch.pointer == pointer; }),
                 touches_.end());
  settled_ = touches_;
  twist_rad_ = 0;
  twisting_ = false;
}

bool NavigateTool::holds(int pointer) const {
  return std::any_of(touches_.begin(), touches_.end(),
                     [&](const Touch& touch) { return touch.pointer == pointer; });
}

void NavigateTool::move(const PointerEvent& event, Camera& camera, Vec3 pivot) {
  Vec2 delta_px;
  for (Touch& touch : touches_) {
    if (touch.pointer != event.id) continue;
    delta_px = event.position_px - touch.position_px;
    touch.position_px = event.position_px;
  }
  switch (mode_) {
    case Mode::orbit:
      camera.orbit(delta_px, pivot);
      break;
    case Mode::pan:
      camera.pan(delta_px);
      break;
    case Mode::fingers:
      if (touches_.size() >= 3) {
        camera.orbit(delta_px / static_cast<double>(touches_.size()), pivot);
      }
      break;
  }
}

void NavigateTool::settle(Camera& camera, ViewSize size, Vec3 pivot) {
  if (mode_ == Mode::fingers && touches_.size() == 2) moveFingers(camera, size, pivot);
  settled_ = touches_;
}

void NavigateTool::moveFingers(Camera& camera, ViewSize size, Vec3 pivot) {
  const Vec2 old_span = settled_[1].position_px - settled_[0].position_px;
  const Vec2 new_span = touches_[1].position_px - touches_[0].position_px;
  const Vec2 old_middle = (settled_[0].position_px + settled_[1].position_px) / 2;
  const Vec2 new_middle = (touches_[0].position_px + touches_[1].position_px) / 2;
  camera.pan(new_middle - old_middle);
  if (length(old_span) < 1 || length(new_span) < 1) return;
  camera.zoomAt(new_middle, length(new_span) / length(old_span), size);

  double twist = std::atan2(cross(old_span, new_span), dot(old_span, new_span));
  twist_rad_ += twist;
  if (!twisting_) {
    twisting_ = std::abs(twist_rad_) > kTwistSlop_rad;
    twist = twisting_ ? twist_rad_ - std::copysign(kTwistSlop_rad, twist_rad_) : 0;
  }
  if (twist != 0) camera.turn(twist, 0, pivot);
}

void NavigateTool::wheel(const WheelEvent& event, Camera& camera, ViewSize size) {
  camera.pan(event.pan_px);
  if (event.zoom != 0) camera.zoomAt(event.position_px, std::exp(event.zoom), size);
}

}  // namespace marrow
