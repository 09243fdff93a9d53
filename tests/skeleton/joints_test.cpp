#include "skeleton/joints.h"

#include <limits>

#include "skeleton/checks.h"
#include "skeleton/shapes.h"
#include "sketch/outline.h"
#include "support/catch.h"
#include "support/polygons.h"

namespace marrow {
namespace {

Axis axisOf(const std::vector<Vec2>& polygon) {
  const auto skeleton = straightSkeleton(polygon);
  REQUIRE(skeleton);
  const auto axis = extractAxis(polygon, *skeleton);
  REQUIRE(axis);
  return *axis;
}

PartSkeleton place(const std::vector<Vec2>& polygon, const Axis& axis, double epsilon_s = 5) {
  JointOptions options;
  options.epsilon_s = epsilon_s;
  const auto skeleton =
      placeJoints(polygon, axis, perimeter(polygon) / kReferencePerimeter, options);
  REQUIRE(skeleton);
  return *skeleton;
}

PartSkeleton jointsOf(const std::vector<Vec2>& polygon, double epsilon_s = 5) {
  return place(polygon, axisOf(polygon), epsilon_s);
}

/// As of a drawing of the shape.
PartSkeleton jointsOfDrawn(const std::vector<Vec2>& shape, double epsilon_s = 5) {
  OutlineOptions outlining;
  outlining.symmetric = false;
  const auto outline = makeOutline(shape, outlining);
  REQUIRE(outline);
  return jointsOf(outline->polygon, epsilon_s);
}

std::vector<Vec2> positions(const PartSkeleton& skeleton) {
  std::vector<Vec2> result;
  for (const auto& joint : skeleton.joints) result.push_back(joint.position);
  return result;
}

int countOf(const PartSkeleton& skeleton, JointKind kind) {
  return static_cast<int>(std::count_if(skeleton.joints.begin(), skeleton.joints.end(),
                                        [&](const auto& joint) { return joint.kind == kind; }));
}

void check(const std::vector<Vec2>& polygon) {
  const Axis axis = axisOf(polygon);
  std::vector<Vec2> last;
  for (const double epsilon_s : {0.5, 1.0, 3.0, 4.0, 5.0, 5.5, 7.0, 12.0, 50.0, 1e9}) {
    const PartSkeleton skeleton = place(polygon, axis, epsilon_s);
    INFO("threshold " << epsilon_s);
    const std::vector<Vec2> now = positions(skeleton);
    CHECK(treeFault(polygon, now, skeleton.bones) == "");
    // Coarser thresholds keep some of the joints and add none.
    CHECK((last.empty() || std::all_of(now.begin(), now.end(), [&](Vec2 p) {
             return std::find(last.begin(), last.end(), p) != last.end();
           })));
    last = now;
  }
}

}  // namespace

TEST_CASE("joints: a tree, every bone inside the polygon, fewer with a larger threshold",
          "[joints]") {
  for (const auto& shape : shapes::named()) {
    INFO(shape.name);
    check(shape.polygon);
  }
  for (const auto& shape : polygonFamilies(41, 1100)) {
    INFO(shape.name);
    check(shape.points);
  }
  Random random(42);
  for (int i = 0; i < 1100; ++i) {
    INFO("random polygon " << i);
    check(shapes::random(random));
  }
}

TEST_CASE("joints: the kind is the number of bones", "[joints]") {
  Random random(43);
  for (int i = 0; i < 200; ++i) {
    const PartSkeleton skeleton = jointsOf(shapes::random(random));
    std::vector<int> degrees(skeleton.joints.size());
    for (const auto& bone : skeleton.bones) {
      ++degrees[bone[0]];
      ++degrees[bone[1]];
    }
    for (size_t k = 0; k < degrees.size(); ++k) {
      const JointKind kind = degrees[k] == 1   ? JointKind::terminal
                             : degrees[k] == 2 ? JointKind::sleeve
                                               : JointKind::junction;
      CHECK(skeleton.joints[k].kind == kind);
    }
  }
  CHECK(toString(JointKind::terminal) == std::string("terminal"));
  CHECK(toString(JointKind::sleeve) == std::string("sleeve"));
  CHECK(toString(JointKind::junction) == std::string("junction"));
}

TEST_CASE("joints: the radius is the inscribed one", "[joints]") {
  Random random(44);
  for (int i = 0; i < 100; ++i) {
    const auto polygon = shapes::random(random);
    for (const auto& joint : jointsOf(polygon).joints) {
      CHECK(joint.radius == Approx(distanceToBorder(polygon, joint.position)));
    }
  }
}

TEST_CASE("joints: blobs are one bone, limbs have a joint in the middle, bends and necks too",
          "[joints]") {
  for (const int n : {5, 8, 24}) CHECK(jointsOfDrawn(shapes::regular(n)).joints.size() == 2);
  // Shorter than three of its radii; longer, and how long does not matter.
  CHECK(jointsOfDrawn(shapes::sausage(10, 25, 16)).joints.size() == 2);
  for (const double length : {150.0, 300.0}) {
    const PartSkeleton sausage = jointsOfDrawn(shapes::sausage(length, 25, 16));
    INFO(length);
    CHECK(sausage.joints.size() >= 3);
    const auto all = positions(sausage);
    CHECK(std::any_of(all.begin(), all.end(), [](Vec2 p) { return distance(p, {0, 0}) < 5; }));
  }

  const PartSkeleton star = jointsOfDrawn(shapes::star(5, 30, 100));
  CHECK(countOf(star, JointKind::terminal) == 5);
  CHECK(countOf(star, JointKind::junction) == 1);
  CHECK(countOf(jointsOfDrawn(shapes::hand(5)), JointKind::terminal) == 5);

  const PartSkeleton bend =
      jointsOfDrawn({{0, 0}, {120, 0}, {120, 40}, {40, 40}, {40, 150}, {0, 150}});
  const auto at = positions(bend);
  CHECK(std::any_of(at.begin(), at.end(), [](Vec2 p) { return distance(p, {20, 20}) < 12; }));

  // A dumbbell: its axis is straight, its shape is not.
  const auto dumbbell = shapes::tube({{-100, 0}, {-60, 0}, {-20, 0}, {20, 0}, {60, 0}, {100, 0}},
                                     {40, 35, 8, 8, 35, 40});
  int in_neck = 0;
  for (const Vec2 p : positions(jointsOfDrawn(dumbbell))) in_neck += std::fabs(p.x) < 35;
  CHECK(in_neck >= 1);
}

TEST_CASE("joints: a limb thinner than its body begins at its mouth, on its own line", "[joints]") {
  // A trunk with an arm at its side, off the trunk's middle.
  const std::vector<Vec2> shape{{-50, 0},   {50, 0},   {50, 150}, {200, 150},
                                {200, 180}, {50, 180}, {50, 320}, {-50, 320}};
  const auto at = positions(jointsOfDrawn(shape));
  CHECK(std::any_of(at.begin(), at.end(),
                    [](Vec2 p) { return std::fabs(p.y - 165) < 5 && p.x > 15 && p.x < 50; }));
}

TEST_CASE("joints: no bone of a limb is shorter than nearly its half width", "[joints]") {
  // A bird's leg, with knobs a hand makes.
  Random random(47);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec2> line;
    std::vector<double> radii;
    for (int k = 0; k <= 12; ++k) {
      line.push_back({random.between(-1, 1), 30.0 * k});
      radii.push_back(12 + random.between(-1, 1));
    }
    const PartSkeleton leg = jointsOfDrawn(shapes::tube(line, radii));
    INFO(i);
    CHECK(leg.joints.size() >= 3);
    CHECK(leg.joints.size() <= 10);
    for (const auto& bone : leg.bones) {
      CHECK(distance(leg.joints[bone[0]].position, leg.joints[bone[1]].position) > 10);
    }
  }
}

TEST_CASE("joints: turned, mirrored, scaled or renumbered, the same", "[joints]") {
  Random random(45);
  for (int i = 0; i < 100; ++i) {
    const auto polygon = shapes::randomRadial(random, 8 + random.below(20), 0.5);
    const double size = sizeOf(polygon);
    const auto points = positions(jointsOf(polygon));
    INFO("random polygon " << i);
    if (points.size() > 2) {  // a blob's bone is upright where it can be
      CHECK(samePoints(positions(jointsOf(shapes::turned(polygon, 2))), shapes::turned(points, 2),
                       1e-6 * size));
    }
    CHECK(samePoints(positions(jointsOf(shapes::mirrored(polygon))), shapes::mirrored(points),
                     1e-6 * size));
    for (const double factor : {1e4, 1e-4}) {
      CHECK(samePoints(positions(jointsOf(shapes::scaled(polygon, factor))),
                       shapes::scaled(points, factor), 1e-6 * size * factor));
    }
    CHECK(samePoints(positions(jointsOf(shapes::renumbered(polygon, polygon.size() / 3))), points,
                     1e-6 * size));
  }
}

TEST_CASE("joints: senseless options do no harm", "[joints]") {
  const auto polygon = shapes::hand(5);
  const Axis axis = axisOf(polygon);
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double epsilon_s : {0.0, -1.0, 1e-300, 1e300, inf, nan}) {
    for (const double scale : {0.0, 1e-300, 1.0, 1e300}) {
      for (const double shrink : {0.0, 0.8, 2.0, nan}) {
        const auto skeleton = placeJoints(polygon, axis, scale, {epsilon_s, 1, shrink, {}});
        REQUIRE(skeleton);
        CHECK(treeFault(polygon, positions(*skeleton), skeleton->bones) == "");
      }
    }
  }
  CHECK(placeJoints(polygon, axis, nan).status() == Status::skeletonFailed);
  CHECK(placeJoints(polygon, axis, -1).status() == Status::skeletonFailed);
  CHECK(placeJoints(polygon, {}, 1).status() == Status::skeletonFailed);
  CHECK(placeJoints({}, axis, 1).status() == Status::skeletonFailed);
}

}  // namespace marrow
