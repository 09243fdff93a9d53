#include "sketch/mirror_line.h"

#include <algorithm>
#include <cmath>

#include "sketch/arc_curve.h"
#include "sketch/polygon.h"
#include "sketch/steady.h"
#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::Stroke;

namespace {

Stroke samplesOf(const Stroke& shape) {
  return steadyCurve(ArcCurve(shape), perimeter(shape) / 200);
}

/// A blob and its image across x = 0, one outline: of its right half what lies right of the line.
Stroke symmetricBlob(Random& random) {
  std::vector<double> radii;
  const int n = 60;
  double swing[4];
  for (double& one : swing) one = random.between(-0.25, 0.25);
  for (int i = 0; i <= n; ++i) {
    double radius = 100;
    for (int k = 0; k < 4; ++k)
      radius += 100 * swing[k] * std::cos((k + 1) * strokes::kTau * i / (2 * n));
    radii.push_back(radius);
  }
  Stroke blob;
  for (int i = 0; i < 2 * n; ++i) {
    const double radius = radii[static_cast<size_t>(i <= n ? i : 2 * n - i)];
    const double angle = strokes::kTau * i / (2 * n);
    blob.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return blob;
}

}  // namespace

TEST_CASE("mirror line: of a symmetric shape it is found, however that is turned and moved",
          "[mirror_line]") {
  Random random(1);
  for (int run = 0; run < 100; ++run) {
    const double turn = random.between(0, strokes::kTau);
    const Vec2 by{random.between(-500, 500), random.between(-500, 500)};
    const Stroke shape = strokes::translated(strokes::rotated(symmetricBlob(random), turn), by);
    const auto fit = findMirrorLine(samplesOf(shape));
    CAPTURE(run);
    REQUIRE(fit);
    CHECK(fit->overlap > 0.98);
    for (const Vec2 p : shape) CHECK(distanceToBorder(shape, fit->line.mirrored(p)) < 2);
  }
}

TEST_CASE("mirror line: a trembling hand hardly moves it", "[mirror_line]") {
  Random random(2);
  for (int run = 0; run < 50; ++run) {
    Stroke shape = symmetricBlob(random);
    for (Vec2& p : shape) p.x *= 0.6;  // one axis alone
    const auto still = findMirrorLine(samplesOf(shape));
    const auto shaken = findMirrorLine(samplesOf(strokes::jittered(random, shape, 2)));
    CAPTURE(run);
    REQUIRE(still);
    REQUIRE(shaken);
    CHECK(shaken->overlap > 0.9);
  }
}

TEST_CASE("mirror line: what has no like side has less in common with its image", "[mirror_line]") {
  // A capital L with arms of one to three, and a snail's spiral.
  const Stroke hook{{0, 0}, {300, 0}, {300, 60}, {60, 60}, {60, 100}, {0, 100}};
  for (const Stroke& shape : {hook, strokes::spiral(2, 60, 15)}) {
    const auto fit = findMirrorLine(samplesOf(shape));
    CHECK((!fit || fit->overlap < 0.8));
  }
}

TEST_CASE("mirror line: the whole is its own mirror image to the last bit of a reflection",
          "[mirror_line]") {
  Random random(4);
  for (int run = 0; run < 50; ++run) {
    const Stroke shape = strokes::rotated(strokes::jittered(random, symmetricBlob(random), 2),
                                          random.between(0, strokes::kTau));
    const auto fit = findMirrorLine(samplesOf(shape));
    CAPTURE(run);
    REQUIRE(fit);
    const Stroke whole = mirroredWhole(*fit);
    REQUIRE(whole.size() % 2 == 0);
    CHECK(std::fabs(fit->line.side(whole[0])) < 1e-9);
    CHECK(std::fabs(fit->line.side(whole[whole.size() / 2])) < 1e-9);
    for (size_t i = 1; i < whole.size() / 2; ++i) {
      CHECK(whole[whole.size() - i] == fit->line.mirrored(whole[i]));
    }
  }
}
