#include "pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Twice the signed area of a, b, c.
double area(Vec3 a, Vec3 b, Vec3 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A part's own coordinates → the view's, model units from the camera's target.
struct ToView {
  Vec3 x, y, z, origin;

  ToView(const Frame& frame, const Camera& camera) {
    const auto [right, up, back] = camera.axes();
    const auto turned = [&, r = right, u = up, b = back](Vec3 v) {
      return Vec3{dot(r, v), dot(u, v), dot(b, v)};
    };
    x = turned(frame.x);
    y = turned(frame.y);
    z = turned(frame.z());
    origin = turned(frame.origin - camera.target);
  }
  Vec3 operator()(Vec3 p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

}  // namespace

std::optional<Hit> surfaceAt(Vec2 pixel, const Evaluation& evaluation, const Camera& camera,
                             ViewSize size) {
  const Vec3 at{(pixel.x - size.width / 2) / camera.zoom, (size.height / 2 - pixel.y) / camera.zoom,
                0};
  std::optional<Hit> hit;
  double nearest = -kInfinity;
  std::vector<Vec3> view;
  for (size_t k = 0; k < evaluation.placed().size(); ++k) {
    const PlacedPart& placed = evaluation.placed()[k];
    const EvaluatedPart& evaluated = evaluation.parts()[placed.source];
    if (!evaluated.part || !evaluated.source->visible) continue;
    const ToView to_view(placed.frame, camera);
    view.clear();
    const Mesh& mesh = evaluated.shapeOf(placed)->mesh;
    for (const Vec3& position : mesh.positions) view.push_back(to_view(position));
    for (const auto& [i, j, l] : mesh.triangles) {
      const double whole = area(view[i], view[j], view[l]);
      if (whole <= 0) continue;  // faces away
      const double a = area(at, view[j], view[l]), b = area(view[i], at, view[l]);
      const double c = whole - a - b;
      if (a < 0 || b < 0 || c < 0) continue;
      const double z = (a * view[i].z + b * view[j].z + c * view[l].z) / whole;
      if (z <= nearest) continue;
      nearest = z;
      const Vec3 normal = cross(view[j] - view[i], view[l] - view[i]);
      hit = Hit{k, camera.fromView({at.x, at.y, z}), normal.z / length(normal)};
    }
  }
  return hit;
}

std::optional<size_t> boneAt(Vec2 pixel, const Evaluation& evaluation, const Camera& camera,
                             ViewSize size, double reach_px) {
  const Rig& rig = evaluation.rig();
  std::optional<size_t> found;
  double nearest = reach_px;
  for (const auto& [parent, child] : rig.bones) {
    const auto hidden = [&](uint32_t joint) {
      const PlacedPart& placed = evaluation.placed()[rig.joints[joint].part];
      const PartSource& source = *evaluation.parts()[placed.source].source;
      return !source.visible || source.locked;
    };
    if (hidden(child)) continue;
    const double away = distanceToSegment(camera.toScreen(rig.joints[parent].position, size),
                                          camera.toScreen(rig.joints[child].position, size), pixel);
    if (away >= nearest) continue;
    nearest = away;
    found = child;
  }
  return found;
}

std::vector<std::string> partsInBox(Vec2 a_px, Vec2 b_px, const Evaluation& evaluation,
                                    const Camera& camera, ViewSize size) {
  const Vec2 low{std::min(a_px.x, b_px.x), std::min(a_px.y, b_px.y)};
  const Vec2 high{std::max(a_px.x, b_px.x), std::max(a_px.y, b_px.y)};
  std::vector<std::string> ids;
  for (const PlacedPart& placed : evaluation.placed()) {
    const EvaluatedPart& evaluated = evaluation.parts()[placed.source];
    if (!evaluated.part || !evaluated.source->visible || evaluated.source->locked) continue;
    const auto& outline = evaluated.part->outline.dense;
    const bool inside = std::any_of(outline.begin(), outline.end(), [&](Vec2 p) {
      const Vec2 at = camera.toScreen(placed.frame.toWorld(p), size);
      return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
    });
    if (inside) ids.push_back(placed.id);
  }
  return ids;
}

Vec3 middleOf(const EvaluatedPart& part, const Frame& frame) {
  if (!part.part) return frame.origin;
  return frame.toWorld(boxOf(part.part->outline.dense).middle());
}

}  // namespace marrow
