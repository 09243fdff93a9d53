// Heights of a part's body above its plane, on a lattice: is a point inside the body?
#pragma once

#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// The body is the same in front and behind, so its upper half says all. Heights are those at
/// thickness 1.
class Relief {
 public:
  Relief() = default;
  /// mesh: a part's, closed. depths: z of each of its vertices at thickness 1.
  /// O(triangles + lattice), kSide × kSide places.
  Relief(const Mesh& mesh, const std::vector<double>& depths);

  /// Height over the lattice's place nearest to a point of the plane; 0 outside the outline.
  double heightAt(Vec2 p) const;
  Vec2 low() const { return low_; }  // box around the outline
  Vec2 high() const { return high_; }
  double highest() const { return highest_; }

 private:
  static constexpr int kSide = 40;

  Vec2 low_, high_;
  double highest_ = 0;
  std::vector<float> heights_;  // of the middles of cells, row by row
};

}  // namespace marrow
