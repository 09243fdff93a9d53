#include "document/placed_parts.h"

#include "document/command.h"
#include "support/catch.h"
#include "support/creatures.h"

using namespace marrow;

namespace {

PartSource square(Vec2 middle) {
  PartSource part;
  part.id = "part-1";
  for (const Vec2 p : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
    part.stroke.push_back(middle + p);
  }
  return part;
}

std::string sides(PartSource part, Plane plane) {
  part.mirror = plane;
  Document document;
  document.parts.push_back(std::make_shared<const PartSource>(part));
  std::string sides;
  for (const PlacedPart& placed : placedParts(document)) sides += placed.side;
  return sides;
}

}  // namespace

TEST_CASE("placed parts: each part in modelling order, its twin after it", "[placed_parts]") {
  Random random(1);
  for (int run = 0; run < 100; ++run) {
    const Document document = randomCreature(random, 1 + random.below(30), {20});
    const auto placed = placedParts(document);
    size_t k = 0;
    for (size_t i = 0; i < document.parts.size(); ++i) {
      const PartSource& part = *document.parts[i];
      REQUIRE(placed.at(k).id == part.id);
      REQUIRE(placed[k].source == i);
      REQUIRE_FALSE(placed[k].twin);
      REQUIRE(placed[k].frame == part.frame);
      REQUIRE((placed[k].side != 0) == part.mirror.has_value());
      ++k;
      if (!part.mirror) continue;
      REQUIRE(placed.at(k).id == part.id + ":twin");
      REQUIRE(placed[k].source == i);
      REQUIRE(placed[k].twin);
      REQUIRE(placed[k].side + placed[k - 1].side == 'L' + 'R');
      for (const Vec2 p : part.stroke) {
        const Vec3 image = mirrored(part.frame.toWorld(p), *part.mirror);
        REQUIRE(distance(placed[k].frame.toWorld(p), image) < 1e-9);
      }
      ++k;
    }
    REQUIRE(k == placed.size());
  }
}

TEST_CASE("placed parts: left is at positive x, as the character looks at the viewer",
          "[placed_parts]") {
  const Plane plane{{1, 0, 0}, 0}, turned{{-1, 0, 0}, 0};
  REQUIRE(sides(square({5, 0}), plane) == "LR");
  REQUIRE(sides(square({-5, 0}), plane) == "RL");
  REQUIRE(sides(square({5, 0}), turned) == "LR");
  REQUIRE(sides(square({-5, 0}), turned) == "RL");
  REQUIRE(sides(square({5, 0}), {{1, 0, 0}, -20}) == "RL");

  PartSource from_side = square({});
  from_side.frame.origin = {0, 0, 7};
  REQUIRE(sides(from_side, {{0, 0, 1}, 0}) == "LR");
  REQUIRE(sides(from_side, {{0, 0, -1}, 0}) == "LR");
  REQUIRE(sides(from_side, {{0, 0, -1}, 8}) == "RL");
}

TEST_CASE("placed parts: an id tells whose twin it is", "[placed_parts]") {
  REQUIRE(sourceId("part-3") == "part-3");
  REQUIRE(sourceId("part-3:twin") == "part-3");
  REQUIRE(sourceId(":twin").empty());
  REQUIRE(sourceId("").empty());
  REQUIRE(isTwinId("part-3:twin"));
  REQUIRE_FALSE(isTwinId("part-3"));
  REQUIRE_FALSE(isTwinId("part-3:twins"));
  REQUIRE_FALSE(isTwinId("twin"));
}
