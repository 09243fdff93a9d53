#include "sketch/steady.h"

#include <algorithm>
#include <cmath>

#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::Stroke;

namespace {

double farthest(const Stroke& from, const Stroke& to) {
  double most = 0;
  for (const Vec2 p : from) most = std::max(most, distanceToBorder(to, p));
  return most;
}

}  // namespace

TEST_CASE("steady: samples lie at even distances, near the curve, wherever that starts",
          "[steady]") {
  Random random(5);
  for (int run = 0; run < 30; ++run) {
    const Stroke blob = strokes::blob(random, 300);
    const double step = perimeter(blob) / 200;
    const Stroke samples = steadyCurve(ArcCurve(blob), step);
    CAPTURE(run);
    for (size_t i = 0; i < samples.size(); ++i) {
      const double here = distance(samples[i], samples[(i + 1) % samples.size()]);
      REQUIRE(here < 0.34 * step);
      REQUIRE(here > 0.15 * step);
    }
    REQUIRE(farthest(samples, blob) < step);
    const Stroke again = steadyCurve(ArcCurve(strokes::startedAt(blob, 71)), step);
    REQUIRE(farthest(samples, again) < 1e-6 * step);
  }
}

TEST_CASE("steady: of a trembling line less than half of the tremor is left", "[steady]") {
  Random random(6);
  const Stroke even = strokes::disc(200, 600);
  const double step = perimeter(even) / 200;
  const auto roughness = [](const Stroke& polygon) {
    double sum = 0;
    for (const Vec2 p : polygon) sum += (length(p) - 200) * (length(p) - 200);
    return std::sqrt(sum / static_cast<double>(polygon.size()));
  };
  for (int run = 0; run < 10; ++run) {
    const Stroke rough = strokes::jittered(random, even, 1.5);
    REQUIRE(roughness(steadyCurve(ArcCurve(rough), step)) < roughness(rough) / 2);
  }
}

TEST_CASE("steady: no corner inward turns by more than 60° once it is bevelled", "[steady]") {
  Random random(7);
  for (int run = 0; run < 100; ++run) {
    const int arms = 3 + random.below(9);
    const Stroke star = strokes::rotated(
        strokes::star(arms, random.between(5, 60), random.between(80, 200)), random.between(0, 6));
    const Stroke cut = bevelled(star, 2);
    CAPTURE(run);
    REQUIRE(cut.size() >= star.size());
    REQUIRE(isSimple(cut));
    REQUIRE(farthest(cut, star) < 0.05);
    for (size_t i = 0; i < cut.size(); ++i) {
      const Vec2 in = cut[i] - cut[(i + cut.size() - 1) % cut.size()],
                 out = cut[(i + 1) % cut.size()] - cut[i];
      if (cross(in, out) < 0) REQUIRE(dot(in, out) > 0.49 * length(in) * length(out));
    }
  }
}
