#include "bench/weight_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <tuple>

#include "base/box.h"
#include "bench/creatures.h"
#include "character/character.h"
#include "document/evaluation.h"
#include "pose/pose.h"
#include "support/samples.h"
#include "weights/skin_weights.h"

namespace marrow::bench {
namespace {

using strokes::NamedStroke;
using strokes::Stroke;

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// The largest of many, and where it was.
struct Worst {
  double value = 0;
  std::string where;
  void add(double one, const std::string& at) {
    if (!(one > value)) return;
    value = one;
    where = at;
  }
};

struct Counted {
  size_t hits = 0, all = 0;
  void add(bool hit) {
    ++all;
    hits += hit ? 1 : 0;
  }
  double percent() const {
    return all ? 100 * static_cast<double>(hits) / static_cast<double>(all) : 0;
  }
  std::string of() const { return std::to_string(hits) + " of " + std::to_string(all); }
};

// ---- Limbs side by side

/// Limbs hang down from a trunk, `gap` apart; their bones are placed by hand.
struct Limbs {
  int count = 2;
  double width = 70, gap = 1, length = 250, trunk = 180;

  double middle(int limb) const { return (limb - (count - 1) / 2.0) * (width + gap); }
  Stroke stroke() const {
    const double half = middle(count - 1) + width / 2;
    Stroke corners{{half, trunk}, {-half, trunk}};
    for (int limb = 0; limb < count; ++limb) {
      const double left = middle(limb) - width / 2, right = middle(limb) + width / 2;
      if (limb > 0) corners.push_back({left, 0});
      corners.push_back({left, -length + width / 2});
      corners.push_back({left + width / 4, -length});
      corners.push_back({right - width / 4, -length});
      corners.push_back({right, -length + width / 2});
      if (limb + 1 < count) corners.push_back({right, 0});
    }
    return strokes::sampled(corners, width / 20);
  }
  /// One of the trunk, then of each limb the one to its mouth and two of its own.
  std::vector<Segment> bones() const {
    const Vec3 hips{0, 0.3 * trunk, 0};
    std::vector<Segment> all{{Vec3{0, 0.8 * trunk, 0}, hips}};
    for (int limb = 0; limb < count; ++limb) {
      const double x = middle(limb);
      const Vec3 mouth{x, 0.1 * trunk, 0}, knee{x, -length / 2, 0}, end{x, 0.4 * width - length, 0};
      all.insert(all.end(), {Segment{hips, mouth}, Segment{mouth, knee}, Segment{knee, end}});
    }
    return all;
  }
};

/// The largest weight that a vertex a limb's width below the slit has of other limbs' bones.
double leak(const Limbs& limbs) {
  const auto part = buildPart(limbs.stroke());
  if (!part) return 1;
  const auto field = WeightField::make(part->mesh, limbs.bones());
  if (!field) return 1;
  const std::vector<Influences> weights = field->at(part->mesh);
  double most = 0;
  for (size_t v = 0; v < weights.size(); ++v) {
    const Vec3 p = part->mesh.positions[v];
    if (p.y > -limbs.width) continue;
    double other = 0;
    for (const Influence& one : weights[v]) {
      if (one.bone == 0 || (one.bone - 1) % 3 == 0) continue;
      const int limb = static_cast<int>((one.bone - 1) / 3);
      if (std::fabs(p.x - limbs.middle(limb)) > (limbs.width + limbs.gap) / 2) other += one.weight;
    }
    most = std::max(most, other);
  }
  return most;
}

void addLeaks(std::vector<QualityRow>& rows) {
  Worst legs, fingers;
  for (const double gap : {1.0, 2.0, 3.0, 4.5, 6.0}) {
    Limbs two;
    two.gap = gap;
    legs.add(leak(two), rounded(gap) + " apart");
  }
  for (const double gap : {0.5, 1.0, 2.0, 3.0}) {
    fingers.add(leak({4, 25, gap, 110, 90}), rounded(gap) + " apart");
  }
  rows.push_back({"legs 1 to 6 apart: largest weight of the other leg", legs.value, 0.02, false, "",
                  legs.where});
  rows.push_back({"fingers ½ to 3 apart: largest weight of other fingers", fingers.value, 0.02,
                  false, "", fingers.where});
}

// ---- Characters

/// Per placed part: the ones that it hangs on, and theirs.
std::vector<std::vector<uint8_t>> ancestorsOf(const Evaluation& evaluation) {
  const size_t n = evaluation.placed().size();
  std::vector<int> parents(n, -1);
  for (const Connection& one : evaluation.rig().connections) {
    parents[one.child] = static_cast<int>(one.parent);
  }
  for (const auto& [part, joint] : evaluation.rig().carried) {
    if (joint >= 0) {
      parents[part] = static_cast<int>(evaluation.rig().joints[static_cast<size_t>(joint)].part);
    }
  }
  std::vector<std::vector<uint8_t>> ancestors(n, std::vector<uint8_t>(n, 0));
  for (size_t part = 0; part < n; ++part) {
    for (int up = static_cast<int>(part); up >= 0; up = parents[static_cast<size_t>(up)]) {
      if (ancestors[part][static_cast<size_t>(up)]) break;
      ancestors[part][static_cast<size_t>(up)] = 1;
    }
  }
  return ancestors;
}

struct Foreign {
  Counted vertices;
  Worst worst;

  /// Of a body: vertices of parts with bones that hang by more than a fifth on parts that neither
  /// hang on their own nor carry it.
  void add(const std::string& name, const Evaluation& evaluation, const Character& character,
           bool verbose) {
    const Rig& rig = evaluation.rig();
    const auto ancestors = ancestorsOf(evaluation);
    std::vector<uint8_t> has_bones(ancestors.size(), 0);
    for (const Rig::Joint& joint : rig.joints) has_bones[joint.part] = 1;
    const MergedMesh& merged = character.merged;
    std::vector<std::vector<uint32_t>> parts(merged.mesh.positions.size());
    for (size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
      for (const uint32_t v : merged.mesh.triangles[t]) {
        parts[v].push_back(merged.part_of_triangle[t]);
      }
    }
    Worst own;
    Counted share;
    for (size_t v = 0; v < parts.size(); ++v) {
      const auto isLimb = [&](uint32_t part) { return has_bones[part]; };
      if (!std::all_of(parts[v].begin(), parts[v].end(), isLimb)) continue;
      double foreign = 0;
      std::string other;
      for (const JointWeight& one : character.unpainted[v]) {
        const uint32_t of = rig.joints[one.joint].part;
        const bool related = std::any_of(parts[v].begin(), parts[v].end(), [&](uint32_t part) {
          return ancestors[part][of] || ancestors[of][part];
        });
        if (related) continue;
        foreign += one.weight;
        other = rig.joints[one.joint].name;
      }
      share.add(foreign > 0.2);
      vertices.add(foreign > 0.2);
      if (parts[v].empty()) continue;
      own.add(foreign, name + ": " + evaluation.placed()[parts[v][0]].id + " on " + other);
    }
    worst.add(own.value, own.where);
    if (verbose && share.hits) {
      std::fprintf(stderr, "foreign %s %s, %s\n", share.of().c_str(), rounded(own.value).c_str(),
                   own.where.c_str());
    }
  }
};

/// The largest difference between the weights of a part and of its twin; nothing where joints have
/// no mirror images, to a hundredth of the size.
std::optional<double> twinsDiffer(const Evaluation& evaluation, const Plane& plane,
                                  CharacterOptions options) {
  const Rig& rig = evaluation.rig();
  Box3 box;
  for (const Rig::Joint& joint : rig.joints) box.include(joint.position);
  const double size = distance(box.low, box.high), near = 1e-6 * size;
  std::vector<uint32_t> images;
  for (const Rig::Joint& joint : rig.joints) {
    const Vec3 image = mirrored(joint.position, plane);
    const auto twin =
        std::min_element(rig.joints.begin(), rig.joints.end(), [&](const auto& a, const auto& b) {
          return distance(a.position, image) < distance(b.position, image);
        });
    if (distance(twin->position, image) > 0.01 * size) return {};
    images.push_back(static_cast<uint32_t>(twin - rig.joints.begin()));
  }
  // A spine across the plane begins at one side: what joints carry there is no mirror image.
  std::vector<std::vector<uint32_t>> children(rig.joints.size());
  for (const auto& [parent, child] : rig.bones) children[parent].push_back(child);
  for (uint32_t joint = 0; joint < images.size(); ++joint) {
    std::vector<uint32_t> mirrored_children = children[joint];
    for (uint32_t& child : mirrored_children) child = images[child];
    const auto& same = children[images[joint]];
    if (!std::is_permutation(mirrored_children.begin(), mirrored_children.end(), same.begin(),
                             same.end())) {
      return {};
    }
  }
  options.merged = false;
  const Character character = makeCharacter(evaluation, options);
  if (character.meshes.size() != evaluation.placed().size()) return {};
  const auto weightOf = [](const VertexSkin& skin, uint32_t joint) {
    double weight = 0;
    for (size_t k = 0; k < VertexSkin::kMost; ++k) {
      if (skin.joints[k] == joint) weight += skin.weights[k];
    }
    return weight;
  };
  double most = 0;
  for (size_t i = 1; i < evaluation.placed().size(); ++i) {
    if (!evaluation.placed()[i].twin) continue;
    const SkinnedMesh &one = character.meshes[i - 1], &other = character.meshes[i];
    if (one.skin.size() != other.skin.size()) continue;
    for (size_t v = 0; v < one.skin.size(); ++v) {
      // The front of the one is the back of the other.
      const Vec3 image = mirrored(one.mesh.positions[v], plane);
      const auto twin = std::find_if(
          other.mesh.positions.begin(), other.mesh.positions.end(),
          [&](Vec3 p) { return std::fabs(p.x - image.x) < near && distance(p, image) < near; });
      if (twin == other.mesh.positions.end()) continue;
      const VertexSkin& same = other.skin[static_cast<size_t>(twin - other.mesh.positions.begin())];
      for (uint32_t joint = 0; joint < images.size(); ++joint) {
        const double off = weightOf(one.skin[v], joint) - weightOf(same, images[joint]);
        most = std::max(most, std::fabs(off));
      }
    }
  }
  return most;
}

/// What moves the ends of an edge, in words.
std::string edgeOf(const Rig& rig, const SkinnedMesh& body, const Paint& paint, uint32_t a,
                   uint32_t b) {
  std::string text = "of " + paint.name;
  for (const uint32_t v : {a, b}) {
    text += v == a ? ": " : " | ";
    for (size_t k = 0; k < VertexSkin::kMost && body.skin[v].weights[k] > 0; ++k) {
      text +=
          rig.joints[body.skin[v].joints[k]].name + " " + rounded(body.skin[v].weights[k]) + ", ";
    }
  }
  return text;
}

struct Stretched {
  Counted turns;
  Worst worst;

  /// Each joint that has bones on both sides is turned by 60°, about z.
  void add(const std::string& name, const Rig& rig, const Character& character, bool verbose) {
    if (character.meshes.empty() || character.meshes[0].skin.empty()) return;
    const SkinnedMesh& body = character.meshes[0];
    Box3 box;
    for (const Vec3 p : body.mesh.positions) box.include(p);
    const double least = 1e-3 * distance(box.low, box.high);  // no edges that merging cut off
    std::vector<uint8_t> bears(rig.joints.size(), 0);
    for (const auto& bone : rig.bones) bears[bone[0]] = 1;
    SkinnedVertices moved;
    for (uint32_t joint = 0; joint < rig.joints.size(); ++joint) {
      if (rig.joints[joint].parent < 0 || !bears[joint]) continue;
      const Pose pose = turned(rig, {}, joint, {0, 0, 0.5, std::sqrt(0.75)});
      skin(body.mesh.positions, body.normals, body.skin, posed(rig, pose), Skinning::linear, moved);
      double most = 0;
      std::string where;
      for (size_t t = 0; t < body.mesh.triangles.size(); ++t) {
        const auto& triangle = body.mesh.triangles[t];
        for (size_t i = 0; i < 3; ++i) {
          const uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
          const double rest = distance(body.mesh.positions[a], body.mesh.positions[b]);
          if (rest < least) continue;
          const double now = distance(moved.positions[a], moved.positions[b]) / rest;
          if (!(now > most)) continue;
          most = now;
          if (verbose) where = edgeOf(rig, body, character.paints[body.paint_of_triangle[t]], a, b);
        }
      }
      turns.add(most > 4);
      if (verbose && most > 4) {
        std::fprintf(stderr, "turn %s %s: %s; %s\n", name.c_str(), rig.joints[joint].name.c_str(),
                     rounded(most).c_str(), where.c_str());
      }
      worst.add(most, name + ": " + rig.joints[joint].name);
    }
  }
};

Document documentOf(const Stroke& stroke) {
  Document document;
  auto part = std::make_shared<PartSource>();
  part->id = partId(takePartNumber(document));
  part->name = "Body";
  part->stroke = stroke;
  document.parts.push_back(std::move(part));
  return document;
}

}  // namespace

std::vector<QualityRow> weightQuality(const std::vector<NamedStroke>& drawings, bool verbose) {
  std::vector<QualityRow> rows;
  addLeaks(rows);

  Foreign foreign;
  Stretched of_parts, of_strokes;
  Worst twins;
  size_t with_twins = 0;
  const auto look = [&](const std::string& name, const Document& document) {
    Evaluation evaluation;
    evaluation.update(document);
    const Rig& rig = evaluation.rig();
    const CharacterOptions options = characterOptions(document, rig);
    const Character character = makeCharacter(evaluation, options);
    if (!character.weights || character.unpainted.empty()) return;
    Stretched& stretched = evaluation.placed().size() > 1 ? of_parts : of_strokes;
    stretched.add(name, rig, character, verbose);
    if (evaluation.placed().size() < 2) return;
    foreign.add(name, evaluation, character, verbose);
    if (!options.symmetry) return;
    const auto differ = twinsDiffer(evaluation, *options.symmetry, options);
    if (!differ) return;
    ++with_twins;
    twins.add(*differ, name);
    if (verbose) std::fprintf(stderr, "twins %s: %s\n", name.c_str(), rounded(*differ).c_str());
  };
  for (const SampleFile& sample : sampleFiles()) look(sample.name, sample.document);
  for (const NamedStroke& drawing : drawings) look(drawing.name, documentOf(drawing.points));

  rows.push_back({"vertices of which over a fifth hangs on limbs that are no relatives",
                  foreign.vertices.percent(), 0.2, false, "%",
                  foreign.vertices.of() + "; worst " + rounded(foreign.worst.value) + ", " +
                      foreign.worst.where});
  for (const auto& [of, stretched, wanted, longest] :
       {std::tuple{"creatures", &of_parts, 8.0, 10.0},
        {"single strokes", &of_strokes, 1.0, 10.0}}) {
    const std::string what = std::string(of) + " turned by 60° at a joint: ";
    rows.push_back({what + "an edge over 4 times as long", stretched->turns.percent(), wanted,
                    false, "%", stretched->turns.of()});
    rows.push_back({what + "the most stretched edge", stretched->worst.value, longest, false, "",
                    stretched->worst.where});
  }
  rows.push_back({"twins' weights: largest difference", twins.value, 0.01, false, "",
                  std::to_string(with_twins) + " characters; " + twins.where});
  return rows;
}

}  // namespace marrow::bench
