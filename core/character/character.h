// A character ready to be taken away: one body around all parts, or each part by itself, and what
// each bone moves of it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/timing.h"
#include "document/evaluation.h"
#include "pose/pose.h"
#include "pose/skin.h"
#include "solid/merge.h"
#include "weights/skin_weights.h"
#include "weights/weight_strokes.h"

namespace marrow {

struct Paint {
  std::string name;  // of the part
  Color color;
  std::string part;  // id of the placed part
};

/// At rest, in space. One normal and one skin entry per vertex, or no skin at all: then it follows
/// no joint. Vertices are doubled where parts meet at an edge, and at the sharp edges of imported
/// ones, so that each has its own normal.
struct SkinnedMesh {
  std::string name;
  Mesh mesh;
  std::vector<Vec3> normals;
  std::vector<VertexSkin> skin;             // joints: indices of the rig's
  std::vector<uint32_t> paint_of_triangle;  // an index of Character::paints
  /// Of a merged body: for each vertex the one of Character::merged that it is, or a double of.
  std::vector<uint32_t> merged_vertex;
};

struct CharacterOptions {
  bool merged = true;  // else each part is a mesh of its own
  bool weights = true;
  std::optional<Plane> symmetry;  // where it lies along the axes, twins get the same weights
  double blend = 0;               // of a merged body: how far around seams are soft (see blend.h)
  std::vector<PlacedWeightStroke> strokes;  // painted over the weights, one after the other
  MergeOptions merge;
  WeightOptions weighting;
};
/// As the document has it, whose rig this is: symmetry, blend and strokes.
CharacterOptions characterOptions(const Document& document, const Rig& rig);

struct Character;

/// What happens on the way to a character.
struct CharacterWatch {
  /// The character with quick weights, before the others are begun.
  std::function<void(const Character&)> first_guess;
  /// Of the weights, and between strokes; where it says to stop, the character has no weights.
  WeightProgress progress;
};

struct Character {
  /// Of what is merged; parts of their own are all there.
  struct LeftOut {
    std::string part;  // id of the placed part
    std::string why;   // a clause
  };
  struct WeightReport {
    size_t bones = 0;
    double max_sum_error = 0, min = 0, max = 0;  // over all vertices of all meshes
  };

  MergedMesh merged;  // without seams doubled; ids are indices of Evaluation::placed
  std::vector<SkinnedMesh> meshes;
  std::vector<Paint> paints;  // one per placed part that is shown
  std::vector<LeftOut> left_out;
  std::optional<WeightReport> weights;  // where they were asked for and there are some
  std::string no_weights;  // a sentence: why there are none though they were asked for, and there
                           // are meshes and bones
  /// As computed, before strokes (see painting.h): one per vertex of `merged`; empty where there
  /// are no weights.
  std::vector<JointWeights> unpainted;
  Timings timings;  // stages: merge, weights, vertices
};

/// A sentence for each part that is not in it.
std::vector<std::string> leftOutOf(const Character& character);

/// Of all visible parts, in their order.
std::vector<Paint> paintsOf(const Evaluation& evaluation);

/// Of all visible parts. A joint moves what the bones that leave it hold [RS §4.1]: weights are
/// those of bounded biharmonic functions on the body's volume, the largest four of each vertex.
Character makeCharacter(const Evaluation& evaluation, const CharacterOptions& options = {},
                        Clock clock = nullptr, const CharacterWatch& watch = {});

/// The mesh as a pose leaves it. One without a skin stays as it is.
SkinnedMesh posedMesh(const SkinnedMesh& mesh, const Rig& rig, const Pose& pose, Skinning how);

}  // namespace marrow
