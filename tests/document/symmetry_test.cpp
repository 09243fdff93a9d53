#include "document/symmetry.h"

#include <algorithm>

#include "document/placement.h"
#include "sketch/outline.h"
#include "sketch/polygon.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/drawings.h"

using namespace marrow;

namespace {

std::vector<Vec2> ellipse(double width, double height, Vec2 center = {}) {
  std::vector<Vec2> points;
  for (Vec2 p : unitCircle(80)) points.push_back(center + Vec2{p.x * width / 2, p.y * height / 2});
  return points;
}

Document bodyOf(const std::vector<Vec2>& stroke, const Frame& frame = {}) {
  PartSource part;
  part.id = "part-1";
  part.stroke = stroke;
  part.frame = frame;
  Document document;
  document.parts.push_back(std::make_shared<const PartSource>(part));
  return document;
}

/// As drawn in the right view, x of the drawing away from the viewer of the front view.
const Frame kFromRight{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}};

}  // namespace

TEST_CASE("symmetry: a body seen from its side lies in its plane, one from its front astride",
          "[symmetry]") {
  REQUIRE_FALSE(symmetryPlane({}));
  const auto side = symmetryPlane(bodyOf(ellipse(300, 120, {40, 10})));
  REQUIRE(side);
  REQUIRE(*side == Plane{{0, 0, 1}, 0});
  const auto front = symmetryPlane(bodyOf(ellipse(120, 300, {40, 10})));
  REQUIRE(front);
  REQUIRE(front->normal == Vec3{1, 0, 0});
  REQUIRE(front->offset == Approx(-40));
  REQUIRE(symmetryPlane(bodyOf(ellipse(200, 200)))->normal == Vec3{1, 0, 0});

  Document given = bodyOf(ellipse(300, 120));
  given.symmetry = Plane{{0, 1, 0}, 3};
  REQUIRE(*symmetryPlane(given) == Plane{{0, 1, 0}, 3});
}

TEST_CASE("symmetry: the plane goes where the body goes", "[symmetry]") {
  Random random(1);
  for (int run = 0; run < 100; ++run) {
    const Document document = bodyOf(randomShape(random, 100, 40));
    const Affine map = randomSimilarity(random);
    const auto before = symmetryPlane(document);
    const Document moved = *apply(document, TransformParts{{"part-1"}, map});
    const auto after = symmetryPlane(moved);
    for (int i = 0; i < 5; ++i) {
      const Vec3 p = randomRotation(random).x * 80;
      REQUIRE(std::fabs(distance(*after, map(p))) ==
              Approx(std::fabs(distance(*before, p)) * length(map.x)).margin(1e-9));
    }
  }
}

TEST_CASE("symmetry: a limb beside the plane gets a twin, one in it none", "[symmetry]") {
  const Plane middle{{0, 0, 1}, 0};
  const std::vector<Vec2> leg = ellipse(40, 160);  // half 20 wide
  const auto off = [&](double depth) { return isOffPlane(leg, {{0, 0, depth}}, middle); };
  REQUIRE_FALSE(off(0));
  REQUIRE_FALSE(off(3));
  REQUIRE(off(20));
  REQUIRE(off(-20));

  const Plane astride{{1, 0, 0}, 0};
  const auto beside = [&](double x) { return isOffPlane(ellipse(40, 160, {x, 0}), {}, astride); };
  REQUIRE_FALSE(beside(0));
  REQUIRE_FALSE(beside(-12));
  REQUIRE(beside(18));
  REQUIRE(beside(-18));
  REQUIRE(beside(400));
}

TEST_CASE("symmetry: whether a stroke lies off the plane does not hang on where all lies",
          "[symmetry]") {
  Random random(2);
  int off = 0;
  for (int run = 0; run < 300; ++run) {
    const Plane plane = randomPlane(random, {});
    PartSource part;
    part.stroke = randomShape(random, 60, 40);
    part.frame.x = randomRotation(random).x;
    const Affine turn = run % 3 ? randomRotation(random) : Affine{};
    part.frame = {{random.between(-60, 60), random.between(-60, 60), 0}, turn.x, turn.y};
    const bool before = isOffPlane(part.stroke, part.frame, plane);
    off += before ? 1 : 0;
    const Affine map = randomSimilarity(random);
    const PartSource moved = *mapped(part, map);
    REQUIRE(isOffPlane(moved.stroke, moved.frame, *mapped(plane, map)) == before);
    const Plane turned{-plane.normal, -plane.offset};
    REQUIRE(isOffPlane(part.stroke, part.frame, turned) == before);
    REQUIRE(isOffPlane(part.stroke, mirrored(part.frame, plane), plane) == before);
  }
  REQUIRE(off > 30);
  REQUIRE(off < 270);
}

TEST_CASE("symmetry: a half outline and its mirror image make a whole one", "[symmetry]") {
  Random random(3);
  for (int run = 0; run < 200; ++run) {
    std::vector<Vec2> half;
    const double width = random.between(20, 90);
    for (int i = 0; i <= 30; ++i) {
      const double t = i / 30.;
      half.push_back({width * 4 * t * (1 - t) + random.between(-0.5, 0.5), 200 * t - 100});
    }
    half.front().x = random.between(-4, 4);
    half.back().x = random.between(-4, 4);
    if (random.below(2)) std::reverse(half.begin(), half.end());
    if (random.below(2)) {
      for (Vec2& p : half) p.x = -p.x;
    }
    const double at = random.between(-50, 50);
    for (Vec2& p : half) p.x += at;

    const Plane plane{{random.below(2) ? 1. : -1., 0, 0}, 0};
    Frame frame;
    frame.origin.x = -at;
    const auto whole = completedByMirror(half, frame, plane, 6);
    REQUIRE(whole);
    const auto outline = makeOutline(*whole);
    REQUIRE(outline);
    REQUIRE(signedArea(outline->dense) == Approx(2 * width * 200 * 2 / 3).epsilon(0.1));
    for (const Vec2 p : *whole) {
      const Vec2 image{2 * at - p.x, p.y};
      const bool there = std::any_of(whole->begin(), whole->end(),
                                     [&](Vec2 q) { return distance(q, image) < 1e-9; });
      REQUIRE(there);
    }
  }
}

TEST_CASE("symmetry: what is no half outline is not completed", "[symmetry]") {
  const Plane plane{{1, 0, 0}, 0};
  std::vector<Vec2> half;
  for (int i = 0; i <= 20; ++i) half.push_back({i * (20 - i) * 0.5, 10. * i});
  REQUIRE(completedByMirror(half, {}, plane, 5));
  REQUIRE_FALSE(completedByMirror(half, kFromRight, plane, 5));
  REQUIRE_FALSE(completedByMirror({}, {}, plane, 5));
  REQUIRE_FALSE(completedByMirror({{0, 0}, {5, 5}}, {}, plane, 5));
  REQUIRE_FALSE(completedByMirror(ellipse(80, 80, {40, 0}), {}, plane, 5));  // ends meet

  std::vector<Vec2> away = half, both = half, along = half;
  away.back().x = 8;
  REQUIRE_FALSE(completedByMirror(away, {}, plane, 5));
  for (size_t i = 0; i < 8; ++i) both[i + 2].x = -20;
  REQUIRE_FALSE(completedByMirror(both, {}, plane, 5));
  for (Vec2& p : along) p.x = 1;
  REQUIRE_FALSE(completedByMirror(along, {}, plane, 5));
}

TEST_CASE("symmetry: reach is a length in space, whatever the frame's scale", "[symmetry]") {
  const Plane plane{{1, 0, 0}, 0};
  std::vector<Vec2> half;
  for (int i = 0; i <= 20; ++i) half.push_back({i * (20 - i) * 0.5 + 4, 10. * i});
  const Frame large{{}, {3, 0, 0}, {0, 3, 0}};
  REQUIRE(completedByMirror(half, {}, plane, 5));
  REQUIRE_FALSE(completedByMirror(half, large, plane, 5));
  REQUIRE(completedByMirror(half, large, plane, 13));
}
