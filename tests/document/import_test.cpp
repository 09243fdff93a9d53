// Parts that are meshes: commands, evaluation, files and what stands on them.
#include <algorithm>
#include <cmath>

#include "character/character.h"
#include "document/command.h"
#include "document/evaluation.h"
#include "document/history.h"
#include "document/reference_image.h"
#include "io/document_json.h"
#include "io/json.h"
#include "rig/connect.h"
#include "sketch/polygon.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/soundness.h"

namespace marrow {
namespace {

/// A bent limb that is not the same in front and behind: a tube along a curve.
Mesh limb() {
  constexpr int kAround = 12, kAlong = 24;
  Mesh mesh;
  for (int i = 0; i <= kAlong; ++i) {
    const double t = static_cast<double>(i) / kAlong;
    const Vec3 middle{200 * t - 100, 40 * t * t, 60 * t * (1 - t)};
    const double radius = 18 - 8 * t;
    for (const Vec2 p : unitCircle(kAround)) {
      mesh.positions.push_back(middle + Vec3{0, p.x * radius, p.y * radius});
    }
  }
  const auto at = [](int i, int j) { return static_cast<uint32_t>(i * kAround + j % kAround); };
  for (int i = 0; i < kAlong; ++i) {
    for (int j = 0; j < kAround; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  for (int j = 1; j + 1 < kAround; ++j) {
    mesh.triangles.push_back({at(0, 0), at(0, j + 1), at(0, j)});
    mesh.triangles.push_back({at(kAlong, 0), at(kAlong, j), at(kAlong, j + 1)});
  }
  if (inspect(mesh).volume < 0) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

std::shared_ptr<const Mesh> shared(Mesh mesh) {
  return std::make_shared<const Mesh>(std::move(mesh));
}

Document must(const Document& document, const Command& command) {
  auto next = apply(document, command);
  CAPTURE(describe(document, command), next.message());
  REQUIRE(next);
  CHECK(faultOf(*next) == "");
  return *next;
}

Document withLimb() { return must({}, ImportPart{shared(limb()), "Limb"}); }

Evaluation evaluated(const Document& document) {
  Evaluation evaluation;
  evaluation.update(document);
  return evaluation;
}

/// The body of a placed part in space.
Mesh inSpace(const Evaluation& evaluation, size_t placed) {
  const PlacedPart& one = evaluation.placed()[placed];
  Mesh mesh = evaluation.parts()[one.source].shapeOf(one)->mesh;
  for (Vec3& p : mesh.positions) p = one.frame.toWorld(p);
  return mesh;
}

bool isInside(const Mesh& mesh, Vec3 p) {
  Mesh moved = mesh;
  for (Vec3& q : moved.positions) q = q - Vec3{0, 0, p.z};
  const auto span = DepthRays(moved).at({p.x, p.y});
  return span && span->low < 0 && span->high > 0;
}

}  // namespace

TEST_CASE("import: a part with a skeleton at mid depth, in balls no larger than the body",
          "[import]") {
  const Evaluation evaluation = evaluated(withLimb());
  REQUIRE(evaluation.parts()[0].part);
  const Part& part = *evaluation.parts()[0].part;
  CHECK(part.skeleton.bones.size() >= 2);
  CHECK(inspect(part.mesh).volume == Approx(inspect(limb()).volume).epsilon(1e-6));
  double deepest = 0;
  for (const auto& joint : part.skeleton.joints) {
    const double t = (joint.position.x + 100) / 200;
    CHECK(joint.depth == Approx(60 * t * (1 - t)).margin(1.5));
    CHECK(joint.radius < 20);
    CHECK(joint.radius > 5);
    deepest = std::max(deepest, joint.depth);
  }
  CHECK(deepest > 10);
  const Mesh body = inSpace(evaluation, 0);
  for (const Rig::Joint& joint : evaluation.rig().joints) CHECK(isInside(body, joint.position));
}

TEST_CASE("import: a finer skeleton stays within the body, too", "[import]") {
  Document document = withLimb();
  document = must(document, SetRefinement{{"part-1"}, "", &Refinement::simplify, 0.2});
  const Evaluation evaluation = evaluated(document);
  CHECK(evaluation.rig().joints.size() >= 5);
  const Mesh body = inSpace(evaluation, 0);
  for (const Rig::Joint& joint : evaluation.rig().joints) CHECK(isInside(body, joint.position));
}

TEST_CASE("import: an inflated part that is imported again gets the skeleton it was drawn with",
          "[import]") {
  std::vector<Vec2> stroke = unitCircle(60);
  for (Vec2& p : stroke) p = {p.x * 140, p.y * 35 + 0.001 * p.x * p.x * 140};
  const Document drawn = must({}, AddPart{stroke});
  const Evaluation first = evaluated(drawn);
  const Document document = must({}, ImportPart{shared(first.parts()[0].part->mesh), ""});
  const Evaluation second = evaluated(document);
  CHECK(document.parts[0]->name == "Part 1");
  const auto &ours = first.rig().joints, &theirs = second.rig().joints;
  REQUIRE(ours.size() == theirs.size());
  for (size_t i = 0; i < ours.size(); ++i) {
    double nearest = 1e9;
    for (const auto& joint : theirs) {
      nearest = std::min(nearest, distance(joint.position, ours[i].position));
    }
    CHECK(nearest < 15);  // of 280
  }
}

TEST_CASE("import: a twin is the mirror image, bones and body", "[import]") {
  Document document = withLimb();
  const Plane plane{{0.6, 0, 0.8}, 30};
  document = must(document, SetMirror{{"part-1"}, plane});
  const Evaluation evaluation = evaluated(document);
  REQUIRE(evaluation.placed().size() == 2);
  const Mesh body = inSpace(evaluation, 0), twin = inSpace(evaluation, 1);
  for (size_t i = 0; i < body.positions.size(); ++i) {
    if (distance(mirrored(body.positions[i], plane), twin.positions[i]) > 1e-9) FAIL(i);
  }
  CHECK(inspect(twin).volume == Approx(inspect(body).volume));
  CHECK(evaluation.parts()[0].meshOf(evaluation.placed()[0]) !=
        evaluation.parts()[0].meshOf(evaluation.placed()[1]));
  size_t twins = 0;
  for (const Rig::Joint& joint : evaluation.rig().joints) {
    if (joint.part != 1) continue;
    ++twins;
    const auto same = std::find_if(
        evaluation.rig().joints.begin(), evaluation.rig().joints.end(), [&](const auto& other) {
          return other.part == 0 &&
                 distance(mirrored(other.position, plane), joint.position) < 1e-9;
        });
    CHECK(same != evaluation.rig().joints.end());
  }
  CHECK(twins > 2);

  const Document apart = must(document, SeparateTwins{{"part-1"}});
  REQUIRE(apart.parts.size() == 2);
  const Mesh separate = inSpace(evaluated(apart), 1);
  for (size_t i = 0; i < twin.positions.size(); ++i) {
    if (distance(separate.positions[i], twin.positions[i]) > 1e-9) FAIL(i);
  }
}

TEST_CASE("import: any map that keeps shapes takes the body with it, mirrors too", "[import]") {
  Random random(4);
  const Document document = withLimb();
  const Mesh before = inSpace(evaluated(document), 0);
  for (int run = 0; run < 20; ++run) {
    Affine map = randomSimilarity(random);
    if (run % 2) map.z = -map.z;
    const Document after = must(document, TransformParts{{"part-1"}, map});
    const Mesh body = inSpace(evaluated(after), 0);
    for (size_t i = 0; i < body.positions.size(); ++i) {
      if (distance(map(before.positions[i]), body.positions[i]) > 1e-6) FAIL(run);
    }
    CHECK(inspect(body).volume > 0);
  }
}

TEST_CASE("import: what is stretched in the frame's plane or across it stays true", "[import]") {
  const Document document = withLimb();
  const Mesh before = inSpace(evaluated(document), 0);
  Affine map;
  map.x = {2, 0, 0};
  map.y = {0.5, 0.7, 0};
  map.z = {0, 0, 1.5};
  const Document after = must(document, TransformParts{{"part-1"}, map});
  const Mesh body = inSpace(evaluated(after), 0);
  for (size_t i = 0; i < body.positions.size(); ++i) {
    if (distance(map(before.positions[i]), body.positions[i]) > 1e-4) FAIL(i);
  }
  map.y = {1e-12, 0, 0};
  CHECK(apply(document, TransformParts{{"part-1"}, map}).status() == Status::noArea);
}

TEST_CASE("import: thickness scales the depth, of bones too, as if it was imported so",
          "[import]") {
  const Document thick = must(withLimb(), SetThickness{{"part-1"}, 2});
  Evaluation evaluation = evaluated(withLimb());
  const uint64_t mesh = evaluation.parts()[0].mesh_id;
  evaluation.update(thick);
  CHECK(evaluation.parts()[0].mesh_id != mesh);
  const Evaluation fresh = evaluated(thick);
  const Part &one = *evaluation.parts()[0].part, &other = *fresh.parts()[0].part;
  REQUIRE(one.mesh.positions == other.mesh.positions);
  REQUIRE(one.normals == other.normals);
  for (size_t i = 0; i < one.mesh.positions.size(); ++i) {
    if (one.mesh.positions[i].z != 2 * one.depths[i]) FAIL(i);
  }
  for (size_t i = 0; i < one.skeleton.joints.size(); ++i) {
    CHECK(one.skeleton.joints[i].depth == other.skeleton.joints[i].depth);
    CHECK(one.skeleton.joints[i].radius == other.skeleton.joints[i].radius);
  }
}

TEST_CASE("import: it is written and read to the same bits, with fields nobody knows", "[import]") {
  Document document = must(withLimb(), SetMirror{{"part-1"}, Plane{{0, 0, 1}, 5}});
  const std::string text = writeDocument(document);
  const auto read = readDocument(text);
  REQUIRE(read);
  CHECK(read->parts[0]->mesh->positions == document.parts[0]->mesh->positions);
  CHECK(read->parts[0]->mesh->triangles == document.parts[0]->mesh->triangles);
  CHECK(read->parts[0]->stroke == document.parts[0]->stroke);
  CHECK(writeDocument(*read) == text);

  Json tree = *parseJson(text);
  tree["parts"][0].erase("stroke");
  tree["parts"][0]["mesh"]["uv"] = "kept";
  const auto bare = readDocument(toText(tree));
  REQUIRE(bare);
  CHECK(bare->parts[0]->stroke == document.parts[0]->stroke);
  CHECK(writeDocument(*bare).find("\"uv\":\"kept\"") != std::string::npos);
}

TEST_CASE("import: as many models as a drawing takes can be read back, and more are refused",
          "[import]") {
  static_assert(3 * kLargestImage + 32 * Document::kMostTriangles < kLargestText);
  const Mesh ring = torusMesh({}, 100, 30, 240, 200);
  REQUIRE(ring.triangles.size() == 96'000);
  const ImportPart import{shared(ring), "Ring"};
  Document document = must({}, import);
  const Document twins = must(document, SetMirror{{"part-1"}, Plane{{1, 0, 0}, 300}});
  while (document.parts.size() < 5) document = must(document, DuplicateParts{{"part-1"}, {}});

  const std::string text = writeDocument(document);
  const auto read = readDocument(text);
  REQUIRE(read);
  CHECK(read->parts.size() == 5);

  const Document mirrored = must(document, SetMirror{{"part-5"}, Plane{{1, 0, 0}, 300}});
  for (const Command& command : {Command(import), Command(DuplicateParts{{"part-2"}, {}}),
                                 Command(SeparateTwins{{"part-5"}})}) {
    const auto refused = apply(mirrored, command);
    REQUIRE(!refused);
    CHECK(refused.status() == Status::tooMany);
    CHECK(refused.message().find("500,000 triangles") != std::string::npos);
  }
  CHECK(apply(twins, SeparateTwins{{"part-1"}}));
  CHECK(apply(mirrored, AddPart{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}));
}

TEST_CASE("import: what is no solid is refused, in a command and in a file", "[import]") {
  CHECK(apply({}, ImportPart{nullptr, ""}).status() == Status::notSolid);
  CHECK(apply({}, ImportPart{shared({}), ""}).status() == Status::notSolid);
  Mesh holed = limb();
  holed.triangles.pop_back();
  CHECK(apply({}, ImportPart{shared(holed), ""}).status() == Status::notSolid);
  Mesh wild = limb();
  wild.positions[3].x = std::numeric_limits<double>::infinity();
  CHECK(!apply({}, ImportPart{shared(wild), ""}));
  Mesh wrong = limb();
  wrong.triangles[3][0] = 4'000'000'000;
  CHECK(apply({}, ImportPart{shared(wrong), ""}).status() == Status::notSolid);
  Mesh inward = limb();
  for (auto& triangle : inward.triangles) std::swap(triangle[1], triangle[2]);
  CHECK(apply({}, ImportPart{shared(inward), ""}).status() == Status::notSolid);
  Frame far;
  far.origin = {1e50, 0, 0};
  far.x = {1e40, 0, 0};
  far.y = {0, 1e40, 0};
  Mesh large = limb();
  for (Vec3& p : large.positions) p = p * 1e20;
  CHECK(!apply({}, ImportPart{shared(large), "", far}));

  const Json tree = *parseJson(writeDocument(withLimb()));
  const auto reads = [&](const char* key, const Json& value) {
    Json other = tree;
    other["parts"][0]["mesh"][key] = value;
    const auto document = readDocument(toText(other));
    if (!document) CHECK(document.message().find("mesh") != std::string::npos);
    return static_cast<bool>(document);
  };
  const std::string positions = tree["parts"][0]["mesh"]["positions"];
  CHECK(reads("positions", positions));
  CHECK_FALSE(reads("positions", ""));
  CHECK_FALSE(reads("positions", 7));
  CHECK_FALSE(reads("positions", "no base64!"));
  CHECK_FALSE(reads("positions", positions.substr(0, positions.size() - 16)));
  CHECK_FALSE(reads("positions", positions + "AAAAAAAAAAAAAAAA"));
  CHECK_FALSE(reads("triangles", ""));
  CHECK_FALSE(reads("triangles", "AAAAAAAAAAAAAAAA"));
  CHECK_FALSE(reads("triangles", std::string(2'000'000, 'A')));
}

TEST_CASE("import: a box is shown and written with sharp edges, as it is and as one body",
          "[import]") {
  Document document = must({}, ImportPart{shared(boxMesh({-50, -50, -50}, {50, 50, 50})), "Box"});
  document = must(document, SetMirror{{"part-1"}, Plane{{1, 0, 0}, 300}});
  Evaluation evaluation;
  evaluation.update(document);
  for (const PlacedPart& placed : evaluation.placed()) {
    const Part& part = *evaluation.parts()[placed.source].shapeOf(placed);
    CHECK(part.mesh.positions.size() == 8);
    CHECK(part.shown.vertices.size() == 24);
    for (size_t i = 0; i < 24; ++i) {
      // Out of the middle, and along an axis.
      const Vec3 n = part.shown.normals[i];
      CHECK(dot(n, part.mesh.positions[part.shown.vertices[i]]) == Approx(50));
      CHECK(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) == Approx(1));
    }
  }
  for (const bool merged : {true, false}) {
    CharacterOptions options;
    options.merged = merged;
    const Character made = makeCharacter(evaluation, options);
    size_t vertices = 0;
    for (const SkinnedMesh& mesh : made.meshes) {
      vertices += mesh.mesh.positions.size();
      CHECK(mesh.skin.size() == mesh.mesh.positions.size());
      for (const auto& triangle : mesh.mesh.triangles) {
        const Vec3 p = mesh.mesh.positions[triangle[0]];
        const Vec3 face =
            cross(mesh.mesh.positions[triangle[1]] - p, mesh.mesh.positions[triangle[2]] - p);
        for (const uint32_t v : triangle) {
          CHECK(dot(mesh.normals[v], face / length(face)) > 0.999);
        }
      }
    }
    CHECK(vertices == 48);
  }
}

TEST_CASE("import: what is seen edge-on is refused with what to do", "[import]") {
  for (const Vec3 size : {Vec3{0.01, 300, 300}, Vec3{300, 0.01, 300}, Vec3{1e-9, 300, 1e-9}}) {
    const auto refused = apply({}, ImportPart{shared(boxMesh({}, size)), "Plate"});
    REQUIRE(!refused);
    CHECK(refused.status() == Status::noArea);
    CHECK(refused.message().find("turn the view") != std::string::npos);
  }
  CHECK(apply({}, ImportPart{shared(boxMesh({}, {300, 300, 0.01})), "Plate"}));
}

TEST_CASE("import: its outline is not to be edited; the step and undoing it have its name",
          "[import]") {
  History history;
  const ImportPart command{shared(limb()), "Limb\n2"};
  CHECK(describe({}, command) == "Import Limb 2");
  CHECK(describe({}, ImportPart{}) == "Import part 1");
  history.push(must({}, command), describe({}, command));
  const auto edited = apply(history.current(), SetStroke{"part-1", {{0, 0}, {100, 0}, {100, 100}}});
  CHECK(edited.status() == Status::notDrawn);
  CHECK(edited.message().find("imported") != std::string::npos);
  history.undo();
  CHECK(history.current().parts.empty());
}

TEST_CASE("import: it connects to drawn parts, and they to it", "[import]") {
  std::vector<Vec2> body = unitCircle(48);
  for (Vec2& p : body) p = {p.x * 90 - 150, p.y * 60};
  for (const bool imported_first : {false, true}) {
    const Command add = AddPart{body}, import = ImportPart{shared(limb()), "Limb"};
    Document document = must({}, imported_first ? import : add);
    document = must(document, imported_first ? add : import);
    const Evaluation evaluation = evaluated(document);
    CHECK(evaluation.rig().roots.size() == 1);
    REQUIRE(evaluation.rig().connections.size() == 1);
  }
  // Far in front of it, in the same place seen from the front.
  Document document = must({}, AddPart{body});
  Affine away;
  away.move = {0, 0, 400};
  document =
      must(must(document, ImportPart{shared(limb()), "Limb"}), TransformParts{{"part-2"}, away});
  CHECK(evaluated(document).rig().roots.size() == 2);
}

TEST_CASE("import: a character of drawn and imported parts is one closed body with weights",
          "[import]") {
  std::vector<Vec2> body = unitCircle(48);
  for (Vec2& p : body) p = {p.x * 90 - 150, p.y * 60};
  Document document = must({}, AddPart{body});
  Mesh mesh = limb();
  const Mesh ball = sphereMesh({95, 45, 0}, 20, 2);  // a piece of its own that passes through it
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), ball.positions.begin(), ball.positions.end());
  for (const auto& [a, b, c] : ball.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
  document = must(document, ImportPart{shared(mesh), "Limb"});
  document = must(document, SetMirror{{"part-2"}, Plane{{1, 0, 0}, 150}});
  const Evaluation evaluation = evaluated(document);
  CharacterOptions options;
  options.weighting = quickWeightOptions();
  for (const bool merged : {true, false}) {
    options.merged = merged;
    const Character made = makeCharacter(evaluation, options);
    CHECK(made.left_out.empty());
    CHECK(validate(made.merged.mesh).empty());
    CHECK(made.meshes.size() == (merged ? 1 : 3));
    REQUIRE(made.weights);
    CHECK(made.weights->max_sum_error < 1e-9);
    for (const SkinnedMesh& one : made.meshes) {
      CHECK(inspect(one.mesh).volume > 0);
      CHECK(one.skin.size() == one.mesh.positions.size());
    }
  }

  // One that crosses itself is named and left out; the rest is merged.
  Mesh knot = sphereMesh({}, 50, 2);
  knot.positions[0] = knot.positions[0] * -1.5;  // through the other side
  Document crossed = must({}, AddPart{body});
  const auto next = apply(crossed, ImportPart{shared(knot), "Knot"});
  REQUIRE(next);
  options.merged = true;
  const Character made = makeCharacter(evaluated(*next), options);
  REQUIRE(made.left_out.size() == 1);
  CHECK(made.left_out[0].part == "part-2");
  CHECK(leftOutOf(made) ==
        std::vector<std::string>{"Knot is left out: its surface crosses itself."});
  options.merged = false;
  const Character apart = makeCharacter(evaluated(*next), options);
  CHECK(apart.left_out.empty());
  CHECK(apart.meshes.size() == 2);
}

}  // namespace marrow
