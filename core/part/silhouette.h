// The outline of a body seen along z, and how deep the body is there: what gives an imported mesh a
// skeleton.
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "solid/box_tree.h"
#include "surface/mesh.h"

namespace marrow {

/// The border of the largest piece of the mesh's shadow, without its holes: a closed stroke, good
/// to about a thousandth of the shadow's size; what is thinner is not seen. Errors: noArea. mesh:
/// closed, finite. O(triangles × rows of pixels).
Result<std::vector<Vec2>> silhouetteOf(const Mesh& mesh);

/// A stretch of a ray along z that is inside.
struct DepthSpan {
  double low = 0, high = 0;

  double middle() const { return (low + high) / 2; }
  double half() const { return (high - low) / 2; }
};

/// Rays along z through a mesh.
class DepthRays {
 public:
  /// mesh: closed and outward; it must outlive this.
  explicit DepthRays(const Mesh& mesh);

  /// The longest stretch inside, or the highest one of those that are nearly as long (three
  /// quarters): of two legs the nearer one. Nothing where the ray misses the mesh.
  std::optional<DepthSpan> at(Vec2 p) const;

 private:
  const Mesh& mesh_;
  BoxTree tree_;  // boxes of the triangles, flat
};

}  // namespace marrow
