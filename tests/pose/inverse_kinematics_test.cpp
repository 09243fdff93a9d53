#include "pose/inverse_kinematics.h"

#include <limits>

#include "pose/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

Vec3 placeOf(const Rig& rig, const Pose& pose, uint32_t joint) {
  return posed(rig, pose)[joint](rig.joints[joint].position);
}

bool bonesKeepLengths(const Rig& rig, const Pose& pose) {
  const std::vector<Rigid> motions = posed(rig, pose);
  for (const auto& [a, b] : rig.bones) {
    const double rest = distance(rig.joints[a].position, rig.joints[b].position);
    const double now =
        distance(motions[a](rig.joints[a].position), motions[b](rig.joints[b].position));
    if (!(std::abs(now - rest) < 1e-7 * (1 + rest))) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("reach: what is within reach is reached, and the root stays", "[reach]") {
  Random random(1);
  for (int run = 0; run < 200; ++run) {
    CAPTURE(run);
    const int joints = 3 + random.below(10);
    const Rig rig = chainRig(joints, 20);
    const auto end = static_cast<uint32_t>(joints - 1);
    const double reach_of_all = 20 * (joints - 1);
    const Vec3 target = randomRotation(random).x * (reach_of_all * random.between(0.3, 0.95));
    const Pose pose = reach(rig, {}, end, target, {});
    CHECK(distance(placeOf(rig, pose, end), target) < 0.02 * reach_of_all);
    CHECK(placeOf(rig, pose, 0) == rig.joints[0].position);
    CHECK(bonesKeepLengths(rig, pose));
  }
}

TEST_CASE("reach: out of reach the chain stretches towards the target, no further", "[reach]") {
  const Rig rig = chainRig(5, 10);
  const Pose pose = reach(rig, {}, 4, {300, 0, 400}, {});
  CHECK(distance(placeOf(rig, pose, 4), Vec3{24, 0, 32}) < 1e-6);
  CHECK(bonesKeepLengths(rig, pose));
}

TEST_CASE("reach: a chain pushed along itself bends", "[reach]") {
  const Rig rig = chainRig(6, 10);
  const Pose pose = reach(rig, {}, 5, {0, 25, 0}, {});
  CHECK(distance(placeOf(rig, pose, 5), Vec3{0, 25, 0}) < 1);
  CHECK(bonesKeepLengths(rig, pose));
}

TEST_CASE("reach: pins above hold the rest, pins below are held", "[reach]") {
  Random random(2);
  const Rig rig = chainRig(9, 10);
  for (int run = 0; run < 50; ++run) {
    CAPTURE(run);
    const Vec3 nearby = placeOf(rig, {}, 6) + randomRotation(random).x * random.between(1, 12);
    const Pose above = reach(rig, {}, 6, nearby, {3});
    for (uint32_t joint = 0; joint <= 3; ++joint) {
      CHECK(distance(placeOf(rig, above, joint), rig.joints[joint].position) < 1e-9);
    }
    // The middle is dragged a little: the pinned end stays where it was.
    const Vec3 aside =
        placeOf(rig, {}, 4) + Vec3{random.between(-8, 8), -12, random.between(-8, 8)};
    const Pose bent = reach(rig, {}, 8, {10, 60, 5}, {});
    const Vec3 end = placeOf(rig, bent, 8);
    const Pose below = reach(rig, bent, 4, aside, {8});
    CHECK(distance(placeOf(rig, below, 8), end) < 1);
    CHECK(bonesKeepLengths(rig, below));
  }
}

TEST_CASE("reach: a dragged root moves everything, but for what is pinned", "[reach]") {
  const Rig rig = chainRig(7, 10);
  const Pose moved = reach(rig, {}, 0, {5, 3, 0}, {});
  for (uint32_t joint = 0; joint < 7; ++joint) {
    CHECK(distance(placeOf(rig, moved, joint), rig.joints[joint].position + Vec3{5, 3, 0}) < 1e-9);
  }
  const Pose squat = reach(rig, {}, 0, {0, 20, 0}, {6});
  CHECK(distance(placeOf(rig, squat, 6), rig.joints[6].position) < 1);
  CHECK(distance(placeOf(rig, squat, 0), Vec3{0, 20, 0}) < 1e-9);
  CHECK(bonesKeepLengths(rig, squat));
}

TEST_CASE("reach: a joint dragged to where it is changes nothing, nor is what holds still bent",
          "[reach]") {
  Random random(11);
  for (int run = 0; run < 200; ++run) {
    CAPTURE(run);
    const Rig rig = randomRig(random, 4 + random.below(14));
    const Pose pose = randomPose(random, rig);
    const auto joint =
        1 + static_cast<uint32_t>(random.below(static_cast<int>(rig.joints.size()) - 1));
    std::vector<uint32_t> pins;
    for (uint32_t pin = 1; pin < rig.joints.size(); ++pin) {
      if (random.below(3) == 0) pins.push_back(pin);
    }
    CHECK(reach(rig, pose, joint, placeOf(rig, pose, joint), pins) == pose);
  }
}

TEST_CASE("reach: a hand that goes to and fro leaves the pinned spine as it is", "[reach]") {
  Rig rig = chainRig(8, 30);  // the spine: 0 … 4; the arm: 5 … 7
  for (uint32_t i = 5; i < 8; ++i) {
    rig.joints[i].position = {30.0 * (i - 4), i == 6 ? 95.0 : 120.0, 0};
  }
  Pose pose;
  for (int drag = 0; drag < 200; ++drag) {
    const double way = drag % 2 == 0 ? 3 : -3;
    pose = reach(rig, pose, 7, placeOf(rig, pose, 7) + Vec3{0, way, 0}, {4});
  }
  for (uint32_t joint = 0; joint <= 4; ++joint) {
    CHECK(distance(placeOf(rig, pose, joint), rig.joints[joint].position) < 1e-9);
  }
  CHECK(distance(placeOf(rig, pose, 7), rig.joints[7].position) < 0.5);
}

TEST_CASE("reach: in any skeleton and pose nothing breaks", "[reach]") {
  Random random(3);
  for (int run = 0; run < 200; ++run) {
    CAPTURE(run);
    const Rig rig = randomRig(random, 1 + random.below(60));
    const Pose start = randomPose(random, rig);
    const auto any = [&] {
      return static_cast<uint32_t>(random.below(static_cast<int>(rig.joints.size())));
    };
    std::vector<uint32_t> pins;
    for (int i = random.below(5); i > 0; --i) pins.push_back(any());
    pins.push_back(1000);
    const uint32_t joint = any();
    const Vec3 target = run % 7 == 0 ? placeOf(rig, start, joint)
                                     : randomRotation(random).y * random.between(0, 500);
    const Pose pose = reach(rig, start, joint, target, pins);
    CHECK(bonesKeepLengths(rig, pose));
    CHECK(reach(rig, start, joint, target, pins) == pose);
  }
  const Rig rig = chainRig(3, 10);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  CHECK(reach(rig, {}, 2, {nowhere, 0, 0}, {}).empty());
  CHECK(reach(rig, {}, 7, {1, 2, 3}, {}).empty());
}

}  // namespace marrow
