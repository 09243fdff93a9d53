// Painting over weights: the strokes of a document on the surface of its body.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "document/document.h"
#include "rig/rig.h"
#include "solid/box_tree.h"
#include "surface/mesh.h"

namespace marrow {

struct JointWeight {
  uint32_t joint = 0;  // of the rig
  double weight = 0;
};
/// Of a vertex: joints ascending, weights > 0 that sum to 1, to rounding; or nothing at all.
using JointWeights = std::vector<JointWeight>;

/// A stroke where it lies in space, and where its mirror image lies if its part has a twin. Both
/// are painted at once, so that what they do is symmetric too.
struct PlacedWeightStroke {
  struct Trail {
    std::string joint;
    double radius = 0;
    std::vector<Vec3> points;
  };
  WeightStroke::Kind kind = WeightStroke::Kind::add;
  double strength = 1;
  std::vector<Trail> trails;
};

bool operator==(const PlacedWeightStroke& a, const PlacedWeightStroke& b);

/// Of all strokes whose part is there, in the order painted. The mirror image is for the joint that
/// is opposite on the rig (see mirror.h), across the plane of the part's twin.
std::vector<PlacedWeightStroke> placedStrokes(const Document& document, const Rig& rig);

/// A stroke in space for a joint of the rig, with the id by which strokeOnPart has it: so that one
/// painted on a twin is for that joint there, and for the opposite one on the part.
WeightStroke forJointOfRig(const Document& document, const Rig& rig, WeightStroke in_space);

class WeightPainter {
 public:
  /// Of a closed surface. Both must outlive this. O(n log n).
  WeightPainter(const Mesh& surface, const Rig& rig);

  /// Changes the weights, one entry per vertex of the surface, and gives the vertices it reached,
  /// ascending. Vertices without weights, and all others, keep every bit.
  ///
  /// A stroke is drawn to the nearest place of the surface; what is more than twice the radius away
  /// from it paints nothing. It reaches the vertices that are nearer to it than the radius and that
  /// the surface within the radius joins to where it lies: not the other leg that is near, but the
  /// back of an ear where the brush is wider than that. With the distance d its share falls as
  /// (1 − (d ÷ radius)²)², however often it passes, times the strength: s.
  ///
  /// add: w += s (1 − w). take: w −= s w, less where others hold under a twentieth, and nothing
  /// where none does. In both the others share the rest in proportion. smooth: s of the way to the
  /// mean of the neighbours, as often as it takes to even out a third of the radius on any mesh.
  ///
  /// Strokes for joints that the rig does not have, of no strength, or far away do nothing.
  std::vector<uint32_t> paint(const PlacedWeightStroke& stroke,
                              std::vector<JointWeights>& weights) const;

 private:
  struct Share {
    uint32_t vertex;
    double share;
  };
  std::vector<Share> cover(const PlacedWeightStroke::Trail& trail) const;
  std::vector<Vec3> drawnToSurface(const PlacedWeightStroke::Trail& trail,
                                   std::vector<uint32_t>& seeds) const;
  std::vector<uint32_t> smooth(const std::vector<Share>& shares, double radius,
                               std::vector<JointWeights>& weights) const;

  const Mesh& surface_;
  std::map<std::string, uint32_t> joints_;     // by their ids
  std::vector<uint32_t> starts_, neighbours_;  // of each vertex, ascending
  BoxTree triangles_;
};

}  // namespace marrow
