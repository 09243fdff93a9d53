// Orthographic camera that turns about the model like a turntable. In the front view the plane of
// the drawing coincides with the screen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/vec.h"

namespace marrow {

/// Width and height of the canvas in CSS pixels.
struct ViewSize {
  double width = 800, height = 600;
};

/// Where the camera looks from: yaw about the y axis, then pitch; zero is the front view.
struct Camera {
  Vec3 target;           // model point in the middle of the canvas
  double yaw_rad = 0;    // positive: seen from the right
  double pitch_rad = 0;  // positive: seen from above; −π/2 … π/2
  double zoom = 1;       // CSS pixels per model unit

  /// Rows: the view's right, up and towards-the-viewer directions in model space.
  std::array<Vec3, 3> axes() const;
  Vec3 toView(Vec3 model) const;   // model units, origin at the target, z to the viewer
  Vec3 fromView(Vec3 view) const;  // inverse of toView
  Vec2 toScreen(Vec3 model, ViewSize size) const;  // CSS pixels
  /// The model point under a pixel, in the plane through the target that faces the viewer.
  Vec3 underPixel(Vec2 pixel, ViewSize size) const;
  /// How far the view is from the front view, radians.
  double angleFromFront() const;

  /// Moves what is under the pointer along with it.
  void pan(Vec2 delta_px);
  /// Turns about `pivot`, which keeps its place on the screen.
  void orbit(Vec2 delta_px, Vec3 pivot);
  void turn(double yaw_rad, double pitch_rad, Vec3 pivot);
  /// Zooms so that the point under `pixel` stays there.
  void zoomAt(Vec2 pixel, double factor, ViewSize size);
};

inline bool operator==(const Camera& a, const Camera& b) {
  return a.target == b.target && a.yaw_rad == b.yaw_rad && a.pitch_rad == b.pitch_rad &&
         a.zoom == b.zoom;
}

/// How far something reaches in from each side of the canvas, CSS pixels.
struct Insets {
  double left = 0, top = 0, right = 0, bottom = 0;
};
inline bool operator==(const Insets& a, const Insets& b) {
  return a.left == b.left && a.top == b.top && a.right == b.right && a.bottom == b.bottom;
}

enum class StandardView : uint8_t { front, right, top };
const char* toString(StandardView view);

/// The camera turned into a standard view, zoom and middle kept; pivot keeps its place.
Camera turnedTo(const Camera& camera, StandardView view, Vec3 pivot);
/// The standard view this camera is in, if any.
std::optional<StandardView> standardView(const Camera& camera);
/// The camera moved and zoomed so that the box fills the part of the canvas inside the insets.
Camera framing(const Camera& camera, Vec3 low, Vec3 high, ViewSize size, const Insets& insets);
/// The camera moved, and zoomed out where it must, so that what is seen of the box lies inside the
/// insets. The same camera where it does already.
Camera makingRoom(const Camera& camera, Vec3 low, Vec3 high, ViewSize size, const Insets& insets);

/// A short glide from one camera to another. What the view turns about moves straight on the
/// screen, or keeps its place there where it has the same one in both.
class CameraGlide {
 public:
  static constexpr double kDuration_ms = 260;

  void start(const Camera& from, const Camera& to, Vec3 pivot, double now_ms);
  void stop() { running_ = false; }
  bool running() const { return running_; }
  const Camera& destination() const { return to_; }
  /// The camera at a moment; ends the glide when its time is over.
  Camera at(double now_ms);

 private:
  Camera from_, to_;
  Vec3 pivot_;
  double start_ms_ = 0;
  bool running_ = false;
};

}  // namespace marrow
