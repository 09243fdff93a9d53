#include "tools/gizmo.h"

#include <algorithm>
#include <cmath>

#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kArrow_px = 78, kArc_px = 58, kRing_px = 98;
constexpr double kTouchFactor = 1.25;
constexpr double kEdgeOn = 0.25;  // shorter than this share of its length: not shown
constexpr int kArcSteps = 48;
constexpr double kFullTurn = 6.28318530717958647692;

double distanceToPolyline(Vec2 p, const std::vector<Vec2>& points) {
  double nearest = 1e9;
  for (size_t i = 1; i < points.size(); ++i) {
    nearest = std::min(nearest, distanceToSegment(points[i - 1], points[i], p));
  }
  return nearest;
}

constexpr TransformAxis kAxes[] = {TransformAxis::x, TransformAxis::y, TransformAxis::z};

}  // namespace

Gizmo layOutGizmo(Vec3 pivot, const Camera& camera, ViewSize size, bool touch) {
  const double factor = touch ? kTouchFactor : 1;
  const auto [right, up, back] = camera.axes();
  Gizmo gizmo;
  gizmo.middle = camera.toScreen(pivot, size);
  gizmo.ring = kRing_px * factor;
  gizmo.scale = gizmo.middle + Vec2{gizmo.ring * 0.7071, -gizmo.ring * 0.7071};
  for (size_t k = 0; k < 3; ++k) {
    const Vec3 axis = axisDirection(kAxes[k], camera);
    const Vec2 on_screen{dot(right, axis), -dot(up, axis)};
    if (length(on_screen) > kEdgeOn) {
      gizmo.arrows[k] = gizmo.middle + on_screen * (kArrow_px * factor);
    }
    // A ring seen edge-on is a line across everything else.
    if (std::abs(dot(back, axis)) < kEdgeOn || std::abs(dot(back, axis)) > 0.985) continue;
    const Vec3 u = axisDirection(kAxes[(k + 1) % 3], camera);
    const Vec3 v = axisDirection(kAxes[(k + 2) % 3], camera);
    std::vector<Vec2> front;
    int first = 0;  // begin behind, so that the front half is in one piece
    const auto depth = [&, b = back](int i) {
      const double a = kFullTurn * i / kArcSteps;
      return dot(b, u) * std::cos(a) + dot(b, v) * std::sin(a);
    };
    for (int i = 0; i < kArcSteps; ++i) {
      if (depth(i) < depth(first)) first = i;
    }
    for (int i = first; i <= first + kArcSteps; ++i) {
      if (depth(i) < -0.02) continue;
      const double a = kFullTurn * i / kArcSteps;
      const Vec3 p = u * std::cos(a) + v * std::sin(a);
      front.push_back(gizmo.middle + Vec2{dot(right, p), -dot(up, p)} * (kArc_px * factor));
    }
    gizmo.arcs[k] = std::move(front);
  }
  return gizmo;
}

std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, Vec2 pixel, bool touch) {
  const double reach = touch ? 20 : 9;
  if (distance(pixel, gizmo.scale) < reach + 4) return GizmoHandle{TransformKind::scale, {}};
  if (distance(pixel, gizmo.middle) < reach + 4) return GizmoHandle{TransformKind::move, {}};
  std::optional<GizmoHandle> found;
  double nearest = reach;
  const auto offer = [&](double away, GizmoHandle handle) {
    if (away >= nearest) return;
    nearest = away;
    found = handle;
  };
  for (size_t k = 0; k < 3; ++k) {
    if (gizmo.arrows[k]) {
      offer(distance(pixel, *gizmo.arrows[k]) - 4, {TransformKind::move, kAxes[k]});
      offer(distanceToPolyline(pixel, {gizmo.middle, *gizmo.arrows[k]}),
            {TransformKind::move, kAxes[k]});
    }
    offer(distanceToPolyline(pixel, gizmo.arcs[k]), {TransformKind::rotate, kAxes[k]});
  }
  offer(std::abs(distance(pixel, gizmo.middle) - gizmo.ring), {TransformKind::rotate, {}});
  return found;
}

}  // namespace marrow
