#include "camera.h"

#include <algorithm>
#include <cmath>

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

Camera framing(const Camera& camera, Vec3 low, Vec3 high, ViewSize size, double margin_px) {
  Camera framed = camera;
  framed.target = (low + high) / 2;
  double half_width = 0, half_height = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 view = framed.toView(
        {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    half_width = std::max(half_width, std::abs(view.x));
    half_height = std::max(half_height, std::abs(view.y));
  }
  const double width = std::max(size.width - 2 * margin_px, 50.0);
  const double height = std::max(size.height - 2 * margin_px, 50.0);
  if (half_width <= 0 && half_height <= 0) return framed;
  framed.zoom = std::min(half_width > 0 ? width / (2 * half_width) : kMaxZoom,
                         half_height > 0 ? height / (2 * half_height) : kMaxZoom);
  framed.zoom = std::clamp(framed.zoom, kMinZoom, kMaxZoom);
  return framed;
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
