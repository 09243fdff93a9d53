// Douglas–Peucker on a closed polygon  [RS §3.1; Douglas & Peucker 1973]
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Which vertices to keep, in order, so that no vertex lies farther than `tolerance` from the chord
/// that replaces it. The recursion starts from two mutually farthest vertices, whatever the first
/// vertex is; afterwards vertices that are not needed between their new neighbours go as well.
/// At least three are kept where three are not on a line. Where the chords would cross, more are
/// kept: the simplification of a simple polygon is simple.
///
/// polygon: at least three vertices.
std::vector<uint32_t> simplify(const std::vector<Vec2>& polygon, double tolerance);

}  // namespace marrow
