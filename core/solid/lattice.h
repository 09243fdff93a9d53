// Exact questions about points whose coordinates are whole numbers of at most 37 bits. Each is
// answered in floating point where that is sure, and by wide integers otherwise.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace marrow {

__extension__ typedef __int128 Int128;

constexpr double kLatticeReach = 0x1p36;  // coordinates lie between −this and this

/// A value that is known up to an error.
struct Measured {
  double value = 0, error = 0;

  bool isSure() const { return value > error || value < -error; }
};

/// The plane of a triangle of lattice points, turned so that the triangle is counter-clockwise.
class Facet {
 public:
  Facet() = default;
  Facet(Vec3 a, Vec3 b, Vec3 c);

  Vec3 normal() const { return normal_; }
  /// Six times the volume of the tetrahedron from the triangle to p; positive in front.
  Measured height(Vec3 p) const {
    const Vec3 d = p - a_;
    return {normal_.x * d.x + normal_.y * d.y + normal_.z * d.z,
            bound_.x * std::fabs(d.x) + bound_.y * std::fabs(d.y) + bound_.z * std::fabs(d.z)};
  }
  Int128 exactHeight(Vec3 p) const;
  /// Sign of the height: −1, 0, 1.
  int side(Vec3 p) const {
    const Measured h = height(p);
    return h.isSure() ? (h.value > 0 ? 1 : -1) : exactSide(p);
  }

 private:
  int exactSide(Vec3 p) const;

  Vec3 a_, ab_, ac_, normal_, bound_;
};

/// Sign of det(b − a, c − a, d − a).
int orientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// Sign of twice the area of the triangle, seen from +z.
int turn(Vec3 a, Vec3 b, Vec3 c);

/// Which of two facets that both lie between `from` and `to` is met first on the way: −1 for the
/// first, 1 for the second, 0 for both at once.
int firstMet(Vec3 from, Vec3 to, const Facet& first, const Facet& second);

/// On which side of `facet` the point is where the line from a to b meets `pierced`; a and b lie on
/// different sides of that.
int sideOfPiercing(Vec3 a, Vec3 b, const Facet& pierced, const Facet& facet);

}  // namespace marrow
