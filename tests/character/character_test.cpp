#include "character/character.h"

#include <cmath>
#include <set>

#include "io/mesh_export.h"
#include "support/catch.h"
#include "support/creatures.h"

namespace marrow {
namespace {

Evaluation evaluated(const Document& document) {
  PartOptions coarse = previewOptions();
  Evaluation evaluation(coarse);
  evaluation.update(document);
  return evaluation;
}

CharacterOptions quick() {
  CharacterOptions options;
  options.weighting = quickWeightOptions();
  return options;
}

/// A body with two legs and their twins, and a lump far away.
Document creature() {
  Document document;
  const auto add = [&](const char* name, double half_width, double half_height, Vec3 origin,
                       bool twin = false) {
    auto part = std::make_shared<PartSource>();
    part->id = partId(takePartNumber(document));
    part->name = name;
    part->color = partColor(document.parts.size());
    part->stroke = unitCircle(48);
    for (Vec2& p : part->stroke) p = {p.x * half_width, p.y * half_height};
    part->frame.origin = origin;
    if (twin) part->mirror = Plane{{0, 0, 1}, 0};
    document.parts.push_back(std::move(part));
  };
  add("Body", 160, 70, {});
  add("Leg", 20, 90, {-90, -90, 40}, true);
  add("Leg", 20, 90, {90, -90, 40}, true);
  add("Moon", 30, 30, {0, 400, 0});
  return document;
}

void checkSkin(const SkinnedMesh& mesh, const Rig& rig) {
  REQUIRE(mesh.skin.size() == mesh.mesh.positions.size());
  for (const VertexSkin& skin : mesh.skin) {
    double sum = 0;
    for (size_t k = 0; k < VertexSkin::kMost; ++k) {
      sum += skin.weights[k];
      const bool in_order = k == 0 || skin.weights[k] <= skin.weights[k - 1];
      const bool unused = skin.weights[k] > 0 || skin.joints[k] == 0;
      if (!(skin.weights[k] >= 0) || !in_order || !unused || skin.joints[k] >= rig.joints.size()) {
        FAIL("weight " << k);
      }
    }
    if (!(std::abs(sum - 1) < 1e-12)) FAIL("sum " << sum);
  }
}

}  // namespace

TEST_CASE("character: merged, every part keeps its paint, and all vertices follow joints",
          "[character]") {
  const Evaluation evaluation = evaluated(creature());
  const Character made = makeCharacter(evaluation, quick());
  REQUIRE(made.left_out.empty());
  REQUIRE(made.meshes.size() == 1);
  REQUIRE(made.paints.size() == 6);
  CHECK(made.paints[1].name == "Leg.L");
  CHECK(made.paints[2].name == "Leg.R");
  const SkinnedMesh& body = made.meshes[0];
  const std::set<uint32_t> paints(body.paint_of_triangle.begin(), body.paint_of_triangle.end());
  CHECK(paints.size() == 6);
  CHECK(body.mesh.triangles.size() == made.merged.mesh.triangles.size());
  for (const Vec3 n : body.normals) {
    if (!(std::abs(length(n) - 1) < 1e-9)) FAIL("a normal of length " << length(n));
  }
  checkSkin(body, evaluation.rig());
  REQUIRE(made.weights);
  CHECK(made.weights->bones == evaluation.rig().bones.size());
  CHECK(made.weights->max_sum_error < 1e-12);
  // The merged solid is whole; only the seams are doubled for their normals.
  const MeshReport report = inspect(made.merged.mesh);
  CHECK((report.closed && report.manifold && report.volume > 0));
  CHECK(body.mesh.positions.size() > made.merged.mesh.positions.size());
}

TEST_CASE("character: part by part each is the part's own mesh, placed", "[character]") {
  const Evaluation evaluation = evaluated(creature());
  CharacterOptions options = quick();
  options.merged = false;
  const Character made = makeCharacter(evaluation, options);
  REQUIRE(made.meshes.size() == 6);
  for (size_t i = 0; i < made.meshes.size(); ++i) {
    const PlacedPart& placed = evaluation.placed()[i];
    const Mesh& own = evaluation.parts()[placed.source].part->mesh;
    REQUIRE(made.meshes[i].mesh.positions.size() == own.positions.size());
    CHECK(made.meshes[i].mesh.positions[7] == placed.frame.toWorld(own.positions[7]));
    CHECK(inspect(made.meshes[i].mesh).volume > 0);
    checkSkin(made.meshes[i], evaluation.rig());
  }
}

TEST_CASE("character: hidden parts are not there, and nothing at all is no fault", "[character]") {
  Document document = creature();
  auto hidden = std::make_shared<PartSource>(*document.parts[3]);
  hidden->visible = false;
  document.parts[3] = hidden;
  CHECK(makeCharacter(evaluated(document), quick()).paints.size() == 5);
  const Character nothing = makeCharacter(evaluated({}), quick());
  CHECK(nothing.meshes.empty());
  CHECK(nothing.merged.mesh.triangles.empty());
  for (auto& part : document.parts) {
    auto bare = std::make_shared<PartSource>(*part);
    bare->skeleton = false;
    part = bare;
  }
  const Character boneless = makeCharacter(evaluated(document), quick());
  REQUIRE(boneless.meshes.size() == 1);
  CHECK(boneless.meshes[0].skin.empty());
  CHECK(boneless.weights->bones == 0);
}

TEST_CASE("character: random creatures become models, none is lost", "[character]") {
  Random random(11);
  for (int run = 0; run < 12; ++run) {
    CAPTURE(run);
    const Evaluation evaluation = evaluated(randomCreature(random, 2 + random.below(12)));
    const Character made = makeCharacter(evaluation, quick());
    CHECK(made.left_out.empty());
    REQUIRE(made.meshes.size() == 1);
    if (!evaluation.rig().bones.empty()) checkSkin(made.meshes[0], evaluation.rig());
    const MeshReport report = inspect(made.merged.mesh);
    CHECK((report.closed && report.manifold));
  }
}

TEST_CASE("character: STL and PLY hold all triangles, OBJ a group for each paint", "[character]") {
  CharacterOptions options = quick();
  options.weights = false;
  const Character made = makeCharacter(evaluated(creature()), options);
  const SkinnedMesh& body = made.meshes[0];
  const auto stl = toStl(body);
  REQUIRE(stl);
  CHECK(stl->size() == 84 + 50 * body.mesh.triangles.size());
  const auto ply = toPly(body, made.paints);
  REQUIRE(ply);
  const size_t header = ply->find("end_header\n") + 11;
  CHECK(ply->size() == header + 24 * body.mesh.positions.size() + 16 * body.mesh.triangles.size());
  const std::string obj = toObj(body, made.paints);
  size_t groups = 0, faces = 0;
  for (size_t at = obj.find('\n'); at != std::string::npos; at = obj.find('\n', at + 1)) {
    groups += obj.compare(at + 1, 2, "g ") == 0;
    faces += obj.compare(at + 1, 2, "f ") == 0;
  }
  CHECK(groups == 6);
  CHECK(faces == body.mesh.triangles.size());
  SkinnedMesh bad = body;
  bad.mesh.positions[0].x = 1e300;
  CHECK(toStl(bad).status() == Status::meshFailed);
  CHECK(toPly(bad, made.paints).status() == Status::meshFailed);
}

}  // namespace marrow
