// Changes to a part's outline by hand.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// The outline with the stretch that `stroke` was drawn over replaced by the stroke.
///
/// outline: simple, counter-clockwise, closed. stroke: drawn along or near it, in either direction.
/// The stretch between the places of the outline nearest to the stroke's ends is what goes: of the
/// two, the one that lies nearer to the stroke. Where stroke and outline leave a step, a straight
/// line joins them. The result may cross itself where the stroke does: makeOutline deals with that.
/// Nothing where the stroke has under two points, or both its ends meet the same place, or the
/// nearest end lies further than `reach` from the outline. O(outline × stroke).
std::optional<std::vector<Vec2>> redrawn(const std::vector<Vec2>& outline,
                                         const std::vector<Vec2>& stroke, double reach);

/// The outline with the point `grabbed` moved by `move`, and its neighbours by less the further
/// they are along the outline: nothing beyond `reach`. Long sides are given points within it, so
/// that they bend. O(outline).
std::vector<Vec2> dragged(const std::vector<Vec2>& outline, Vec2 grabbed, Vec2 move, double reach);

}  // namespace marrow
