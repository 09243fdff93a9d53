#include "sketch/arc_curve.h"

#include <cmath>

#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::Stroke;

TEST_CASE("arc curve: means a hair before and behind a whole turn are those at the start",
          "[arc_curve]") {
  for (const int samples : {7, 50, 333}) {
    const ArcCurve curve(strokes::translated(strokes::disc(100, samples), {300, 70}));
    const double whole = curve.length(), reach = whole / 50;
    for (int turns = -3; turns <= 3; ++turns) {
      const double at = turns * whole;
      // What is averaged begins or ends next to the seam.
      for (const double hair : {0.0, 1e-300, 1e-18 * whole, 1e-15 * whole}) {
        CAPTURE(samples, turns, hair);
        const double here = at - hair;
        REQUIRE(distance(curve.mean(here, here + reach), curve.mean(0, reach)) < 1e-6 * whole);
        REQUIRE(distance(curve.mean(here - reach, here), curve.mean(-reach, 0)) < 1e-6 * whole);
      }
    }
  }
}

TEST_CASE("arc curve: means are those of many places", "[arc_curve]") {
  Random random(3);
  for (int run = 0; run < 50; ++run) {
    const ArcCurve curve(strokes::blob(random, 20 + random.below(200)));
    const double from = random.between(-3, 3) * curve.length();
    const double wide = random.between(0.01, 0.9) * curve.length();
    Vec2 sum;
    constexpr int kPlaces = 4000;
    for (int i = 0; i < kPlaces; ++i) sum = sum + curve.at(from + wide * (i + 0.5) / kPlaces);
    CAPTURE(run);
    REQUIRE(distance(curve.mean(from, from + wide), sum / kPlaces) < 1e-4 * curve.length());
  }
}
