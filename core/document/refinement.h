// How coarse or fine a skeleton is  [RS §3.3]
#pragma once

#include <optional>

namespace marrow {

/// The four thresholds, in units at the reference perimeter of the root part of a tree (ε_s: of the
/// part that nobody holds, whichever the user made the root). Unset: the next wider scope's: a
/// branch's ε_s, then its part's, then the model's, then the default.
struct Refinement {
  static constexpr double kSimplify = 5, kMerge = 30, kPrune = 30, kCollapse = 10;
  static constexpr double kLargest = 2000;  // and 0 the smallest

  std::optional<double> simplify;  // ε_s: BoundedDP along each branch
  std::optional<double> merge;     // ε_m: junctions nearer than this become one
  std::optional<double> prune;     // ε_t: side branches shorter than this go
  std::optional<double> collapse;  // ε_c: joints nearer than this become one
};
inline bool operator==(const Refinement& a, const Refinement& b) {
  return a.simplify == b.simplify && a.merge == b.merge && a.prune == b.prune &&
         a.collapse == b.collapse;
}

}  // namespace marrow
