#include "sketch/contour_edit.h"

#include <algorithm>
#include <cmath>

#include "sketch/outline.h"
#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/drawings.h"
#include "support/random.h"

namespace marrow {
namespace {

const std::vector<Vec2> kSquare{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

double areaOf(const std::vector<Vec2>& polygon) { return std::fabs(signedArea(polygon)); }

}  // namespace

TEST_CASE("contour edit: what is drawn over a side replaces that side and nothing else",
          "[contour_edit]") {
  // A roof over the upper side.
  const std::vector<Vec2> roof{{90, 100}, {50, 160}, {10, 100}};
  const auto result = redrawn(kSquare, roof, 5);
  REQUIRE(result);
  CHECK(areaOf(*result) == Approx(100 * 100 + 80 * 60 / 2));
  for (const Vec2 p : roof) CHECK(distanceToBorder(*result, p) < 1e-9);
  for (const Vec2 p : kSquare) CHECK(distanceToBorder(*result, p) < 1e-9);
}

TEST_CASE(
    "contour edit: the direction of the stroke and where the outline begins count for nothing",
    "[contour_edit]") {
  const std::vector<Vec2> dent{{20, 0}, {50, 40}, {80, 0}};
  const double area = 100 * 100 - 60 * 40 / 2;
  for (size_t first = 0; first < kSquare.size(); ++first) {
    std::vector<Vec2> outline = kSquare;
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(first),
                outline.end());
    for (const bool reversed : {false, true}) {
      std::vector<Vec2> stroke = dent;
      if (reversed) std::reverse(stroke.begin(), stroke.end());
      const auto result = redrawn(outline, stroke, 5);
      REQUIRE(result);
      CHECK(areaOf(*result) == Approx(area));
    }
  }
}

TEST_CASE("contour edit: a stroke along the longer way round replaces the longer stretch",
          "[contour_edit]") {
  // From the lower side clockwise round three corners.
  const std::vector<Vec2> around{{40, -10},  {-10, -10}, {-10, 110},
                                 {110, 110}, {110, -10}, {60, -10}};
  const auto result = redrawn(kSquare, around, 20);
  REQUIRE(result);
  CHECK(areaOf(*result) > 13000);
}

TEST_CASE("contour edit: a stroke far away, a point and nothing at all change nothing",
          "[contour_edit]") {
  CHECK_FALSE(redrawn(kSquare, {{300, 300}, {400, 400}}, 20));
  CHECK_FALSE(redrawn(kSquare, {{50, 100}}, 20));
  CHECK_FALSE(redrawn(kSquare, {}, 20));
  CHECK_FALSE(redrawn(kSquare, {{50, 100}, {50, 100}}, 20));
  CHECK_FALSE(redrawn({{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}, 20));
}

TEST_CASE("contour edit: a dragged point goes all the way, what is beyond the reach stays",
          "[contour_edit]") {
  const auto outline = makeOutline(softStar(5, 100))->dense;
  const Vec2 move{13, -7};
  for (size_t i = 0; i < outline.size(); i += 7) {
    const Vec2 grabbed = lerp(outline[i], outline[(i + 1) % outline.size()], 0.3);
    const auto result = dragged(outline, grabbed, move, 60);
    CHECK(distanceToBorder(result, grabbed + move) < 1e-9);
    size_t still = 0;
    for (const Vec2 p : outline) {
      if (distance(p, grabbed) <= 61) continue;
      CHECK(distanceToBorder(result, p) < 1e-9);
      ++still;
    }
    CHECK(still > 10);
  }
}

TEST_CASE("contour edit: a long straight side bends smoothly", "[contour_edit]") {
  const auto result = dragged(kSquare, {50, 0}, {0, -20}, 40);
  CHECK(result.size() > 15);
  CHECK(areaOf(result) > areaOf(kSquare) + 400);
  // No step: neighbours are moved by nearly the same.
  for (size_t i = 1; i < result.size(); ++i) {
    if (result[i].y > 0.01 || result[i - 1].y > 0.01) continue;
    CHECK(std::fabs(result[i].y - result[i - 1].y) < 5);
  }
}

TEST_CASE("contour edit: moving nothing, and there and back, gives the same shape",
          "[contour_edit]") {
  const auto outline = makeOutline(softStar(3, 80))->dense;
  const auto same = dragged(outline, outline[5], {0, 0}, 50);
  CHECK(areaOf(same) == Approx(areaOf(outline)));
  const auto there = dragged(outline, outline[5], {9, 4}, 50);
  CHECK(areaOf(there) != Approx(areaOf(outline)));
}

TEST_CASE("contour edit: any stroke over any outline can be made an outline again, or says why not",
          "[contour_edit]") {
  Random random(7);
  int redrawn_count = 0;
  for (int run = 0; run < 200; ++run) {
    const auto outline = makeOutline(softStar(2 + run % 5, 100))->dense;
    const auto stroke = randomPoints(random, 2 + run % 30);
    const auto result = redrawn(outline, stroke, 1e9);
    if (!result) continue;  // both ends are nearest to the same tip
    ++redrawn_count;
    const auto again = makeOutline(*result);
    if (!again) {
      CHECK(again.status() == Status::noArea);
      continue;
    }
    CHECK(isSimple(again->dense));
  }
  CHECK(redrawn_count > 150);
}

}  // namespace marrow
