// A dense outline as the border of a mesh: about evenly spaced, still the same shape.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Drops vertices that lie closer than `spacing` asks for and hardly leave the line between their
/// neighbours (corners stay), and splits long edges into even pieces. What is kept is kept as
/// drawn; vertex 0 always is. A simple, counter-clockwise outline stays simple.
///
/// max_points: where more would be left, spacing and tolerance grow until it holds, or until the
/// area would change by more than a twentieth.
std::vector<Vec2> fitBorder(const std::vector<Vec2>& outline, double spacing, size_t max_points);

}  // namespace marrow
