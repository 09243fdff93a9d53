// Unit quaternions as rotations, and rigid motions. No angles: nothing but + − × ÷ √.
#pragma once

#include <array>
#include <cmath>

#include "base/vec.h"

namespace marrow {

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};
inline bool operator==(const Quaternion& a, const Quaternion& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}
inline bool operator!=(const Quaternion& a, const Quaternion& b) { return !(a == b); }

inline double dot(const Quaternion& a, const Quaternion& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
inline Quaternion operator+(const Quaternion& a, const Quaternion& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
inline Quaternion operator*(const Quaternion& q, double s) {
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}
/// First b, then a.
inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
inline Quaternion conjugate(const Quaternion& q) { return {-q.x, -q.y, -q.z, q.w}; }
/// The rotation that is nearest; none for (0, 0, 0, 0) and what is not finite.
inline Quaternion normalised(const Quaternion& q) {
  const double size = std::sqrt(dot(q, q));
  return size > 0 && std::isfinite(size) ? q * (1 / size) : Quaternion{};
}
inline Vec3 rotated(const Quaternion& q, Vec3 v) {
  const Vec3 axis{q.x, q.y, q.z}, twice = 2 * cross(axis, v);
  return v + twice * q.w + cross(axis, twice);
}

/// The shortest rotation that turns one direction into another; about any axis where they are
/// opposite. Directions need not be of unit length; none where one has no length.
inline Quaternion between(Vec3 from, Vec3 to) {
  const double lengths = std::sqrt(dot(from, from) * dot(to, to));
  if (!(lengths > 0)) return {};
  const double cosine = dot(from, to) / lengths;
  if (cosine < -1 + 1e-12) {
    const Vec3 aside = std::abs(from.x) < 0.5 * length(from) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 axis = cross(from, aside) / length(cross(from, aside));
    return {axis.x, axis.y, axis.z, 0};
  }
  const Vec3 axis = cross(from, to) / lengths;
  return normalised({axis.x, axis.y, axis.z, 1 + cosine});
}

/// The rotation that takes the axes of space to these, which are orthonormal and right-handed.
inline Quaternion rotationTo(Vec3 x, Vec3 y, Vec3 z) {
  // Of the four components the largest is found without cancellation.
  const std::array<double, 4> squares{1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                                      1 + x.x + y.y + z.z};
  size_t largest = 0;
  for (size_t i = 1; i < 4; ++i) {
    if (squares[i] > squares[largest]) largest = i;
  }
  const double a = y.z - z.y, b = z.x - x.z, c = x.y - y.x;
  const double d = x.y + y.x, e = x.z + z.x, f = y.z + z.y, big = squares[largest];
  switch (largest) {
    case 0:
      return normalised({big, d, e, a});
    case 1:
      return normalised({d, big, f, b});
    case 2:
      return normalised({e, f, big, c});
    default:
      return normalised({a, b, c, big});
  }
}

/// Between a (t = 0) and b (t = 1), the shorter way round. Not at even speed: between rotations a
/// right angle apart it is off by a degree at most.
inline Quaternion mixed(const Quaternion& a, const Quaternion& b, double t) {
  return normalised(a * (1 - t) + b * (dot(a, b) < 0 ? -t : t));
}

/// A rotation about the origin, and then a move.
struct Rigid {
  Quaternion rotation;
  Vec3 move;

  Vec3 operator()(Vec3 p) const { return rotated(rotation, p) + move; }
  Vec3 direction(Vec3 v) const { return rotated(rotation, v); }
};
/// First b, then a.
inline Rigid operator*(const Rigid& a, const Rigid& b) {
  return {normalised(a.rotation * b.rotation), a(b.move)};
}
inline Rigid inverse(const Rigid& r) {
  const Quaternion back = conjugate(r.rotation);
  return {back, -rotated(back, r.move)};
}
/// The rotation about a point, and then a move.
inline Rigid rotationAbout(Vec3 point, const Quaternion& rotation, Vec3 move = {}) {
  return {rotation, point - rotated(rotation, point) + move};
}

}  // namespace marrow
