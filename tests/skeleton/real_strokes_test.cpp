#include "skeleton/checks.h"
#include "skeleton/joints.h"
#include "sketch/outline.h"
#include "support/catch.h"
#include "support/strokes.h"

namespace marrow {

TEST_CASE("joints: real strokes get a sound skeleton of a few dozen joints", "[joints]") {
  const auto strokes = strokes::realStrokes();
  if (strokes.empty()) {
    WARN("the real strokes are not there");
    return;
  }
  for (const auto& stroke : strokes) {
    INFO(stroke.name);
    const auto outline = makeOutline(stroke.points);
    REQUIRE(outline);
    const auto straight = straightSkeleton(outline->polygon);
    REQUIRE(straight);
    const auto axis = extractAxis(outline->polygon, *straight);
    REQUIRE(axis);
    const auto skeleton = placeJoints(outline->polygon, *axis, outline->scale());
    REQUIRE(skeleton);
    std::vector<Vec2> positions;
    for (const auto& joint : skeleton->joints) positions.push_back(joint.position);
    CHECK(treeFault(outline->polygon, positions, skeleton->bones) == "");
    CHECK(positions.size() < 70);
  }
}

}  // namespace marrow
