// Small repairs of closed polygons
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Takes back what a pen drew forth and back over nearly the same line: the tips of spikes and of
/// crevices, down to where their two sides are `thin` apart. A simple polygon nearly always stays
/// simple; check.
std::vector<Vec2> withoutSpikes(const std::vector<Vec2>& polygon, double thin);

/// The vertices, in order, without those no farther than `near` from the line between their
/// neighbours.
std::vector<uint32_t> withoutCollinear(const std::vector<Vec2>& polygon, double near);

/// Counter-clockwise, without collinear vertices.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

}  // namespace marrow
