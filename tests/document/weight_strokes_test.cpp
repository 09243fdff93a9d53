// Strokes of the weight brush are kept with the part that they were painted on.
#include "weights/weight_strokes.h"

#include <cmath>
#include <limits>

#include "document/command.h"
#include "document/evaluation.h"
#include "io/document_json.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

Document must(const Result<Document>& result) {
  if (!result) FAIL(result.message());
  REQUIRE(faultOf(*result) == "");
  return *result;
}

/// A body with a leg that has a twin.
Document creature() {
  Document document;
  for (const bool leg : {false, true}) {
    AddPart part{unitCircle(40)};
    for (Vec2& p : part.stroke) p = leg ? Vec2{20 * p.x, 80 * p.y} : Vec2{150 * p.x, 60 * p.y};
    if (leg) {
      part.frame = {{60, -90, 40}, {0.6, 0, 0.8}, {0, 1, 0}};
      part.mirror = Plane{{0, 0, 1}, 0};
    }
    document = must(apply(document, part));
  }
  return document;
}

WeightStroke onLeg() {
  WeightStroke stroke;
  stroke.part = "part-2";
  stroke.joint = "part-2/n1";
  stroke.radius = 25;
  stroke.strength = 0.5;
  stroke.points = {{60, -100, 52}, {63, -120, 50}, {59, -150, 53}};
  return stroke;
}

double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}

}  // namespace

TEST_CASE("weight strokes: a stroke lies where it was painted, and its mirror image on the twin",
          "[weight_strokes]") {
  const Document document = must(apply(creature(), AddWeightStroke{onLeg()}));
  const auto placed = placedStrokes(document, {});
  REQUIRE(placed.size() == 1);
  REQUIRE(placed[0].trails.size() == 2);
  REQUIRE(placed[0].trails[0].joint == "part-2/n1");
  REQUIRE(placed[0].trails[1].joint == "part-2:twin/n1");
  REQUIRE(std::abs(placed[0].trails[0].radius - 25) < 1e-12);
  REQUIRE(apart(placed[0].trails[0].points, onLeg().points) < 1e-9);
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 p = onLeg().points[i];
    REQUIRE(distance(placed[0].trails[1].points[i], {p.x, p.y, -p.z}) < 1e-9);
  }
}

TEST_CASE("weight strokes: painting on the twin is painting on the part", "[weight_strokes]") {
  WeightStroke stroke = onLeg();
  stroke.part = "part-2:twin";
  stroke.joint = "part-1/a:part-2:twin";
  for (Vec3& p : stroke.points) p.z = -p.z;
  const Document document = must(apply(creature(), AddWeightStroke{stroke}));
  const WeightStroke& kept = *document.weight_strokes[0];
  REQUIRE(kept.part == "part-2");
  REQUIRE(kept.joint == "part-1/a:part-2");
  const Document other = must(apply(creature(), AddWeightStroke{onLeg()}));
  REQUIRE(apart(kept.points, other.weight_strokes[0]->points) < 1e-9);
}

TEST_CASE("weight strokes: they move, turn, scale and stretch with their part",
          "[weight_strokes]") {
  Random random(1);
  const Document before = must(apply(creature(), AddWeightStroke{onLeg()}));
  const auto was = placedStrokes(before, {})[0].trails[0];
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Affine map = randomSimilarity(random, 50);
    if (run % 3 == 1) map.z = -map.z;       // mirrors
    if (run % 3 == 2) map.y = map.y * 1.5;  // stretches
    const bool twin = run % 2 == 1;
    const Document after =
        must(apply(before, TransformParts{{twin ? "part-2:twin" : "part-2"}, map}));
    const auto is = placedStrokes(after, {})[0].trails[twin ? 1 : 0];
    const Plane plane = *before.parts[1]->mirror;
    for (size_t i = 0; i < was.points.size(); ++i) {
      const Vec3 from = twin ? mirrored(was.points[i], plane) : was.points[i];
      REQUIRE(distance(is.points[i], map(from)) < 1e-6);
    }
    // What the frame does needs no other stroke.
    if (run % 3 == 0) REQUIRE(after.weight_strokes[0] == before.weight_strokes[0]);
  }
}

TEST_CASE("weight strokes: a part that is mirrored across its own plane has them on the other side",
          "[weight_strokes]") {
  WeightStroke stroke = onLeg();
  stroke.part = "part-1";
  const Document before = must(apply(creature(), AddWeightStroke{stroke}));
  const Affine mirror{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};
  const Document after = must(apply(before, TransformParts{{"part-1"}, mirror}));
  REQUIRE(after.parts == before.parts);
  std::vector<Vec3> mirrored_points;
  for (const Vec3 p : stroke.points) mirrored_points.push_back(mirror(p));
  REQUIRE(apart(placedStrokes(after, {})[0].trails[0].points, mirrored_points) < 1e-9);
}

TEST_CASE("weight strokes: they stay on the surface of what becomes thicker or thinner",
          "[weight_strokes]") {
  Evaluation evaluation;
  Document drawn = creature(), imported;
  evaluation.update(drawn);
  Mesh lopsided = evaluation.parts()[1].part->mesh;
  for (Vec3& p : lopsided.positions) p.z = 1.3 * p.z + 4 + 0.1 * p.x;
  const auto mesh = std::make_shared<const Mesh>(lopsided);
  const Frame frame = drawn.parts[1]->frame;
  for (int i = 0; i < 2; ++i) imported = must(apply(imported, ImportPart{mesh, "Leg", frame}));
  imported = must(apply(imported, SetMirror{{"part-2"}, Plane{{0, 0, 1}, 0}}));

  for (const Document& start : {drawn, imported}) {
    // Where vertices are, so that it can be told where they went.
    Document document = start;
    evaluation.update(document);
    const auto surface = [&](size_t k) {
      return evaluation.placed()[1].frame.toWorld(
          evaluation.parts()[1].part->mesh.positions[17 * k]);
    };
    WeightStroke stroke = onLeg();
    stroke.radius = 1e-3;
    for (size_t k = 0; k < 20; ++k) stroke.points.push_back(surface(k));
    stroke.points.erase(stroke.points.begin(), stroke.points.begin() + 3);
    document = must(apply(document, AddWeightStroke{stroke}));
    const auto isOnSurface = [&](const Document& changed) {
      evaluation.update(changed);
      const auto trails = placedStrokes(changed, {})[0].trails;
      const Plane plane = *changed.parts[1]->mirror;
      for (size_t k = 0; k < 20; ++k) {
        CAPTURE(k);
        REQUIRE(distance(trails[0].points.at(k), surface(k)) < 1e-4);
        REQUIRE(distance(trails[1].points.at(k), mirrored(surface(k), plane)) <
                1e-4);  // meshes are kept as floats
      }
    };
    isOnSurface(document);
    for (const double thickness : {2.5, 4., 0.3, 0.05, 1.}) {
      document = must(apply(document, SetThickness{{"part-2:twin", "part-1"}, thickness}));
      isOnSurface(document);
      const Document same = must(apply(document, SetThickness{{"part-2"}, thickness}));
      REQUIRE(same.weight_strokes[0] == document.weight_strokes[0]);
    }
    const Document other = must(apply(document, SetThickness{{"part-1"}, 3}));
    REQUIRE(other.weight_strokes[0] == document.weight_strokes[0]);
    // Stretched along its depth further than a part can be thick, and sheared.
    const Frame& leg = document.parts[1]->frame;
    const Vec3 z = leg.z();
    Affine stretch;
    const auto stretched = [&](Vec3 axis) { return axis + (z * 9 + leg.y) * dot(z, axis); };
    stretch.x = stretched({1, 0, 0});
    stretch.y = stretched({0, 1, 0});
    stretch.z = stretched({0, 0, 1});
    isOnSurface(must(apply(document, TransformParts{{"part-2"}, stretch})));
    // The vertices of a drawn one change sides instead.
    Affine mirror;
    mirror.x = {-2, 0, 0};
    if (document.parts[1]->mesh) {
      isOnSurface(must(apply(document, TransformParts{{"part-2"}, mirror})));
    }
  }
}

TEST_CASE("weight strokes: copies have copies, for their own joints", "[weight_strokes]") {
  WeightStroke stroke = onLeg();
  Document document = must(apply(creature(), AddWeightStroke{stroke}));
  stroke.joint = "part-1/a:part-2";
  document = must(apply(document, AddWeightStroke{stroke}));
  document = must(apply(document, DuplicateParts{{"part-2"}, {10, 0, 0}}));
  REQUIRE(document.weight_strokes.size() == 4);
  REQUIRE(document.weight_strokes[1]->part == "part-3");
  REQUIRE(document.weight_strokes[1]->joint == "part-3/n1");
  REQUIRE(document.weight_strokes[3]->joint == "part-1/a:part-3");
  document = must(apply(document, DeleteParts{{"part-2"}}));
  REQUIRE(document.weight_strokes.size() == 2);
  REQUIRE(document.weight_strokes[0]->part == "part-3");
}

TEST_CASE("weight strokes: separated twins keep what each of them showed", "[weight_strokes]") {
  WeightStroke stroke = onLeg();
  Document document = must(apply(creature(), AddWeightStroke{stroke}));
  stroke.part = "part-1";
  stroke.joint = "part-2:twin/n0";
  document = must(apply(document, AddWeightStroke{stroke}));
  const auto before = placedStrokes(document, {});
  document = must(apply(document, SeparateTwins{{"part-2"}}));
  const auto after = placedStrokes(document, {});
  REQUIRE(after.size() == 3);
  REQUIRE(after[0].trails[0].joint == "part-2/n1");
  REQUIRE(after[1].trails[0].joint == "part-3/n1");
  REQUIRE(after[2].trails[0].joint == "part-3/n0");
  REQUIRE(apart(after[0].trails[0].points, before[0].trails[0].points) < 1e-9);
  REQUIRE(apart(after[1].trails[0].points, before[0].trails[1].points) < 1e-9);
  for (const auto& one : after) REQUIRE(one.trails.size() == 1);
}

TEST_CASE("weight strokes: they are cleared for one joint, on both sides, or all",
          "[weight_strokes]") {
  WeightStroke other = onLeg();
  other.joint = "part-1/n0";
  Document document = must(apply(creature(), AddWeightStroke{onLeg()}));
  document = must(apply(document, AddWeightStroke{other}));
  for (const char* joint : {"part-2/n1", "part-2:twin/n1"}) {
    const Document cleared = must(apply(document, ClearWeightStrokes{joint}));
    REQUIRE(cleared.weight_strokes.size() == 1);
    REQUIRE(cleared.weight_strokes[0] == document.weight_strokes[1]);
  }
  REQUIRE(must(apply(document, ClearWeightStrokes{"gone"})).weight_strokes.size() == 2);
  REQUIRE(must(apply(document, ClearWeightStrokes{})).weight_strokes.empty());
  document = must(apply(document, SetLocked{{"part-2"}, true}));
  REQUIRE(must(apply(document, ClearWeightStrokes{})).weight_strokes.size() == 2);
  REQUIRE(apply(document, AddWeightStroke{onLeg()}).status() == Status::locked);
}

TEST_CASE("weight strokes: what is none is refused, what is out of range brought into it",
          "[weight_strokes]") {
  const Document document = creature();
  const auto status = [&](const auto& change) {
    WeightStroke stroke = onLeg();
    change(stroke);
    return apply(document, AddWeightStroke{stroke}).status();
  };
  const double huge = std::numeric_limits<double>::infinity(), none = std::nan("");
  REQUIRE(status([](WeightStroke& s) { s.part = "part-9"; }) == Status::notFound);
  REQUIRE(status([](WeightStroke& s) { s.part = "part-1:twin"; }) == Status::notFound);
  REQUIRE(status([](WeightStroke& s) { s.joint.clear(); }) == Status::notFound);
  for (const double bad : {0., -1., none, huge, 1e60}) {
    REQUIRE(status([&](WeightStroke& s) { s.radius = bad; }) == Status::noArea);
  }
  REQUIRE(status([](WeightStroke& s) { s.points.clear(); }) == Status::noArea);
  REQUIRE(status([&](WeightStroke& s) {
            s.points = {{none, 0, 0}, {0, huge, 0}};
          }) == Status::noArea);
  REQUIRE(status([](WeightStroke& s) {
            for (int i = 0; i < 20000; ++i) s.points.push_back({i % 2 * 99., 0, 0});
          }) == Status::tooMany);
  WeightStroke stroke = onLeg();
  stroke.strength = none;
  stroke.points.insert(stroke.points.begin() + 1, 500, stroke.points[0]);
  const Document kept = must(apply(document, AddWeightStroke{stroke}));
  REQUIRE(kept.weight_strokes[0]->strength == 0);
  REQUIRE(kept.weight_strokes[0]->points.size() == 3);
  // A smooth stroke needs no joint.
  stroke.joint.clear();
  stroke.kind = WeightStroke::Kind::smooth;
  REQUIRE(apply(document, AddWeightStroke{stroke}));
}

TEST_CASE("weight strokes: ids of parts with slashes are found in joints' ids",
          "[weight_strokes]") {
  const auto turned = [](const std::string& joint) {
    return renamedJoint(joint, [](const std::string& id) { return "<" + id + ">"; });
  };
  REQUIRE(turned("part-1/n0") == "<part-1>/n0");
  REQUIRE(turned("a//b/b1.17") == "<a//b>/b1.17");
  REQUIRE(turned("a///a:c//d") == "<a//>/a:<c//d>");
  REQUIRE(turned("part-1/a:part-2:twin") == "<part-1>/a:<part-2:twin>");
  REQUIRE(turned("odd") == "<odd>");
  REQUIRE(turned("") == "<>");
}

TEST_CASE("weight strokes: steps are called by what they do", "[weight_strokes]") {
  const Document document = creature();
  WeightStroke stroke = onLeg();
  REQUIRE(describe(document, AddWeightStroke{stroke}) == "Add weight on part 2");
  stroke.kind = WeightStroke::Kind::take;
  REQUIRE(describe(document, AddWeightStroke{stroke}) == "Take weight on part 2");
  stroke.kind = WeightStroke::Kind::smooth;
  REQUIRE(describe(document, AddWeightStroke{stroke}) == "Smooth weights on part 2");
  REQUIRE(describe(document, ClearWeightStrokes{}) == "Clear painted weights");
  REQUIRE(describe(document, SetBlend{4}) == "Soft seams");
}

TEST_CASE("weight strokes: the softness of seams is kept within its range", "[weight_strokes]") {
  for (const auto& [given, kept] : {std::pair(12.5, 12.5), std::pair(-3., 0.),
                                    std::pair(1e9, 1000.), std::pair(std::nan(""), 0.)}) {
    const Document document = must(apply({}, SetBlend{given}));
    REQUIRE(document.blend == kept);
    REQUIRE(readDocument(writeDocument(document))->blend == kept);
  }
}

namespace {

/// Across x = 0, seen from the front: a body and two arms that hang on it.
struct Front {
  Document document;
  Evaluation evaluation{previewOptions()};

  Front(Vec2 body, Vec3 arm) {
    document.symmetry = Plane{{1, 0, 0}, 0};
    for (const bool is_arm : {false, true}) {
      AddPart part{unitCircle(40)};
      for (Vec2& p : part.stroke)
        p = is_arm ? Vec2{70 * p.x, 16 * p.y} : Vec2{body.x * p.x, body.y * p.y};
      if (is_arm) part.frame.origin = arm;
      if (is_arm) part.mirror = document.symmetry;
      document = must(apply(document, part));
    }
    evaluation.update(document);
  }
  const Rig& rig() const { return evaluation.rig(); }
  bool has(const std::string& id) const {
    return std::any_of(rig().joints.begin(), rig().joints.end(),
                       [&](const Rig::Joint& joint) { return joint.id == id; });
  }
  /// The body's joint at which the arm on one side hangs.
  const Rig::Joint& shoulder(double side) const {
    for (const auto& bone : rig().bones) {
      const Rig::Joint &joint = rig().joints[bone[0]], &arm = rig().joints[bone[1]];
      if (joint.part == 0 && arm.part != 0 && arm.position.x * side > 0) return joint;
    }
    FAIL("no arm hangs on that side");
    return rig().joints[0];
  }
  /// For a joint, on the arm or its twin, as the brush leaves it.
  Document painted(const std::string& part, const std::string& joint) const {
    WeightStroke stroke;
    stroke.part = part;
    stroke.joint = joint;
    stroke.points = {{part == "part-2" ? 120. : -120., 0, 0}};
    return must(apply(document, AddWeightStroke{forJointOfRig(document, rig(), stroke)}));
  }
};

}  // namespace

TEST_CASE("weight strokes: the mirror image is for the joint on the other side of one body",
          "[weight_strokes]") {
  const Front front({150, 40}, {170, 0, 0});
  const Rig::Joint &left = front.shoulder(1), &right = front.shoulder(-1);
  REQUIRE(left.position.x > 30);
  REQUIRE(right.position.x < -30);
  for (const bool twin : {false, true}) {
    for (const Rig::Joint* joint : {&left, &right}) {
      const Document painted = front.painted(twin ? "part-2:twin" : "part-2", joint->id);
      const auto placed = placedStrokes(painted, front.rig());
      REQUIRE(placed.size() == 1);
      REQUIRE(placed[0].trails.size() == 2);
      const auto& here = placed[0].trails[twin ? 1 : 0];
      const auto& there = placed[0].trails[twin ? 0 : 1];
      CHECK(here.points[0].x * (twin ? -1 : 1) > 0);
      CHECK(here.joint == joint->id);
      CHECK(there.joint == (joint == &left ? right.id : left.id));
    }
  }
}

TEST_CASE("weight strokes: arms that hang at one joint are both painted for it",
          "[weight_strokes]") {
  const Front front({40, 150}, {70, 30, 0});
  const std::string held = "part-1/a:part-2";
  REQUIRE(front.has(held));
  REQUIRE_FALSE(front.has(oppositeJoint(front.document, held)));
  for (const char* part : {"part-2", "part-2:twin"}) {
    const auto placed = placedStrokes(front.painted(part, held), front.rig());
    REQUIRE(placed.size() == 1);
    REQUIRE(placed[0].trails.size() == 2);
    for (const auto& trail : placed[0].trails) CHECK(trail.joint == held);
  }
  // So are those that were painted when they hung apart.
  Document before = front.painted("part-2", held);
  WeightStroke stroke = *before.weight_strokes[0];
  stroke.joint = oppositeJoint(before, held);
  before.weight_strokes[0] = std::make_shared<const WeightStroke>(stroke);
  const auto apart = placedStrokes(before, front.rig());
  for (const auto& trail : apart[0].trails) CHECK(trail.joint == held);
  // Joints of the arms are those of the own arm each.
  const auto end = std::find_if(front.rig().bones.begin(), front.rig().bones.end(),
                                [&](auto& bone) { return front.rig().joints[bone[0]].part == 1; });
  REQUIRE(end != front.rig().bones.end());
  const std::string id = front.rig().joints[(*end)[0]].id;
  const auto placed = placedStrokes(front.painted("part-2", id), front.rig());
  CHECK(placed[0].trails[0].joint == id);
  CHECK(placed[0].trails[1].joint == oppositeJoint(front.document, id));
}
