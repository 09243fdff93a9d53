// A cap for a hole in a surface  [Barequet & Sharir 1995, for short holes]
#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// The edges of a mesh.
class Edges {
 public:
  void add(uint32_t a, uint32_t b) { keys_.insert(keyOf(a, b)); }
  bool has(uint32_t a, uint32_t b) const { return keys_.count(keyOf(a, b)) > 0; }

 private:
  static uint64_t keyOf(uint32_t a, uint32_t b) {
    return a < b ? static_cast<uint64_t>(a) << 32 | b : static_cast<uint64_t>(b) << 32 | a;
  }
  std::unordered_set<uint64_t> keys_;
};
Edges edgesOf(const Mesh& mesh);

/// Adds triangles that close the hole. False, and nothing added, where it is neither flat (no
/// corner further from its mean plane than a tenth of its size, or all on one line) nor of at most
/// `small`, or has more corners than anybody would cap, or a cap would run along edges that are
/// there already.
/// loop: its vertices, each once, in the direction in which the cap's border runs.
/// edges: of the mesh; those of the cap are added.
bool fillHole(Mesh& mesh, const std::vector<uint32_t>& loop, Edges& edges, double small);

}  // namespace marrow
