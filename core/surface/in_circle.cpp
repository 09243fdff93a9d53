#include "surface/in_circle.h"

namespace marrow {
namespace {

/// high + low, low within half a unit in the last place of high  [Dekker 1971].
struct Wide {
  double high, low;
};

Wide exactSum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// As above, for |a| ≥ |b|.
Wide exactSumOrdered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

Wide exactProduct(double a, double b) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double a_scaled = kSplitter * a, b_scaled = kSplitter * b;
  const double a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
  const double b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

Wide operator+(Wide a, Wide b) {
  const Wide high = exactSum(a.high, b.high), low = exactSum(a.low, b.low);
  const Wide sum = exactSumOrdered(high.high, high.low + low.high);
  return exactSumOrdered(sum.high, sum.low + low.low);
}

Wide operator-(Wide a) { return {-a.high, -a.low}; }
Wide operator-(Wide a, Wide b) { return a + -b; }

Wide operator*(Wide a, Wide b) {
  const Wide high = exactProduct(a.high, b.high);
  return exactSumOrdered(high.high, high.low + (a.high * b.low + a.low * b.high));
}

double size(Wide a) { return std::fabs(a.high); }

}  // namespace

bool surelyInCircleWide(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Wide ux = exactSum(a.x, -d.x), uy = exactSum(a.y, -d.y);
  const Wide vx = exactSum(b.x, -d.x), vy = exactSum(b.y, -d.y);
  const Wide wx = exactSum(c.x, -d.x), wy = exactSum(c.y, -d.y);
  const Wide vw1 = vx * wy, vw2 = wx * vy;
  const Wide wu1 = wx * uy, wu2 = ux * wy;
  const Wide uv1 = ux * vy, uv2 = vx * uy;
  const Wide uu = ux * ux + uy * uy, vv = vx * vx + vy * vy, ww = wx * wx + wy * wy;
  const Wide det = uu * (vw1 - vw2) + vv * (wu1 - wu2) + ww * (uv1 - uv2);
  const double permanent = uu.high * (size(vw1) + size(vw2)) + vv.high * (size(wu1) + size(wu2)) +
                           ww.high * (size(uv1) + size(uv2));
  // A few dozen units of 2^-106, generously.
  return det.high > 0x1p-97 * permanent;
}

}  // namespace marrow
