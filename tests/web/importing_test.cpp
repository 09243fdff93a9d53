#include "importing.h"

#include "base/box.h"
#include "solid/solids.h"
#include "support/catch.h"

namespace marrow {
namespace {

Vec3 sizeOf(const Mesh& mesh) { return boxOf(mesh.positions).size(); }

}  // namespace

TEST_CASE("importing: a model is half as large as the view, whichever of its sides is the longest",
          "[importing]") {
  const ViewSize view{800, 600};
  const std::pair<Vec3, Vec3> cases[] = {{{1, 0.1, 0.1}, {400, 40, 40}},
                                         {{0.1, 1, 0.1}, {30, 300, 30}},
                                         {{0.001, 0.001, 1}, {0.4, 0.4, 400}},
                                         {{1, 1, 1}, {300, 300, 300}}};
  for (const auto& [size, expected] : cases) {
    Camera camera;
    camera.zoom = 2;
    const Mesh box = boxMesh(size * -0.5, size * 0.5);
    const ImportPart command = asSeen(box, camera, view, {7, 8, 9});
    const Vec3 seen = sizeOf(*command.mesh) * camera.zoom;
    CHECK(length(seen - expected) < 1e-9);
    CHECK(command.frame.origin == Vec3{0, 0, 9});
  }
}

TEST_CASE("importing: it lies in the plane of the view, as it is seen there", "[importing]") {
  Camera camera;
  camera.yaw_rad = 0.7;
  camera.pitch_rad = -0.3;
  const Mesh box = boxMesh({-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3});
  const ImportPart command = asSeen(box, camera, {500, 500}, {});
  const Vec3 first = command.frame.toWorld(command.mesh->positions[0]),
             second = command.frame.toWorld(command.mesh->positions[1]);
  CHECK(length(cross(second - first, Vec3{1, 0, 0})) < 1e-9);
  CHECK(inspect(*command.mesh).volume > 0);
}

}  // namespace marrow
