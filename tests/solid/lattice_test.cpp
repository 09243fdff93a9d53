// Exact answers about lattice points.
#include "solid/lattice.h"

#include "support/catch.h"
#include "support/random.h"

using namespace marrow;

namespace {

Vec3 randomPoint(Random& random, double reach) {
  const auto whole = [&] { return std::floor(random.between(-reach, reach)); };
  return {whole(), whole(), whole()};
}

}  // namespace

TEST_CASE("lattice: a step of one unit off a plane is seen, at full reach") {
  Random random(31);
  for (int i = 0; i < 3000; ++i) {
    const double reach = i % 2 ? 1000 : kLatticeReach / 8;
    const Vec3 a = randomPoint(random, reach), b = randomPoint(random, reach),
               c = randomPoint(random, reach);
    const Vec3 on = a + (b - a) * random.below(4) - (c - a) * random.below(4);
    const Facet facet(a, b, c);
    CHECK(facet.side(on) == 0);
    CHECK(orientation(a, b, c, on) == 0);
    const double up = facet.normal().z;
    if (up == 0) continue;
    CHECK(facet.side(on + Vec3{0, 0, 1}) == (up > 0 ? 1 : -1));
    CHECK(orientation(a, b, c, on - Vec3{0, 0, 1}) == (up > 0 ? -1 : 1));
    CHECK(orientation(b, a, c, on - Vec3{0, 0, 1}) == (up > 0 ? 1 : -1));
  }
}

TEST_CASE("lattice: the turn of three points is exact") {
  Random random(32);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 a = randomPoint(random, kLatticeReach / 8),
               b = randomPoint(random, kLatticeReach / 8);
    const Vec3 on = a + (b - a) * (random.below(7) - 3);
    CHECK(turn(a, b, on) == 0);
    if (b.x == a.x) continue;
    CHECK(turn(a, b, on + Vec3{0, 1, 5}) == (b.x > a.x ? 1 : -1));
  }
}

TEST_CASE("lattice: of two facets across a way, the nearer is met first") {
  Random random(33);
  for (int i = 0; i < 2000; ++i) {
    // Triangles in planes x = near and x = far, sheared so that no coordinate is simple.
    const double far_end = std::floor(kLatticeReach / 4);
    const double near = std::floor(random.between(1, far_end - 2));
    const double shear = random.below(3);
    const auto facet = [&](double x) {
      return Facet(Vec3{x, shear * x, 0}, Vec3{x, shear * x + 7, 3}, Vec3{x, shear * x - 5, 11});
    };
    const Vec3 from = {0, random.between(0, 9) < 5 ? 0.0 : 4.0, 1}, to = {far_end, 17, 23};
    const Facet first = facet(near), second = facet(near + 1);
    CHECK(firstMet(from, to, first, second) == -1);
    CHECK(firstMet(from, to, second, first) == 1);
    CHECK(firstMet(to, from, first, second) == 1);
    CHECK(firstMet(from, to, first, first) == 0);
    // Where the way meets `first`, one unit before `second`.
    const int before = second.side(from);
    CHECK(sideOfPiercing(from, to, first, second) == before);
    CHECK(sideOfPiercing(from, to, second, first) == -first.side(from));
    CHECK(sideOfPiercing(to, from, first, second) == before);
    CHECK(sideOfPiercing(from, to, first, first) == 0);
  }
}
