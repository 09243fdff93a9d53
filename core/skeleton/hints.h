// What a skeleton of nearly the same shape was like.
#pragma once

#include <vector>

#include "base/vec.h"

namespace marrow {

/// While a stroke is drawn, and from one edit of a part to the next, what was there stays until it
/// is clearly gone, and what was not there comes only when it clearly is: nothing flickers.
struct SkeletonHints {
  std::vector<Vec2> ends;  // of limbs, in the part's plane
  std::vector<Vec2> junctions;
  bool mirrored = false;  // the skeleton was its own mirror image
};
inline bool operator==(const SkeletonHints& a, const SkeletonHints& b) {
  return a.ends == b.ends && a.junctions == b.junctions && a.mirrored == b.mirrored;
}

}  // namespace marrow
