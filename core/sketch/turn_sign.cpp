#include "sketch/turn_sign.h"

#include <cstddef>

namespace marrow {
namespace {

/// A sum of doubles, exact: growing magnitude, no two of them overlap in their bits.
class Expansion {
 public:
  void add(double value) {
    double carry = value;
    size_t kept = 0;
    for (size_t i = 0; i < size_; ++i) {
      const double sum = carry + terms_[i];
      const double shadow = sum - carry;
      const double rest = (carry - (sum - shadow)) + (terms_[i] - shadow);
      if (rest != 0) terms_[kept++] = rest;
      carry = sum;
    }
    if (carry != 0) terms_[kept++] = carry;
    size_ = kept;
  }

  void addProduct(double a, double b) {
    const double product = a * b;
    const Halves ha = split(a), hb = split(b);
    const double rest =
        ha.low * hb.low - (((product - ha.high * hb.high) - ha.low * hb.high) - ha.high * hb.low);
    add(rest);
    add(product);
  }

  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0 ? 1 : -1); }

 private:
  struct Halves {
    double high, low;
  };

  static Halves split(double value) {
    constexpr double kSplitter = 134217729;  // 2²⁷ + 1
    const double scaled = kSplitter * value;
    const double high = scaled - (scaled - value);
    return {high, value - high};
  }

  double terms_[16] = {};
  size_t size_ = 0;
};

}  // namespace

int turnSignExactly(Vec2 a, Vec2 b, Vec2 c) {
  Expansion det;
  det.addProduct(a.x, b.y);
  det.addProduct(-a.x, c.y);
  det.addProduct(b.x, c.y);
  det.addProduct(-b.x, a.y);
  det.addProduct(c.x, a.y);
  det.addProduct(-c.x, b.y);
  return det.sign();
}

}  // namespace marrow
