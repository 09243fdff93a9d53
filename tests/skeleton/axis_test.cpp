#include "skeleton/axis.h"

#include "skeleton/checks.h"
#include "skeleton/shapes.h"
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

void check(const std::vector<Vec2>& polygon) {
  const Axis axis = axisOf(polygon);
  CHECK(treeFault(polygon, axis.points, axis.edges) == "");
  REQUIRE(axis.radii.size() == axis.points.size());
  double error = 0;
  for (size_t i = 0; i < axis.points.size(); ++i) {
    error = std::max(error, std::fabs(axis.radii[i] - distanceToBorder(polygon, axis.points[i])));
  }
  CHECK(error <= 1e-12 * sizeOf(polygon));
}

}  // namespace

TEST_CASE("axis: a tree inside the polygon with the inscribed radius at every point", "[axis]") {
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

TEST_CASE("axis: a rectangle's is the line between the centres of its ends' circles", "[axis]") {
  const Axis axis = axisOf(shapes::rectangle(200, 60));
  CHECK(samePoints(axis.points, {{30, 30}, {170, 30}}, 1e-9));
  CHECK(axis.radii[0] == Approx(30));
}

TEST_CASE("axis: every limb has a tip and nothing else has", "[axis]") {
  for (int arms : {3, 4, 5, 6, 9}) CHECK(tips(axisOf(shapes::star(arms, 30, 100))) == arms);
  for (int fingers : {2, 3, 5, 8}) CHECK(tips(axisOf(shapes::hand(fingers))) == fingers);
  for (int teeth : {3, 6, 12}) CHECK(tips(axisOf(shapes::comb(teeth, 20, 15, 100))) == teeth);
  CHECK(tips(axisOf(shapes::sausage(100, 25))) == 2);
  CHECK(tips(axisOf(shapes::sausage(100, 25, 24))) == 2);
  CHECK(tips(axisOf(shapes::sausage(1000, 1))) == 2);
  CHECK(tips(axisOf(shapes::spiral(4, 60, 18))) == 2);
}

TEST_CASE("axis: a limb keeps its length but for about its half width", "[axis]") {
  for (const int cap : {2, 3, 4, 5, 8, 16}) {
    const Axis axis = axisOf(shapes::sausage(100, 25, cap));
    double low = 0, high = 0;
    for (const Vec2 p : axis.points) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    INFO(cap);
    CHECK(low < -87.5);
    CHECK(high > 87.5);
  }
}

TEST_CASE("axis: a sharp tip gets a bone like a blunted one", "[axis]") {
  // A cone on a block, once with a tip of one vertex, once of two.
  const std::vector<Vec2> sharp{{0, 0}, {60, 0}, {60, 20}, {200, 30}, {60, 40}, {60, 60}, {0, 60}};
  const std::vector<Vec2> blunt{{0, 0},        {60, 0},  {60, 20}, {199.5, 29.5},
                                {199.5, 30.5}, {60, 40}, {60, 60}, {0, 60}};
  for (const auto& polygon : {sharp, blunt}) {
    const Axis axis = axisOf(polygon);
    double reach = 0;
    for (const Vec2 p : axis.points) reach = std::max(reach, p.x);
    CHECK(reach > 150);
  }
}

TEST_CASE("axis: corners of blocks and bumps of a trembling hand get no branch", "[axis]") {
  const std::vector<Vec2> chamfered{{10, 0},   {90, 0},   {100, 10}, {100, 90},
                                    {90, 100}, {10, 100}, {0, 90},   {0, 10}};
  CHECK(axisOf(chamfered).edges.size() == 1);
  Random random(33);
  for (int i = 0; i < 100; ++i) {
    INFO(i);
    CHECK(axisOf(shapes::randomRadial(random, 12 + random.below(40), 0.95)).edges.size() == 1);
    auto trembling = shapes::tube(
        {{-200, 0}, {-150, 0}, {-100, 0}, {-50, 0}, {0, 0}, {50, 0}, {100, 0}, {150, 0}, {200, 0}},
        std::vector<double>(9, 25), 8);
    for (Vec2& p : trembling) p = p + Vec2{random.between(-1, 1), random.between(-1, 1)};
    CHECK(tips(axisOf(trembling)) == 2);
  }
}

TEST_CASE("axis: a blob gets one edge along its longest inscribed diameter", "[axis]") {
  for (const int n : {3, 4, 5, 6, 7, 8, 16, 33}) {
    const auto polygon = shapes::regular(n, 100);
    const Axis axis = axisOf(polygon);
    INFO(n);
    REQUIRE(axis.edges.size() == 1);
    const Vec2 a = axis.points[0], b = axis.points[1];
    CHECK(std::fabs(cross(a, b)) < 1e-9 * 100 * 100);  // through the centre
    // From half way to a corner to half way to what is opposite.
    const double opposite = n % 2 ? 100 * std::cos(shapes::kPi / n) : 100;
    CHECK(distance(a, b) == Approx((100 + opposite) / 2));
  }
}

TEST_CASE("axis: turned, mirrored, scaled or renumbered, the same", "[axis]") {
  Random random(35);
  for (int i = 0; i < 300; ++i) {
    const auto polygon = shapes::random(random);
    const double size = sizeOf(polygon);
    const auto points = axisOf(polygon).points;
    INFO("random polygon " << i);
    CHECK(samePoints(axisOf(shapes::turned(polygon, 1)).points, shapes::turned(points, 1),
                     1e-6 * size));
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
