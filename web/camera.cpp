#include "camera.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"

namespace marrow {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;
constexpr double kQuarterTurn = kHalfTurn / 2;
constexpr double kRadiansPerPixel = 0.0085;
constexpr double kMinZoom = 1e-6, kMaxZoom = 1e6;

double wrapped(double angle) { return std::remainder(angle, 2 * kHalfTurn); }

}  // namespace

std::array<Vec3, 3> Camera::axes() const {
  const double cy = std::cos(yaw_rad), sy = std::sin(yaw_rad);
  const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
  return {Vec3{cy, 0, -sy}, Vec3{-sy * sp, cp, -cy * sp}, Vec3{sy * cp, sp, cy * cp}};
}

Vec3 Camera::toView(Vec3 model) const {
  const auto [right, up, back] = axes();
  const Vec3 p = model - target;
  return {dot(right, p), dot(up, p), dot(back, p)};
}

Vec3 Camera::fromView(Vec3 view) const {
  const auto [right, up, back] = axes();
  return target + right * view.x + up * view.y + back * view.z;
}

Vec2 Camera::toScreen(Vec3 model, ViewSize size) const {
  const Vec3 view = toView(model);
  return {size.width / 2 + view.x * zoom, size.height / 2 - view.y * zoom};
}

Vec3 Camera::underPixel(Vec2 pixel, ViewSize size) const {
  return fromView({(pixel.x - size.width / 2) / zoom, (size.height / 2 - pixel.y) / zoom, 0});
}

double Camera::angleFromFront() const {
  return std::acos(std::clamp(std::cos(yaw_rad) * std::cos(pitch_rad), -1.0, 1.0));
}

void Camera::pan(Vec2 delta_px) { target = fromView({-delta_px.x / zoom, delta_px.y / zoom, 0}); }

void Camera::orbit(Vec2 delta_px, Vec3 pivot) {
  turn(-delta_px.x * kRadiansPerPixel, delta_px.y * kRadiansPerPixel, pivot);
}

void Camera::turn(double yaw, double pitch, Vec3 pivot) {
  const Vec3 offset = toView(pivot);
  yaw_rad = wrapped(yaw_rad + yaw);
  pitch_rad = std::clamp(pitch_rad + pitch, -kQuarterTurn, kQuarterTurn);
  target = target + pivot - fromView(offset);
}

void Camera::zoomAt(Vec2 pixel, double factor, ViewSize size) {
  const Vec3 before = underPixel(pixel, size);
  zoom = std::clamp(zoom * factor, kMinZoom, kMaxZoom);
  target = target + before - underPixel(pixel, size);
}

const char* toString(StandardView view) {
  switch (view) {
    case StandardView::front:
      return "front";
    case StandardView::right:
      return "right";
    case StandardView::top:
      return "top";
  }
  return "";
}

Camera turnedTo(const Camera& camera, StandardView view, Vec3 pivot) {
  const double yaw = view == StandardView::right ? kQuarterTurn : 0;
  const double pitch = view == StandardView::top ? kQuarterTurn : 0;
  Camera turned = camera;
  turned.turn(yaw - camera.yaw_rad, pitch - camera.pitch_rad, pivot);
  turned.yaw_rad = yaw;
  turned.pitch_rad = pitch;
  return turned;
}

std::optional<StandardView> standardView(const Camera& camera) {
  for (const StandardView view : {StandardView::front, StandardView::right, StandardView::top}) {
    const Camera turned = turnedTo(camera, view, {});
    if (std::abs(wrapped(turned.yaw_rad - camera.yaw_rad)) < 1e-6 &&
        std::abs(turned.pitch_rad - camera.pitch_rad) < 1e-6) {
      return view;
    }
  }
  return std::nullopt;
}

Camera framing(const Camera& camera, Vec3 low, Vec3 high, ViewSize size, const Insets& insets) {
  Camera framed = camera;
  framed.target = (low + high) / 2;
  double half_width = 0, half_height = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 view = framed.toView(
        {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    half_width = std::max(half_width, std::abs(view.x));
    half_height = std::max(half_height, std::abs(view.y));
  }
  const double width = std::max(size.width - insets.left - insets.right, 50.0);
  const double height = std::max(size.height - insets.top - insets.bottom, 50.0);
  if (half_width <= 0 && half_height <= 0) return framed;
  framed.zoom = std::min(half_width > 0 ? width / (2 * half_width) : kMaxZoom,
                         half_height > 0 ? height / (2 * half_height) : kMaxZoom);
  framed.zoom = std::clamp(framed.zoom, kMinZoom, kMaxZoom);
  framed.pan({(insets.left - insets.right) / 2, (insets.top - insets.bottom) / 2});
  return framed;
}

Camera makingRoom(const Camera& camera, Vec3 low, Vec3 high, ViewSize size, const Insets& insets) {
  Box2 seen;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec2 at = camera.toScreen(
        {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z},
        size);
    seen.include(Vec2{std::clamp(at.x, 0.0, size.width), std::clamp(at.y, 0.0, size.height)});
  }
  const Vec2 middle{size.width / 2, size.height / 2}, span = seen.high - seen.low;
  const Vec2 from{insets.left, insets.top};
  const Vec2 to{size.width - insets.right, size.height - insets.bottom};
  if (span.x <= 0 || span.y <= 0 || from.x >= to.x || from.y >= to.y) return camera;
  const double scale = std::min({1.0, (to.x - from.x) / span.x, (to.y - from.y) / span.y});
  Camera moved = camera;
  moved.zoom = std::max(camera.zoom * scale, kMinZoom);
  const Vec2 a = middle + (seen.low - middle) * scale, b = middle + (seen.high - middle) * scale;
  const Vec2 way{std::clamp(0.0, from.x - a.x, std::max(from.x - a.x, to.x - b.x)),
                 std::clamp(0.0, from.y - a.y, std::max(from.y - a.y, to.y - b.y))};
  if (way != Vec2{}) moved.pan(way);
  return moved;
}

void CameraGlide::start(const Camera& from, const Camera& to, Vec3 pivot, double now_ms) {
  from_ = from;
  to_ = to;
  pivot_ = pivot;
  start_ms_ = now_ms;
  running_ = true;
}

Camera CameraGlide::at(double now_ms) {
  const double t = std::clamp((now_ms - start_ms_) / kDuration_ms, 0.0, 1.0);
  if (t >= 1) {
    running_ = false;
    return to_;
  }
  const double s = t * t * (3 - 2 * t);
  Camera camera = from_;
  camera.yaw_rad = from_.yaw_rad + wrapped(to_.yaw_rad - from_.yaw_rad) * s;
  camera.pitch_rad = from_.pitch_rad + (to_.pitch_rad - from_.pitch_rad) * s;
  camera.zoom = from_.zoom * std::pow(to_.zoom / from_.zoom, s);
  const Vec3 offset = from_.toView(pivot_) * (1 - s) + to_.toView(pivot_) * s;
  camera.target = pivot_;
  camera.target = pivot_ + pivot_ - camera.fromView(offset);
  return camera;
}

}  // namespace marrow
