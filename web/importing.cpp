#include "importing.h"

#include <algorithm>

#include "base/box.h"

namespace marrow {

ImportPart asSeen(const Mesh& mesh, const Camera& camera, ViewSize size, Vec3 pivot) {
  constexpr double kShare = 0.5;
  const auto [right, up, back] = camera.axes();
  Mesh seen = mesh;
  Box3 box;
  for (Vec3& p : seen.positions) {
    p = {dot(right, p), dot(up, p), dot(back, p)};
    box.include(p);
  }
  const Vec3 extent = box.size();
  const double most =
      std::max({extent.x / size.width, extent.y / size.height, extent.z / size.width});
  const double scale = kShare / camera.zoom / most;
  for (Vec3& p : seen.positions) p = (p - box.middle()) * scale;
  ImportPart command;
  command.mesh = std::make_shared<const Mesh>(std::move(seen));
  command.frame = {camera.target + back * dot(back, pivot - camera.target), right, up};
  return command;
}

}  // namespace marrow
