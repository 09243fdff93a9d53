#include "surface/fans.h"

namespace marrow {

Mesh splitByFans(const Mesh& mesh, Sets& fans) {
  constexpr uint32_t kNone = ~0u;
  Mesh split;
  split.triangles.resize(mesh.triangles.size());
  std::vector<uint32_t> index(3 * mesh.triangles.size(), kNone);
  for (uint32_t corner = 0; corner < index.size(); ++corner) {
    uint32_t& number = index[fans.find(corner)];
    if (number == kNone) {
      number = static_cast<uint32_t>(split.positions.size());
      split.positions.push_back(mesh.positions[mesh.triangles[corner / 3][corner % 3]]);
    }
    split.triangles[corner / 3][corner % 3] = number;
  }
  return split;
}

}  // namespace marrow
