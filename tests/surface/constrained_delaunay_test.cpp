#include "surface/constrained_delaunay.h"

#include "support/catch.h"
#include "support/meshes.h"
#include "surface/in_circle.h"

using namespace marrow;

TEST_CASE("constrained Delaunay: points outside, or inserted from afar, are dealt with",
          "[constrained_delaunay]") {
  ConstrainedDelaunay mesh;
  REQUIRE(mesh.start({{0, 0}, {10, 0}, {10, 10}, {9, 10}, {9, 1}, {1, 1}, {1, 10}, {0, 10}}, 20));
  CHECK(mesh.insert({5, 5}, 0) == ConstrainedDelaunay::kNone);
  CHECK(mesh.insert({50, 5}, 0) == ConstrainedDelaunay::kNone);
  for (uint32_t hint = 0; hint < 6; ++hint) {
    CHECK(mesh.insert({0.5, 9 - hint * 0.5}, hint) != ConstrainedDelaunay::kNone);
    CHECK(mesh.insert({9.5, 9 - hint * 0.5}, hint) != ConstrainedDelaunay::kNone);
  }
  CHECK(mesh.triangles().size() == 2 * mesh.points().size() - 8 - 2);
}

TEST_CASE("constrained Delaunay: borders that cannot be triangulated are refused",
          "[constrained_delaunay]") {
  ConstrainedDelaunay mesh;
  CHECK_FALSE(mesh.start({{0, 0}, {1, 0}}, 10));
  CHECK_FALSE(mesh.start({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 10));
  CHECK_FALSE(mesh.start({{0, 0}, {0, 1}, {1, 0}}, 10));
}

TEST_CASE("constrained Delaunay: points on a slanted line but for rounding make no flat triangles",
          "[constrained_delaunay]") {
  // Two edges on one line, cut into many pieces whose ends are rounded to either side of it.
  const std::vector<Vec2> corners = {{-1.25, -33.75}, {-5.0 / 13, -135.0 / 13},  {8, -8},
                                     {0, 0},          {-0.26779, -0.26779 * 27}, {-6, -20}};
  std::vector<Vec2> border;
  for (size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < 20; ++k) {
      border.push_back(lerp(corners[i], corners[(i + 1) % corners.size()], k / 20.0));
    }
  }
  ConstrainedDelaunay mesh;
  REQUIRE(mesh.start(border, border.size()));
  int flat = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    flat += cross(border[b] - border[a], border[c] - border[a]) < 1e-9 ? 1 : 0;
  }
  CHECK(flat == 0);
}

TEST_CASE("in circle: sure of what is inside, never of what is on the circle or outside",
          "[constrained_delaunay]") {
  const Vec2 a = {1, 0}, b = {0, 1}, c = {-1, 0};
  CHECK(surelyInCircle(a, b, c, {0, 0}));
  CHECK(surelyInCircle(a, b, c, {0, -0.999999999}));
  CHECK(surelyInCircle(a, b, c, {0, -1 + 0x1p-52}));
  CHECK_FALSE(surelyInCircle(a, b, c, {0, -1}));
  CHECK_FALSE(surelyInCircle(a, b, c, {0, -1 - 0x1p-52}));
  CHECK_FALSE(surelyInCircle(a, b, c, {5, 5}));
  // Whole numbers: exactly on a circle of radius 5.
  CHECK_FALSE(surelyInCircle({5, 0}, {3, 4}, {-4, 3}, {-3, -4}));
}

TEST_CASE("in circle: of four points all but on a circle, at most one diagonal is preferred",
          "[constrained_delaunay]") {
  Random random(41);
  int preferred = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec2 centre = {random.between(-1, 1), random.between(-1, 1)};
    const auto point = [&](double quarter) {
      const double angle = kPi / 2 * (quarter + random.unit());
      return centre + Vec2{std::cos(angle), std::sin(angle)};
    };
    const Vec2 a = point(0), b = point(1), c = point(2), d = point(3);
    const bool one = surelyInCircle(a, b, c, d), other = surelyInCircle(b, c, d, a);
    CHECK_FALSE((one && other));
    preferred += one || other ? 1 : 0;
  }
  CHECK(preferred > 9000);
}
