// Planes in space, and what maps one place to another.
#pragma once

#include "base/vec.h"

namespace marrow {

/// The points p with dot(normal, p) + offset = 0. The normal is a unit vector.
struct Plane {
  Vec3 normal{1, 0, 0};
  double offset = 0;
};
inline bool operator==(const Plane& a, const Plane& b) {
  return a.normal == b.normal && a.offset == b.offset;
}

/// Signed: positive on the side that the normal points to.
inline double distance(const Plane& plane, Vec3 p) { return dot(plane.normal, p) + plane.offset; }
inline Vec3 mirrored(Vec3 p, const Plane& plane) {
  return p - plane.normal * (2 * distance(plane, p));
}
inline Vec3 mirroredDirection(Vec3 v, const Plane& plane) {
  return v - plane.normal * (2 * dot(plane.normal, v));
}

/// Where a part's plane lies in space: a rotation, a uniform scale and a place. x and y are
/// orthogonal and equally long; their length is the scale.
struct Frame {
  Vec3 origin;
  Vec3 x{1, 0, 0}, y{0, 1, 0};

  double scale() const { return length(x); }
  /// x × y, as long as x.
  Vec3 z() const { return cross(x, y) / length(x); }
  Vec3 toWorld(Vec2 p) const { return origin + x * p.x + y * p.y; }
  Vec3 toWorld(Vec3 p) const { return origin + x * p.x + y * p.y + z() * p.z; }
  Vec3 toLocal(Vec3 world) const {
    const Vec3 d = world - origin;
    return Vec3{dot(x, d), dot(y, d), dot(z(), d)} / dot(x, x);
  }
};
inline bool operator==(const Frame& a, const Frame& b) {
  return a.origin == b.origin && a.x == b.x && a.y == b.y;
}
inline bool operator!=(const Frame& a, const Frame& b) { return !(a == b); }

/// The frame seen in the mirror. Parts are the same in front and behind, so a part in this frame is
/// the mirror image of the part in the given one.
inline Frame mirrored(const Frame& frame, const Plane& plane) {
  return {mirrored(frame.origin, plane), mirroredDirection(frame.x, plane),
          mirroredDirection(frame.y, plane)};
}

/// A linear map, given by what it does to the three axes, and then a move.
struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Vec3 move;

  Vec3 direction(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3 operator()(Vec3 p) const { return direction(p) + move; }
};

}  // namespace marrow
