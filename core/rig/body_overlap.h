// How much two bodies are inside each other, where their proxies are too coarse to tell.
#pragma once

#include "rig/rig.h"

namespace marrow {

/// The larger of two shares: of the points of one part's body that lie inside the other's, and the
/// other way round. The points are some of its outline, its surface and its joints; a single one
/// inside counts for nothing. 0 where the bodies do not meet; O(points).
double bodyOverlap(const RigPart& one, const RigPart& other);

}  // namespace marrow
