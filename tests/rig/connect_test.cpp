#include "rig/connect.h"

#include <cmath>

#include "rig/body_overlap.h"
#include "rig/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

/// Who hangs on whom, by id.
std::map<std::string, std::string> parents(const Assembly& assembly) {
  std::map<std::string, std::string> result;
  for (const Connection& c : assembly.connections()) {
    result[assembly.placed[c.child].id] = assembly.placed[c.parent].id;
  }
  return result;
}

AttachTest testOf(const Assembly& assembly, const std::string& child) {
  const auto connections = assembly.connections();
  const Connection* found = connectionOf(connections, assembly.indexOf(child));
  REQUIRE(found);
  return found->test;
}

void moveBy(Document& document, size_t part, Vec3 move) {
  auto source = std::make_shared<PartSource>(*document.parts[part]);
  source->frame.origin = source->frame.origin + move;
  document.parts[part] = source;
}

PartSource& edit(Document& document, size_t part) {
  auto source = std::make_shared<PartSource>(*document.parts[part]);
  document.parts[part] = source;
  return *source;
}

using Parents = std::map<std::string, std::string>;

}  // namespace

TEST_CASE("connect: body, legs, neck, head and tail become one character", "[rig]") {
  Workshop workshop;
  const Assembly creature(quadruped(), workshop);
  CHECK(parents(creature) == Parents{{"part-2", "part-1"},
                                     {"part-2:twin", "part-1"},
                                     {"part-3", "part-1"},
                                     {"part-3:twin", "part-1"},
                                     {"part-4", "part-1"},
                                     {"part-5", "part-4"},
                                     {"part-6", "part-1"}});
  CHECK(faultOf(creature.connections(), creature) == "");
  const Rig rig = creature.rig();
  CHECK(faultOf(rig, creature) == "");
  CHECK(rig.roots.size() == 1);
  CHECK(rig.joints[rig.roots[0]].part == 0);
}

TEST_CASE("connect: a joint inside is one thing, plain overlap another", "[rig]") {
  Workshop workshop;
  Document document;
  addPart(document, "Neck", ellipse({0, 0}, 20, 80));
  addPart(document, "Head", ellipse({0, 90}, 100, 45));  // its axis passes above the neck's end
  CHECK(testOf(Assembly(document, workshop), "part-2") == AttachTest::overlap);
  addPart(document, "Arm", ellipse({60, 20}, 70, 10));
  CHECK(testOf(Assembly(document, workshop), "part-3") == AttachTest::joint);
  // Barely touching is no overlap.
  Document apart;
  addPart(apart, "Neck", ellipse({0, 0}, 20, 80));
  addPart(apart, "Head", ellipse({0, 128}, 100, 45));
  CHECK(Assembly(apart, workshop).connections().empty());
}

TEST_CASE("connect: a bone is split where the child projects onto it, else its joint is taken",
          "[rig]") {
  Workshop workshop;
  Document document;
  addPart(document, "Body", ellipse({0, 0}, 200, 30));
  addPart(document, "Leg", ellipse({13, -60}, 10, 50));
  addPart(document, "Head", ellipse({243, 0}, 50, 15));
  const Assembly creature(document, workshop);
  const auto connections = creature.connections();
  const Connection* leg = connectionOf(connections, 1);
  const Connection* head = connectionOf(connections, 2);
  REQUIRE(leg);
  REQUIRE(head);
  CHECK(leg->event == AttachEvent::split);
  CHECK(leg->parent_position.x == Approx(13).margin(0.5));
  CHECK(leg->child_position.y > -40);
  CHECK(head->event == AttachEvent::connect);
  CHECK(toString(leg->event) == std::string("split"));
  CHECK(toString(head->event) == std::string("connect"));
  const auto& body = creature.parts[0].part->skeleton;
  CHECK(body.joints[head->parent_joint].kind == JointKind::terminal);
  CHECK(body.joints[head->parent_joint].position.x > 150);
}

TEST_CASE("connect: the parent is the one that is penetrated deepest, the earlier on a tie",
          "[rig]") {
  Workshop workshop;
  const auto limb = ellipse({0, 0}, 80, 20);
  for (const bool swap : {false, true}) {
    Document document;
    addPart(document, "Near", limb, swap ? 14 : 2);
    addPart(document, "Far", limb, swap ? -2 : -14);
    addPart(document, "Child", ellipse({90, 0}, 40, 8), 0);
    edit(document, 1).attachment = Attachment{};  // the two lie in each other
    CHECK(parents(Assembly(document, workshop)) == Parents{{"part-3", swap ? "part-2" : "part-1"}});
  }
  Document document;
  addPart(document, "One", limb, 5);
  addPart(document, "Same", limb, -5);
  addPart(document, "Child", ellipse({90, 0}, 40, 8), 0);
  edit(document, 1).attachment = Attachment{};
  CHECK(parents(Assembly(document, workshop)) == Parents{{"part-3", "part-1"}});
  // Rounding does not decide ties.
  Random random(20);
  for (int i = 0; i < 50; ++i) {
    const Affine map = randomSimilarity(random, 1e4);
    CHECK(parents(Assembly(mapped(document, map), workshop)) == Parents{{"part-3", "part-1"}});
  }
}

TEST_CASE("connect: what is a tie for twins goes to either side", "[rig]") {
  Workshop workshop;
  const Plane plane{{0, 0, 1}, 0};
  Document document;
  addPart(document, "Leg", ellipse({0, 0}, 80, 20), 5, plane);
  addPart(document, "Foot", ellipse({90, 0}, 40, 8), 0, plane);  // in the plane, as is its twin
  CHECK(parents(Assembly(document, workshop)) ==
        Parents{{"part-1:twin", "part-1"}, {"part-2", "part-1"}, {"part-2:twin", "part-1:twin"}});
}

TEST_CASE("connect: moved away a part is let go, moved back it hangs as before", "[rig]") {
  Workshop workshop;
  const Document before = quadruped();
  const auto connections = Assembly(before, workshop).connections();
  Document document = before;
  moveBy(document, 4, {0, 512, 0});
  CHECK(parents(Assembly(document, workshop)).count("part-5") == 0);
  CHECK(Assembly(document, workshop).rig().roots.size() == 2);
  moveBy(document, 4, {0, -512, 0});
  CHECK(Assembly(document, workshop).connections() == connections);
}

TEST_CASE("connect: legs drawn before the body are no trees of their own", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  std::rotate(document.parts.begin(), document.parts.begin() + 1, document.parts.begin() + 3);
  const Assembly creature(document, workshop);
  CHECK(creature.rig().roots.size() == 1);
  CHECK(faultOf(creature.rig(), creature) == "");
}

TEST_CASE("connect: legs drawn before the body hang on it, feet drawn before legs on these",
          "[rig]") {
  Workshop workshop;
  const Plane middle{{0, 0, 1}, 0};
  Document document;
  addPart(document, "Foot", ellipse({-105, -172}, 34, 14), 45, middle);
  addPart(document, "Leg", ellipse({-120, -90}, 22, 80), 45, middle);
  addPart(document, "Leg", ellipse({110, -90}, 22, 80), 45, middle);
  addPart(document, "Body", ellipse({0, 0}, 180, 70));
  const Assembly creature(document, workshop);
  CHECK(parents(creature) == Parents{{"part-1", "part-2"},
                                     {"part-1:twin", "part-2:twin"},
                                     {"part-2", "part-4"},
                                     {"part-2:twin", "part-4"},
                                     {"part-3", "part-4"},
                                     {"part-3:twin", "part-4"}});
  CHECK(faultOf(creature.rig(), creature) == "");
}

TEST_CASE("connect: a neck drawn last holds a head that was drawn apart from the body", "[rig]") {
  Workshop workshop;
  Document document;
  addPart(document, "Body", ellipse({0, 0}, 160, 80));
  addPart(document, "Head", ellipse({190, 190}, 60, 50));
  addPart(document, "Neck", ellipse({150, 100}, 24, 85));
  const Assembly creature(document, workshop);
  CHECK(parents(creature) == Parents{{"part-2", "part-3"}, {"part-3", "part-1"}});
}

TEST_CASE("connect: a fin that lies along a body hangs by its middle", "[rig]") {
  Workshop workshop;
  Document document;
  addPart(document, "Body", ellipse({0, 0}, 200, 70));
  addPart(document, "Fin", ellipse({20, 62}, 110, 22));
  const Assembly creature(document, workshop);
  const auto connections = creature.connections();
  REQUIRE(connections.size() == 1);
  CHECK(std::abs(connections[0].child_position.x - 20) < 40);
  const Rig rig = creature.rig(unrefined());
  CHECK(faultOf(rig, creature) == "");
  // It moves from there to both sides, with a joint of its own unless one was there.
  std::map<std::string, int> bones;
  for (const auto& [a, b] : rig.bones) {
    if (rig.joints[a].part == 1) ++bones[rig.joints[a].id];
  }
  const bool own = connections[0].child_split;
  CHECK((!own || bones.at("part-2/h") == 2));
}

TEST_CASE("connect: a head with ears is not held by an ear", "[rig]") {
  Workshop workshop;
  Random random(25);
  for (int run = 0; run < 10; ++run) {
    // Two ears up, the chin on the body; turned a little.
    std::vector<Vec2> head;
    for (const Vec2 p : unitCircle(80)) {
      double r = 55;
      for (const Vec2 ear : {Vec2{0.6, 0.8}, Vec2{-0.6, 0.8}}) {
        const double off = (1 - dot(p, ear)) / 0.05;
        if (off < 1) r += 70 * (1 - off);
      }
      const double turn = 0.1 * (run - 5);
      head.push_back(Vec2{p.x - turn * p.y, p.y + turn * p.x} * r);
    }
    Document document;
    addPart(document, "Body", ellipse({0, 0}, 60, 100));
    addPart(document, "Head", head, random.between(-5, 5)).frame.origin = {0, 135, 0};
    const Assembly creature(document, workshop);
    const auto connections = creature.connections();
    REQUIRE(connections.size() == 1);
    CHECK(connections[0].child_position.y < 150);
    CHECK(distance(connections[0].child_position, connections[0].parent_position) < 90);
  }
}

TEST_CASE("connect: connecting bones stay inside of the bodies", "[rig]") {
  Random random(26);
  CreatureOptions options;
  options.overruled = 0;
  int all = 0, outside = 0;
  for (int run = 0; run < 30; ++run) {
    Workshop workshop;
    const Assembly creature(randomCreature(random, 2 + random.below(9), options), workshop);
    for (const Connection& c : creature.connections()) {
      const PartBody child(creature.parts[c.child]), parent(creature.parts[c.parent]);
      int off = 0;
      for (int i = 0; i <= 20; ++i) {
        const Vec3 p = lerp(c.child_position, c.parent_position, i / 20.0);
        off += !child.contains(p) && !parent.contains(p);
      }
      ++all;
      outside += off > 1;
    }
  }
  CHECK(all > 80);
  CHECK(outside <= 0.03 * all);
}

TEST_CASE("connect: what the user took off stays off", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  for (size_t i = 0; i < document.parts.size(); ++i) {
    Document detached = document;
    edit(detached, i).attachment = Attachment{};
    const Assembly creature(detached, workshop);
    const std::string id = document.parts[i]->id;
    CHECK(parents(creature).count(id) == 0);
    CHECK(parents(creature).count(id + kTwinSuffix) == 0);
  }
  // Not even when drawn before what it touches.
  std::swap(document.parts[0], document.parts[5]);
  edit(document, 5).attachment = Attachment{};
  CHECK(parents(Assembly(document, workshop)).count("part-6") == 0);
  CHECK(parents(Assembly(document, workshop)).count("part-1") == 0);
}

TEST_CASE("connect: twins that hang nowhere else hang on each other", "[rig]") {
  Workshop workshop;
  const Plane plane{{1, 0, 0}, 0};
  Document document;
  addPart(document, "Half", ellipse({30, 0}, 50, 80), 0, plane);
  CHECK(parents(Assembly(document, workshop)) == Parents{{"part-1:twin", "part-1"}});
  Document apart;
  addPart(apart, "Half", ellipse({60, 0}, 50, 80), 0, plane);
  CHECK(Assembly(apart, workshop).connections().empty());
  // Legs that touch each other still hang on the body.
  Document legs;
  addPart(legs, "Body", ellipse({0, 100}, 90, 60));
  addPart(legs, "Leg", ellipse({15, 0}, 20, 80), 0, plane);
  CHECK(parents(Assembly(legs, workshop)) ==
        Parents{{"part-2", "part-1"}, {"part-2:twin", "part-1"}});
}

TEST_CASE("connect: what is symmetric hangs symmetrically", "[rig]") {
  Random random(21);
  int pairs = 0;
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Workshop workshop;
    const Plane plane = randomPlane(random, {});
    // All parts have a twin across one plane, so the whole is its own mirror image.
    CreatureOptions options;
    options.mirrored = 0;
    options.overruled = 0.2;
    Document document = randomCreature(random, 2 + random.below(8), options);
    for (size_t i = 0; i < document.parts.size(); ++i) {
      PartSource& part = edit(document, i);
      part.mirror = plane;
      // A limb in the plane is its own mirror image.
      if (random.below(4) > 0) continue;
      part.frame.origin = part.frame.origin - plane.normal * distance(plane, part.frame.origin);
    }
    const Assembly creature(document, workshop);
    const auto connections = creature.connections();
    CHECK(faultOf(connections, creature) == "");
    for (size_t i = 0; i < creature.parts.size(); i += 2) {
      const Connection* one = connectionOf(connections, i);
      const Connection* other = connectionOf(connections, i + 1);
      // Only what would close a circle, or hangs on its own image, may be one-sided.
      if (!one || !other) continue;
      if (one->parent / 2 == i / 2 || other->parent / 2 == i / 2) continue;
      if (one->parent > one->child || other->parent > other->child) continue;
      CHECK(one->parent / 2 == other->parent / 2);
      CHECK(one->parent != other->parent);
      CHECK(one->test == other->test);
      CHECK(one->event == other->event);
      CHECK(one->child_joint == other->child_joint);
      CHECK(one->parent_joint == other->parent_joint);
      CHECK(one->parent_bone == other->parent_bone);
      CHECK(one->along == Approx(other->along).margin(1e-6));
      ++pairs;
    }
  }
  CHECK(pairs > 100);
}

TEST_CASE("connect: any creature gives a forest, by itself or overruled", "[rig]") {
  Random random(22);
  for (int run = 0; run < 120; ++run) {
    CAPTURE(run);
    Workshop workshop;
    CreatureOptions options;
    options.overruled = random.unit();
    options.no_bones = 0.3 * random.unit();
    const int parts = 2 + random.below(run % 10 == 0 ? 59 : 10);
    const Assembly creature(randomCreature(random, parts, options), workshop);
    const auto connections = creature.connections();
    CHECK(faultOf(connections, creature) == "");
    CHECK(creature.connections() == connections);
  }
}

TEST_CASE("connect: part by part, later parts hardly change anything among earlier ones", "[rig]") {
  Random random(23);
  CreatureOptions options;
  options.overruled = 0;
  options.mirrored = 0;
  int found = 0, turned = 0;
  for (int run = 0; run < 30; ++run) {
    Workshop workshop;
    Document document = randomCreature(random, 9, options);
    const auto all = Assembly(document, workshop).connections();
    document.parts.resize(6);
    for (const Connection& connection : Assembly(document, workshop).connections()) {
      // What hangs on a later part may find a better one among still later ones.
      if (connection.parent > connection.child) continue;
      const Connection* then = connectionOf(all, connection.child);
      // A body that comes after its limbs turns their trees round.
      turned += !then || !(*then == connection);
      ++found;
    }
  }
  CHECK(found > 50);
  CHECK(turned < 0.04 * found);
}

TEST_CASE("connect: where the whole stands, how large and turned, changes nothing", "[rig]") {
  Random random(24);
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Workshop workshop;
    const Document document = randomCreature(random, 2 + random.below(14));
    const Assembly here(document, workshop);
    const Rig rig = here.rig();
    const auto connections = here.connections();
    for (int i = 0; i < 4; ++i) {
      Affine map = randomSimilarity(random, i == 0 ? 1e6 : 1000);
      if (i == 1) map = {{1e4, 0, 0}, {0, 1e4, 0}, {0, 0, 1e4}, {}};
      if (i == 2) map = {{1e-4, 0, 0}, {0, 1e-4, 0}, {0, 0, 1e-4}, {}};
      const double scale = length(map.x);
      const Assembly there(mapped(document, map), workshop);
      const Rig other = there.rig();
      REQUIRE(other.joints.size() == rig.joints.size());
      CHECK(other.bones == rig.bones);
      CHECK(other.roots == rig.roots);
      CHECK(other.carried == rig.carried);
      for (size_t k = 0; k < rig.joints.size(); ++k) {
        const auto &a = rig.joints[k], &b = other.joints[k];
        CHECK(a.id == b.id);
        // Which side is left hangs on where the plane of symmetry points.
        CHECK(a.name.size() == b.name.size());
        CHECK(a.kind == b.kind);
        CHECK(distance(map(a.position), b.position) < 1e-6 * 1000 * scale);
        CHECK(a.radius * scale == Approx(b.radius));
      }
      REQUIRE(other.connections.size() == rig.connections.size());
      for (size_t k = 0; k < rig.connections.size(); ++k) {
        const auto &a = rig.connections[k], &b = other.connections[k];
        CHECK(a.parent == b.parent);
        CHECK(a.test == b.test);
        CHECK(a.child_joint == b.child_joint);
      }
    }
  }
}

TEST_CASE("connect: the user's word counts, and outlives what it does not touch", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  // The tail on the head, near its right end.
  edit(document, 5).attachment = Attachment{"part-5", {280, 150}};
  const Assembly told(document, workshop);
  CHECK(parents(told)["part-6"] == "part-5");
  CHECK(testOf(told, "part-6") == AttachTest::user);
  const auto connections = told.connections();
  CHECK(connectionOf(connections, told.indexOf("part-6"))->parent_position.x > 230);

  moveBy(document, 5, {0, -900, 0});
  CHECK(parents(Assembly(document, workshop))["part-6"] == "part-5");
  // A parent that is gone, or has no bones: by itself again.
  Document gone = document;
  moveBy(gone, 5, {0, 900, 0});
  edit(gone, 4).skeleton = false;
  CHECK(parents(Assembly(gone, workshop))["part-6"] == "part-1");
  gone.parts.erase(gone.parts.begin() + 4);
  CHECK(parents(Assembly(gone, workshop))["part-6"] == "part-1");
  edit(gone, 4).attachment = Attachment{};
  CHECK(parents(Assembly(gone, workshop)).count("part-6") == 0);
}

TEST_CASE("connect: a twin hangs on the mirror image of what its part was told", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  addPart(document, "Foot", ellipse({-100, -170}, 40, 12), 45, Plane{{0, 0, 1}, 0});
  edit(document, 6).attachment = Attachment{"part-3:twin", {110, -60}};
  Parents found = parents(Assembly(document, workshop));
  CHECK(found["part-7"] == "part-3:twin");
  CHECK(found["part-7:twin"] == "part-3");
  edit(document, 6).attachment = Attachment{"part-6", {-230, 30}};
  found = parents(Assembly(document, workshop));
  CHECK(found["part-7"] == "part-6");
  CHECK(found["part-7:twin"] == "part-6");
}

TEST_CASE("connect: circles that the user asked for are not closed", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  // In modelling order: the last of the three would close the circle.
  edit(document, 0).attachment = Attachment{"part-5", {215, 150}};
  edit(document, 3).attachment = Attachment{"part-1", {0, 0}};
  edit(document, 4).attachment = Attachment{"part-4", {185, 60}};
  const Assembly creature(document, workshop);
  CHECK(faultOf(creature.connections(), creature) == "");
  const Parents found = parents(creature);
  CHECK(found.at("part-1") == "part-5");
  CHECK(found.at("part-4") == "part-1");
  CHECK(found.count("part-5") == 0);
  // Nor does a part hang on itself.
  edit(document, 0).attachment = Attachment{"part-1", {0, 0}};
  edit(document, 3).attachment.reset();
  CHECK(parents(Assembly(document, workshop)).at("part-5") == "part-4");
  CHECK(faultOf(Assembly(document, workshop).rig(), creature) == "");
}

TEST_CASE("connect: what has no bones is carried and carries nothing", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  addPart(document, "Ear", ellipse({190, 190}, 10, 30));
  addPart(document, "Ring", ellipse({190, 215}, 12, 9));
  edit(document, 6).skeleton = false;
  const Assembly creature(document, workshop);
  const Rig rig = creature.rig();
  CHECK(faultOf(rig, creature) == "");
  REQUIRE(rig.carried.size() == 1);
  CHECK(rig.carried[0].first == creature.indexOf("part-7"));
  REQUIRE(rig.carried[0].second >= 0);
  CHECK(rig.joints[static_cast<size_t>(rig.carried[0].second)].part == creature.indexOf("part-5"));
  CHECK(parents(creature).count("part-8") == 0);
  // Far away nothing carries it.
  moveBy(document, 6, {0, 2000, 0});
  CHECK(Assembly(document, workshop).rig().carried[0].second == -1);
}

TEST_CASE("connect: what lies on what has no bones hangs where that hangs", "[rig]") {
  // A pupil in front of an eye that bulges out of the head: it does not reach the head.
  Workshop workshop;
  Document document = quadruped();
  addPart(document, "Eye", ellipse({190, 150}, 14, 14));
  addPart(document, "Pupil", ellipse({190, 150}, 6, 6));
  edit(document, 6).skeleton = edit(document, 7).skeleton = false;
  moveBy(document, 6, {0, 0, 40});
  moveBy(document, 7, {0, 0, 52});
  const Assembly creature(document, workshop);
  const Rig rig = creature.rig();
  CHECK(faultOf(rig, creature) == "");
  REQUIRE(rig.carried.size() == 2);
  CHECK(rig.carried[0].second >= 0);
  CHECK(rig.carried[1].second == rig.carried[0].second);
}

TEST_CASE("connect: the root is the user's choice, and the bones turn round", "[rig]") {
  Workshop workshop;
  Document document = quadruped();
  const Rig before = Assembly(document, workshop).rig(unrefined());
  edit(document, 4).root = true;
  const Assembly creature(document, workshop);
  const Rig rig = creature.rig(unrefined());
  CHECK(faultOf(rig, creature) == "");
  CHECK(rig.joints[rig.roots.at(0)].part == creature.indexOf("part-5"));
  CHECK(rig.connections == before.connections);
  CHECK(idsOf(rig) == idsOf(before));
  edit(document, 1).root = true;
  CHECK(Assembly(document, workshop).rig().joints[0].part == 1);
}

}  // namespace marrow
