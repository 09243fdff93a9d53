#include "skeleton/axis.h"

#include "skeleton/checks.h"
#include "skeleton/shapes.h"
#include "sketch/outline.h"
#include "support/catch.h"
#include "support/polygons.h"

namespace marrow {
namespace {

Axis axisOf(const std::vector<Vec2>& polygon, const AxisOptions& options = {}) {
  const auto skeleton = straightSkeleton(polygon);
  REQUIRE(skeleton);
  const auto axis = extractAxis(polygon, *skeleton, options);
  REQUIRE(axis);
  return *axis;
}

/// Of the polygon that is made of a drawing of the shape, not of the one with its sharp corners.
Axis axisOfDrawn(const std::vector<Vec2>& shape, const AxisOptions& options = {}) {
  OutlineOptions outlining;
  outlining.symmetric = false;
  const auto outline = makeOutline(shape, outlining);
  REQUIRE(outline);
  return axisOf(outline->polygon, options);
}

std::vector<int> degrees(const Axis& axis) {
  std::vector<int> result(axis.points.size());
  for (const auto& edge : axis.edges) {
    ++result[edge[0]];
    ++result[edge[1]];
  }
  return result;
}

int tips(const Axis& axis) {
  const auto all = degrees(axis);
  return static_cast<int>(std::count(all.begin(), all.end(), 1));
}

std::vector<Vec2> endsOf(const Axis& axis) {
  const auto all = degrees(axis);
  std::vector<Vec2> ends;
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i] == 1) ends.push_back(axis.points[i]);
  }
  return ends;
}

void check(const std::vector<Vec2>& polygon) {
  const Axis axis = axisOf(polygon);
  CHECK(treeFault(polygon, axis.points, axis.edges) == "");
  REQUIRE(axis.radii.size() == axis.points.size());
  double error = 0;
  for (size_t i = 0; i < axis.points.size(); ++i) {
    error = std::max(error, axis.radii[i] - distanceToBorder(polygon, axis.points[i]));
  }
  CHECK(error <= 1e-9 * sizeOf(polygon));
}

}  // namespace

TEST_CASE("axis: a tree inside the polygon with a ball inside it at every point", "[axis]") {
  for (const auto& shape : shapes::named()) {
    INFO(shape.name);
    check(shape.polygon);
  }
  for (const auto& shape : polygonFamilies(31, 800)) {
    INFO(shape.name);
    check(shape.points);
  }
  Random random(32);
  for (int i = 0; i < 800; ++i) {
    INFO("random polygon " << i);
    check(shapes::random(random));
  }
}

TEST_CASE("axis: a rectangle's goes along its middle, to the middle of both ends", "[axis]") {
  const Axis axis = axisOfDrawn(shapes::rectangle(200, 60));
  double low = 200, high = 0;
  for (const Vec2 p : axis.points) {
    CHECK(std::fabs(p.y - 30) < 0.5);
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  }
  CHECK(low == Approx(18).margin(1));
  CHECK(high == Approx(182).margin(1));
  CHECK(tips(axis) == 2);
}

TEST_CASE("axis: every limb has a tip and nothing else has", "[axis]") {
  for (int arms : {3, 4, 5, 6, 9}) CHECK(tips(axisOfDrawn(shapes::star(arms, 30, 100))) == arms);
  for (int fingers : {5, 8}) CHECK(tips(axisOfDrawn(shapes::hand(fingers))) == fingers);
  // A palm whose few fingers are all on one side has a bone to the other.
  for (int fingers : {2, 3}) CHECK(tips(axisOfDrawn(shapes::hand(fingers))) == fingers + 1);
  for (int teeth : {3, 6, 12}) {
    CHECK(tips(axisOfDrawn(shapes::comb(teeth, 20, 15, 100))) == teeth);
  }
  CHECK(tips(axisOfDrawn(shapes::sausage(100, 25))) == 2);
  CHECK(tips(axisOfDrawn(shapes::sausage(100, 25, 24))) == 2);
  CHECK(tips(axisOfDrawn(shapes::sausage(1000, 1))) == 2);
  CHECK(tips(axisOfDrawn(shapes::spiral(4, 60, 18))) == 2);
}

TEST_CASE("axis: a limb ends nearly its half width from the middle of its end", "[axis]") {
  for (const int cap : {2, 3, 4, 5, 8, 16}) {  // from a corner to a round end
    const Axis axis = axisOfDrawn(shapes::sausage(100, 25, cap));
    double low = 0, high = 0;
    for (const Vec2 p : axis.points) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
      CHECK(std::fabs(p.y) < 2.5);
    }
    INFO(cap);
    CHECK(low < -87.5);
    CHECK(high > 87.5);
    CHECK(low > -125);
    CHECK(high < 125);
  }
}

TEST_CASE("axis: a sharp tip gets a bone like a blunted one", "[axis]") {
  // A cone on a block, once with a tip of one vertex, once of two.
  const std::vector<Vec2> sharp{{0, 0}, {60, 0}, {60, 20}, {200, 30}, {60, 40}, {60, 60}, {0, 60}};
  const std::vector<Vec2> blunt{{0, 0},        {60, 0},  {60, 20}, {199.5, 29.5},
                                {199.5, 30.5}, {60, 40}, {60, 60}, {0, 60}};
  for (const auto& polygon : {sharp, blunt}) {
    const Axis axis = axisOfDrawn(polygon);
    double reach = 0;
    for (const Vec2 p : axis.points) reach = std::max(reach, p.x);
    CHECK(reach > 150);
  }
}

TEST_CASE("axis: a sharp notch does not drag it across the body", "[axis]") {
  // A bar with a cut from above, ever narrower, to its middle: the axis goes below the cut.
  for (const double half : {20.0, 5.0, 1.0, 0.2}) {
    const std::vector<Vec2> notched{{-200, 0},      {200, 0},     {200, 100}, {half, 100},
                                    {0, 60 - half}, {-half, 100}, {-200, 100}};
    const Axis axis = axisOfDrawn(notched);
    INFO(half);
    CHECK(tips(axis) == 2);
    CHECK(treeFault(notched, axis.points, axis.edges) == "");
    for (const Vec2 p : axis.points) {
      CHECK(p.y > 20);
      CHECK(p.y < 55);
    }
  }
}

TEST_CASE("axis: corners of blocks and bumps of a trembling hand get no branch", "[axis]") {
  const std::vector<Vec2> chamfered{{10, 0},   {90, 0},   {100, 10}, {100, 90},
                                    {90, 100}, {10, 100}, {0, 90},   {0, 10}};
  CHECK(axisOfDrawn(chamfered).edges.size() == 1);
  Random random(33);
  for (int i = 0; i < 100; ++i) {
    INFO(i);
    CHECK(axisOfDrawn(shapes::randomRadial(random, 12 + random.below(40), 0.95)).edges.size() == 1);
    auto trembling = shapes::tube(
        {{-200, 0}, {-150, 0}, {-100, 0}, {-50, 0}, {0, 0}, {50, 0}, {100, 0}, {150, 0}, {200, 0}},
        std::vector<double>(9, 25), 8);
    for (Vec2& p : trembling) p = p + Vec2{random.between(-1, 1), random.between(-1, 1)};
    CHECK(tips(axisOfDrawn(trembling)) == 2);
  }
}

TEST_CASE("axis: a blob gets one bone through its middle, upright where it is not longer",
          "[axis]") {
  for (const int n : {5, 6, 7, 8, 16, 33}) {
    const Axis axis = axisOfDrawn(shapes::regular(n, 100));
    INFO(n);
    REQUIRE(axis.edges.size() == 1);
    const Vec2 a = axis.points[0], b = axis.points[1];
    CHECK(std::fabs(cross(a, b)) < 0.02 * 100 * 100);
    CHECK(std::fabs(a.x - b.x) < 0.1 * std::fabs(a.y - b.y));
    CHECK(distance(a, b) > 70);
  }
  auto wide = shapes::regular(32, 100);
  for (Vec2& p : wide) p.x *= 1.2;
  const Axis axis = axisOfDrawn(wide);
  REQUIRE(axis.edges.size() == 1);
  CHECK(std::fabs(axis.points[0].y - axis.points[1].y) < 5);
}

TEST_CASE("axis: what was there a moment ago stays until it is clearly gone", "[axis]") {
  // A block with a stub that grows and shrinks again.
  const auto withStub = [](double height) {
    return std::vector<Vec2>{
        {0, 0},    {200, 0}, {200, 100}, {120, 100}, {120, 100 + height}, {80, 100 + height},
        {80, 100}, {0, 100}};
  };
  AxisOptions options;
  double comes = 0, goes = 0;
  for (double height = 0; height <= 60; height += 1) {
    const Axis axis = axisOfDrawn(withStub(height), options);
    if (!comes && tips(axis) == 3) comes = height;
    options.hints = SkeletonHints{endsOf(axis), {}, false};
  }
  for (double height = 60; height >= 0; height -= 1) {
    const Axis axis = axisOfDrawn(withStub(height), options);
    if (!goes && tips(axis) == 2) goes = height;
    options.hints = SkeletonHints{endsOf(axis), {}, false};
  }
  CHECK(comes > 0);
  CHECK(goes > 0);
  CHECK(comes > goes + 3);
}

TEST_CASE("axis: turned, mirrored, scaled or renumbered, the same", "[axis]") {
  // Shapes whose balls are all different: where two are the largest, rounding decides.
  Random random(35);
  for (int i = 0; i < 100; ++i) {
    const auto polygon = shapes::randomRadial(random, 8 + random.below(20), 0.5);
    const double size = sizeOf(polygon);
    const Axis axis = axisOf(polygon);
    const auto& points = axis.points;
    INFO("random polygon " << i);
    if (axis.edges.size() > 1) {  // a blob's bone is upright where it can be
      CHECK(samePoints(axisOf(shapes::turned(polygon, 1)).points, shapes::turned(points, 1),
                       1e-6 * size));
    }
    CHECK(samePoints(axisOf(shapes::mirrored(polygon)).points, shapes::mirrored(points),
                     1e-6 * size));
    for (const double factor : {1e4, 1e-4}) {
      CHECK(samePoints(axisOf(shapes::scaled(polygon, factor)).points,
                       shapes::scaled(points, factor), 1e-6 * size * factor));
    }
    CHECK(samePoints(axisOf(shapes::renumbered(polygon, polygon.size() / 2)).points, points,
                     1e-6 * size));
  }
}

TEST_CASE("axis: a skeleton of something else is an error", "[axis]") {
  CHECK(extractAxis({}, {}).status() == Status::skeletonFailed);
  CHECK(extractAxis(shapes::regular(5), {}).status() == Status::skeletonFailed);
}

}  // namespace marrow
