#include "character/character.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

#include "character/joint_skin.h"
#include "document/symmetry.h"
#include "solid/blend.h"
#include "solid/close.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// The strokes over the weights of the merged surface; and which vertices they reached. Nothing
/// where it was told to stop.
std::optional<std::vector<char>> paintOver(const Mesh& merged, const Rig& rig,
                                           const std::vector<PlacedWeightStroke>& strokes,
                                           const std::function<bool()>& goOn,
                                           std::vector<JointWeights>& weights) {
  std::vector<char> painted(merged.positions.size(), 0);
  if (strokes.empty()) return painted;
  const WeightPainter painter(merged, rig);
  for (const PlacedWeightStroke& stroke : strokes) {
    if (!goOn()) return std::nullopt;
    for (const uint32_t v : painter.paint(stroke, weights)) painted[v] = 1;
  }
  return painted;
}

/// For each point the nearest vertex of the merged surface, where one is as near as its edges are
/// long; else kNone.
std::vector<uint32_t> nearestVertices(const Mesh& merged, const std::vector<Vec3>& points) {
  double edges = 0;
  for (const auto& [a, b, c] : merged.triangles) {
    edges += distance(merged.positions[a], merged.positions[b]);
  }
  const double reach = edges / static_cast<double>(merged.triangles.size());
  std::vector<Box3> boxes(points.size()), vertices(merged.positions.size());
  for (size_t i = 0; i < points.size(); ++i) {
    boxes[i].include(points[i] - Vec3{reach, reach, reach});
    boxes[i].include(points[i] + Vec3{reach, reach, reach});
  }
  for (size_t v = 0; v < vertices.size(); ++v) vertices[v].include(merged.positions[v]);
  std::vector<uint32_t> nearest(points.size(), kNone);
  std::vector<double> best(points.size(), reach);
  BoxTree(std::move(boxes)).pairs(BoxTree(std::move(vertices)), [&](uint32_t i, uint32_t v) {
    const double here = distance(points[i], merged.positions[v]);
    if (!(here < best[i] || (here == best[i] && v < nearest[i]))) return;
    best[i] = here;
    nearest[i] = v;
  });
  return nearest;
}

void report(const std::vector<VertexSkin>& skin, Character::WeightReport& into) {
  for (const VertexSkin& own : skin) {
    double sum = 0;
    for (const double weight : own.weights) {
      sum += weight;
      into.min = std::min(into.min, weight);
      into.max = std::max(into.max, weight);
    }
    into.max_sum_error = std::max(into.max_sum_error, std::abs(sum - 1));
  }
}

/// Bones in the same place, as copies of a part have them, hold the same: it is worked out once,
/// and they share it.
class DistinctBones {
 public:
  explicit DistinctBones(const std::vector<Segment>& bones) {
    std::map<std::array<double, 6>, size_t> known;
    for (uint32_t bone = 0; bone < bones.size(); ++bone) {
      const auto& [a, b] = bones[bone];
      const auto [at, is_new] =
          known.emplace(std::array{a.x, a.y, a.z, b.x, b.y, b.z}, segments_.size());
      if (is_new) {
        segments_.push_back(bones[bone]);
        bones_.emplace_back();
      }
      bones_[at->second].push_back(bone);
    }
    count_ = bones.size();
  }

  const std::vector<Segment>& segments() const { return segments_; }

  /// Influences of segments as those of bones, as far as there is room for them.
  void share(std::vector<Influences>& influences) const {
    if (segments_.size() == count_) return;
    std::vector<Influence> all;
    for (Influences& own : influences) {
      all.clear();
      for (const Influence& one : own) {
        if (!(one.weight > 0)) continue;
        const std::vector<uint32_t>& bones = bones_[one.bone];
        const double weight = one.weight / static_cast<double>(bones.size());
        for (const uint32_t bone : bones) all.push_back({bone, weight});
      }
      std::sort(all.begin(), all.end(), [](const Influence& a, const Influence& b) {
        return a.weight != b.weight ? a.weight > b.weight : a.bone < b.bone;
      });
      all.resize(std::min(all.size(), own.size()));
      double sum = 0;
      for (const Influence& one : all) sum += one.weight;
      own = {};
      for (size_t i = 0; i < all.size(); ++i) own[i] = {all[i].bone, all[i].weight / sum};
    }
  }

 private:
  std::vector<Segment> segments_;
  std::vector<std::vector<uint32_t>> bones_;  // of each segment
  size_t count_ = 0;
};

/// Of a merged body: its vertices follow what those of the merged surface follow.
void skinBody(const std::vector<JointWeights>& weights, Character& character) {
  std::vector<VertexSkin> skin;
  skin.reserve(weights.size());
  for (const JointWeights& one : weights) skin.push_back(skinOf(one));
  for (SkinnedMesh& body : character.meshes) {
    body.skin.clear();
    body.skin.reserve(body.merged_vertex.size());
    for (const uint32_t v : body.merged_vertex) body.skin.push_back(skin[v]);
  }
}

/// Vertices once for each normal that their triangles have there.
SkinnedMesh withNormals(const MergedMesh& merged) {
  SplitVertices split = splitByNormals(merged.mesh, merged.corner_normals);
  SkinnedMesh made;
  made.mesh.positions.reserve(split.vertices.size());
  for (const uint32_t v : split.vertices) made.mesh.positions.push_back(merged.mesh.positions[v]);
  made.mesh.triangles = std::move(split.triangles);
  made.normals = std::move(split.normals);
  made.merged_vertex = std::move(split.vertices);
  return made;
}

const Part* shownPart(const Evaluation& evaluation, const PlacedPart& placed) {
  const EvaluatedPart& evaluated = evaluation.parts()[placed.source];
  return evaluated.part && evaluated.source->visible ? evaluated.shapeOf(placed).get() : nullptr;
}

using WeightReport = Character::WeightReport;

class Maker {
 public:
  Maker(const Evaluation& evaluation, const CharacterOptions& options, Clock clock,
        const CharacterWatch& watch)
      : evaluation_(evaluation),
        options_(options),
        clock_(clock),
        seen_(watch),
        watch_(clock, made_.timings) {}

  Character make() {
    addPaints();
    merge();
    watch_.lap("merge");
    if (options_.merged) {
      addMerged();
    } else {
      addParts();
    }
    if (options_.weights) {
      if (seen_.first_guess) {
        addWeights(quickWeightOptions(), {}, 0);
        if (stopped_) return std::move(made_);
        seen_.first_guess(made_);
        for (SkinnedMesh& mesh : made_.meshes) mesh.skin.clear();
      }
      addWeights(options_.weighting, seen_.progress, 1);
    }
    splitParts();
    return std::move(made_);
  }

 private:
  const Part* shownPart(const PlacedPart& placed) const {
    return marrow::shownPart(evaluation_, placed);
  }

  void addPaints() {
    made_.paints = paintsOf(evaluation_);
    const auto& placed = evaluation_.placed();
    paint_of_.assign(placed.size(), 0);
    uint32_t count = 0;
    for (size_t i = 0; i < placed.size(); ++i) {
      if (shownPart(placed[i])) paint_of_[i] = count++;
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
    if (!options_.merged) return;
    made_.merged = blendSeams(std::move(made_.merged), {options_.blend}, clock_);
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
    body.paint_of_triangle.reserve(made_.merged.part_of_triangle.size());
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
      if (part->imported) sharp_.push_back({made_.meshes.size(), part, turn});
      own.paint_of_triangle.assign(own.mesh.triangles.size(), paint_of_[i]);
      made_.meshes.push_back(std::move(own));
    }
  }

  /// Doubles vertices at the sharp edges of imported parts; now that doubles have the same weights.
  void splitParts() {
    for (const auto& [index, part, turn] : sharp_) {
      SkinnedMesh& own = made_.meshes[index];
      const SplitVertices& shown = part->shown;
      std::vector<Vec3> positions;
      std::vector<VertexSkin> skins;
      for (const uint32_t v : shown.vertices) {
        positions.push_back(own.mesh.positions[v]);
        if (!own.skin.empty()) skins.push_back(own.skin[v]);
      }
      own.mesh = {std::move(positions), shown.triangles};
      own.skin = std::move(skins);
      own.normals.clear();
      for (const Vec3 n : shown.normals) own.normals.push_back(turn.toWorld(n));
    }
  }

  /// done: of all weights, behind these.
  void addWeights(WeightOptions weighting, const WeightProgress& progress, double done) {
    const Rig& rig = evaluation_.rig();
    WeightReport& weights = made_.weights.emplace();
    weights.bones = rig.bones.size();
    if (rig.bones.empty() || made_.meshes.empty()) return;
    if (options_.symmetry) {
      weighting.volume.centre = options_.symmetry->normal * -options_.symmetry->offset;
      weighting.symmetry = options_.symmetry;
    }
    const Mesh& merged = made_.merged.mesh;
    const DistinctBones bones(boneSegments(rig));
    const auto field = WeightField::make(merged, bones.segments(), weighting, progress, clock_);
    watch_.lap("weights");
    if (!field) {
      made_.weights.reset();
      made_.no_weights = field.message();
      return;
    }
    made_.unpainted = weightsOf(*field, bones, merged);
    std::vector<JointWeights> own;  // only where there is something to paint
    if (!options_.strokes.empty()) own = made_.unpainted;
    std::vector<JointWeights>& painted = own.empty() ? made_.unpainted : own;
    const auto goOn = [&] { return !seen_.progress || seen_.progress(done); };
    const auto reached = paintOver(merged, rig, options_.strokes, goOn, painted);
    if (!reached) {
      stopped_ = true;
      made_.weights.reset();
      made_.no_weights = "The weights were given up.";
      return;
    }
    if (options_.merged) {
      skinBody(painted, made_);
    } else {
      for (SkinnedMesh& part : made_.meshes) {
        skinPart(weightsOf(*field, bones, part.mesh), painted, *reached, part);
      }
    }
    weights.min = 1;
    for (const SkinnedMesh& mesh : made_.meshes) report(mesh.skin, weights);
    watch_.lap("vertices");
  }

  std::vector<JointWeights> weightsOf(const WeightField& field, const DistinctBones& bones,
                                      const Mesh& mesh) const {
    std::vector<Influences> influences = field.at(mesh);
    bones.share(influences);
    return jointWeights(influences, evaluation_.rig());
  }

  /// What was painted on the body shows on the parts that it was made of.
  void skinPart(std::vector<JointWeights> own, const std::vector<JointWeights>& painted,
                const std::vector<char>& reached, SkinnedMesh& part) {
    if (std::find(reached.begin(), reached.end(), 1) != reached.end()) {
      const auto nearest = nearestVertices(made_.merged.mesh, part.mesh.positions);
      for (size_t i = 0; i < own.size(); ++i) {
        if (nearest[i] != kNone && reached[nearest[i]]) own[i] = painted[nearest[i]];
      }
    }
    for (JointWeights& one : own) part.skin.push_back(skinOf(std::move(one)));
  }

  const Evaluation& evaluation_;
  const CharacterOptions& options_;
  Clock clock_;
  const CharacterWatch& seen_;
  Character made_;
  Stopwatch watch_;
  std::vector<uint32_t> paint_of_;  // by placed part
  bool stopped_ = false;            // while strokes were painted
  struct Sharp {
    size_t mesh;  // of the character's
    const Part* part;
    Frame turn;
  };
  std::vector<Sharp> sharp_;  // imported parts, each a mesh of its own
};

}  // namespace

CharacterOptions characterOptions(const Document& document, const Rig& rig) {
  CharacterOptions options;
  options.symmetry = symmetryPlane(document);
  options.blend = document.blend;
  options.strokes = placedStrokes(document, rig);
  return options;
}

std::vector<std::string> leftOutOf(const Character& character) {
  std::vector<std::string> sentences;
  for (const Character::LeftOut& out : character.left_out) {
    const auto paint = std::find_if(character.paints.begin(), character.paints.end(),
                                    [&](const Paint& one) { return one.part == out.part; });
    const std::string name = paint != character.paints.end() ? paint->name : out.part;
    sentences.push_back(name + " is left out: " + out.why + ".");
  }
  return sentences;
}

std::vector<Paint> paintsOf(const Evaluation& evaluation) {
  std::vector<Paint> paints;
  for (const PlacedPart& placed : evaluation.placed()) {
    if (!shownPart(evaluation, placed)) continue;
    const PartSource& source = *evaluation.parts()[placed.source].source;
    std::string name = source.name;
    if (placed.side) name += std::string(".") + placed.side;
    paints.push_back({std::move(name), source.color, placed.id});
  }
  return paints;
}

Character makeCharacter(const Evaluation& evaluation, const CharacterOptions& options, Clock clock,
                        const CharacterWatch& watch) {
  return Maker(evaluation, options, clock, watch).make();
}

SkinnedMesh posedMesh(const SkinnedMesh& mesh, const Rig& rig, const Pose& pose, Skinning how) {
  SkinnedMesh result = mesh;
  if (mesh.skin.empty()) return result;
  SkinnedVertices moved;
  skin(mesh.mesh.positions, mesh.normals, mesh.skin, posed(rig, pose), how, moved);
  result.mesh.positions = std::move(moved.positions);
  result.normals = std::move(moved.normals);
  return result;
}

}  // namespace marrow
