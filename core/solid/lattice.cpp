#include "solid/lattice.h"

#include <cmath>

namespace marrow {
namespace {

// Of a sum of three products of three differences, the differences being exact.
constexpr double kRounding = 8 * 0x1p-53;

__extension__ typedef unsigned __int128 Unsigned128;

int64_t whole(double value) { return static_cast<int64_t>(value); }

template <typename T>
int signOf(T value) {
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

Vec3 absolute(Vec3 v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

/// |a| × |b|, high half first.
std::array<Unsigned128, 2> product(Int128 a, Int128 b) {
  const auto magnitude = [](Int128 v) {
    return v < 0 ? -static_cast<Unsigned128>(v) : static_cast<Unsigned128>(v);
  };
  const Unsigned128 x = magnitude(a), y = magnitude(b), low = ~static_cast<uint64_t>(0);
  const Unsigned128 ll = (x & low) * (y & low), lh = (x & low) * (y >> 64),
                    hl = (x >> 64) * (y & low), hh = (x >> 64) * (y >> 64);
  const Unsigned128 middle = (ll >> 64) + (lh & low) + (hl & low);
  return {hh + (lh >> 64) + (hl >> 64) + (middle >> 64), (middle << 64) | (ll & low)};
}

/// Sign of a·d − b·c.
int compareProducts(Int128 a, Int128 d, Int128 b, Int128 c) {
  const int left = signOf(a) * signOf(d), right = signOf(b) * signOf(c);
  if (left != right) return left > right ? 1 : -1;
  if (left == 0) return 0;
  const auto p = product(a, d), q = product(b, c);
  if (p == q) return 0;
  return p > q ? left : -left;
}

/// Sign of (height of `to` over `first`) × (height of `from` over `second`) − the other two.
int compareHeights(Vec3 from, Vec3 to, const Facet& first, const Facet& second) {
  const Measured a = first.height(to), d = second.height(from), b = first.height(from),
                 c = second.height(to);
  const double ad = a.value * d.value, bc = b.value * c.value;
  const auto spread = [](Measured x, Measured y) {
    return std::fabs(x.value) * y.error + std::fabs(y.value) * x.error + x.error * y.error;
  };
  const double error =
      (spread(a, d) + spread(b, c) + (std::fabs(ad) + std::fabs(bc)) * 0x1p-51) * (1 + 0x1p-50);
  const double value = ad - bc;
  if (value > error) return 1;
  if (value < -error) return -1;
  return compareProducts(first.exactHeight(to), second.exactHeight(from), first.exactHeight(from),
                         second.exactHeight(to));
}

}  // namespace

Facet::Facet(Vec3 a, Vec3 b, Vec3 c) : a_(a), ab_(b - a), ac_(c - a), normal_(cross(ab_, ac_)) {
  const Vec3 u = absolute(ab_), v = absolute(ac_);
  bound_ = Vec3{u.y * v.z + u.z * v.y, u.z * v.x + u.x * v.z, u.x * v.y + u.y * v.x} * kRounding;
}

Int128 Facet::exactHeight(Vec3 p) const {
  const Vec3 d = p - a_;
  const auto minor = [](double a, double b, double c, double e) {
    return static_cast<Int128>(whole(a)) * whole(e) - static_cast<Int128>(whole(b)) * whole(c);
  };
  return minor(ab_.y, ab_.z, ac_.y, ac_.z) * whole(d.x) +
         minor(ab_.z, ab_.x, ac_.z, ac_.x) * whole(d.y) +
         minor(ab_.x, ab_.y, ac_.x, ac_.y) * whole(d.z);
}

int Facet::exactSide(Vec3 p) const { return signOf(exactHeight(p)); }

int orientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double value = dot(cross(u, v), w);
  const Vec3 au = absolute(u), av = absolute(v), aw = absolute(w);
  const double error = ((au.y * av.z + au.z * av.y) * aw.x + (au.z * av.x + au.x * av.z) * aw.y +
                        (au.x * av.y + au.y * av.x) * aw.z) *
                       kRounding;
  if (value > error) return 1;
  if (value < -error) return -1;
  return signOf(Facet(a, b, c).exactHeight(d));
}

int turn(Vec3 a, Vec3 b, Vec3 c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double error = (std::fabs(left) + std::fabs(right)) * kRounding;
  if (left - right > error) return 1;
  if (left - right < -error) return -1;
  return signOf(static_cast<Int128>(whole(b.x - a.x)) * whole(c.y - a.y) -
                static_cast<Int128>(whole(b.y - a.y)) * whole(c.x - a.x));
}

int firstMet(Vec3 from, Vec3 to, const Facet& first, const Facet& second) {
  // The way to a facet is from ÷ (from − to), its heights having different signs.
  return compareHeights(from, to, first, second) * first.side(from) * second.side(from);
}

int sideOfPiercing(Vec3 a, Vec3 b, const Facet& pierced, const Facet& facet) {
  return compareHeights(a, b, facet, pierced) * pierced.side(a);
}

}  // namespace marrow
