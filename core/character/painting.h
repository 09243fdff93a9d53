// Painting on a character while the brush moves.
#pragma once

#include <cstdint>
#include <vector>

#include "character/character.h"

namespace marrow {

/// Of a merged character with weights: what makeCharacter would make of it with other strokes, to
/// the bit, without computing the weights again. What stays is painted once.
class Painting {
 public:
  /// Both must outlive this. O(n log n).
  Painting(const Character& character, const Rig& rig);

  /// The strokes that stay, in place of those before; only what differs from them is painted.
  void set(std::vector<PlacedWeightStroke> strokes);

  /// With one more stroke on top, the one that is being painted, or none (null): a skin entry per
  /// vertex of the body, till the next call. O(what this stroke and the last one reach).
  const std::vector<VertexSkin>& with(const PlacedWeightStroke* stroke);

 private:
  void show(const std::vector<uint32_t>& vertices, const std::vector<JointWeights>& weights);

  const Character& character_;
  WeightPainter painter_;
  std::vector<PlacedWeightStroke> strokes_;
  std::vector<JointWeights> staying_, shown_;  // by merged vertex
  std::vector<uint32_t> on_top_;               // where these differ
  std::vector<uint32_t> starts_, doubles_;     // of a merged vertex: those of the body
  std::vector<VertexSkin> skin_;
};

}  // namespace marrow
