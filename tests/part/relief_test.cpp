#include "part/relief.h"

#include <cmath>

#include "part/part.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/drawings.h"

namespace marrow {
namespace {

std::vector<Vec2> disc(double radius, Vec2 center = {}) {
  std::vector<Vec2> stroke;
  for (const Vec2 p : unitCircle(80)) stroke.push_back(center + p * radius);
  return stroke;
}

}  // namespace

TEST_CASE("relief: a disc is as high as the sphere it becomes", "[relief]") {
  const auto part = buildPart(disc(100));
  REQUIRE(part);
  CHECK(part->relief.highest() == Approx(100).epsilon(0.03));
  for (const double x : {-80.0, -45.0, -3.0, 20.0, 66.0}) {
    for (const double y : {-50.0, 1.0, 37.0}) {
      const double square = 100 * 100 - x * x - y * y;
      if (square < 2500) continue;  // steep at the rim
      CHECK(part->relief.heightAt({x, y}) == Approx(std::sqrt(square)).margin(6));
    }
  }
}

TEST_CASE("relief: there is no height outside the outline, nor far away", "[relief]") {
  const auto part = buildPart(softStar(5, 100));
  REQUIRE(part);
  const Relief& relief = part->relief;
  for (int i = 0; i < 400; ++i) {
    const double angle = 0.0157 * i;
    const Vec2 p = Vec2{std::cos(angle), std::sin(angle)} * 160;
    CHECK(relief.heightAt(p) == 0);
  }
  CHECK(relief.heightAt({1e30, 0}) == 0);
  CHECK(relief.heightAt({0, -1e300}) == 0);
  CHECK(Relief().heightAt({0, 0}) == 0);
}

TEST_CASE("relief: every vertex of the mesh is about as high as the relief there", "[relief]") {
  const auto part = buildPart(softStar(3, 120));
  REQUIRE(part);
  int far = 0, inner = 0;
  for (size_t i = 0; i < part->mesh.positions.size(); ++i) {
    if (part->depths[i] < 0.3 * part->relief.highest()) continue;
    const Vec3 p = part->mesh.positions[i];
    ++inner;
    far += std::fabs(part->relief.heightAt({p.x, p.y}) - p.z) > 0.15 * part->relief.highest();
  }
  REQUIRE(inner > 100);
  CHECK(far < inner / 50);
}

TEST_CASE("relief: thickness scales the body and leaves the relief alone", "[relief]") {
  const auto part = buildPart(softStar(4, 90));
  REQUIRE(part);
  const Part thick = withThickness(*part, 2.5);
  CHECK(thick.relief.highest() == part->relief.highest());
  CHECK(thick.relief.heightAt({5, 7}) == part->relief.heightAt({5, 7}));
}

}  // namespace marrow
