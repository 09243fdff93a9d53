#include "document/placement.h"

#include <limits>

#include "document/command.h"
#include "support/catch.h"
#include "support/commands.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

double largestOf(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z), 1.0}); }

void requireNear(Vec3 a, Vec3 b, double tolerance = 1e-10) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  REQUIRE(distance(a, b) <= tolerance * largestOf(b));
}

/// The strokes lie where the map takes them.
void requireMapped(const PartSource& before, const PartSource& after, const Affine& map) {
  REQUIRE(isSound(after.frame));
  REQUIRE(before.stroke.size() == after.stroke.size());
  for (size_t i = 0; i < before.stroke.size(); ++i) {
    requireNear(after.frame.toWorld(after.stroke[i]), map(before.frame.toWorld(before.stroke[i])));
  }
}

PartSource anyPart(Random& random) { return *randomCreature(random, 2, {20}).parts[1]; }

/// Stretches, shears, may mirror; flattens nothing.
Affine anyMap(Random& random) {
  const Affine turn = randomRotation(random), other = randomRotation(random);
  Affine map;
  map.x = other.direction(turn.x * random.between(0.4, 2));
  map.y = other.direction(turn.y * random.between(0.4, 2) + turn.x * random.between(-0.5, 0.5));
  map.z = other.direction(turn.z * random.between(0.4, 2));
  if (random.below(2)) map.y = -map.y;
  map.move = {random.between(-300, 300), random.between(-300, 300), random.between(-300, 300)};
  return map;
}

Affine inverseOfSimilarity(const Affine& map) {
  const double square = dot(map.x, map.x);
  Affine back;
  back.x = Vec3{map.x.x, map.y.x, map.z.x} / square;
  back.y = Vec3{map.x.y, map.y.y, map.z.y} / square;
  back.z = Vec3{map.x.z, map.y.z, map.z.z} / square;
  back.move = -back.direction(map.move);
  return back;
}

}  // namespace

TEST_CASE("placement: a part's stroke goes where any map takes it", "[placement]") {
  Random random(1);
  for (int run = 0; run < 500; ++run) {
    const PartSource part = anyPart(random);
    const Affine map = anyMap(random);
    const auto after = mapped(part, map);
    REQUIRE(after);
    requireMapped(part, *after, map);
  }
}

TEST_CASE("placement: a similarity changes the frame alone, mirroring or not", "[placement]") {
  Random random(2);
  for (int run = 0; run < 500; ++run) {
    const PartSource part = anyPart(random);
    Affine map = randomSimilarity(random);
    if (run % 2) map.z = -map.z;
    const auto after = mapped(part, map);
    REQUIRE(after);
    REQUIRE(after->stroke == part.stroke);
    REQUIRE(after->thickness == part.thickness);
    requireMapped(part, *after, map);
    REQUIRE(after->frame.scale() == Approx(part.frame.scale() * length(map.x)).epsilon(1e-12));
  }
}

TEST_CASE("placement: a move keeps the directions to the bit", "[placement]") {
  Random random(3);
  for (int run = 0; run < 200; ++run) {
    const PartSource part = anyPart(random);
    Affine map;
    map.move = {random.between(-300, 300), 0, random.between(-300, 300)};
    const auto after = mapped(part, map);
    REQUIRE(after);
    REQUIRE(after->frame.x == part.frame.x);
    REQUIRE(after->frame.y == part.frame.y);
    REQUIRE(after->frame.origin == part.frame.origin + map.move);
    REQUIRE(after->stroke == part.stroke);
  }
}

TEST_CASE("placement: a thousand turns leave directions orthogonal and the scale", "[placement]") {
  Random random(4);
  PartSource part = anyPart(random);
  const double scale = part.frame.scale();
  for (int turn = 0; turn < 1000; ++turn) part = *mapped(part, randomRotation(random));
  REQUIRE(part.frame.scale() == Approx(scale).epsilon(1e-12));
  REQUIRE(std::fabs(dot(part.frame.x, part.frame.y)) < 1e-14 * scale * scale);
  REQUIRE(length(part.frame.y) == Approx(part.frame.scale()).epsilon(1e-14));
}

TEST_CASE("placement: what a map stretches along the normal gets thicker", "[placement]") {
  Random random(5);
  PartSource part = *randomCreature(random, 1, {20}).parts[0];
  part.frame = {};
  part.thickness = 1;
  Affine map;
  map.z = {0, 0, 1.5};
  const auto thick = mapped(part, map);
  REQUIRE(thick);
  REQUIRE(thick->thickness == Approx(1.5));
  REQUIRE(thick->frame == part.frame);
  REQUIRE(thick->stroke == part.stroke);
  map.z = {0, 0, 100};
  REQUIRE(mapped(part, map)->thickness == kMaxThickness);
  map.z = {0, 0, 1};
  map.x = {4, 0, 0};  // the scale doubles, the depth stays
  const auto wide = mapped(part, map);
  REQUIRE(wide);
  REQUIRE(wide->frame.scale() == 2);
  REQUIRE(wide->thickness == Approx(0.5));
}

TEST_CASE("placement: what flattens a part or takes it too far away is refused", "[placement]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Random random(6);
  PartSource part = *randomCreature(random, 1, {20}).parts[0];
  part.frame = {};
  const auto refused = [&](Vec3 x, Vec3 y, Vec3 z, Vec3 move) {
    const auto after = mapped(part, {x, y, z, move});
    return !after && after.status() == Status::noArea;
  };
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  REQUIRE_FALSE(refused(x, y, z, {1, 2, 3}));
  REQUIRE(refused({}, y, z, {}));
  REQUIRE(refused(x, x, z, {}));
  REQUIRE(refused(x, x + y * 1e-10, z, {}));
  REQUIRE(refused(x, y, x, {}));
  REQUIRE(refused(x * nan, y, z, {}));
  REQUIRE(refused(x, y, z * nan, {}));
  REQUIRE(refused(x, y, z, {nan, 0, 0}));
  REQUIRE(refused(x, y, z, {0, 1e51, 0}));
  REQUIRE(refused(x * 1e60, y * 1e60, z * 1e60, {}));
  REQUIRE(refused(x * 1e-60, y * 1e-60, z * 1e-60, {}));
  REQUIRE(refused(x * HUGE_VAL, y, z, {}));
}

TEST_CASE("placement: any two directions that span a plane become a sound frame", "[placement]") {
  Random random(7);
  for (int run = 0; run < 1000; ++run) {
    const auto any = [&] {
      return Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)} *
             (random.below(2) ? 1 : 1e6);
    };
    const Vec3 x = any(), y = any(), origin = any();
    const auto fit = fitFrame(origin, x, y);
    if (!fit) continue;
    REQUIRE(isSound(fit->frame));
    for (const Vec2 p : {Vec2{3, 0}, Vec2{0, -5}, Vec2{2, 7}}) {
      const Vec3 world = origin + x * p.x + y * p.y;
      const double tolerance = 1e-13 * (length(x) + length(y) + length(origin));
      REQUIRE(distance(fit->frame.toWorld((*fit)(p)), world) <= 10 * tolerance);
    }
    const auto again = fitFrame(fit->frame.origin, fit->frame.x, fit->frame.y);
    REQUIRE(again);
    REQUIRE(again->even);
  }
}

TEST_CASE("placement: a normal is a unit vector after one step, and stays to the bit",
          "[placement]") {
  Random random(8);
  for (int run = 0; run < 1000; ++run) {
    const double size = run % 3 == 0 ? 1e-200 : run % 3 == 1 ? 1 : 1e200;
    const Vec3 normal =
        Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)} * size;
    const Plane plane{normal, random.between(-100, 100) * size};
    const auto unit = normalised(plane);
    REQUIRE(unit);
    REQUIRE(isUnit(*unit));
    REQUIRE(*normalised(*unit) == *unit);
    REQUIRE(unit->offset * length(normal / size) == Approx(plane.offset / size));
  }
  REQUIRE_FALSE(normalised({{0, 0, 0}, 1}));
  REQUIRE_FALSE(normalised({{HUGE_VAL, 0, 0}, 1}));
  REQUIRE_FALSE(normalised({{1, std::nan(""), 0}, 1}));
  REQUIRE_FALSE(normalised({{1, 0, 0}, 1e51}));
  REQUIRE_FALSE(normalised({{1e-60, 0, 0}, 1}));
}

TEST_CASE("placement: a plane goes where its points go", "[placement]") {
  Random random(9);
  for (int run = 0; run < 500; ++run) {
    const Vec3 point{random.between(-50, 50), random.between(-50, 50), random.between(-50, 50)};
    const Plane plane = randomPlane(random, point);
    const Affine map = anyMap(random);
    const auto after = mapped(plane, map);
    REQUIRE(after);
    REQUIRE(isUnit(*after));
    for (int i = 0; i < 3; ++i) {
      const Vec3 any = point + randomRotation(random).x * 40;
      const Vec3 on = any - plane.normal * distance(plane, any);
      REQUIRE(std::fabs(distance(*after, map(on))) < 1e-9);
      const Vec3 before = on + plane.normal;
      REQUIRE(distance(*after, map(before)) > 0);
    }
  }
}

TEST_CASE("placement: a map seen in the mirror does to images what it does to things",
          "[placement]") {
  Random random(10);
  for (int run = 0; run < 500; ++run) {
    const Plane plane = randomPlane(random, {random.between(-50, 50), 0, 9});
    Affine map = anyMap(random);
    if (run % 4 == 0) map = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, map.move};
    const Affine seen = mirrored(map, plane);
    const Vec3 p{random.between(-50, 50), random.between(-50, 50), random.between(-50, 50)};
    requireNear(seen(mirrored(p, plane)), mirrored(map(p), plane));
  }
}

TEST_CASE("placement: a map and its inverse put a character back", "[placement]") {
  Random random(11);
  for (int run = 0; run < 30; ++run) {
    const Document document = randomCreature(random, 2 + random.below(20), {20});
    const Affine map = randomSimilarity(random);
    const Ids all = allPlacedIds(document);
    auto there = apply(document, TransformParts{all, map});
    REQUIRE(there);
    auto back = apply(*there, TransformParts{all, inverseOfSimilarity(map)});
    REQUIRE(back);
    for (size_t i = 0; i < document.parts.size(); ++i) {
      const PartSource &a = *document.parts[i], &b = *back->parts[i];
      REQUIRE(a.stroke == b.stroke);
      requireNear(b.frame.origin, a.frame.origin, 1e-8);
      requireNear(b.frame.x, a.frame.x);
      requireNear(b.frame.y, a.frame.y);
    }
    if (document.symmetry) requireNear(back->symmetry->normal, document.symmetry->normal);
  }
}
