#include "bench/models.h"

#include <utility>

#include "bench/creatures.h"
#include "bench/measure.h"
#include "character/character.h"
#include "io/glb.h"
#include "pose/inverse_kinematics.h"
#include "pose/pose.h"
#include "pose/rigs.h"
#include "pose/skin.h"
#include "solid/solids.h"

namespace marrow::bench {
namespace {

struct Solids {
  std::string name;
  std::vector<Mesh> meshes;
};

size_t vertexCount(const std::vector<Mesh>& meshes) {
  size_t count = 0;
  for (const Mesh& mesh : meshes) count += mesh.positions.size();
  return count;
}

/// All parts, where they are in space.
std::vector<Mesh> placedMeshes(const Evaluation& evaluation) {
  std::vector<Mesh> meshes;
  for (const PlacedPart& placed : evaluation.placed()) {
    const EvaluatedPart& part = evaluation.parts()[placed.source];
    if (!part.part) continue;
    meshes.push_back(part.part->mesh);
    for (Vec3& p : meshes.back().positions) p = placed.frame.toWorld(p);
  }
  return meshes;
}

/// The creature of eight parts with about 7,000 vertices.
Evaluation eightParts(const Document& document) {
  PartOptions options;
  options.triangulation.target_points = 455;
  Evaluation evaluation(options);
  evaluation.update(document);
  return evaluation;
}

/// Eight parts each and about as many vertices, in general position and in hard ones.
std::vector<Solids> solids() {
  const Evaluation creature = eightParts(fourLegged().document);
  const std::vector<Mesh> parts = placedMeshes(creature);
  std::vector<Solids> all{{"8 parts", parts}};

  Solids mirrored{"8 parts, four of them mirrored onto themselves", {}};
  for (size_t i = 0; i < 4; ++i) {
    mirrored.meshes.push_back(parts[i]);
    mirrored.meshes.push_back(parts[i]);
    // The plane goes through the part's own middle: most of the two is nearly the same.
    Mesh& twin = mirrored.meshes.back();
    for (Vec3& p : twin.positions) {
      p.z = 2 * creature.placed()[i].frame.origin.z - p.z;
    }
    for (auto& triangle : twin.triangles) std::swap(triangle[0], triangle[1]);
  }
  all.push_back(std::move(mirrored));

  Solids coplanar{"8 boxes in a row, coplanar", {}};
  for (int i = 0; i < 8; ++i) {
    coplanar.meshes.push_back(gridBoxMesh({0.6 * i, 0, 0}, {0.6 * i + 1, 1, 1}, 12));
  }
  all.push_back(std::move(coplanar));
  all.push_back({"8 times the same part", std::vector<Mesh>(8, parts[0])});

  Evaluation many;
  many.update(sixtyParts().document);
  std::vector<Mesh> meshes = placedMeshes(many);
  all.push_back({"60 parts", {meshes.begin(), meshes.begin() + 60}});
  all.push_back({"60 strokes and twins", std::move(meshes)});
  return all;
}

std::vector<SolidInput> inputsOf(const Solids& solids) {
  std::vector<SolidInput> inputs;
  for (const Mesh& mesh : solids.meshes) {
    inputs.push_back({&mesh, {}, static_cast<uint32_t>(inputs.size())});
  }
  return inputs;
}

void merging(const Solids& solids, Effort effort) {
  const std::vector<SolidInput> inputs = inputsOf(solids);
  MergedMesh merged;
  const Times times = measure([&] { merged = mergeSolids(inputs); }, effort);
  Json row{{"bench", "merge"},
           {"solids", solids.name},
           {"parts", solids.meshes.size()},
           {"vertices", vertexCount(solids.meshes)},
           {"crossings", merged.crossings},
           {"lost", merged.left_out.size()}};
  row["ms"]["total"] = {times.min_ms, times.median_ms};
  print(row);
}

/// As few bones as `most`, by the first of the four thresholds.
void coarsen(Document& document, size_t most) {
  for (double simplify = 0; simplify < 200; simplify += 2) {
    document.refine.simplify = simplify;
    if (eightParts(document).rig().bones.size() <= most) return;
  }
}

void weighing(const std::string& name, const Evaluation& evaluation, Effort effort) {
  CharacterOptions only_merged;
  only_merged.weights = false;
  const Character body = makeCharacter(evaluation, only_merged);
  const std::vector<Segment> bones = boneSegments(evaluation.rig());
  if (body.meshes.empty() || bones.empty()) return;
  const Mesh& mesh = body.meshes[0].mesh;
  size_t vertices = 0;
  const auto weigh = [&](const WeightOptions& options) {
    const auto field = WeightField::make(body.merged.mesh, bones, options);
    if (!field) return;
    vertices = field->volume().vertices.size();
    (void)field->at(mesh);
  };
  const Times quick = measure([&] { weigh(quickWeightOptions()); }, effort);
  const Times full = measure([&] { weigh({}); }, effort);
  Json row{{"bench", "weights"}, {"creature", name}, {"bones", bones.size()}, {"volume", vertices}};
  row["ms"]["total"] = {full.min_ms, full.median_ms};
  row["ms"]["firstGuess"] = {quick.min_ms, quick.median_ms};
  print(row);
}

void posing(Effort effort) {
  constexpr size_t kVertices = 20000;
  constexpr int kJoints = 60;
  Random random(7);
  const Rig rig = randomRig(random, kJoints);
  std::vector<Vec3> positions, normals;
  std::vector<VertexSkin> skins;
  for (size_t i = 0; i < kVertices; ++i) {
    positions.push_back(Vec3{random.unit(), random.unit(), random.unit()} * 500);
    normals.push_back(randomRotation(random).x);
    VertexSkin one;
    double left = 1;
    for (size_t k = 0; k < VertexSkin::kMost; ++k) {
      one.joints[k] = static_cast<uint32_t>(random.below(kJoints));
      one.weights[k] = k + 1 < VertexSkin::kMost ? 0.6 * left : left;
      left -= one.weights[k];
    }
    skins.push_back(one);
  }
  const Pose pose = randomPose(random, rig);
  SkinnedVertices moved;
  Json row{{"bench", "pose"}, {"vertices", kVertices}, {"joints", kJoints}};
  for (const auto& [name, how] : {std::pair{"linear", Skinning::linear},
                                  std::pair{"dualQuaternions", Skinning::dualQuaternions}}) {
    const Skinning skinning = how;
    const Times times = measure(
        [&] { skin(positions, normals, skins, posed(rig, pose), skinning, moved); }, effort);
    row["ms"][name] = {times.min_ms, times.median_ms};
  }
  const Times joints = measure([&] { (void)posed(rig, pose); }, effort);
  row["ms"]["joints"] = {joints.min_ms, joints.median_ms};
  print(row);
}

/// Sixty joints: a spine and four limbs of 12 each; a hand is dragged in a circle, the others are
/// pinned.
void reaching(Effort effort) {
  constexpr int kLimb = 12;
  Rig rig = chainRig(kLimb, 20);
  std::vector<uint32_t> ends;
  for (int limb = 0; limb < 4; ++limb) {
    int32_t parent = limb < 2 ? kLimb - 1 : 0;
    const Vec3 way = Vec3{limb % 2 ? 1.0 : -1.0, -0.5, 0.2} * 15;
    for (int i = 0; i < kLimb; ++i) {
      Rig::Joint joint;
      const uint32_t index = static_cast<uint32_t>(rig.joints.size());
      joint.id = "part-1/n" + std::to_string(index);
      joint.parent = parent;
      joint.position = rig.joints[static_cast<size_t>(parent)].position + way;
      rig.bones.push_back({static_cast<uint32_t>(parent), index});
      rig.joints.push_back(std::move(joint));
      parent = static_cast<int32_t>(index);
    }
    ends.push_back(static_cast<uint32_t>(parent));
  }
  // A frame's worth each: from where the drag has come to on to the next place of the hand; and a
  // joint of the spine, which drags all pinned ones along.
  const auto drag = [&](uint32_t joint, const std::vector<uint32_t>& pins) {
    Pose pose;
    std::vector<double> times_ms;
    const Vec3 start = rig.joints[joint].position;
    const double end_ms = now() + effort.budget_ms;
    for (int frame = 0; frame < 200 || now() < end_ms; ++frame) {
      const double t = static_cast<double>(frame % 100) / 100, s = t < 0.5 ? t : 1 - t;
      const Vec3 target = start + Vec3{240 * s, 160 * t * (1 - t), -120 * s};
      const double start_ms = now();
      pose = reach(rig, pose, joint, target, pins);
      times_ms.push_back(now() - start_ms);
    }
    return toJson(std::move(times_ms));
  };
  Json row{{"bench", "reach"}, {"joints", rig.joints.size()}};
  row["ms"]["a hand"] = drag(ends[0], {ends[1], ends[2], ends[3]});
  row["ms"]["the spine, all hands pinned"] = drag(kLimb / 2, ends);
  print(row);
}

void writing(const std::string& name, const Document& document, const Evaluation& evaluation,
             Effort effort) {
  const GlbCharacter glb = glbOf(makeCharacter(evaluation), evaluation.rig(), document, name);
  size_t vertices = 0;
  for (const SkinnedMesh& mesh : glb.meshes) vertices += mesh.mesh.positions.size();
  const Times times = measure([&] { (void)toGlb(glb); }, effort);
  Json row{{"bench", "glb"}, {"creature", name}, {"vertices", vertices}};
  row["ms"]["write"] = {times.min_ms, times.median_ms};
  print(row);
}

}  // namespace

void models(bool quick, const std::vector<std::string>& paths) {
  const std::vector<Solids> all = solids();
  const std::vector<SolidInput> first = inputsOf(all[0]);
  // Until WebAssembly has been compiled for speed.
  const double warm_ms = now() + (quick ? 1000 : 2000);
  while (now() < warm_ms) (void)mergeSolids(first);
  const Effort effort{quick ? 100.0 : 600.0, quick ? 3 : 8};
  for (const Solids& one : all) merging(one, effort);

  Document thirty = fourLegged().document;
  coarsen(thirty, 30);
  const Evaluation four_legged = eightParts(thirty);
  weighing("four-legged (8 strokes)", four_legged, effort);
  const Effort short_effort{effort.budget_ms / 4, 1};
  for (const Creature& sample : samples(paths)) {
    Evaluation evaluation;
    evaluation.update(sample.document);
    weighing(sample.name, evaluation, short_effort);
  }
  posing(effort);
  reaching(effort);
  writing("four-legged (8 strokes)", thirty, four_legged, effort);
  const Document many = sixtyParts().document;
  Evaluation evaluation;
  evaluation.update(many);
  writing("60 strokes", many, evaluation, effort);
}

}  // namespace marrow::bench
