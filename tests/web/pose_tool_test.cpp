// What a press takes hold of, and what dragging it does.
#include "tools/pose_tool.h"

#include "pose/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

constexpr ViewSize kSize{800, 600};

/// Joints every 50 units to the right, 10 thick.
Rig chain(size_t joints) {
  Rig rig;
  for (size_t i = 0; i < joints; ++i) {
    Rig::Joint joint;
    joint.id = "j" + std::to_string(i);
    joint.parent = static_cast<int32_t>(i) - 1;
    joint.position = {50.0 * static_cast<double>(i), 0, 0};
    joint.radius = 15;
    rig.joints.push_back(joint);
    if (i > 0) rig.bones.push_back({static_cast<uint32_t>(i - 1), static_cast<uint32_t>(i)});
  }
  rig.roots = {0};
  return rig;
}

Stance standing(const Rig& rig) {
  Stance stance;
  stance.rest = stance.posed = rig;
  return stance;
}

std::optional<uint32_t> grab(const Rig& rig, Vec2 pixel, bool touch = false) {
  return jointToGrab(pixel, standing(rig), Camera{}, kSize, touch);
}

Vec3 placeOf(const Stance& stance, const Pose& pose, uint32_t joint) {
  return posed(stance.rest, pose)[joint](stance.rest.joints[joint].position);
}

}  // namespace

TEST_CASE("pose tool: a press takes the joint that is near, or else an end of the limb under it") {
  const Rig rig = chain(4);  // in pixels: from (400, 300) to (550, 300)
  CHECK(grab(rig, {452, 303}) == 1u);
  CHECK(grab(rig, {550, 290}) == 3u);
  CHECK(grab(rig, {481, 300}) == 2u);
  CHECK(grab(rig, {466, 300}) == 1u);
  CHECK(grab(rig, {528, 312}) == 3u);  // on the skin
  CHECK(grab(rig, {418, 300}) == 1u);  // never the root by its limb
  CHECK(grab(rig, {403, 300}) == 0u);
  CHECK_FALSE(grab(rig, {475, 330}));
  CHECK_FALSE(grab(rig, {575, 300}));
  CHECK(grab(rig, {572, 300}, true) == 3u);  // fingers are wider
  CHECK_FALSE(grab({}, {400, 300}));
}

TEST_CASE("pose tool: of two limbs in one place the one in front is taken") {
  for (const double behind : {-40.0, 40.0}) {
    Rig rig = chain(4);
    const Rig other = chain(4);
    for (Rig::Joint joint : other.joints) {
      joint.position.z = behind;
      if (joint.parent >= 0) joint.parent += 4;
      rig.joints.push_back(joint);
    }
    for (const auto& [a, b] : other.bones) rig.bones.push_back({a + 4, b + 4});
    const uint32_t first = behind > 0 ? 4 : 0;
    CHECK(grab(rig, {452, 303}) == first + 1);
    CHECK(grab(rig, {528, 312}) == first + 3);
  }
}

TEST_CASE("pose tool: joints of parts that are hidden cannot be taken") {
  Stance stance = standing(chain(4));
  stance.hidden = {0, 0, 1, 1};
  const auto grabbed = [&](Vec2 pixel) {
    return jointToGrab(pixel, stance, Camera{}, kSize, false);
  };
  CHECK_FALSE(grabbed({550, 300}));
  CHECK_FALSE(grabbed({500, 303}));
  CHECK_FALSE(grabbed({528, 300}));
  CHECK(grabbed({452, 303}) == 1u);
}

TEST_CASE("pose tool: what is pulled comes along, as far as its bones reach") {
  const Rig rig = chain(4);
  PoseTool tool;
  tool.begin(standing(rig), 3, PoseTool::Way::pull, {550, 300}, {}, kSize);
  tool.move({551, 300});
  CHECK_FALSE(tool.changed());
  tool.move({480, 220});
  CHECK(tool.changed());
  CHECK(distance(placeOf(standing(rig), tool.pose(), 3), {80, 80, 0}) < 0.1);
  CHECK_FALSE(tool.outOfReach());
  tool.move({400, 0});
  REQUIRE(tool.outOfReach());
  CHECK(distance(*tool.outOfReach(), {0, 300, 0}) < 1e-9);
  CHECK(distance(placeOf(standing(rig), tool.pose(), 3), {0, 150, 0}) < 0.1);
}

TEST_CASE("pose tool: a limb bends by itself, and takes along what it hangs on where it is short") {
  Rig rig = chain(6);
  for (size_t i = 3; i < 6; ++i) rig.joints[i].part = 1;
  PoseTool tool;
  tool.begin(standing(rig), 5, PoseTool::Way::pull, {650, 300}, {}, kSize);
  tool.move({600, 250});
  CHECK(distance(placeOf(standing(rig), tool.pose(), 5), {200, 50, 0}) < 0.1);
  CHECK(distance(placeOf(standing(rig), tool.pose(), 3), {150, 0, 0}) < 1e-9);
  tool.move({600, 180});
  CHECK(distance(placeOf(standing(rig), tool.pose(), 5), {200, 120, 0}) < 1);
  CHECK(distance(placeOf(standing(rig), tool.pose(), 3), {150, 0, 0}) > 10);
}

TEST_CASE("pose tool: a pinned joint stays where it is") {
  const Rig rig = chain(5);
  Stance stance = standing(rig);
  stance.pins = {2};
  PoseTool tool;
  tool.begin(stance, 4, PoseTool::Way::pull, {600, 300}, {}, kSize);
  tool.move({540, 220});
  CHECK(distance(placeOf(stance, tool.pose(), 2), {100, 0, 0}) < 1e-6);
  CHECK(distance(placeOf(stance, tool.pose(), 1), {50, 0, 0}) < 1e-6);
}

TEST_CASE("pose tool: turning swings the bone about its own beginning") {
  const Rig rig = chain(4);
  PoseTool tool;
  tool.begin(standing(rig), 2, PoseTool::Way::turn, {500, 300}, {}, kSize);
  tool.move({450, 200});
  CHECK(distance(placeOf(standing(rig), tool.pose(), 1), {50, 0, 0}) < 1e-9);
  CHECK(distance(placeOf(standing(rig), tool.pose(), 2), {50, 50, 0}) < 1e-6);
  CHECK(distance(placeOf(standing(rig), tool.pose(), 3), {50, 100, 0}) < 1e-6);
}

TEST_CASE("pose tool: by key a bone turns about an axis, by a number") {
  const Rig rig = chain(3);
  PoseTool tool;
  tool.beginByKey(standing(rig), 2, TransformKind::rotate, {500, 300}, {}, kSize);
  for (const char key : {'y', '9', '0'}) CHECK(tool.key(key));
  CHECK_FALSE(tool.key('q'));
  CHECK(distance(placeOf(standing(rig), tool.pose(), 2), {50, 0, -50}) < 1e-6);
  CHECK(distance(placeOf(standing(rig), tool.pose(), 1), {50, 0, 0}) < 1e-9);

  tool.beginByKey(standing(rig), 0, TransformKind::move, {400, 300}, {}, kSize);
  for (const char key : {'x', '7'}) CHECK(tool.key(key));
  CHECK(distance(placeOf(standing(rig), tool.pose(), 2), {107, 0, 0}) < 1e-9);
}

}  // namespace marrow
