// The two loose ends of a pen stroke that is about to be closed
#pragma once

#include <vector>

#include "base/vec.h"

namespace marrow {

/// Cuts off what the pen overshot, so that the line that closes the stroke leaves no spike and no
/// notch: where the two ends run past each other side by side, and where one end comes close to the
/// flank of the other. Strokes of few samples, and gaps that are wide beside the whole, are left
/// alone. The same whichever end is the first.
///
/// stroke: at least three points, neighbours distinct. At least three are left.
std::vector<Vec2> trimOvershoot(const std::vector<Vec2>& stroke);

}  // namespace marrow
