#include "document/evaluation.h"

#include <cstring>
#include <set>

#include "document/command.h"
#include "document/history.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/drawings.h"

using namespace marrow;

namespace {

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool sameSkeleton(const PartSkeleton& a, const PartSkeleton& b) {
  if (a.joints.size() != b.joints.size() || !sameBits(a.bones, b.bones)) return false;
  for (size_t i = 0; i < a.joints.size(); ++i) {
    const auto &p = a.joints[i], &q = b.joints[i];
    if (p.kind != q.kind || p.position != q.position || p.radius != q.radius) return false;
  }
  return true;
}

/// Everything but the timings.
bool samePart(const Part& a, const Part& b) {
  return sameBits(a.outline.dense, b.outline.dense) &&
         sameBits(a.outline.polygon, b.outline.polygon) &&
         sameBits(a.straight_skeleton.nodes, b.straight_skeleton.nodes) &&
         sameBits(a.straight_skeleton.times, b.straight_skeleton.times) &&
         sameBits(a.axis.points, b.axis.points) && sameBits(a.axis.edges, b.axis.edges) &&
         sameSkeleton(a.skeleton, b.skeleton) && sameBits(a.mesh.positions, b.mesh.positions) &&
         sameBits(a.mesh.triangles, b.mesh.triangles) && sameBits(a.normals, b.normals) &&
         sameBits(a.depths, b.depths) && sameBits(a.inscribed_radii, b.inscribed_radii);
}

void requireFresh(const Evaluation& evaluation, const Document& document) {
  Evaluation fresh;
  fresh.update(document);
  REQUIRE(evaluation.parts().size() == document.parts.size());
  for (size_t i = 0; i < document.parts.size(); ++i) {
    const EvaluatedPart &ours = evaluation.parts()[i], &theirs = fresh.parts()[i];
    REQUIRE(ours.source == document.parts[i]);
    REQUIRE((ours.part != nullptr) == (theirs.part != nullptr));
    REQUIRE(ours.error.status == theirs.error.status);
    if (ours.part) REQUIRE(samePart(*ours.part, *theirs.part));
  }
  REQUIRE(evaluation.placed().size() == fresh.placed().size());
  for (size_t i = 0; i < fresh.placed().size(); ++i) {
    REQUIRE(evaluation.placed()[i].id == fresh.placed()[i].id);
    REQUIRE(evaluation.placed()[i].frame == fresh.placed()[i].frame);
  }
  REQUIRE(evaluation.rig() == fresh.rig());
}

std::set<std::string> stages(const Part& part) {
  std::set<std::string> names;
  for (const auto& stage : part.timings.stages_ms) names.insert(stage.first);
  return names;
}

Document with(const Document& document, const Command& command) {
  auto next = apply(document, command);
  REQUIRE(next);
  return *next;
}

}  // namespace

TEST_CASE("evaluation: an unchanged document computes nothing", "[evaluation]") {
  const Document document = drawnDocument(4);
  Evaluation evaluation;
  evaluation.update(document);
  REQUIRE(evaluation.recomputed() == 4);
  const auto before = evaluation.parts();
  evaluation.update(document);
  REQUIRE(evaluation.recomputed() == 0);
  for (size_t i = 0; i < before.size(); ++i) {
    REQUIRE(evaluation.parts()[i].part == before[i].part);
    REQUIRE(evaluation.parts()[i].mesh_id == before[i].mesh_id);
    REQUIRE(evaluation.parts()[i].skeleton_id == before[i].skeleton_id);
  }
}

TEST_CASE("evaluation: an equal document read anew computes nothing", "[evaluation]") {
  const Document document = drawnDocument(2);
  Document copy;
  for (const auto& part : document.parts) {
    copy.parts.push_back(std::make_shared<const PartSource>(*part));
  }
  Evaluation evaluation;
  evaluation.update(document);
  evaluation.update(copy);
  REQUIRE(evaluation.recomputed() == 0);
  REQUIRE(evaluation.parts()[0].source == copy.parts[0]);
}

TEST_CASE("evaluation: a new part leaves the others alone", "[evaluation]") {
  Document document = drawnDocument(2);
  Evaluation evaluation;
  evaluation.update(document);
  const auto before = evaluation.parts();
  document = with(document, AddPart{softStar(6, 90)});
  evaluation.update(document);
  REQUIRE(evaluation.recomputed() == 1);
  REQUIRE(evaluation.parts()[1].part == before[1].part);
  document = with(document, DeleteParts{{"part-1"}});
  evaluation.update(document);
  REQUIRE(evaluation.recomputed() == 0);
  REQUIRE(evaluation.parts()[0].part == before[1].part);
}

TEST_CASE("evaluation: colour and name compute nothing", "[evaluation]") {
  Document document = drawnDocument(2);
  Evaluation evaluation;
  evaluation.update(document);
  const auto before = evaluation.parts();
  document = with(document, SetColor{{"part-2"}, {1, 2, 3}});
  document = with(document, RenamePart{"part-1", "Belly"});
  evaluation.update(document);
  REQUIRE(evaluation.recomputed() == 0);
  for (size_t i = 0; i < 2; ++i) {
    REQUIRE(evaluation.parts()[i].part == before[i].part);
    REQUIRE(evaluation.parts()[i].source == document.parts[i]);
  }
}

TEST_CASE("evaluation: thickness redoes neither skeleton nor triangulation", "[evaluation]") {
  Document document = drawnDocument(2);
  Evaluation evaluation;
  evaluation.update(document);
  const auto before = evaluation.parts();
  document = with(document, SetThickness{{"part-2"}, 2});
  evaluation.update(document);
  REQUIRE(evaluation.recomputed() == 1);
  const EvaluatedPart& thick = evaluation.parts()[1];
  REQUIRE(stages(*thick.part) == std::set<std::string>{"inflation", "normals", "proxy"});
  REQUIRE(thick.mesh_id != before[1].mesh_id);
  requireFresh(evaluation, document);
}

TEST_CASE("evaluation: parts of the same stroke and thickness share one body", "[evaluation]") {
  Document document;
  for (int i = 0; i < 20; ++i) document = with(document, AddPart{softStar(6, 90)});
  document = with(document, SetThickness{{"part-20"}, 2});
  Evaluation evaluation;
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 2);
  const auto& parts = evaluation.parts();
  for (size_t i = 1; i < 19; ++i) {
    CHECK(parts[i].part == parts[0].part);
    CHECK(parts[i].mesh_id == parts[0].mesh_id);
    CHECK(parts[i].skeleton_id != parts[0].skeleton_id);
  }
  CHECK(parts[19].part != parts[0].part);
  CHECK(parts[19].mesh_id != parts[0].mesh_id);
  requireFresh(evaluation, document);

  // One that goes its own way leaves the others theirs, and finds back.
  document = with(document, SetThickness{{"part-3"}, 3});
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 1);
  CHECK(evaluation.parts()[2].part != evaluation.parts()[0].part);
  requireFresh(evaluation, document);
  document = with(document, SetThickness{{"part-3"}, 1});
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 0);
  CHECK(evaluation.parts()[2].part == evaluation.parts()[0].part);

  // A copy that is added later costs nothing either.
  document = with(document, AddPart{softStar(6, 90)});
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 0);
  CHECK(evaluation.parts()[20].part == evaluation.parts()[0].part);
}

TEST_CASE("evaluation: thousands of parts have a few times the points of 64", "[evaluation]") {
  const auto pointsOf = [](size_t parts) {
    double sum = 0;
    for (size_t i = 0; i < parts; ++i) sum += pointsOfPart(i, 1000);
    return sum;
  };
  CHECK(pointsOf(64) == 64000);
  CHECK(pointsOf(500) < 2 * pointsOf(64));
  CHECK(pointsOf(5000) < 6 * pointsOf(64));
  for (size_t i = 0; i < 10000; ++i) {
    REQUIRE(pointsOfPart(i + 1, 1000) <= pointsOfPart(i, 1000));
    REQUIRE(pointsOfPart(i, 1000) >= TriangulationOptions::kFewest);
    REQUIRE(pointsOfPart(i, 20) == 20);
  }

  // Nor does a part that is added change another one.
  Document document;
  const auto star = [](int i) { return softStar(3 + i % 4, 60 + i); };
  for (int i = 0; i < 130; ++i) document = with(document, AddPart{star(i)});
  Evaluation evaluation;
  evaluation.update(document);
  const auto before = evaluation.parts();
  CHECK(before[63].points == 1000);
  CHECK(before[64].points == 250);
  CHECK(before[128].points == 125);
  for (const EvaluatedPart& part : before) CHECK(validate(part.part->mesh).empty());
  document = with(document, AddPart{star(130)});
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 1);
  for (size_t i = 0; i < before.size(); ++i) CHECK(evaluation.parts()[i].part == before[i].part);
  // Where one goes, only those that come to another place in the order of sizes change.
  document = with(document, DeleteParts{{"part-2"}});
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 2);
  CHECK(evaluation.parts()[1].part == before[2].part);
  CHECK(evaluation.parts()[63].points == 1000);
  CHECK(evaluation.parts()[127].points == 250);
  // A copy is a copy, wherever it comes.
  for (int i = 0; i < 100; ++i) document = with(document, AddPart{star(0)});
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 0);
  CHECK(evaluation.parts()[229].part == before[0].part);
  for (int i = 0; i < 300; ++i) {
    Frame elsewhere;
    elsewhere.origin.x = 10.0 * (i + 1);
    document = with(document, AddPart{star(0), elsewhere});
  }
  evaluation.update(document);
  CHECK(evaluation.recomputed() == 1);
  CHECK(evaluation.parts()[529].points == 62);
  CHECK(evaluation.parts()[529].part == evaluation.parts()[0].part);
  requireFresh(evaluation, document);
}

TEST_CASE("evaluation: placing and refining build no part anew", "[evaluation]") {
  Document document = drawnDocument(3);
  Evaluation evaluation;
  evaluation.update(document);
  const auto before = evaluation.parts();
  const auto& simplify = &Refinement::simplify;
  const std::vector<Command> commands = {
      TransformParts{{"part-2"}, Affine{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}, {5, 6, 7}}},
      SetMirror{{"part-3"}, Plane{{1, 0, 0}, -300}},
      SetRefinement{{"part-1"}, "", simplify, 40.0},
      SetRefinement{{"part-1"}, "b0", simplify, 1.0},
      SetRefinement{{}, "", &Refinement::merge, 100.0},
      SetSkeleton{{"part-3"}, false},
      SetAttachment{"part-2", Attachment{}},
      SetVisible{{"part-1"}, false},
  };
  for (const Command& command : commands) {
    document = with(document, command);
    evaluation.update(document);
    REQUIRE(evaluation.recomputed() == 0);
    requireFresh(evaluation, document);
  }
  for (size_t i = 0; i < 3; ++i) REQUIRE(evaluation.parts()[i].part == before[i].part);
  REQUIRE(evaluation.placed().size() == 4);
}

TEST_CASE("evaluation: the rig's id changes when the rig does, and never comes back",
          "[evaluation]") {
  const Document first = drawnDocument(3);
  Evaluation evaluation;
  evaluation.update(first);
  std::set<uint64_t> ids{evaluation.rigId()};
  const auto changes = [&](const Document& document) {
    evaluation.update(document);
    return ids.insert(evaluation.rigId()).second;
  };
  REQUIRE_FALSE(changes(first));
  REQUIRE_FALSE(changes(with(first, SetColor{{"part-2"}, {1, 2, 3}})));
  REQUIRE_FALSE(changes(with(first, SetVisible{{"part-2"}, false})));
  REQUIRE(changes(with(first, RenamePart{"part-1", "Belly"})));
  REQUIRE(changes(first));
  REQUIRE(changes(with(first, SetRefinement{{}, "", &Refinement::simplify, 0.5})));
  REQUIRE(changes(first));
  REQUIRE(changes(with(
      first, TransformParts{{"part-3"}, Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 500, 0}}})));
  REQUIRE(changes(with(first, DeleteParts{{"part-1"}})));
}

TEST_CASE("evaluation: a part still being drawn joins the rig that it is added to",
          "[evaluation]") {
  const Document document = drawnDocument(2);
  Evaluation evaluation;
  evaluation.update(document);
  const auto drawn = with(document, AddPart{softStar(3, 50, {30, 20})});
  const PartSource& source = *drawn.parts.back();
  const auto part = buildPart(source.stroke);
  REQUIRE(part);
  const PlacedPart placed = placedParts(drawn).back();
  std::vector<RigPart> parts = evaluation.rigParts();
  parts.push_back({&placed, &source, &*part});
  const Rig live = makeRig(parts, document.refine);

  evaluation.update(drawn);
  REQUIRE(live == evaluation.rig());
  REQUIRE(live.connections.back().child == 2);
}

TEST_CASE("evaluation: after any commands it equals an evaluation from nothing", "[evaluation]") {
  Random random(7);
  for (int run = 0; run < 6; ++run) {
    History history(drawnDocument(2));
    Evaluation evaluation;
    std::set<uint64_t> mesh_ids;
    for (int step = 0; step < 25; ++step) {
      const Document& document = history.current();
      const int count = static_cast<int>(document.parts.size());
      const std::string id =
          count > 0 ? document.parts[static_cast<size_t>(random.below(count))]->id : "";
      Command command = AddPart{softStar(2 + random.below(5), random.between(20, 90))};
      switch (random.below(8)) {
        case 0:
          command = DeleteParts{{id}};
          break;
        case 1:
        case 2:
          command = SetThickness{{id}, random.between(0, 4.5)};
          break;
        case 3:
        case 4:
          command = SetRefinement{{id}, "", &Refinement::simplify, random.between(0, 50)};
          break;
        case 5:
          command = SetRefinement{{id}, "", &Refinement::simplify, std::nullopt};
          break;
        case 6:
          history.undo();
          break;
      }
      auto next = apply(history.current(), command);
      if (next) history.push(*next, describe(history.current(), command));
      // Several changes may come between two updates.
      if (random.below(3) == 0) continue;
      evaluation.update(history.current());
      requireFresh(evaluation, history.current());
    }
  }
}

TEST_CASE("evaluation: a part that cannot be made says why and harms no other", "[evaluation]") {
  Document document = drawnDocument(2);
  auto flat = std::make_shared<PartSource>(*document.parts[0]);
  flat->id = "flat";
  flat->stroke = {{0, 0}, {1, 1}, {2, 2}};
  document.parts.insert(document.parts.begin() + 1, flat);
  Evaluation evaluation;
  evaluation.update(document);
  REQUIRE(evaluation.parts()[0].part);
  REQUIRE_FALSE(evaluation.parts()[1].part);
  REQUIRE(evaluation.parts()[1].error.status == Status::noArea);
  REQUIRE(evaluation.parts()[2].part);
  evaluation.update(with(document, SetThickness{{"flat"}, 3}));
  REQUIRE_FALSE(evaluation.parts()[1].part);
  REQUIRE(evaluation.parts()[1].error.status == Status::noArea);
}

TEST_CASE("evaluation: any creature equals its evaluation from nothing", "[evaluation]") {
  Random random(11);
  Evaluation evaluation;
  for (int run = 0; run < 8; ++run) {
    Document creature = randomCreature(random, 2 + random.below(8));
    evaluation.update(creature);
    requireFresh(evaluation, creature);
    // Parts of the last creature under the same id do no harm.
    for (int step = 0; step < 3; ++step) {
      const auto ids = allPlacedIds(creature);
      const std::string id = ids[static_cast<size_t>(random.below(static_cast<int>(ids.size())))];
      creature = with(creature, TransformParts{{id}, randomSimilarity(random, 50)});
      evaluation.update(creature);
      requireFresh(evaluation, creature);
    }
  }
}

TEST_CASE("evaluation: mesh and skeleton ids are never used twice", "[evaluation]") {
  History history(drawnDocument(2));
  Evaluation evaluation;
  evaluation.update(history.current());
  std::set<uint64_t> meshes, skeletons;
  const auto note = [&](size_t index) {
    meshes.insert(evaluation.parts()[index].mesh_id);
    skeletons.insert(evaluation.parts()[index].skeleton_id);
  };
  note(0);
  note(1);
  history.push(with(history.current(), SetThickness{{"part-1"}, 2}), "");
  evaluation.update(history.current());
  note(0);
  history.undo();
  evaluation.update(history.current());
  note(0);
  REQUIRE(meshes.size() == 4);
  REQUIRE(skeletons.size() == 4);
}
