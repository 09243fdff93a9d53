// Heights of a part's body above its plane, on a lattice: is a point inside the body?
#pragma once

#include <vector>

#include "surface/mesh.h"

namespace marrow {

/// A drawn body is the same in front and behind, so its upper half says all; of an imported one the
/// highest and the lowest places count, whatever is between them. Heights are those at thickness 1.
class Relief {
 public:
  Relief() = default;
  /// mesh: a part's, closed. depths: z of each of its vertices at thickness 1. even: it is the same
  /// in front and behind. O(triangles + lattice), kSide × kSide places.
  Relief(const Mesh& mesh, const std::vector<double>& depths, bool even = true);

  /// Height over the lattice's place nearest to a point of the plane; 0 outside the outline.
  double heightAt(Vec2 p) const { return at(heights_, p); }
  /// The same of the lower side.
  double depthAt(Vec2 p) const { return depths_.empty() ? -heightAt(p) : at(depths_, p); }
  Vec2 low() const { return low_; }  // box around the outline
  Vec2 high() const { return high_; }
  double highest() const { return highest_; }
  double lowest() const { return depths_.empty() ? -highest_ : lowest_; }

  /// Of the body seen in the mirror z = 0.
  Relief flipped() const;

 private:
  static constexpr int kSide = 40;

  double at(const std::vector<float>& lattice, Vec2 p) const;

  Vec2 low_, high_;
  double highest_ = 0, lowest_ = 0;
  std::vector<float> heights_;  // of the middles of cells, row by row
  std::vector<float> depths_;   // of the lower side; none where it is like the upper one
};

}  // namespace marrow
