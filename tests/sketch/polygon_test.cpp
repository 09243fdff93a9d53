#include "sketch/polygon.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "sketch/turn_sign.h"
#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::Stroke;

namespace {

__extension__ typedef __int128 Int128;

int exactTurn(Vec2 a, Vec2 b, Vec2 c) {
  const auto whole = [](double v) { return static_cast<Int128>(static_cast<int64_t>(v)); };
  const Int128 det = (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) -
                     (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
  return det > 0 ? 1 : (det < 0 ? -1 : 0);
}

bool segmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto onSegment = [](Vec2 p, Vec2 q, Vec2 r) {
    return exactTurn(p, q, r) == 0 && std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) &&
           std::min(p.y, q.y) <= r.y && r.y <= std::max(p.y, q.y);
  };
  if (exactTurn(a, b, c) * exactTurn(a, b, d) < 0 && exactTurn(c, d, a) * exactTurn(c, d, b) < 0) {
    return true;
  }
  return onSegment(a, b, c) || onSegment(a, b, d) || onSegment(c, d, a) || onSegment(c, d, b);
}

/// Every pair of edges, on whole coordinates.
bool isSimpleByBruteForce(const Stroke& p) {
  const size_t n = p.size();
  if (n < 3) return false;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
    if (a == b) return false;
    if (exactTurn(a, b, c) == 0 && dot(b - a, c - b) < 0) return false;
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segmentsMeet(a, b, p[j], p[(j + 1) % n])) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("turnSign: exact on whole numbers, however nearly on a line", "[polygon]") {
  Random random(1);
  int on_line = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1, 2 + random.below(49));
    const auto whole = [&] { return std::floor(random.between(-size, size)); };
    const Vec2 a{whole(), whole()}, b{whole(), whole()};
    Vec2 c{whole(), whole()};
    if (i % 2) {
      // On the line through a and b but for rounding.
      c = lerp(a, b, random.between(-1, 2));
      c = {std::floor(c.x), std::floor(c.y)};
    }
    const int sign = turnSign(a, b, c);
    on_line += sign == 0;
    REQUIRE(sign == exactTurn(a, b, c));
    REQUIRE(turnSign(b, c, a) == sign);
    REQUIRE(turnSign(b, a, c) == -sign);
  }
  REQUIRE(on_line > 100);
}

TEST_CASE("turnSign: sees one unit in the last place", "[polygon]") {
  const Vec2 a{0.5, 0.5}, b{12, 12};
  const double up = std::nextafter(24.0, 25.0), down = std::nextafter(24.0, 23.0);
  REQUIRE(turnSign(a, b, {24, 24}) == 0);
  REQUIRE(turnSign(a, b, {24, up}) == 1);
  REQUIRE(turnSign(a, b, {24, down}) == -1);
  REQUIRE(turnSign(a, b, {up, 24}) == -1);
}

TEST_CASE("polygon: area, perimeter and centroid of a rectangle far from the origin", "[polygon]") {
  const Stroke far = strokes::translated(strokes::rectangle(3, 2), {1e9, -2e9});
  REQUIRE(signedArea(far) == Approx(6));
  REQUIRE(signedArea(strokes::reversed(far)) == Approx(-6));
  REQUIRE(perimeter(far) == Approx(10));
  REQUIRE(distance(areaCentroid(far), {1e9, -2e9}) < 1e-5);
}

TEST_CASE("isSimple: agrees with every pair of edges on random lattice polygons", "[polygon]") {
  Random random(2);
  int simple = 0;
  for (int i = 0; i < 20000; ++i) {
    const Stroke polygon = strokes::latticeWalk(random, 3 + random.below(6), 2 + random.below(9));
    const bool expected = isSimpleByBruteForce(polygon);
    simple += expected;
    REQUIRE(isSimple(polygon) == expected);
    const std::vector<char> faulty = faultyEdges(polygon);
    REQUIRE((std::count(faulty.begin(), faulty.end(), 1) == 0) == expected);
  }
  REQUIRE(simple > 1000);
}

TEST_CASE("isSimple: turning, mirroring, scaling and reversing change nothing", "[polygon]") {
  for (const auto& shape : strokes::plainShapes()) {
    CAPTURE(shape.name);
    for (const Stroke& variant :
         {shape.points, strokes::reversed(shape.points), strokes::mirrored(shape.points),
          strokes::rotated(shape.points, 1), strokes::scaled(shape.points, 1e4),
          strokes::scaled(shape.points, 1e-4), strokes::startedAt(shape.points, 3)}) {
      REQUIRE(isSimple(variant));
    }
  }
  REQUIRE_FALSE(isSimple(strokes::figureEight(1e-6, 200)));
  REQUIRE_FALSE(isSimple(strokes::scaled(strokes::figureEight(100, 200), 1e9)));
}

TEST_CASE("isSimple: a vertex that touches an edge counts, the least gap does not", "[polygon]") {
  //  a spike from above reaches down to the base's level
  const auto notched = [](double tip) {
    return Stroke{{0, 0}, {10, 0}, {10, 10}, {5, tip}, {0, 10}};
  };
  REQUIRE(isSimple(notched(1e-300)));
  REQUIRE_FALSE(isSimple(notched(0)));
  REQUIRE_FALSE(isSimple(notched(-1e-300)));
}

TEST_CASE("isSimple: repeats and turning back are faults", "[polygon]") {
  REQUIRE_FALSE(isSimple({}));
  REQUIRE_FALSE(isSimple({{0, 0}, {1, 0}}));
  REQUIRE_FALSE(isSimple({{0, 0}, {1, 0}, {2, 0}}));
  REQUIRE_FALSE(isSimple({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
  REQUIRE_FALSE(isSimple({{0, 0}, {4, 0}, {2, 0}, {2, 2}}));
  REQUIRE(isSimple({{0, 0}, {1, 0}, {2, 0}, {2, 2}}));
}

TEST_CASE("contains: points beside the border are on their side of it", "[polygon]") {
  for (const auto& shape : strokes::plainShapes()) {
    CAPTURE(shape.name);
    Stroke polygon = shape.points;
    if (signedArea(polygon) < 0) polygon = strokes::reversed(polygon);
    const size_t n = polygon.size();
    for (size_t i = 0; i < n; ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % n];
      const Vec2 beside = perpendicular(b - a) * 1e-6;
      REQUIRE(contains(polygon, lerp(a, b, 0.5) + beside));
      REQUIRE_FALSE(contains(polygon, lerp(a, b, 0.5) - beside));
      REQUIRE(distanceToBorder(polygon, lerp(a, b, 0.5) + beside) <= length(beside) * 1.001);
    }
  }
}

TEST_CASE("distanceToSegment: to the nearer end where the foot falls outside", "[polygon]") {
  REQUIRE(distanceToSegment({0, 0}, {4, 0}, {2, 3}) == Approx(3));
  REQUIRE(distanceToSegment({0, 0}, {4, 0}, {7, 4}) == Approx(5));
  REQUIRE(distanceToSegment({1, 1}, {1, 1}, {4, 5}) == Approx(5));
}
