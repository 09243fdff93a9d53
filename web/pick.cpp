#include "pick.h"

#include <limits>

namespace marrow {
namespace {

// Twice the signed area of a, b, c.
double area(Vec3 a, Vec3 b, Vec3 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::string partAt(Vec2 pixel, const std::vector<EvaluatedPart>& parts, const Camera& camera,
                   ViewSize size) {
  const auto [right, up, back] = camera.axes();
  const Vec3 at{(pixel.x - size.width / 2) / camera.zoom, (size.height / 2 - pixel.y) / camera.zoom,
                0};
  std::string found;
  double nearest = -std::numeric_limits<double>::infinity();
  std::vector<Vec3> view;
  for (const EvaluatedPart& evaluated : parts) {
    if (!evaluated.part) continue;
    view.clear();
    for (const Vec3& position : evaluated.part->mesh.positions) {
      const Vec3 p = position - camera.target;
      view.push_back({dot(right, p), dot(up, p), dot(back, p)});
    }
    for (const auto& [i, j, k] : evaluated.part->mesh.triangles) {
      const double whole = area(view[i], view[j], view[k]);
      if (whole <= 0) continue;  // faces away
      const double a = area(at, view[j], view[k]), b = area(view[i], at, view[k]);
      const double c = whole - a - b;
      if (a < 0 || b < 0 || c < 0) continue;
      const double z = (a * view[i].z + b * view[j].z + c * view[k].z) / whole;
      if (z > nearest) {
        nearest = z;
        found = evaluated.source->id;
      }
    }
  }
  return found;
}

}  // namespace marrow
