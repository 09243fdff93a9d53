// A closed curve that crosses itself → the border of its largest piece
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"

namespace marrow {

/// Lattice coordinates that outerBoundary() takes lie in [0, 2^kLatticeBits].
constexpr int kLatticeBits = 30;

/// The outer boundary of what a closed curve encloses, cut where it touches itself; of the pieces
/// the one with the largest area. Holes are ignored.
///
/// Crossing an edge changes the winding number by one, so the outer boundary of the non-zero
/// winding area is the border of the unbounded face of the curve's arrangement. That border is
/// walked edge by edge: only edges that touch it are ever intersected. All decisions are made in
/// exact integer and rational arithmetic, so any input is good: overlaps, repeats, touching points.
///
/// curve: whole numbers in [0, 2^kLatticeBits].
/// most_work: how often an edge is looked at, at most; nothing is returned where that is not
/// enough. A few times the curve's size is the rule. Result: counter-clockwise; crossings are
/// rounded to double, so two of them that lie closer than 1e-15 of the size may coincide. Empty
/// where the curve encloses no area.
std::optional<std::vector<Vec2>> outerBoundary(const std::vector<Vec2>& curve,
                                               size_t most_work = SIZE_MAX);

}  // namespace marrow
