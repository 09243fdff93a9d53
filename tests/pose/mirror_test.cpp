// What is opposite what on a rig, and poses seen in the mirror.
#include "pose/mirror.h"

#include "document/command.h"
#include "document/evaluation.h"
#include "document/symmetry.h"
#include "pose/pose.h"
#include "pose/rigs.h"
#include "support/catch.h"
#include "support/samples.h"

namespace marrow {
namespace {

bool near(Vec3 a, Vec3 b, double by = 1e-9) { return distance(a, b) < by * (1 + length(a)); }

/// A part with a twin, and bones of both.
struct Twins {
  Document document;
  Rig rig;
  uint32_t count = 0;  // of joints; behind them as many of the twin

  Twins(Random& random, const Plane& plane, int joints) {
    auto part = std::make_shared<PartSource>();
    part->id = "part-1";
    part->mirror = plane;
    document.parts.push_back(part);
    rig = randomRig(random, joints);
    count = static_cast<uint32_t>(rig.joints.size());
    for (uint32_t i = 0; i < count; ++i) {
      rig.joints[i].radius = 0.01;
      Rig::Joint image = rig.joints[i];
      image.id = "part-1:twin" + image.id.substr(6);
      image.position = mirrored(image.position, plane);
      image.part = 1;
      if (image.parent >= 0) {
        image.parent += static_cast<int32_t>(count);
        rig.bones.push_back({static_cast<uint32_t>(image.parent), i + count});
      }
      rig.joints.push_back(image);
    }
  }
};

/// A body with a head, arms and legs in one stroke, as it is drawn by hand: the left half is not
/// quite the mirror image of the right one.
Document drawnInOne(Random& random, double unrest) {
  const std::vector<Vec2> half{{18, 150}, {45, 120}, {24, 90},   {70, 84},   {165, 90}, {172, 62},
                               {60, 48},  {44, -20}, {66, -180}, {30, -186}, {10, -60}};
  AddPart part;
  part.stroke = half;
  for (auto p = half.rbegin(); p != half.rend(); ++p) {
    part.stroke.push_back({-p->x * (1 + random.between(-unrest, unrest)),
                           p->y * (1 + random.between(-unrest, unrest))});
  }
  // Points along the way, as a hand leaves them.
  std::vector<Vec2> fine;
  for (size_t i = 0; i < part.stroke.size(); ++i) {
    const Vec2 from = part.stroke[i], to = part.stroke[(i + 1) % part.stroke.size()];
    for (int k = 0; k < 8; ++k) fine.push_back(lerp(from, to, k / 8.));
  }
  part.stroke = fine;
  Document document = *apply({}, part);
  document.symmetry = Plane{{1, 0, 0}, 0};
  return document;
}

std::vector<Vec3> places(const Rig& rig, const Pose& pose) {
  std::vector<Vec3> places;
  const auto motions = posed(rig, pose);
  for (size_t i = 0; i < motions.size(); ++i) places.push_back(motions[i](rig.joints[i].position));
  return places;
}

double furthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}

/// The joint furthest to the right, or to the left.
uint32_t hand(const Rig& rig, double side) {
  uint32_t best = 0;
  for (uint32_t i = 0; i < rig.joints.size(); ++i) {
    if (rig.joints[i].position.x * side > rig.joints[best].position.x * side) best = i;
  }
  return best;
}

/// Up to the joint before the plane, each bent a little.
Pose raised(const Rig& rig, uint32_t hand, double side) {
  Pose pose;
  for (int32_t up = rig.joints[hand].parent; up >= 0;
       up = rig.joints[static_cast<size_t>(up)].parent) {
    const Rig::Joint& joint = rig.joints[static_cast<size_t>(up)];
    if (joint.position.x * side < 30) break;
    pose[joint.id].rotation = normalised({0, 0, 0.3 * side, 1});
  }
  return pose;
}

double sizeOf(const Rig& rig) {
  double most = 0;
  for (const auto& joint : rig.joints) {
    most = std::max(most, distance(joint.position, rig.joints[0].position));
  }
  return most;
}

}  // namespace

TEST_CASE("mirror: seen in the mirror, a mirrored pose is the pose", "[mirror]") {
  Random random(6);
  for (int run = 0; run < 20; ++run) {
    const Plane plane = randomPlane(random, {});
    const Twins both(random, plane, 12);
    Pose pose = randomPose(random, both.rig);
    const std::vector<Rigid> left = posed(both.rig, pose);
    const Pose image = mirroredPose(both.document, both.rig, pose, plane);
    const std::vector<Rigid> right = posed(both.rig, image);
    for (uint32_t i = 0; i < 2 * both.count; ++i) {
      const Vec3 p{random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)};
      const uint32_t other = (i + both.count) % (2 * both.count);
      CHECK(near(right[other](mirrored(p, plane)), mirrored(left[i](p), plane)));
    }
    const Pose again = mirroredPose(both.document, both.rig, image, plane);
    REQUIRE(again.size() == pose.size());
    for (const auto& [id, motion] : pose) {
      REQUIRE(again.count(id));
      CHECK(std::abs(dot(again.at(id).rotation, motion.rotation)) > 1 - 1e-12);
      CHECK(near(again.at(id).move, motion.move));
    }
  }
}

TEST_CASE("mirror: a joint's partner is the one at its mirror place, of the same part",
          "[mirror]") {
  Random random(8);
  for (int run = 0; run < 20; ++run) {
    const Plane plane = randomPlane(random, {});
    Twins both(random, plane, 12);
    Rig& rig = both.rig;
    Rig::Joint alone = rig.joints[0];  // another part's, in the same place
    alone.part = 2;
    rig.joints.push_back(alone);
    const std::vector<PlacedPart> placed{
        {"part-1", 0, false, {}}, {"part-1:twin", 0, true, {}}, {"part-2", 1, false, {}}};
    const std::vector<uint32_t> partners = mirrorPartners(rig, placed, plane);
    REQUIRE(partners.size() == rig.joints.size());
    for (uint32_t i = 0; i < 2 * both.count; ++i) {
      const Vec3 wanted = mirrored(rig.joints[i].position, plane);
      REQUIRE(partners[i] < 2 * both.count);
      CHECK(distance(rig.joints[partners[i]].position, wanted) < 0.01);
      CHECK(partners[partners[i]] == i);
    }
    CHECK(partners.back() == kNoPartner);
  }
}

TEST_CASE("mirror: two joints never become one, and what is left over loses no bend", "[mirror]") {
  // Across x = 0: left an arm of five bones, right one of three, both from the middle.
  Rig rig;
  const auto add = [&](double x, int32_t parent) {
    Rig::Joint joint;
    joint.id = "part-1/b0." + std::to_string(rig.joints.size());
    joint.position = {x, 0, 0};
    joint.radius = 12;
    joint.parent = parent;
    const auto own = static_cast<uint32_t>(rig.joints.size());
    if (parent >= 0) rig.bones.push_back({static_cast<uint32_t>(parent), own});
    rig.joints.push_back(joint);
    return static_cast<int32_t>(own);
  };
  const int32_t middle = add(0, -1);
  int32_t last = middle;
  for (const double x : {-20., -40., -60., -80., -100.}) last = add(x, last);
  const auto left = static_cast<uint32_t>(last);
  last = middle;
  for (const double x : {33., 66., 100.}) last = add(x, last);
  const auto right = static_cast<uint32_t>(last);
  Document document;
  document.parts.push_back(std::make_shared<PartSource>());
  const Plane plane{{1, 0, 0}, 0};
  Pose pose;
  for (size_t i = 1; i < 5; ++i) {
    pose[rig.joints[i].id].rotation = normalised({0, 0, 0.2, 1});
  }
  const Pose image = mirroredPose(document, rig, pose, plane);
  // The hand on the other side turns as far as this one did; this one is at rest.
  const auto before = posed(rig, pose), after = posed(rig, image);
  CHECK(near(after[left]({1, 2, 3}), {1, 2, 3}));
  const Vec3 wanted = mirroredDirection(before[left].direction({1, 0, 0}), plane);
  CHECK(near(after[right].direction({-1, 0, 0}), wanted));
  const auto partners = mirrorPartners(rig, {{"part-1", 0, false, {}}}, plane);
  size_t mutual = 0;
  for (uint32_t i = 0; i < partners.size(); ++i) {
    REQUIRE(partners[i] != kNoPartner);
    mutual += partners[partners[i]] == i;
  }
  CHECK(mutual >= 4);
}

TEST_CASE("mirror: of a body drawn in one stroke, a raised arm is raised on the other side",
          "[mirror]") {
  Random random(3);
  for (int run = 0; run < 12; ++run) {
    const double unrest = run < 2 ? 0 : 0.05;
    const Document document = drawnInOne(random, unrest);
    Evaluation evaluation{previewOptions()};
    evaluation.update(document);
    const Rig& rig = evaluation.rig();
    const Plane plane = *document.symmetry;
    const double size = sizeOf(rig);
    for (const double side : {-1., 1.}) {
      const uint32_t own = hand(rig, side), other = hand(rig, -side);
      const Pose pose = raised(rig, own, side);
      REQUIRE_FALSE(pose.empty());
      const Pose image = mirroredPose(document, rig, pose, plane);
      const auto rest = places(rig, {}), before = places(rig, pose), after = places(rig, image);
      CAPTURE(run, side, size);
      REQUIRE(distance(before[own], rest[own]) > 0.15 * size);
      CHECK(distance(after[own], rest[own]) < 0.02 * size);
      CHECK(distance(after[other], mirrored(before[own], plane)) < 0.12 * size);
      const auto again = places(rig, mirroredPose(document, rig, image, plane));
      // Where an arm of two joints has become one of a single joint, so it stays.
      CHECK(furthest(again, before) < 0.12 * size);
    }
  }
}

TEST_CASE("mirror: twice it is the pose again, on the samples and on random creatures",
          "[mirror]") {
  Random random(4);
  std::vector<Document> documents;
  for (const SampleFile& sample : sampleFiles()) documents.push_back(sample.document);
  for (int run = 0; run < 10; ++run) documents.push_back(randomCreature(random, 4));
  size_t symmetric = 0;
  for (const Document& document : documents) {
    const auto plane = symmetryPlane(document);
    if (!plane) continue;
    Evaluation evaluation{previewOptions()};
    evaluation.update(document);
    const Rig& rig = evaluation.rig();
    if (rig.joints.empty()) continue;
    const auto partners = mirrorPartners(rig, evaluation.placed(), *plane);
    bool all_mutual = true;
    for (uint32_t i = 0; i < partners.size(); ++i) {
      // A joint without one keeps its motion, which is the same twice as well.
      all_mutual = all_mutual && (partners[i] == kNoPartner || partners[partners[i]] == i);
    }
    const Pose pose = randomPose(random, rig);
    const Pose image = mirroredPose(document, rig, pose, *plane);
    const Pose again = mirroredPose(document, rig, image, *plane);
    if (!all_mutual) continue;
    ++symmetric;
    const auto before = places(rig, pose), after = places(rig, again);
    CHECK(furthest(before, after) < 1e-6 * (1 + sizeOf(rig)));
    if (image.size() != pose.size()) continue;  // a tree that begins at one side
    REQUIRE(again.size() == pose.size());
    for (const auto& [id, motion] : pose) {
      REQUIRE(again.count(id));
      CHECK(std::abs(dot(again.at(id).rotation, motion.rotation)) > 1 - 1e-9);
      CHECK(near(again.at(id).move, motion.move));
    }
  }
  CHECK(symmetric > documents.size() / 2);
}

TEST_CASE("mirror: what a coarser rig does not have stays in the pose", "[mirror]") {
  Random random(5);
  Document document = drawnInOne(random, 0);
  AddPart leg{unitCircle(40)};
  for (Vec2& p : leg.stroke) p = {20 * p.x, 80 * p.y};
  leg.frame.origin = {60, -220, 0};
  leg.mirror = document.symmetry;
  document = *apply(document, leg);
  const Plane plane = *document.symmetry;
  Pose pose;
  const JointMotion turn{normalised({0.1, 0.2, 0.3, 1}), {1, 2, 3}};
  Evaluation evaluation{previewOptions()};
  evaluation.update(document);
  pose["part-2/b0.999999"] = turn;
  pose["part-1/gone"] = turn;
  pose["elsewhere"] = turn;
  pose[evaluation.rig().joints[1].id] = turn;
  const Pose image = mirroredPose(document, evaluation.rig(), pose, plane);
  CHECK(image.size() == 4);
  REQUIRE(image.count("part-2:twin/b0.999999"));
  CHECK(image.at("part-2:twin/b0.999999").move == mirroredDirection(turn.move, plane));
  REQUIRE(image.count("part-1/gone"));
  CHECK(image.at("elsewhere") == turn);
  const Pose again = mirroredPose(document, evaluation.rig(), image, plane);
  CHECK(again.size() == 4);
  for (const auto& [id, motion] : pose) {
    REQUIRE(again.count(id));
    CHECK(near(again.at(id).move, motion.move));
  }
  // Of a branch in the plane they are mirrored where they are: a body seen from its side.
  AddPart trunk{unitCircle(40)};
  for (Vec2& p : trunk.stroke) p = {200 * p.x, 40 * p.y};
  const Document side = *apply({}, trunk);
  const Plane flat = *symmetryPlane(side);
  Evaluation other{previewOptions()};
  other.update(side);
  REQUIRE(other.rig().joints.size() > 2);
  const Pose lost{{"part-1/b0.999999", turn}};
  CHECK(mirroredPose(side, other.rig(), lost, flat).at("part-1/b0.999999").move ==
        mirroredDirection(turn.move, flat));
}

TEST_CASE("mirror: the opposite of the opposite joint is the joint, across any plane", "[mirror]") {
  Random random(7);
  for (int run = 0; run < 12; ++run) {
    const Document document = run < 6 ? randomCreature(random, 5) : drawnInOne(random, 0.1);
    Evaluation evaluation{previewOptions()};
    evaluation.update(document);
    Rig rig = evaluation.rig();
    OppositeJoints opposite(document, rig);
    for (int k = 0; k < 4; ++k) {
      Plane plane = randomPlane(random, {random.between(-50, 50), 0, 0});
      if (k == 3) plane = {{0, 0, 1}, 1e50};
      for (const Rig::Joint& joint : rig.joints) {
        const std::string other = opposite.of(joint.id, plane);
        if (opposite.of(other, plane) != joint.id) FAIL(joint.id << " and " << other);
      }
    }
    // All in one place, and of no size: nothing breaks.
    for (Rig::Joint& joint : rig.joints) {
      joint.position = {};
      joint.radius = 0;
    }
    const Plane middle{{1, 0, 0}, 0};
    for (const uint32_t partner : mirrorPartners(rig, evaluation.placed(), middle)) {
      CHECK((partner == kNoPartner || partner < rig.joints.size()));
    }
    const Pose pose = randomPose(random, rig);
    for (const auto& [id, motion] : mirroredPose(document, rig, pose, middle)) {
      CHECK(std::isfinite(length(motion.move)));
      CHECK(std::abs(dot(motion.rotation, motion.rotation) - 1) < 1e-9);
    }
  }
  CHECK(mirrorPartners({}, {}, {}).empty());
  CHECK(mirroredPose({}, {}, {}, {}).empty());
}

}  // namespace marrow
