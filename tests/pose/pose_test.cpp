#include "pose/pose.h"

#include "pose/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

Vec3 columnOf(const Quaternion& q, int axis) {
  return rotated(q, {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
}

bool near(Vec3 a, Vec3 b, double by = 1e-9) { return distance(a, b) < by * (1 + length(a)); }

}  // namespace

TEST_CASE("quaternion: a rotation is that of its matrix, and back", "[pose]") {
  Random random(1);
  for (int run = 0; run < 500; ++run) {
    const Affine turn = randomRotation(random);
    const Quaternion q = rotationTo(turn.x, turn.y, turn.z);
    const Vec3 v{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    CHECK(near(rotated(q, v), turn(v)));
    CHECK(std::abs(dot(q, q) - 1) < 1e-12);
    const Affine other = randomRotation(random);
    const Quaternion p = rotationTo(other.x, other.y, other.z);
    CHECK(near(rotated(q * p, v), turn(other(v))));
    CHECK(near(rotated(conjugate(q), turn(v)), v));
  }
}

TEST_CASE("quaternion: the shortest rotation takes one direction to the other", "[pose]") {
  Random random(2);
  for (int run = 0; run < 500; ++run) {
    const Vec3 a = randomRotation(random).x * random.between(0.1, 50);
    Vec3 b = randomRotation(random).y * random.between(0.1, 50);
    if (run % 5 == 0) b = a * 3;
    if (run % 5 == 1) b = a * -2;
    const Quaternion q = between(a, b);
    CHECK(near(rotated(q, a / length(a)), b / length(b), 1e-6));
    // Nothing turns about the axis: what is at right angles to both stays.
    const Vec3 normal = cross(a, b);
    if (length(normal) > 1e-6 * length(a) * length(b))
      CHECK(near(rotated(q, normal), normal, 1e-6));
  }
  CHECK(between({}, {1, 0, 0}) == Quaternion{});
}

TEST_CASE("pose: without motions everything rests", "[pose]") {
  Random random(3);
  const Rig rig = randomRig(random, 30);
  for (const Rigid& motion : posed(rig, {})) CHECK(motion({1, 2, 3}) == Vec3{1, 2, 3});
  const Pose elsewhere{{"part-9/n9", {{0, 0, 0.6, 0.8}, {5, 5, 5}}}};
  for (const Rigid& motion : posed(rig, elsewhere)) CHECK(motion({1, 2, 3}) == Vec3{1, 2, 3});
}

TEST_CASE("pose: bones keep their lengths, and only what hangs on a joint follows it", "[pose]") {
  Random random(4);
  for (int run = 0; run < 50; ++run) {
    const Rig rig = randomRig(random, 2 + random.below(40));
    const Pose pose = randomPose(random, rig);
    const std::vector<Rigid> motions = posed(rig, pose);
    const auto place = [&](uint32_t joint) { return motions[joint](rig.joints[joint].position); };
    for (const auto& [a, b] : rig.bones) {
      const double rest = distance(rig.joints[a].position, rig.joints[b].position);
      CHECK(std::abs(distance(place(a), place(b)) - rest) < 1e-9 * (1 + rest));
    }
    // One more joint turned: who is not below it does not move.
    const auto turned = static_cast<uint32_t>(random.below(static_cast<int>(rig.joints.size())));
    Pose more = pose;
    more[rig.joints[turned].id].rotation = normalised({0.3, -0.2, 0.5, 0.7});
    const std::vector<Rigid> after = posed(rig, more);
    for (uint32_t joint = 0; joint < rig.joints.size(); ++joint) {
      bool below = false;
      for (int32_t up = static_cast<int32_t>(joint); up >= 0;
           up = rig.joints[static_cast<size_t>(up)].parent) {
        below = below || up == static_cast<int32_t>(turned);
      }
      if (!below) CHECK(after[joint]({1, 2, 3}) == motions[joint]({1, 2, 3}));
    }
    CHECK(near(after[turned](rig.joints[turned].position), place(turned)));
  }
}

TEST_CASE("pose: mixed poses go from one to the other", "[pose]") {
  Random random(5);
  const Rig rig = randomRig(random, 20);
  const Pose a = randomPose(random, rig), b = randomPose(random, rig);
  const auto same = [&](const Pose& one, const Pose& two) {
    const std::vector<Rigid> first = posed(rig, one), second = posed(rig, two);
    bool all = true;
    for (size_t i = 0; i < first.size(); ++i) {
      all = all && near(first[i]({3, 4, 5}), second[i]({3, 4, 5}));
    }
    return all;
  };
  CHECK(same(mixed(a, b, 0), a));
  CHECK(same(mixed(a, b, 1), b));
  CHECK_FALSE(same(mixed(a, b, 0.5), a));
  CHECK(same(mixed(a, b, 0.25), mixed(b, a, 0.75)));
}

TEST_CASE("pose: a joint turns in space, about where it is", "[pose]") {
  Random random(9);
  for (int run = 0; run < 50; ++run) {
    const Rig rig = randomRig(random, 2 + random.below(30));
    const Pose pose = randomPose(random, rig);
    const auto joint = static_cast<uint32_t>(random.below(static_cast<int>(rig.joints.size())));
    const Affine turn = randomRotation(random);
    const std::vector<Rigid> before = posed(rig, pose);
    const std::vector<Rigid> after =
        posed(rig, turned(rig, pose, joint, rotationTo(turn.x, turn.y, turn.z)));
    const Vec3 middle = before[joint](rig.joints[joint].position);
    for (const auto& [a, b] : rig.bones) {
      if (a != joint) continue;
      const Vec3 was = before[a](rig.joints[b].position);
      CHECK(near(after[a](rig.joints[b].position), middle + turn(was - middle), 1e-8));
    }
    CHECK(near(after[joint](rig.joints[joint].position), middle));
  }
  const Rig rig = randomRig(random, 3);
  CHECK(turned(rig, {}, 99, {}).empty());
}

TEST_CASE("pose: joints that rest are left out, and nothing moves by it", "[pose]") {
  Random random(10);
  const Rig rig = randomRig(random, 20);
  Pose pose = randomPose(random, rig);
  const std::vector<Rigid> before = posed(rig, pose);
  const size_t moved = withoutResting(pose).size();
  for (const Rig::Joint& joint : rig.joints) pose.emplace(joint.id, JointMotion{});
  CHECK(withoutResting(pose).size() == moved);
  const std::vector<Rigid> after = posed(rig, withoutResting(pose));
  for (size_t i = 0; i < before.size(); ++i) CHECK(after[i]({1, 2, 3}) == before[i]({1, 2, 3}));
}

TEST_CASE("pose: at rest y lies along a bone that goes on from the joint", "[pose]") {
  Random random(7);
  for (int run = 0; run < 50; ++run) {
    const Rig rig = randomRig(random, 2 + random.below(40));
    const std::vector<Quaternion> axes = restAxes(rig);
    for (uint32_t joint = 0; joint < rig.joints.size(); ++joint) {
      CHECK(std::abs(dot(axes[joint], axes[joint]) - 1) < 1e-9);
      bool is_end = true, along = false;
      for (const auto& [a, b] : rig.bones) {
        if (a != joint) continue;
        is_end = false;
        const Vec3 way = rig.joints[b].position - rig.joints[a].position;
        along = along || near(columnOf(axes[joint], 1), way / length(way), 1e-6);
      }
      CHECK((is_end || along));
    }
  }
}

}  // namespace marrow
