// Exact orientation of three points.  [Shewchuk 1997, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates"; Dekker 1971]
#pragma once

#include "base/vec.h"

namespace marrow {

/// turnSign() where the rounded determinant cannot decide. Never wrong while the products of
/// two coordinates neither overflow nor underflow (1e-140 to 1e140).
int turnSignExactly(Vec2 a, Vec2 b, Vec2 c);

/// +1 where a, b, c turn counter-clockwise, −1 clockwise, 0 where they lie exactly on a line.
inline int turnSign(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // (3 + 16 u) u for the unit roundoff u = 2⁻⁵³: the rounded determinant's relative error.
  constexpr double kErrorBound = 3.3306690738754716e-16;
  const double bound = kErrorBound * (std::fabs(left) + std::fabs(right));
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return turnSignExactly(a, b, c);
}

}  // namespace marrow
