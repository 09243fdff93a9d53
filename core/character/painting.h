// Painting on a character while the brush moves.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "character/character.h"

namespace marrow {

/// Of a merged character with weights: what makeCharacter would make of it with other strokes, to
/// the bit, without computing the weights again. Only strokes that differ from those before, and
/// what was painted after them, are painted.
class Painting {
 public:
  /// Both must outlive this. O(n log n).
  Painting(const Character& character, const Rig& rig);

  /// The strokes, in place of those before. What the last ones painted over is kept, so that it
  /// takes no more than what differs; only to go back further begins at the first stroke again.
  /// progress: between two strokes, how much is done; where it says to stop the later ones are
  /// missing, till the next call, and the answer is false.
  bool set(const std::vector<PlacedWeightStroke>& strokes,
           const WeightProgress& progress = nullptr);

  /// A skin entry per vertex of the body.
  const std::vector<VertexSkin>& skin() const { return skin_; }

 private:
  struct Covered {
    uint32_t vertex;
    JointWeights weights;
  };
  void paint(const PlacedWeightStroke& stroke);
  void goBack(size_t strokes);
  void beginAgain();
  void show(uint32_t vertex);

  const Character& character_;
  WeightPainter painter_;
  std::vector<PlacedWeightStroke> strokes_;
  std::vector<JointWeights> weights_, last_;  // by merged vertex; last_: before the stroke at hand
  std::deque<std::vector<Covered>> covered_;  // by the last strokes: what was there before
  size_t covered_count_ = 0;                  // of all of these
  std::vector<uint32_t> starts_, doubles_;    // of a merged vertex: those of the body
  std::vector<VertexSkin> skin_;
};

}  // namespace marrow
