// The two loose ends of a pen stroke that is about to be closed
#pragma once

#include <vector>

#include "base/vec.h"

namespace marrow {

/// Cuts off what the pen overshot. Where the two ends run past each other the line that closes the
/// stroke would run back beside it and leave a spike; instead the stroke is closed where its ends
/// come closest, if that is much closer, saves more than is cut off, and little is cut off.
///
/// stroke: at least three points, neighbours distinct. At least three are left.
std::vector<Vec2> trimOvershoot(const std::vector<Vec2>& stroke);

}  // namespace marrow
