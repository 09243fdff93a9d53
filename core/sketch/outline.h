// Stroke → outline  [RS §3.1 "Simple polygon acquisition"]
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "sketch/mirror_line.h"

namespace marrow {

/// The perimeter for which the paper's absolute thresholds hold. Every length threshold of the
/// pipeline is multiplied by perimeter / kReferencePerimeter, so that scale changes nothing else.
constexpr double kReferencePerimeter = 2000;

struct OutlineOptions {
  int samples = 200;      // resampling step = perimeter ÷ samples [RS Fig. 19]; finer for thin
                          // shapes, coarser for small ones drawn on whole pixels
  double steadiness = 1;  // how far `polygon` is averaged along the curve to either side, × step;
                          // 0: not at all, it lies inside `dense`
  std::optional<bool> symmetric;  // whether `polygon` is to be its own mirror image; unset: where
                                  // what was drawn nearly is
  std::optional<bool> was_symmetric;  // a moment ago: "nearly" means less then, or more
};

struct Outline {
  std::vector<Vec2> dense;    // what the hand drew, evenly sampled, corners kept, straight sides in
                              // one piece; for the mesh
  std::vector<Vec2> polygon;  // smoother, with few vertices; input of the skeleton
  std::optional<MirrorLine> mirror;  // where `polygon` is its own mirror image
  double likeness = 0;   // of `dense` to its mirror image across the best line: MirrorFit::overlap
  double perimeter = 0;  // of `dense`, model units
  bool crossed_itself = false;  // the stroke did: `dense` is the border of its largest piece

  /// What a threshold given at the reference perimeter is multiplied by.
  double scale() const { return perimeter / kReferencePerimeter; }
};

/// Closes a pointer stroke into a simple polygon.
///
/// stroke: any number of samples, model units, y up, open or closed, either direction, any noise;
///         non-finite samples and repeats are dropped.
/// Both polygons of the result are simple, counter-clockwise, without repeated or collinear
/// vertices, with at least three vertices. A stroke that crosses itself becomes the outer boundary
/// of its non-zero-winding area, largest piece. Ends that overshoot each other are trimmed.
///
/// The same whichever end of the stroke is the first; of a closed stroke also wherever it starts.
/// Scaling the stroke by a power of two scales the result exactly, by other factors but for
/// rounding. Milliseconds for a thousand samples, a fraction of a second for a hundred thousand.
/// Errors: tooFewPoints, noArea.
Result<Outline> makeOutline(const std::vector<Vec2>& stroke, const OutlineOptions& options = {});

}  // namespace marrow
