#include "character/character.h"

#include <cmath>
#include <set>

#include "character/painting.h"
#include "document/command.h"
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

TEST_CASE("character: copies of a part in the same place share what it holds", "[character]") {
  Document document = creature();
  document.parts.resize(1);
  const auto boneCount = [&](const Evaluation& evaluation) {
    return evaluation.rig().bones.size();
  };
  const Evaluation alone = evaluated(document);
  const Character one = makeCharacter(alone, quick());
  for (int copy = 0; copy < 2; ++copy) {
    auto part = std::make_shared<PartSource>(*document.parts[0]);
    part->id = partId(takePartNumber(document));
    document.parts.push_back(std::move(part));
  }
  const Evaluation evaluation = evaluated(document);
  REQUIRE(evaluation.parts()[2].part == evaluation.parts()[0].part);
  REQUIRE(boneCount(evaluation) >= 3 * boneCount(alone));
  const Character made = makeCharacter(evaluation, quick());
  CHECK(made.merged.mesh.positions == one.merged.mesh.positions);
  CHECK(made.merged.distinct == 1);
  CHECK(made.no_weights.empty());
  checkSkin(made.meshes[0], evaluation.rig());
  // Vertices follow all copies of what they followed alike.
  for (size_t v = 0; v < made.unpainted.size(); ++v) {
    std::map<uint32_t, std::vector<double>> by_part;
    for (const JointWeight& weight : made.unpainted[v]) {
      by_part[evaluation.rig().joints[weight.joint].part].push_back(weight.weight);
    }
    double sum = 0;
    for (const JointWeight& weight : made.unpainted[v]) sum += weight.weight;
    if (std::abs(sum - 1) > 1e-12) FAIL("vertex " << v);
    if (by_part.empty()) FAIL("vertex " << v);
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

TEST_CASE("character: doubled vertices follow the same joints", "[character]") {
  const Evaluation evaluation = evaluated(creature());
  const Character made = makeCharacter(evaluation, quick());
  const SkinnedMesh& body = made.meshes[0];
  REQUIRE(body.merged_vertex.size() == body.mesh.positions.size());
  std::vector<const VertexSkin*> first(made.merged.mesh.positions.size(), nullptr);
  for (size_t i = 0; i < body.skin.size(); ++i) {
    const uint32_t v = body.merged_vertex[i];
    REQUIRE(body.mesh.positions[i] == made.merged.mesh.positions[v]);
    if (!first[v]) first[v] = &body.skin[i];
    if (first[v]->joints != body.skin[i].joints || first[v]->weights != body.skin[i].weights) {
      FAIL("a seam comes apart");
    }
  }
}

TEST_CASE("character: strokes of the document change weights where they were painted",
          "[character]") {
  Document document = creature();
  const Evaluation evaluation = evaluated(document);
  const Rig& rig = evaluation.rig();
  uint32_t end = 0;  // the last joint of the first leg that moves something
  for (const auto& bone : rig.bones) {
    if (rig.joints[bone[0]].part == 1) end = bone[0];
  }
  WeightStroke stroke;
  stroke.part = evaluation.placed()[1].id;
  stroke.joint = rig.joints[end].id;
  stroke.radius = 30;
  stroke.points = {{-90, -70, 58}, {-90, -110, 58}};
  const auto painted = apply(document, AddWeightStroke{stroke});
  REQUIRE(painted);
  const auto options = [&](const Document& of, bool merged) {
    CharacterOptions made = characterOptions(of, rig);
    made.weighting = quickWeightOptions();
    made.merged = merged;
    return made;
  };
  for (const bool merged : {true, false}) {
    const Character before = makeCharacter(evaluation, options(document, merged));
    const Character after = makeCharacter(evaluation, options(*painted, merged));
    double near_part = 0, near_twin = 0;
    size_t changed = 0, all = 0;
    for (size_t m = 0; m < after.meshes.size(); ++m) {
      checkSkin(after.meshes[m], rig);
      const SkinnedMesh& mesh = after.meshes[m];
      for (size_t i = 0; i < mesh.skin.size(); ++i) {
        const VertexSkin& is = mesh.skin[i];
        const VertexSkin& was = before.meshes[m].skin[i];
        ++all;
        if (is.joints == was.joints && is.weights == was.weights) continue;
        ++changed;
        const Vec3 p = mesh.mesh.positions[i];
        if (!(distance(p, {-90, -90, p.z > 0 ? 55. : -55.}) < 70)) FAIL("changed far away");
        double& most = p.z > 0 ? near_part : near_twin;
        const uint32_t joint = is.joints[0];
        const bool own = rig.joints[joint].id == stroke.joint ||
                         rig.joints[joint].id == oppositeJoint(document, stroke.joint);
        if (own) most = std::max(most, is.weights[0]);
      }
    }
    CHECK(changed > 20);
    CHECK(changed < all / 4);
    CHECK(near_part > 0.9);
    CHECK(near_twin > 0.9);
    if (!merged) continue;
    // Painting over the same weights gives the same bits, in whatever steps.
    const auto isAs = [](const std::vector<VertexSkin>& skin, const Character& made) {
      const std::vector<VertexSkin>& other = made.meshes[0].skin;
      return std::equal(skin.begin(), skin.end(), other.begin(), other.end(),
                        [](const VertexSkin& a, const VertexSkin& b) {
                          return a.joints == b.joints && a.weights == b.weights;
                        });
    };
    const std::vector<PlacedWeightStroke> strokes = placedStrokes(*painted, rig);
    PlacedWeightStroke other = strokes[0];
    other.kind = WeightStroke::Kind::smooth;
    other.trails[0].points[1].x += 60;
    Painting painting(before, rig);
    const auto isPaintedAs = [&](const std::vector<PlacedWeightStroke>& with, const Character& as) {
      REQUIRE(painting.set(with));
      return isAs(painting.skin(), as);
    };
    CHECK(isAs(painting.skin(), before));
    CHECK(isPaintedAs(strokes, after));
    CHECK_FALSE(isPaintedAs({other}, after));
    CHECK(isPaintedAs({}, before));
    CHECK(isPaintedAs(strokes, after));
    CHECK_FALSE(isPaintedAs({strokes[0], other}, after));
    CHECK(isPaintedAs(strokes, after));
    CHECK(isAs(Painting(after, rig).skin(), before));
    CHECK(isPaintedAs({}, before));
  }
}

TEST_CASE("character: soft seams are the document's, of the merged body alone", "[character]") {
  const Document document = *apply(creature(), SetBlend{25});
  const Evaluation evaluation = evaluated(document);
  CharacterOptions options = characterOptions(document, evaluation.rig());
  options.weights = false;
  const Character soft = makeCharacter(evaluation, options);
  options.blend = 0;
  const Character hard = makeCharacter(evaluation, options);
  const MeshReport report = inspect(soft.merged.mesh);
  CHECK((report.closed && report.manifold));
  CHECK(report.volume > inspect(hard.merged.mesh).volume);
  CHECK(soft.meshes[0].mesh.triangles.size() == hard.meshes[0].mesh.triangles.size());
  options.merged = false;
  options.blend = 25;
  const Character parts = makeCharacter(evaluation, options);
  CHECK(inspect(parts.merged.mesh).volume == inspect(hard.merged.mesh).volume);
}

TEST_CASE("character: where there are no weights it says so", "[character]") {
  // So far away that nothing is left of the body's shape.
  Document document;
  auto far = std::make_shared<PartSource>(*creature().parts[0]);
  far->frame.origin = {1e40, 0, 0};
  document.parts.push_back(far);
  const Evaluation evaluation = evaluated(document);
  REQUIRE_FALSE(evaluation.rig().bones.empty());
  CharacterOptions options = quick();
  options.merged = false;
  const Character made = makeCharacter(evaluation, options);
  REQUIRE(made.meshes.size() == 1);
  CHECK(made.meshes[0].skin.empty());
  CHECK_FALSE(made.weights);
  CHECK(made.no_weights == "There is no body to spread weights through.");
  options.merged = true;  // no mesh: nothing to say
  CHECK(makeCharacter(evaluation, options).no_weights.empty());
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
