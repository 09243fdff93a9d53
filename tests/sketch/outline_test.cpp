#include "sketch/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/strokes.h"

using namespace marrow;
using strokes::NamedStroke;
using strokes::Stroke;

namespace {

double sizeOf(const Stroke& points) {
  double size = 0;
  for (const Vec2& p : points) size = std::max(size, distance(p, points[0]));
  return size;
}

void requireGood(const Stroke& polygon) {
  REQUIRE(polygon.size() >= 3);
  REQUIRE(isSimple(polygon));
  REQUIRE(signedArea(polygon) > 0);
  const double size = sizeOf(polygon);
  const size_t n = polygon.size();
  for (size_t i = 0; i < n; ++i) {
    const double off =
        distanceToSegment(polygon[(i + n - 1) % n], polygon[(i + 1) % n], polygon[i]);
    REQUIRE(off > 1e-10 * size);
  }
}

void requireGood(const Outline& outline) {
  requireGood(outline.dense);
  requireGood(outline.polygon);
  REQUIRE(outline.perimeter == perimeter(outline.dense));
  // The polygon approximates the dense outline, or lies between that and its mirror image.
  if (outline.mirror) return;
  for (const Vec2& p : outline.dense) {
    REQUIRE(distanceToBorder(outline.polygon, p) <= 0.02 * outline.perimeter);
  }
}

Outline outlineOf(const Stroke& stroke) {
  auto outline = makeOutline(stroke);
  REQUIRE(outline);
  return *outline;
}

double hausdorff(const Stroke& a, const Stroke& b) {
  double worst = 0;
  for (const Vec2& p : a) worst = std::max(worst, distanceToBorder(b, p));
  for (const Vec2& p : b) worst = std::max(worst, distanceToBorder(a, p));
  return worst;
}

/// Up to rounding, which may choose other vertices for the polygon on the same smooth curve.
void requireSame(const Outline& a, const Outline& b, double error = 1e-7) {
  const double size = sizeOf(a.dense);
  REQUIRE(hausdorff(a.dense, b.dense) <= error * size);
  REQUIRE(hausdorff(a.polygon, b.polygon) <= 5e-4 * size);
  REQUIRE(a.mirror.has_value() == b.mirror.has_value());
}

Outline moved(Outline outline, double factor, Vec2 by) {
  outline.dense = strokes::translated(strokes::scaled(outline.dense, factor), by);
  outline.polygon = strokes::translated(strokes::scaled(outline.polygon, factor), by);
  return outline;
}

bool hasVertexNear(const Stroke& polygon, Vec2 place, double near) {
  return std::any_of(polygon.begin(), polygon.end(),
                     [&](Vec2 p) { return distance(p, place) <= near; });
}

/// Shapes in general position: nothing in them is so symmetric that rounding decides.
std::vector<NamedStroke> irregularShapes() {
  std::vector<NamedStroke> shapes;
  for (auto& shape : strokes::plainShapes()) {
    if (shape.name.find("blob") == 0 || shape.name.find("wavy") != std::string::npos) {
      shapes.push_back(std::move(shape));
    }
  }
  Random random(21);
  for (int i = 0; i < 6; ++i) {
    shapes.push_back({"crossing curve", strokes::closedCurve(random, 250)});
  }
  return shapes;
}

}  // namespace

TEST_CASE("outline: every stroke of every family becomes two good polygons", "[outline]") {
  int errors = 0;
  for (const auto& stroke : strokes::strokeFamilies(31, 1200)) {
    CAPTURE(stroke.name, stroke.points.size());
    const auto outline = makeOutline(stroke.points);
    if (!outline) {
      REQUIRE(outline.status() == Status::noArea);
      ++errors;
      continue;
    }
    requireGood(*outline);
  }
  REQUIRE(errors <= 2);  // short walks that only go forth and back
}

TEST_CASE("outline: plain shapes keep their area and their way", "[outline]") {
  for (const auto& shape : strokes::plainShapes()) {
    CAPTURE(shape.name);
    const Outline outline = outlineOf(shape.points);
    requireGood(outline);
    REQUIRE_FALSE(outline.crossed_itself);
    const double area = std::fabs(signedArea(shape.points));
    REQUIRE(signedArea(outline.dense) == Approx(area).epsilon(0.02));
    REQUIRE(signedArea(outline.polygon) == Approx(area).epsilon(0.06));
    const double step = perimeter(shape.points) / 200;
    for (const Vec2& p : shape.points) REQUIRE(distanceToBorder(outline.dense, p) <= 0.35 * step);
    for (const Vec2& p : outline.dense) REQUIRE(distanceToBorder(shape.points, p) <= 0.35 * step);
  }
}

TEST_CASE("outline: a disc is a round polygon of about 200 even sides", "[outline]") {
  const Outline outline = outlineOf(strokes::disc(100, 1000));
  REQUIRE(outline.dense.size() >= 190);
  REQUIRE(outline.dense.size() <= 210);
  REQUIRE(signedArea(outline.dense) == Approx(strokes::kTau / 2 * 1e4).epsilon(1e-3));
  REQUIRE(outline.polygon.size() >= 40);
  REQUIRE(outline.polygon.size() <= 220);
  for (const Vec2& p : outline.dense) REQUIRE(length(p) == Approx(100).epsilon(1e-3));
  for (size_t i = 1; i < outline.dense.size(); ++i) {
    REQUIRE(distance(outline.dense[i - 1], outline.dense[i]) ==
            Approx(outline.perimeter / 200).epsilon(0.1));
  }
}

TEST_CASE("outline: corners stay where they are, and the polygon rounds them little", "[outline]") {
  const std::vector<NamedStroke> cornered = {
      {"rectangle", strokes::rectangle(300, 200)},
      {"star", strokes::star(5, 60, 150)},
      {"L", {{0, 0}, {300, 0}, {300, 90}, {110, 90}, {110, 280}, {0, 280}}},
      {"T",
       {{-300, 0}, {300, 0}, {300, 90}, {60, 90}, {60, 500}, {-50, 500}, {-50, 90}, {-300, 90}}},
      {"triangle", {{0, 0}, {400, 30}, {150, 260}}},
  };
  for (const auto& shape : cornered) {
    for (const double spacing : {1e9, 30.0, 3.0, 0.7}) {
      CAPTURE(shape.name, spacing);
      Stroke stroke = strokes::rotated(strokes::sampled(shape.points, spacing), 0.2);
      const Outline outline = outlineOf(stroke);
      const Stroke corners = strokes::rotated(shape.points, 0.2);
      for (const Vec2& corner : corners) {
        REQUIRE(hasVertexNear(outline.dense, corner, 1e-9));
        REQUIRE(distanceToBorder(outline.polygon, corner) < outline.perimeter / 200);
      }
    }
  }
}

TEST_CASE("outline: the noise of whole pixels is smoothed away", "[outline]") {
  Random random(8);
  for (const double radius : {25.0, 60.0, 150.0, 400.0}) {
    CAPTURE(radius);
    const auto samples = static_cast<int>(4 * radius);
    const Outline smooth = outlineOf(strokes::disc(radius, samples));
    const Outline noisy = outlineOf(
        strokes::onPixels(strokes::jittered(random, strokes::disc(radius, samples), 0.3), 1));
    requireGood(noisy);
    REQUIRE(noisy.polygon.size() <= smooth.polygon.size() * 1.4 + 4);
    for (const Vec2& p : noisy.dense) REQUIRE(std::fabs(length(p) - radius) < 0.8);
    // Its sides turn little: no stair steps are left.
    const Stroke& dense = noisy.dense;
    const size_t n = dense.size();
    for (size_t i = 0; i < n; ++i) {
      const Vec2 in = dense[i] - dense[(i + n - 1) % n], out = dense[(i + 1) % n] - dense[i];
      REQUIRE(dot(in, out) > 0.64 * length(in) * length(out));
    }
  }
}

TEST_CASE("outline: thin tubes are kept, however thin beside the step", "[outline]") {
  for (const double half_width : {0.02, 0.1, 0.5, 1.5, 4.0, 12.0}) {
    CAPTURE(half_width);
    const Stroke tube = strokes::wavyTube(half_width);
    const Outline outline = outlineOf(tube);
    requireGood(outline);
    REQUIRE_FALSE(outline.crossed_itself);
    REQUIRE(signedArea(outline.dense) == Approx(std::fabs(signedArea(tube))).epsilon(0.1));
    REQUIRE(outline.perimeter == Approx(perimeter(tube)).epsilon(0.02));
    REQUIRE(outline.polygon.size() <= 2 * outline.dense.size());
  }
}

TEST_CASE("outline: a stroke that crosses itself becomes its largest piece", "[outline]") {
  const Outline eight = outlineOf(strokes::figureEight(200, 300));
  requireGood(eight);
  REQUIRE(eight.crossed_itself);
  const bool right = areaCentroid(eight.dense).x > 0;
  for (const Vec2& p : eight.dense) REQUIRE((right ? p.x : -p.x) > -1);

  //  twice around, the second time a little wider
  Stroke rounds;
  for (int i = 0; i < 400; ++i)
    rounds.push_back(strokes::polar(100 + 0.02 * i, strokes::kTau * i / 200));
  const Outline round = outlineOf(rounds);
  requireGood(round);
  REQUIRE(signedArea(round.dense) > strokes::kTau / 2 * 100 * 100);
}

TEST_CASE("outline: a pen that overshoots its start leaves no spike", "[outline]") {
  Random random(9);
  const auto around = [](double from, double to, double radius_from, double radius_to) {
    Stroke stroke;
    for (int i = 0; i <= 200; ++i) {
      const double t = i / 200.0;
      stroke.push_back(strokes::polar(radius_from + (radius_to - radius_from) * t,
                                      strokes::kTau * (from + (to - from) * t)));
    }
    return stroke;
  };
  const std::vector<NamedStroke> drawn = {
      {"past the start, outside", around(0, 1.06, 100, 104)},
      {"past the start, inside", around(0, 1.06, 104, 100)},
      {"far past the start", around(0, 1.1, 100, 103)},
      {"on the start", around(0, 1.05, 100, 100)},
      {"short of the start", around(0, 0.95, 100, 100)},
  };
  for (const auto& stroke : drawn) {
    for (const bool backwards : {false, true}) {
      CAPTURE(stroke.name, backwards);
      const Outline outline =
          outlineOf(backwards ? strokes::reversed(stroke.points) : stroke.points);
      requireGood(outline);
      REQUIRE(signedArea(outline.dense) == Approx(strokes::kTau / 2 * 102 * 102).epsilon(0.06));
      REQUIRE(outline.perimeter == Approx(strokes::kTau * 102).epsilon(0.04));
    }
  }

  //  tails that cross: in from outside, around, and out again
  Stroke tails{{160, -30}, {140, -20}, {120, -10}};
  for (const Vec2& p : around(0, 1, 100, 100)) tails.push_back(p);
  for (const Vec2& p : {Vec2{120, 10}, Vec2{140, 20}, Vec2{160, 30}}) tails.push_back(p);
  std::swap(tails[0], tails[tails.size() - 1]);
  std::swap(tails[1], tails[tails.size() - 2]);
  std::swap(tails[2], tails[tails.size() - 3]);
  const Outline outline = outlineOf(tails);
  requireGood(outline);
  for (const Vec2& p : outline.dense) REQUIRE(length(p) < 125);
}

TEST_CASE("outline: a line that is drawn forth and back disappears", "[outline]") {
  Random random(10);
  for (int i = 0; i < 40; ++i) {
    const double turn = random.between(0, strokes::kTau);
    const double wobble = i % 2 ? 0 : 1e-9 * random.unit();
    Stroke stroke = strokes::disc(100, 150);
    for (int k = 0; k <= 20; ++k) stroke.push_back({100 + 8.0 * k, 3.0 * k});
    for (int k = 20; k-- > 0;) stroke.push_back({100 + 8.0 * k, 3.0 * k});
    stroke = strokes::jittered(random, strokes::rotated(stroke, turn), wobble);
    const Outline outline = outlineOf(stroke);
    CAPTURE(i);
    requireGood(outline);
    for (const Vec2& p : outline.dense) REQUIRE(length(p) < 102);
  }
}

TEST_CASE("outline: close arms do not grow together", "[outline]") {
  for (const double half_width : {8.0, 16.0, 19.0, 19.5}) {
    CAPTURE(half_width);
    const Stroke spiral = strokes::spiral(4, 40, half_width, 400);
    REQUIRE(isSimple(spiral));
    const Outline outline = outlineOf(spiral);
    requireGood(outline);
    REQUIRE_FALSE(outline.crossed_itself);
    REQUIRE(outline.perimeter == Approx(perimeter(spiral)).epsilon(0.01));
  }
}

TEST_CASE("outline: scaling scales it and nothing else", "[outline]") {
  for (const auto& shape : irregularShapes()) {
    CAPTURE(shape.name);
    const Outline outline = outlineOf(shape.points);
    for (const double factor : {1e4, 1e-4, 1e-6, 1e9}) {
      const Outline scaled = outlineOf(strokes::scaled(shape.points, factor));
      REQUIRE(scaled.dense.size() == outline.dense.size());
      requireSame(moved(scaled, 1 / factor, {}), outline);
    }
    for (const double factor : {0x1p40, 0x1p-40}) {
      const Outline scaled =
          moved(outlineOf(strokes::scaled(shape.points, factor)), 1 / factor, {});
      REQUIRE(scaled.dense == outline.dense);
      REQUIRE(scaled.polygon == outline.polygon);
    }
  }
}

TEST_CASE("outline: moving, turning and mirroring the stroke do the same to it", "[outline]") {
  for (const auto& shape : irregularShapes()) {
    CAPTURE(shape.name);
    const Outline outline = outlineOf(shape.points);
    requireSame(moved(outlineOf(strokes::translated(shape.points, {3e6, -1e6})), 1, {-3e6, 1e6}),
                outline);
    // A wide shape's polygon may begin at another of two nearly equal vertices.
    Outline turned = outlineOf(strokes::rotated(shape.points, 1));
    turned.dense = strokes::rotated(turned.dense, -1);
    REQUIRE(hausdorff(turned.dense, outline.dense) <= 1e-7 * sizeOf(outline.dense));
    Outline mirrored = outlineOf(strokes::mirrored(shape.points));
    mirrored.dense = strokes::mirrored(mirrored.dense);
    REQUIRE(hausdorff(mirrored.dense, outline.dense) <= 1e-7 * sizeOf(outline.dense));
  }
}

TEST_CASE("outline: neither the direction nor the start of a closed stroke matters", "[outline]") {
  for (const auto& shape : irregularShapes()) {
    CAPTURE(shape.name);
    const Outline outline = outlineOf(shape.points);
    requireSame(outlineOf(strokes::reversed(shape.points)), outline);
    for (const size_t first : {1, 17, 40}) {
      requireSame(outlineOf(strokes::startedAt(shape.points, first)), outline);
      requireSame(outlineOf(strokes::startedAt(strokes::reversed(shape.points), first)), outline);
    }
  }
}

TEST_CASE("outline: repeated samples change nothing", "[outline]") {
  for (const auto& shape : strokes::plainShapes()) {
    CAPTURE(shape.name);
    const Outline outline = outlineOf(shape.points);
    Stroke slow;
    for (const Vec2& p : shape.points) slow.insert(slow.end(), 3, p);
    slow.push_back(shape.points[0]);
    const Outline same = outlineOf(slow);
    REQUIRE(same.dense == outline.dense);
    REQUIRE(same.polygon == outline.polygon);
  }
}

TEST_CASE("outline: samples that are no numbers are dropped", "[outline]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  Stroke stroke = strokes::disc(100, 100);
  const Outline outline = outlineOf(stroke);
  stroke.insert(stroke.begin(), {nan, 0});
  stroke.insert(stroke.begin() + 30, {{0, nan}, {inf, 0}, {0, -inf}, {1e300, 1}});
  stroke.push_back({nan, nan});
  REQUIRE(outlineOf(stroke).dense == outline.dense);
}

TEST_CASE("outline: under three different points is tooFewPoints", "[outline]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  REQUIRE(makeOutline({}).status() == Status::tooFewPoints);
  REQUIRE(makeOutline({{1, 2}}).status() == Status::tooFewPoints);
  REQUIRE(makeOutline(Stroke(1000, Vec2{1, 2})).status() == Status::tooFewPoints);
  REQUIRE(makeOutline({{1, 2}, {3, 4}, {1, 2}, {3, 4}, {3, 4}}).status() == Status::tooFewPoints);
  REQUIRE(makeOutline({{0, 0}, {1, 0}, {nan, 1}, {nan, 2}}).status() == Status::tooFewPoints);
}

TEST_CASE("outline: points on a line and lines drawn forth and back are noArea", "[outline]") {
  REQUIRE(makeOutline({{0, 0}, {1, 1}, {2, 2}}).status() == Status::noArea);
  REQUIRE(makeOutline({{0, 0}, {1, 1}, {2, 2}, {0.5, 0.5}}).status() == Status::noArea);
  REQUIRE(makeOutline({{0, 0}, {1, 3}, {2, 2}, {1, 3}}).status() == Status::noArea);
  for (const double angle : {0.1, 0.2, 1.0, 2.5}) {
    Stroke line;
    for (int i = 0; i < 100; ++i) line.push_back({0.1 * i, 0});
    for (int i = 99; i-- > 0;) line.push_back({0.1 * i + 0.03, 0});
    REQUIRE(makeOutline(strokes::rotated(line, angle)).status() == Status::noArea);
  }
}

TEST_CASE("outline: tiny and huge strokes far from the origin", "[outline]") {
  Random random(12);
  const Stroke blob = strokes::blob(random, 200, 1);
  for (const double size : {1e-60, 1e-3, 1.0, 1e6, 1e60}) {
    for (const double offset : {0.0, 10.0, 1e6, 1e10}) {
      CAPTURE(size, offset);
      const Vec2 far{size * offset, -size * offset / 3};
      const Outline outline = outlineOf(strokes::translated(strokes::scaled(blob, size), far));
      requireGood(outline);
      REQUIRE(signedArea(outline.dense) / size / size == Approx(signedArea(blob)).epsilon(0.01));
    }
  }
  // As far away as the numbers reach: about 30 of them across the shape.
  const auto coarse = makeOutline(strokes::translated(strokes::scaled(blob, 1e-3), {1e12, 1e12}));
  if (coarse) requireGood(*coarse);
}

TEST_CASE("outline: ten to a hundred thousand samples draw the same shape", "[outline]") {
  for (const int samples : {100, 1000, 10000, 100000}) {
    CAPTURE(samples);
    Random random(13);
    const Outline outline = outlineOf(strokes::blob(random, samples));
    Random again(13);
    const Stroke fine = strokes::blob(again, 4000);
    requireGood(outline);
    REQUIRE(hausdorff(outline.dense, fine) < 0.002 * sizeOf(fine));
    REQUIRE(outline.dense.size() <= 220);
  }
}

TEST_CASE("outline: a hundred thousand samples of wandering stay in hand", "[outline]") {
  Random random(14);
  std::vector<NamedStroke> wild = {
      {"scribble", strokes::scribble(random, 100000)},
      {"slow scribble", strokes::scribble(random, 100000, 400, 0.7)},
      {"random points", strokes::jittered(random, Stroke(100000), 300)},
      {"lattice walk", strokes::latticeWalk(random, 100000, 200)},
      {"lattice steps", strokes::latticeSteps(random, 100000)},
      {"zigzag", strokes::zigzag(3000, 800, 300)},
      {"spikes", strokes::star(20000, 1, 200)},
  };
  Stroke clustered = strokes::disc(200, 1000);
  for (int i = 0; i < 99000; ++i) {
    clustered.push_back({200 + random.between(-0.2, 0.2), random.between(-0.2, 0.2)});
  }
  wild.push_back({"a pen that rests", clustered});
  for (const auto& stroke : wild) {
    CAPTURE(stroke.name);
    const Outline outline = outlineOf(stroke.points);
    requireGood(outline);
    REQUIRE(outline.dense.size() < 5000);
  }
}

TEST_CASE("outline: each beginning of a stroke has an outline as well", "[outline]") {
  Random random(15);
  for (const Stroke& whole :
       {strokes::hand(), strokes::scribble(random, 300), strokes::spiral(3, 60, 18)}) {
    for (size_t count = 12; count < whole.size(); count += 7) {
      CAPTURE(count);
      const auto outline =
          makeOutline(Stroke(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count)));
      if (outline) {
        requireGood(*outline);
      } else {
        REQUIRE(outline.status() == Status::noArea);
      }
    }
  }
}

TEST_CASE("outline: options are obeyed", "[outline]") {
  OutlineOptions options;
  options.samples = 50;
  options.steadiness = 4;
  const Outline coarse = *makeOutline(strokes::disc(100, 300), options);
  REQUIRE(coarse.dense.size() <= 60);
  REQUIRE(coarse.polygon.size() < outlineOf(strokes::disc(100, 300)).polygon.size());
  options.samples = -5;
  options.steadiness = -1;
  requireGood(makeOutline(strokes::disc(100, 300), options)->dense);
}

TEST_CASE("outline: real strokes become close polygons of moderate size", "[outline]") {
  const auto real = strokes::realStrokes();
  if (real.empty()) WARN("no real strokes beside the project: skipped");
  for (const auto& stroke : real) {
    CAPTURE(stroke.name);
    const Outline outline = outlineOf(stroke.points);
    requireGood(outline);
    REQUIRE(outline.polygon.size() >= 12);
    REQUIRE(outline.polygon.size() <= 500);
    REQUIRE(outline.dense.size() <= 400);
    // What the hand drew is hardly ever left: at ends that were closed another way.
    size_t off = 0;
    for (const Vec2& p : stroke.points) {
      off += distanceToBorder(outline.dense, p) > 0.005 * outline.perimeter;
    }
    REQUIRE(off <= stroke.points.size() / 6);
    requireSame(outlineOf(strokes::reversed(stroke.points)), outline);
    requireSame(moved(outlineOf(strokes::scaled(stroke.points, 1e4)), 1e-4, {}), outline, 1e-4);
  }
}

TEST_CASE("outline: polygons that broke other programs", "[outline]") {
  const auto hard = strokes::hardPolygons();
  if (hard.empty()) WARN("no hard polygons beside the project: skipped");
  for (const auto& ring : hard) {
    CAPTURE(ring.name);
    const auto outline = makeOutline(ring.points);
    if (ring.name == "earcut-degenerate") {
      REQUIRE(outline.status() == Status::noArea);
      continue;
    }
    REQUIRE(outline);
    requireGood(*outline);
    if (isSimple(ring.points)) {
      REQUIRE_FALSE(outline->crossed_itself);
      REQUIRE(signedArea(outline->dense) ==
              Approx(std::fabs(signedArea(ring.points))).epsilon(0.03));
    }
  }
}

TEST_CASE("outline: lines closer than a screen can show give a bounded polygon", "[outline]") {
  // Up and down, 25,000 times, and back along the bottom.
  Stroke comb{{0, 0}};
  const double pitch = 1000.0 / 25000;
  for (int i = 0; i < 25000; ++i) {
    const double x = i * pitch;
    comb.insert(comb.end(), {{x, 10}, {x, 400}, {x + pitch / 2, 400}, {x + pitch / 2, 10}});
  }
  comb.push_back({1000, 0});
  for (const Stroke& stroke : std::vector<Stroke>{comb, strokes::spiral(40, 10, 3, 20000),
                                                  strokes::star(25000, 150, 200)}) {
    const auto outline = makeOutline(stroke);
    REQUIRE(outline);
    CHECK(outline->dense.size() <= 6000);
    CHECK(outline->polygon.size() <= 1200);
    CHECK(isSimple(outline->dense));
    CHECK(isSimple(outline->polygon));
  }
}

TEST_CASE("outline: a spiral of many turns stays a spiral", "[outline]") {
  const auto outline = makeOutline(strokes::spiral(20, 20, 6, 4000));
  REQUIRE(outline);
  CHECK(perimeter(outline->dense) > 0.97 * perimeter(strokes::spiral(20, 20, 6, 4000)));
}
