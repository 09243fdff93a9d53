#include "part/proxy.h"

#include <cmath>

#include "support/catch.h"
#include "surface/inflate.h"

namespace marrow {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr uint32_t kAround = 48;

/// A closed tube of radius `radius` about the segment a b in the plane z = 0, ends flat.
void addTube(Mesh& mesh, Vec2 a, Vec2 b, double radius, int rings = 20) {
  const uint32_t first = static_cast<uint32_t>(mesh.positions.size());
  const Vec2 side = perpendicular(b - a) / distance(a, b);
  for (int r = 0; r <= rings; ++r) {
    const Vec2 middle = lerp(a, b, static_cast<double>(r) / rings);
    for (uint32_t k = 0; k < kAround; ++k) {
      const double angle = 2 * kPi * k / kAround;
      const Vec2 p = middle + side * (radius * std::cos(angle));
      mesh.positions.push_back({p.x, p.y, radius * std::sin(angle)});
    }
  }
  const auto add = [&](uint32_t i, uint32_t j, uint32_t k) {
    mesh.triangles.push_back({first + i, first + j, first + k});
  };
  for (int r = 0; r < rings; ++r) {
    for (uint32_t k = 0; k < kAround; ++k) {
      const uint32_t low = r * kAround + k, next = r * kAround + (k + 1) % kAround;
      add(low, next, low + kAround);
      add(next, next + kAround, low + kAround);
    }
  }
  for (uint32_t k = 1; k + 1 < kAround; ++k) {
    add(0, k + 1, k);
    add(rings * kAround, rings * kAround + k, rings * kAround + k + 1);
  }
}

PartSkeleton chain(const std::vector<Vec2>& points, double radius) {
  PartSkeleton skeleton;
  for (const Vec2 p : points) skeleton.joints.push_back({JointKind::sleeve, p, radius});
  for (uint32_t i = 0; i + 1 < points.size(); ++i) skeleton.bones.push_back({i, i + 1});
  return skeleton;
}

std::vector<Vec2> stripOutline(double half_length, double half_width) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 60; ++i) outline.push_back({(i / 30.0 - 1) * half_length, -half_width});
  for (int i = 0; i < 12; ++i) {
    const double angle = kPi * (i / 12.0 - 0.5);
    outline.push_back({half_length + half_width * std::cos(angle), half_width * std::sin(angle)});
  }
  for (int i = 0; i < 60; ++i) outline.push_back({(1 - i / 30.0) * half_length, half_width});
  for (int i = 0; i < 12; ++i) {
    const double angle = kPi * (i / 12.0 + 0.5);
    outline.push_back({-half_length + half_width * std::cos(angle), half_width * std::sin(angle)});
  }
  return outline;
}

}  // namespace

TEST_CASE("proxy: a tube's joints have the tube's radius", "[proxy]") {
  for (const double angle : {0.0, 0.3, kPi / 2, 2.0}) {
    for (const double scale : {1e-4, 1.0, 1e4}) {
      const Vec2 along = Vec2{std::cos(angle), std::sin(angle)} * scale;
      Mesh mesh;
      addTube(mesh, along * -100, along * 100, 15 * scale);
      REQUIRE(inspect(mesh).closed);
      REQUIRE(inspect(mesh).volume > 0);
      const auto radii = proxyRadii(
          chain({along * -80.0, along * -20.0, along * 33.0, along * 80.0}, scale * 15), mesh);
      REQUIRE(radii.size() == 4);
      for (const double radius : radii) CHECK(radius == Approx(15 * scale).epsilon(0.005));
    }
  }
}

TEST_CASE("proxy: a strip of half width w inflates to balls of radius w", "[proxy]") {
  const double w = 20;
  const auto flat = triangulate(stripOutline(200, w));
  REQUIRE(flat);
  const auto mesh = inflate(*flat, w);
  REQUIRE(mesh);
  const auto radii = proxyRadii(chain({{-120, 0}, {-40, 0}, {50, 0}, {120, 0}}, w), *mesh);
  for (const double radius : radii) CHECK(radius == Approx(w).epsilon(0.02));
}

TEST_CASE("proxy: only the loop around the joint counts", "[proxy]") {
  Mesh mesh;
  addTube(mesh, {-100, 0}, {100, 0}, 10);
  addTube(mesh, {-100, 50}, {100, 50}, 30);
  const auto radii = proxyRadii(chain({{-50, 0}, {50, 0}}, 10), mesh);
  CHECK(radii[0] == Approx(10).epsilon(0.01));
  CHECK(radii[1] == Approx(10).epsilon(0.01));
}

TEST_CASE("proxy: where a cut misses the mesh, the given radius stays", "[proxy]") {
  Mesh mesh;
  addTube(mesh, {-100, 0}, {100, 0}, 10);
  const auto outside = proxyRadii(chain({{0, 0}, {0, 40}, {300, 40}}, 7), mesh);
  CHECK(outside[0] != 7);
  CHECK(outside[1] == 7);
  CHECK(outside[2] == 7);
  CHECK(proxyRadii(chain({{0, 0}, {1, 0}}, 7), Mesh{}) == std::vector<double>{7, 7});
  CHECK(proxyRadii(PartSkeleton{}, mesh).empty());
  // A bone without length has no plane.
  CHECK(proxyRadii(chain({{0, 0}, {0, 0}}, 7), mesh) == std::vector<double>{7, 7});
}

TEST_CASE("proxy: several bones give their mean", "[proxy]") {
  Mesh mesh;
  addTube(mesh, {-100, 0}, {100, 0}, 10, 100);
  // Along the tube the cut is the circle; a slanted bone's cut is an ellipse.
  const auto straight = proxyRadii(chain({{-50, 0}, {0, 0}}, 10), mesh);
  const auto slanted = proxyRadii(chain({{0, 0}, {5, 5}}, 10), mesh);
  const auto both = proxyRadii(chain({{-50, 0}, {0, 0}, {5, 5}}, 10), mesh);
  CHECK(slanted[0] > 1.05 * straight[1]);
  CHECK(both[1] == Approx((straight[1] + slanted[0]) / 2));
}

TEST_CASE("proxy: a junction's ball does not swell along its other limbs", "[proxy]") {
  // The bar of a T, with a stem's bone at a right angle: its cut runs along the whole bar.
  Mesh mesh;
  addTube(mesh, {-200, 0}, {200, 0}, 10, 100);
  const auto radii = proxyRadii(chain({{0, -9}, {0, 0}}, 10), mesh);
  CHECK(radii[1] < 1.35 * 10);
}

}  // namespace marrow
