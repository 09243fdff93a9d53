#include "part/silhouette.h"

#include <algorithm>

#include "sketch/outline.h"
#include "sketch/polygon.h"
#include "solid/solids.h"
#include "support/catch.h"

namespace marrow {
namespace {

std::vector<Vec2> outlineOf(const Mesh& mesh) {
  const auto outline = silhouetteOf(mesh);
  REQUIRE(outline);
  CHECK(isSimple(*outline));
  return *outline;
}

Mesh turned(Mesh mesh, Random& random) {
  const auto x = Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  const Vec3 unit = x / length(x);
  const Vec3 other = cross(unit, Vec3{0, 0, 1}), y = other / length(other), z = cross(unit, y);
  for (Vec3& p : mesh.positions) p = unit * p.x + y * p.y + z * p.z;
  return mesh;
}

}  // namespace

TEST_CASE("silhouette: a block's is its face, a ball's a disc, a ring's without its hole",
          "[silhouette]") {
  const auto block = outlineOf(boxMesh({10, 20, -5}, {110, 60, 5}));
  CHECK(signedArea(block) == Approx(4000).epsilon(0.005));
  CHECK(block.size() < 30);
  const Box2 box = boxOf(block);
  CHECK(length(box.low - Vec2{10, 20}) < 0.2);
  CHECK(length(box.high - Vec2{110, 60}) < 0.2);
  CHECK(signedArea(outlineOf(sphereMesh({3, 4, 5}, 2, 5))) == Approx(4 * kPi).epsilon(0.005));
  CHECK(signedArea(outlineOf(torusMesh({}, 10, 3, 80, 40))) == Approx(169 * kPi).epsilon(0.005));
}

TEST_CASE("silhouette: it holds every vertex, to within a few thousandths", "[silhouette]") {
  Random random(1);
  for (int run = 0; run < 20; ++run) {
    const Mesh mesh = turned(run % 2 ? torusMesh({}, 10, 3, 40, 20)
                                     : boxMesh({-3, -5, -7}, {5, random.between(-4, 9), 2}),
                             random);
    const auto outline = outlineOf(mesh);
    const double size = boxOf(outline).longerSide();
    for (const Vec3 p : mesh.positions) {
      const Vec2 flat{p.x, p.y};
      if (!contains(outline, flat) && distanceToBorder(outline, flat) > 0.004 * size) FAIL(run);
    }
    CHECK(makeOutline(outline));
  }
}

TEST_CASE("silhouette: of several pieces the largest counts; a line has none", "[silhouette]") {
  Mesh two = boxMesh({0, 0, 0}, {10, 10, 1});
  const Mesh small = boxMesh({50, 0, 0}, {55, 5, 100});
  for (const auto& [a, b, c] : small.triangles) two.triangles.push_back({a + 8, b + 8, c + 8});
  two.positions.insert(two.positions.end(), small.positions.begin(), small.positions.end());
  CHECK(signedArea(outlineOf(two)) == Approx(100).epsilon(0.05));

  Mesh line = boxMesh({0, 0, 0}, {10, 0, 1});
  CHECK(!silhouetteOf(line));
  CHECK(!silhouetteOf({}));
}

TEST_CASE("depth rays: they find the body, the nearer of two like ones, the thicker of others",
          "[silhouette]") {
  const Mesh ball = sphereMesh({0, 0, 10}, 5, 5);
  const DepthRays rays(ball);
  const auto middle = rays.at({0.01, 0.02});
  REQUIRE(middle);
  CHECK(middle->middle() == Approx(10).margin(0.01));
  CHECK(middle->half() == Approx(5).epsilon(0.01));
  const auto aside = rays.at({3.01, 0.02});
  REQUIRE(aside);
  CHECK(aside->half() == Approx(4).epsilon(0.02));
  CHECK(!rays.at({6, 0}));

  Mesh legs = boxMesh({0, 0, 0}, {10, 10, 4});
  const auto add = [&](Vec3 low, Vec3 high) {
    const auto first = static_cast<uint32_t>(legs.positions.size());
    const Mesh other = boxMesh(low, high);
    legs.positions.insert(legs.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c] : other.triangles) {
      legs.triangles.push_back({a + first, b + first, c + first});
    }
  };
  add({0, 0, 10}, {10, 10, 14});
  CHECK(DepthRays(legs).at({3, 4})->middle() == 12);
  CHECK(DepthRays(legs).at({5, 5})->middle() == 12);  // through the diagonals of all faces
  add({0, 0, -30}, {10, 10, -10});
  CHECK(DepthRays(legs).at({3, 4})->middle() == -20);
  add({0, 0, 3}, {10, 10, 11});  // two overlap with it: one body
  CHECK(DepthRays(legs).at({3, 4})->middle() == -20);
  add({0, 0, -12}, {10, 10, 1});
  CHECK(DepthRays(legs).at({3, 4})->low == -30);
  CHECK(DepthRays(legs).at({3, 4})->high == 14);
}

}  // namespace marrow
