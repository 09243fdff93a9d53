// The handles around what is selected, on the screen.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "camera.h"
#include "tools/transform_tool.h"

namespace marrow {

struct GizmoHandle {
  TransformKind kind = TransformKind::move;
  TransformAxis axis = TransformAxis::none;
};
inline bool operator==(GizmoHandle a, GizmoHandle b) {
  return a.kind == b.kind && a.axis == b.axis;
}

/// Where its lines lie, CSS pixels. An axis or a ring that is seen edge-on is empty.
struct Gizmo {
  Vec2 middle;                                // moves in the plane of the screen
  std::array<std::optional<Vec2>, 3> arrows;  // tips
  std::array<std::vector<Vec2>, 3> arcs;      // the front halves of the rings about X, Y and Z
  double ring = 0;                            // radius of the ring that turns on the screen
  Vec2 scale;                                 // the knob that scales
};

/// Larger for fingers.
Gizmo layOutGizmo(Vec3 pivot, const Camera& camera, ViewSize size, bool touch);
std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, Vec2 pixel, bool touch);

}  // namespace marrow
