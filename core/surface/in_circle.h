// The Delaunay test.
#pragma once

#include <cmath>

#include "base/vec.h"

namespace marrow {

/// surelyInCircle() where double precision leaves it open: in twice that precision.
bool surelyInCircleWide(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// True where d is inside the circle through a, b, c (counter-clockwise) beyond all doubt: false
/// when rounding could matter [error bound: Shewchuk 1997]. A flip decided by it is always a real
/// improvement, so flipping ends. Points that are on one line but for rounding are told apart.
inline bool surelyInCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  constexpr double kRounding = 0x1p-53;
  const Vec2 u = a - d, v = b - d, w = c - d;
  const double vw1 = v.x * w.y, vw2 = w.x * v.y;
  const double wu1 = w.x * u.y, wu2 = u.x * w.y;
  const double uv1 = u.x * v.y, uv2 = v.x * u.y;
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const double det = uu * (vw1 - vw2) + vv * (wu1 - wu2) + ww * (uv1 - uv2);
  const double permanent = uu * (std::fabs(vw1) + std::fabs(vw2)) +
                           vv * (std::fabs(wu1) + std::fabs(wu2)) +
                           ww * (std::fabs(uv1) + std::fabs(uv2));
  const double bound = (10 + 96 * kRounding) * kRounding * permanent;
  if (det > bound) return true;
  if (det < -bound) return false;
  return surelyInCircleWide(a, b, c, d);
}

}  // namespace marrow
