// Pointer samples → a stroke in a plane that faces the viewer.
#pragma once

#include <vector>

#include "camera.h"
#include "input.h"

namespace marrow {

/// Collects the stroke under a pen, finger or button. Where the pointer goes down is mapped by the
/// camera that is given then, so a camera that glides meanwhile does not bend the stroke.
class DrawTool {
 public:
  /// Samples nearer to the last one than this are dropped: nothing is seen of them.
  static constexpr double kMinStep_px = 0.5;
  /// What the live preview is computed from at most, whatever the hand does.
  static constexpr size_t kPreviewPoints = 2000;

  /// camera: the one that pointers are mapped by until the stroke ends.
  void begin(const PointerEvent& event, const Camera& camera, ViewSize size);
  void move(const PointerEvent& event);
  void cancel() { active_ = false; }
  /// Ends the stroke and gives it away.
  std::vector<Vec2> end();

  bool active() const { return active_; }
  /// The pointer has left the place where it went down: this is a stroke, not a click.
  bool isStroke() const { return is_stroke_; }
  int pointer() const { return pointer_; }
  const Camera& camera() const { return camera_; }  // the one given to begin()
  Vec2 last_px() const { return last_px_; }
  PointerKind kind() const { return kind_; }
  double started_ms() const { return started_ms_; }
  /// How far the pointer has travelled, CSS pixels.
  double travelled_px() const { return travelled_px_; }

  /// Model units along the camera's right and up directions, from the foot of the world's origin:
  /// the same at whatever depth the plane lies.
  const std::vector<Vec2>& points() const { return points_; }
  Vec2 first_px() const { return first_px_; }
  /// At most kPreviewPoints of the points, evenly thinned.
  std::vector<Vec2> previewPoints() const;
  /// Pressure at point `index` of `count` evenly thinned ones, 0 … 1.
  double pressureNear(size_t index, size_t count) const {
    return pressures_[count < 2 ? 0 : index * (pressures_.size() - 1) / (count - 1)];
  }

 private:
  void add(const PointerEvent& event);

  Camera camera_;
  ViewSize size_;
  PointerKind kind_ = PointerKind::mouse;
  int pointer_ = 0;
  bool active_ = false, is_stroke_ = false;
  double started_ms_ = 0, travelled_px_ = 0;
  Vec2 first_px_, last_px_;
  std::vector<Vec2> points_;
  std::vector<double> pressures_;
};

}  // namespace marrow
