// Vertices that follow the joints of a pose.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/quaternion.h"

namespace marrow {

/// What moves one vertex: weights ≥ 0 that sum up to 1, the largest first; where they are 0 the
/// joint is 0 as well.
struct VertexSkin {
  static constexpr size_t kMost = 4;
  std::array<uint32_t, kMost> joints{};
  std::array<double, kMost> weights{1, 0, 0, 0};
};

enum class Skinning : uint8_t {
  linear,           // blends matrices: joints that bend far lose volume
  dualQuaternions,  // blends rigid motions: they keep it, and bulge a little [Kavan et al. 2008]
};

/// Positions and unit normals as the motions of the joints (see posed) leave them; a skin entry per
/// vertex, each joint an index of `motions`. O(vertices).
struct SkinnedVertices {
  std::vector<Vec3> positions, normals;
};
void skin(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
          const std::vector<VertexSkin>& skin, const std::vector<Rigid>& motions, Skinning how,
          SkinnedVertices& result);

}  // namespace marrow
