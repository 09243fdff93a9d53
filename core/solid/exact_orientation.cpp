#include "solid/exact_orientation.h"

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace marrow {
namespace {

// Of the determinant in floating point, the rounded differences included [Shewchuk 1997, §4.3].
constexpr double kRounding = 8.5 * 0x1p-53;

/// a · b = product + rest, exactly [Dekker 1971].
double productRest(double a, double b, double product) {
  constexpr double kSplitter = 134217729;  // 2²⁷ + 1
  const double sa = kSplitter * a, sb = kSplitter * b;
  const double ah = sa - (sa - a), bh = sb - (sb - b), al = a - ah, bl = b - bh;
  return al * bl - (((product - ah * bh) - al * bh) - ah * bl);
}

/// A sum of doubles, exact: growing magnitude, no two of them overlap in their bits.
class Sum {
 public:
  void add(double value) {
    size_t kept = 0;
    for (size_t i = 0; i < size_; ++i) {
      const double sum = value + terms_[i], shadow = sum - value;
      const double rest = (value - (sum - shadow)) + (terms_[i] - shadow);
      if (rest != 0) terms_[kept++] = rest;
      value = sum;
    }
    if (value != 0) terms_[kept++] = value;
    size_ = kept;
  }

  void addProduct(double a, double b, double c) {
    const double high = a * b, low = productRest(a, b, high);
    for (const double part : {low, high}) {
      const double product = part * c;
      add(productRest(part, c, product));
      add(product);
    }
  }

  void addDeterminant(Vec3 a, Vec3 b, Vec3 c) {
    addProduct(a.x, b.y, c.z);
    addProduct(-a.x, b.z, c.y);
    addProduct(a.y, b.z, c.x);
    addProduct(-a.y, b.x, c.z);
    addProduct(a.z, b.x, c.y);
    addProduct(-a.z, b.y, c.x);
  }

  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0 ? 1 : -1); }

 private:
  double terms_[128] = {};
  size_t size_ = 0;
};

}  // namespace

int exactOrientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double value = dot(cross(u, v), w);
  const double error = ((std::fabs(u.y * v.z) + std::fabs(u.z * v.y)) * std::fabs(w.x) +
                        (std::fabs(u.z * v.x) + std::fabs(u.x * v.z)) * std::fabs(w.y) +
                        (std::fabs(u.x * v.y) + std::fabs(u.y * v.x)) * std::fabs(w.z)) *
                       kRounding;
  if (value > error) return 1;
  if (value < -error) return -1;
  Sum sum;
  sum.addDeterminant(b, c, d);
  sum.addDeterminant(a, d, c);
  sum.addDeterminant(a, b, d);
  sum.addDeterminant(a, c, b);
  return sum.sign();
}

}  // namespace marrow
