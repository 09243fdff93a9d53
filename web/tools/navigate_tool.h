// Buttons, wheel and fingers that move the camera.
#pragma once

#include <vector>

#include "camera.h"
#include "input.h"

namespace marrow {

/// One pointer turns or moves the view, as it was told to. Two fingers: what is between them
/// follows them (pan and pinch), a twist turns the model on its turntable. Three: turn freely.
/// The events of two fingers come one finger after the other; they are followed together, once a
/// frame, or else a pan would twist.
class NavigateTool {
 public:
  enum class Mode : uint8_t { orbit, pan, fingers };

  void add(const PointerEvent& event, Mode mode);
  void remove(int pointer);
  void clear() { touches_.clear(); }
  /// Lets the camera catch up with two fingers: at the end of a frame's input, and before a finger
  /// comes or goes.
  void settle(Camera& camera, ViewSize size, Vec3 pivot);
  bool active() const { return !touches_.empty(); }
  size_t pointers() const { return touches_.size(); }
  bool holds(int pointer) const;

  /// pivot: what the view turns about.
  void move(const PointerEvent& event, Camera& camera, Vec3 pivot);
  static void wheel(const WheelEvent& event, Camera& camera, ViewSize size);

 private:
  struct Touch {
    int pointer;
    Vec2 position_px;
  };
  void moveFingers(Camera& camera, ViewSize size, Vec3 pivot);

  Mode mode_ = Mode::orbit;
  std::vector<Touch> touches_;
  std::vector<Touch> settled_;  // the same when the camera last followed
  double twist_rad_ = 0;        // since the second finger came down
  bool twisting_ = false;
};

}  // namespace marrow
