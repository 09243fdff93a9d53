// Poses outlive what is done to the parts that they pose.
#include <map>
#include <optional>

#include "document/command.h"
#include "document/joint_id.h"
#include "pose/rigs.h"
#include "rig/rigs.h"
#include "support/catch.h"
#include "support/soundness.h"

namespace marrow {
namespace {

Document must(const Result<Document>& result) {
  if (!result) FAIL(result.message());
  REQUIRE(faultOf(*result) == "");
  return *result;
}

Rig rigOf(const Document& document, Workshop& workshop) {
  return Assembly(document, workshop).rig();
}

/// With a pose of this rig, in which all joints that are no roots have turned, and roots have
/// moved as well.
Document posedDocument(const Document& document, const Rig& rig, Random& random) {
  Pose pose;
  for (const Rig::Joint& joint : rig.joints) {
    pose[joint.id].rotation = randomTurn(random);
    if (joint.parent < 0) pose[joint.id].move = randomRotation(random).z * random.between(1, 40);
  }
  return must(apply(document, SetPose{"Dance", pose}));
}

/// Where the joints are in the document's pose, by their ids.
std::map<std::string, Vec3> places(const Document& document, const Rig& rig) {
  const std::vector<Rigid> motions = posed(rig, document.poses.at(0)->joints);
  std::map<std::string, Vec3> places;
  for (size_t i = 0; i < motions.size(); ++i) {
    places[rig.joints[i].id] = motions[i](rig.joints[i].position);
  }
  return places;
}

/// Whether the rigs have the same joints, each below the same one.
bool areAlike(const Rig& a, const Rig& b) {
  const auto parents = [](const Rig& rig) {
    std::map<std::string, std::string> above;
    for (const auto& joint : rig.joints) {
      const auto parent = static_cast<size_t>(joint.parent);
      above[joint.id] = joint.parent < 0 ? "" : rig.joints[parent].id;
    }
    return above;
  };
  return parents(a) == parents(b);
}

bool isNear(Vec3 a, Vec3 b) { return distance(a, b) < 1e-9 * (1 + length(b)); }

/// A rotation about a place.
Affine about(Vec3 place, Affine turn) {
  turn.move = place - turn.direction(place);
  return turn;
}

/// A quadruped whose legs have feet: twins hang on twins.
Document withFeet() {
  Document document = quadruped();
  const Plane middle{{0, 0, 1}, 0};
  addPart(document, "Foot", ellipse({-100, -165}, 45, 18), 45, middle);
  addPart(document, "Foot", ellipse({130, -165}, 45, 18), 45, middle);
  return document;
}

}  // namespace

TEST_CASE("posed parts: separated twins are posed as they were", "[posed_parts]") {
  Random random(1);
  Workshop workshop;
  size_t twins = 0, hanging = 0;
  for (int run = 0; run < 80; ++run) {
    CAPTURE(run);
    Document document = run < 5 ? withFeet() : randomCreature(random, 2 + random.below(8));
    const Rig rig = rigOf(document, workshop);
    document = posedDocument(document, rig, random);
    Ids ids = allPlacedIds(document);
    if (run % 2 == 1) ids.resize(1 + ids.size() / 2);
    const Document apart = must(apply(document, SeparateTwins{ids}));
    const Rig rig_apart = rigOf(apart, workshop);
    const bool same = std::equal(rig.joints.begin(), rig.joints.end(), rig_apart.joints.begin(),
                                 rig_apart.joints.end(), [](const auto& a, const auto& b) {
                                   return a.parent == b.parent && a.position == b.position;
                                 });
    if (!same) continue;  // parts by themselves connect as they like
    const auto before = places(document, rig), after = places(apart, rig_apart);
    for (size_t i = 0; i < rig.joints.size(); ++i) {
      const std::string &id = rig.joints[i].id, &id_apart = rig_apart.joints[i].id;
      REQUIRE(distance(after.at(id_apart), before.at(id)) < 1e-9);
      if (id == id_apart) continue;
      ++twins;
      if (id.find("/a:") != std::string::npos) ++hanging;
    }
    REQUIRE(apart.poses[0]->joints.size() == document.poses[0]->joints.size());
  }
  REQUIRE(twins > 200);
  REQUIRE(hanging >= 10);
}

TEST_CASE("posed parts: poses without twins' joints stay as they are", "[posed_parts]") {
  Document document = must(apply(withFeet(), SetPose{"Nod", {{"part-5/n0", {{0, 0, 1, 0}, {}}}}}));
  document = must(apply(document, SetPose{"Lift", {{"part-2:twin/n0", {{0, 0, 1, 0}, {}}}}}));
  const Document apart = must(apply(document, SeparateTwins{{"part-2"}}));
  REQUIRE(apart.poses[0] == document.poses[0]);
  REQUIRE(apart.poses[1]->joints == Pose{{"part-9/n0", {{0, 0, 1, 0}, {}}}});
  const Document other = must(apply(document, SeparateTwins{{"part-3"}}));
  REQUIRE(other.poses[1] == document.poses[1]);
}

TEST_CASE("posed parts: a character that is turned, scaled or mirrored strikes the same poses",
          "[posed_parts]") {
  Random random(2);
  Workshop workshop;
  int compared = 0;
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Document document = run < 5 ? withFeet() : randomCreature(random, 2 + random.below(8));
    const Rig rig = rigOf(document, workshop);
    document = posedDocument(document, rig, random);
    Affine map = randomSimilarity(random);
    if (run % 3 == 2) map.y = -map.y;
    // Across their own plane drawn parts are the same: only the poses tell.
    if (run == 0) map = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};
    const Document after =
        must(apply(document, TransformParts{allPlacedIds(document), map, "Turn"}));
    const Rig rig_after = rigOf(after, workshop);
    if (!areAlike(rig, rig_after)) continue;  // on the verge of being connected otherwise
    ++compared;
    const auto were = places(document, rig), are = places(after, rig_after);
    for (const auto& [id, place] : were) {
      CAPTURE(id);
      REQUIRE(isNear(are.at(id), map(place)));
    }
  }
  REQUIRE(compared > 50);
}

TEST_CASE("posed parts: a leg that is turned bends about its own axis, and so does its twin",
          "[posed_parts]") {
  Workshop workshop;
  Random random(3);
  Document document = quadruped();
  PartSource leg = *document.parts[1];
  for (Vec2& p : leg.stroke) p.x += (p.y + 90) * (p.y + 90) / 400;
  document.parts[1] = std::make_shared<const PartSource>(leg);
  const Rig rig = rigOf(document, workshop);
  document = posedDocument(document, rig, random);
  const Pose all = document.poses[0]->joints;
  // Of the whole pose what the joints of the legs do.
  Pose legs;
  std::optional<Vec3> hip;  // the highest of the leg
  size_t elbows = 0;
  for (const Rig::Joint& joint : rig.joints) {
    const std::string part = partOfJoint(joint.id);
    if (sourceId(part) != "part-2") continue;
    legs[joint.id] = all.at(joint.id);
    elbows += joint.kind == JointKind::sleeve;
    if (!isTwinId(part) && (!hip || joint.position.y > hip->y)) hip = joint.position;
  }
  REQUIRE(elbows > 0);
  document = must(apply(document, SetPose{"Dance", legs}));
  document = must(apply(document, SetPose{"All", all}));
  const Plane middle = *document.parts[1]->mirror;
  for (const bool twin : {false, true}) {
    // A quarter turn about the upright line through the hip: Z becomes X.
    Affine turn;
    turn.x = {0, 0, -1};
    turn.z = {1, 0, 0};
    turn = about(twin ? mirrored(*hip, middle) : *hip, turn);
    const std::string named = twin ? "part-2:twin" : "part-2";
    const Document after = must(apply(document, TransformParts{{named}, turn, "Turn"}));
    const Rig rig_after = rigOf(after, workshop);
    REQUIRE(areAlike(rig, rig_after));
    const auto were = places(document, rig), are = places(after, rig_after);
    for (const auto& [id, motion] : legs) {
      CAPTURE(id);
      const bool is_named = isTwinId(partOfJoint(id)) == twin;
      REQUIRE(isNear(are.at(id), (is_named ? turn : mirrored(turn, middle))(were.at(id))));
    }
    // Joints of other parts keep their motions, those where the legs hang among them.
    size_t kept = 0;
    for (const auto& [id, motion] : after.findPose("All")->joints) {
      if (legs.count(id) == 0) REQUIRE(motion == all.at(id));
      kept += motion == all.at(id);
    }
    REQUIRE(kept < all.size());
  }
}

TEST_CASE("posed parts: what a part does follows its own turn, not that of the part it hangs on",
          "[posed_parts]") {
  const JointMotion bend{{0, 0, 0.6, 0.8}, {1, 2, 3}};
  const Pose pose{{"part-1/n0", bend},
                  {"part-1/a:part-2", bend},
                  {"part-1/a:part-2:twin", bend},
                  {"part-2/b0.7", bend},
                  {"part-2:twin/b0.7", bend},
                  {"part-20/n0", bend},
                  {"part-1//x/n0", bend},
                  {"odd", bend}};
  const Document document = must(apply(quadruped(), SetPose{"Bow", pose}));
  Affine turn;  // a third about the diagonal, twice as large: Z becomes X
  turn.x = {0, 2, 0};
  turn.y = {0, 0, 2};
  turn.z = {2, 0, 0};
  const JointMotion turned{{0.6, 0, 0, 0.8}, {6, 2, 4}};
  const auto after = [&](const Ids& ids, const Affine& map) {
    return must(apply(document, TransformParts{ids, map})).poses[0]->joints;
  };
  const auto isTurned = [&](const JointMotion& motion, const JointMotion& wanted) {
    return std::abs(dot(motion.rotation, wanted.rotation) - 1) < 1e-12 &&
           isNear(motion.move, wanted.move);
  };
  for (const auto& [id, motion] : after({"part-1"}, turn)) {
    CAPTURE(id);
    const bool own = id.compare(0, 7, "part-1/") == 0 && id[7] != '/';
    if (own) REQUIRE(isTurned(motion, turned));
    if (!own) REQUIRE(motion == bend);
  }
  // The twin lies across z = 0: seen in that mirror the turn takes Z to −X.
  const JointMotion opposite{{-0.6, 0, 0, 0.8}, {-6, 2, -4}};
  const Pose by_leg = after({"part-2"}, turn), by_twin = after({"part-2:twin"}, turn);
  REQUIRE(isTurned(by_leg.at("part-2/b0.7"), turned));
  REQUIRE(isTurned(by_leg.at("part-2:twin/b0.7"), opposite));
  REQUIRE(isTurned(by_twin.at("part-2/b0.7"), opposite));
  REQUIRE(isTurned(by_twin.at("part-2:twin/b0.7"), turned));
  const Pose by_both = after({"part-2", "part-2:twin"}, turn);
  REQUIRE(isTurned(by_both.at("part-2/b0.7"), turned));
  REQUIRE(isTurned(by_both.at("part-2:twin/b0.7"), turned));
  REQUIRE(by_both.at("part-1/a:part-2") == bend);
  // A mirror image bends the other way where its axis lies in the mirror.
  Affine mirror;
  mirror.x = {-1, 0, 0};
  REQUIRE(isTurned(after({"part-2"}, mirror).at("part-2/b0.7"), {{0, 0, -0.6, 0.8}, {-1, 2, 3}}));
  // Stretching turns nothing, but what is stretched moves as much further.
  Affine stretch;
  stretch.y = {0, 3, 0};
  REQUIRE(isTurned(after({"part-2"}, stretch).at("part-2/b0.7"), {{0, 0, 0.6, 0.8}, {1, 6, 3}}));
}

TEST_CASE("posed parts: what only moves keeps its poses to the bit", "[posed_parts]") {
  Random random(4);
  Workshop workshop;
  for (int run = 0; run < 20; ++run) {
    Document document = randomCreature(random, 2 + random.below(8));
    document = posedDocument(document, rigOf(document, workshop), random);
    Ids ids = allPlacedIds(document);
    if (run % 2 == 1) ids.resize(1 + ids.size() / 2);
    Affine move;
    move.move = randomRotation(random).x * random.between(1, 500);
    const Document after = must(apply(document, TransformParts{ids, move}));
    REQUIRE(after.parts != document.parts);
    REQUIRE(after.poses[0] == document.poses[0]);
  }
  Document locked = must(apply(quadruped(), SetPose{"Bow", {{"part-1/n0", {{1, 0, 0, 0}, {}}}}}));
  locked = must(apply(locked, SetLocked{{"part-1"}, true}));
  const Affine turn = randomRotation(random);
  const Document after = must(apply(locked, TransformParts{allPlacedIds(locked), turn}));
  REQUIRE(after.poses[0] == locked.poses[0]);
}

TEST_CASE("posed parts: a twin across another plane bends as it did", "[posed_parts]") {
  Random random(5);
  Workshop workshop;
  int compared = 0;
  for (int run = 0; run < 20; ++run) {
    CAPTURE(run);
    Document document = randomCreature(random, 1);
    PartSource part = *document.parts[0];
    const Plane before = randomPlane(random, {900, 0, 0});
    part.mirror = before;
    document.parts[0] = std::make_shared<const PartSource>(part);
    const Rig rig = rigOf(document, workshop);
    document = posedDocument(document, rig, random);
    const Plane plane = randomPlane(random, {0, -900, 0});
    const Document after = must(apply(document, SetMirror{{"part-1"}, plane}));
    const Rig rig_after = rigOf(after, workshop);
    if (!areAlike(rig, rig_after)) continue;
    ++compared;
    const auto were = places(document, rig), are = places(after, rig_after);
    for (const auto& [id, place] : were) {
      const bool twin = isTwinId(partOfJoint(id));
      REQUIRE(isNear(are.at(id), twin ? mirrored(mirrored(place, before), plane) : place));
    }
    const Document away = must(apply(after, SetMirror{{"part-1"}, std::nullopt}));
    REQUIRE(away.poses[0] == after.poses[0]);
  }
  REQUIRE(compared > 10);
}

}  // namespace marrow
