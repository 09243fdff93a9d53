#include "character/character.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

#include "solid/close.h"

namespace marrow {
namespace {

constexpr double kSameNormal = 1e-6;  // 1 − cosine; closer ones share a vertex

/// The weights of bones as those of the joints that they leave, the largest few.
VertexSkin skinOf(const Influences& influences, const Rig& rig) {
  std::vector<std::pair<double, uint32_t>> joints;
  for (const Influence& one : influences) {
    if (!(one.weight > 0)) continue;
    const uint32_t joint = rig.bones[one.bone][0];
    const auto same = std::find_if(joints.begin(), joints.end(),
                                   [&](const auto& other) { return other.second == joint; });
    if (same == joints.end()) {
      joints.push_back({one.weight, joint});
    } else {
      same->first += one.weight;
    }
  }
  std::sort(joints.begin(), joints.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  joints.resize(std::min(joints.size(), VertexSkin::kMost));
  double sum = 0;
  for (const auto& [weight, joint] : joints) sum += weight;
  VertexSkin skin;
  if (!(sum > 0)) return skin;
  double others = 0;
  for (size_t k = joints.size(); k-- > 0;) {
    skin.joints[k] = joints[k].second;
    skin.weights[k] = k > 0 ? joints[k].first / sum : 1 - others;
    others += skin.weights[k];
  }
  // Equal but for the rounding of the rest: the order stays.
  if (skin.weights[0] < skin.weights[1]) {
    std::swap(skin.weights[0], skin.weights[1]);
    std::swap(skin.joints[0], skin.joints[1]);
  }
  return skin;
}

/// Vertices once for each normal that their triangles have there.
SkinnedMesh withNormals(const MergedMesh& merged) {
  SkinnedMesh split;
  std::vector<std::vector<uint32_t>> copies(merged.mesh.positions.size());
  for (size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
    std::array<uint32_t, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t vertex = merged.mesh.triangles[t][k];
      const Vec3 normal = merged.corner_normals[t][k];
      auto& here = copies[vertex];
      const auto same = std::find_if(here.begin(), here.end(), [&](uint32_t copy) {
        return dot(split.normals[copy], normal) > 1 - kSameNormal;
      });
      if (same != here.end()) {
        corners[k] = *same;
        continue;
      }
      corners[k] = static_cast<uint32_t>(split.mesh.positions.size());
      here.push_back(corners[k]);
      split.mesh.positions.push_back(merged.mesh.positions[vertex]);
      split.normals.push_back(normal);
    }
    split.mesh.triangles.push_back(corners);
  }
  return split;
}

using WeightReport = Character::WeightReport;

class Maker {
 public:
  Maker(const Evaluation& evaluation, const CharacterOptions& options, Clock clock)
      : evaluation_(evaluation), options_(options), clock_(clock), watch_(clock, made_.timings) {}

  Character make() {
    addPaints();
    merge();
    watch_.lap("merge");
    if (options_.merged) {
      addMerged();
    } else {
      addParts();
    }
    if (options_.weights) addWeights();
    return std::move(made_);
  }

 private:
  const Part* shownPart(const PlacedPart& placed) const {
    const EvaluatedPart& evaluated = evaluation_.parts()[placed.source];
    return evaluated.part && evaluated.source->visible ? evaluated.shapeOf(placed).get() : nullptr;
  }

  void addPaints() {
    const auto& placed = evaluation_.placed();
    paint_of_.assign(placed.size(), 0);
    for (size_t i = 0; i < placed.size(); ++i) {
      if (!shownPart(placed[i])) continue;
      const PartSource& source = *evaluation_.parts()[placed[i].source].source;
      paint_of_[i] = static_cast<uint32_t>(made_.paints.size());
      std::string name = source.name;
      if (placed[i].side) name += std::string(".") + placed[i].side;
      made_.paints.push_back({std::move(name), source.color});
    }
  }

  void merge() {
    const auto& placed = evaluation_.placed();
    std::vector<SolidInput> solids;
    std::deque<Mesh> pieces;
    for (size_t i = 0; i < placed.size(); ++i) {
      const Part* part = shownPart(placed[i]);
      if (!part) continue;
      const auto id = static_cast<uint32_t>(i);
      if (!part->imported) {
        solids.push_back({&part->mesh, placed[i].frame, id});
        continue;
      }
      // Pieces may pass through each other; only one that crosses itself is no solid.
      for (Mesh& piece : piecesOf(part->mesh)) {
        pieces.push_back(std::move(piece));
        solids.push_back({&pieces.back(), placed[i].frame, id, true});
      }
    }
    made_.merged = mergeSolids(solids, options_.merge, clock_);
    for (const MergedMesh::LeftOut& out : made_.merged.left_out) {
      const std::string& id = placed[out.id].id;
      const bool known = std::any_of(made_.left_out.begin(), made_.left_out.end(),
                                     [&](const Character::LeftOut& one) { return one.part == id; });
      if (!known) made_.left_out.push_back({id, out.why});
    }
  }

  void addMerged() {
    if (made_.merged.mesh.triangles.empty()) return;
    SkinnedMesh body = withNormals(made_.merged);
    body.name = "Body";
    for (const uint32_t part : made_.merged.part_of_triangle) {
      body.paint_of_triangle.push_back(paint_of_[part]);
    }
    made_.meshes.push_back(std::move(body));
  }

  void addParts() {
    const auto& placed = evaluation_.placed();
    for (size_t i = 0; i < placed.size(); ++i) {
      const Part* part = shownPart(placed[i]);
      if (!part) continue;
      SkinnedMesh own;
      own.name = made_.paints[paint_of_[i]].name;
      const Frame& frame = placed[i].frame;
      for (const Vec3 p : part->mesh.positions) own.mesh.positions.push_back(frame.toWorld(p));
      const Frame turn{{}, frame.x / frame.scale(), frame.y / frame.scale()};
      for (const Vec3 n : part->normals) own.normals.push_back(turn.toWorld(n));
      own.mesh.triangles = part->mesh.triangles;
      own.paint_of_triangle.assign(own.mesh.triangles.size(), paint_of_[i]);
      made_.meshes.push_back(std::move(own));
    }
  }

  void addWeights() {
    const Rig& rig = evaluation_.rig();
    WeightReport& report = made_.weights.emplace();
    report.bones = rig.bones.size();
    if (rig.bones.empty()) return;
    WeightOptions weighting = options_.weighting;
    if (options_.symmetry) {
      weighting.volume.centre = options_.symmetry->normal * -options_.symmetry->offset;
    }
    const auto field =
        WeightField::make(made_.merged.mesh, boneSegments(rig), weighting, {}, clock_);
    watch_.lap("weights");
    if (!field) return;
    report.min = 1;
    for (SkinnedMesh& mesh : made_.meshes) {
      for (const Influences& influences : field->at(mesh.mesh)) {
        mesh.skin.push_back(skinOf(influences, rig));
        double sum = 0;
        for (const double weight : mesh.skin.back().weights) {
          sum += weight;
          report.min = std::min(report.min, weight);
          report.max = std::max(report.max, weight);
        }
        report.max_sum_error = std::max(report.max_sum_error, std::abs(sum - 1));
      }
    }
    watch_.lap("vertices");
  }

  const Evaluation& evaluation_;
  const CharacterOptions& options_;
  Clock clock_;
  Character made_;
  Stopwatch watch_;
  std::vector<uint32_t> paint_of_;  // by placed part
};

}  // namespace

Character makeCharacter(const Evaluation& evaluation, const CharacterOptions& options,
                        Clock clock) {
  return Maker(evaluation, options, clock).make();
}

}  // namespace marrow
