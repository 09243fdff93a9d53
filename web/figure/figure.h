// The whole character as one mesh that follows the joints: what pose mode shows.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "character/character.h"

namespace marrow {

/// Single precision, as the GPU wants it, around `origin`: what lies far away stays sharp.
struct Figure {
  struct Vertex {
    std::array<float, 3> position, normal;
    std::array<float, VertexSkin::kMost> weights;  // sum 1; all 0: it follows nothing
    std::array<uint16_t, VertexSkin::kMost> joints;
    std::array<float, 3>
        hull;  // the normal of the smooth surface, the same where a vertex is doubled
  };
  struct Joint {
    std::string id;
    int32_t parent = -1;  // −1: a root
  };
  /// The triangles of one placed part.
  struct Stretch {
    std::string part;  // id of the placed part
    uint32_t first = 0, count = 0;
  };

  Vec3 origin;
  std::vector<Vertex> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;  // by stretches
  std::vector<Stretch> stretches;
  std::vector<Joint> joints;
  std::vector<std::string> left_out;  // sentences: parts that are not in it, and why
  bool guessed = false;               // its weights are a first guess
  double made_ms = 0;                 // how long it took
};

/// Of a merged character. Errors: tooMany joints to be numbered in 16 bits; meshFailed without a
/// mesh.
Result<Figure> figureOf(const Character& character, const Evaluation& evaluation);

/// The bytes it travels in; only for the same build of the app.
std::string toBytes(const Figure& figure);
/// Errors: unreadable.
Result<Figure> figureFromBytes(const std::string& bytes);

/// Its vertices that lie outermost, for each joint of those that follow it most, and of those that
/// follow none: without triangles. They tell how far it reaches in a pose, all but a little.
Figure outermost(const Figure& figure);

/// For each joint of the figure the motion that a pose of the rig gives it, in space. Joints that
/// the rig does not have follow the nearest above them that it has.
std::vector<Rigid> motionsOf(const Figure& figure, const Rig& rig, const std::vector<Rigid>& posed);

/// Where its vertices are in a pose, in space, as the GPU is to show them. motions: of the figure's
/// joints.
SkinnedVertices posedVertices(const Figure& figure, const std::vector<Rigid>& motions,
                              Skinning how);

}  // namespace marrow
