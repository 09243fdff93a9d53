#include "io/decimal.h"

#include <cmath>
#include <cstdint>

namespace marrow {
namespace {

constexpr int kMostDigits = 19;  // 10^19 < 2^64
constexpr int kMostExponent = 22;
constexpr double kPowers[kMostExponent + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
// Of the second part of a sum: far more than what rounding made of it.
constexpr double kDoubt = 0x1p-48;

/// product + rest is a × b to the last bit.
struct Product {
  double product, rest;
};
Product multiply(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double a_big = kSplit * a, b_big = kSplit * b;
  const double a_high = a_big - (a_big - a), b_high = b_big - (b_big - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// sum + rest, whose rest is known but for doubt; nothing where that leaves two doubles.
std::optional<double> rounded(double sum, double rest, double doubt) {
  const double low = sum + (rest - doubt), high = sum + (rest + doubt);
  if (low != high) return std::nullopt;
  return low;
}

}  // namespace

std::optional<double> quickDouble(std::string_view text) {
  size_t at = 0;
  const bool negative = !text.empty() && text[0] == '-';
  if (negative) ++at;
  uint64_t digits = 0;
  int count = 0, exponent = 0;
  bool fraction = false;
  for (; at < text.size() && text[at] != 'e' && text[at] != 'E'; ++at) {
    if (text[at] == '.') {
      fraction = true;
      continue;
    }
    if ((digits > 0 || text[at] != '0') && ++count > kMostDigits) return std::nullopt;
    digits = 10 * digits + static_cast<uint64_t>(text[at] - '0');
    if (fraction && --exponent < -10 * kMostExponent) return std::nullopt;
  }
  if (at < text.size()) {
    ++at;
    const bool minus = text[at] == '-';
    if (minus || text[at] == '+') ++at;
    int written = 0;
    for (; at < text.size(); ++at) {
      written = 10 * written + (text[at] - '0');
      if (written > 10 * kMostExponent) return std::nullopt;
    }
    exponent += minus ? -written : written;
  }
  if (digits == 0) return negative ? -0.0 : 0.0;
  if (exponent < -kMostExponent || exponent > kMostExponent) return std::nullopt;

  const auto whole = static_cast<double>(digits);
  const auto rest =
      static_cast<double>(static_cast<int64_t>(digits - static_cast<uint64_t>(whole)));
  std::optional<double> value;
  if (exponent >= 0) {
    const double power = kPowers[exponent];
    const Product main = multiply(whole, power);
    const double small = rest * power;
    value = rounded(main.product, main.rest + small,
                    (std::fabs(main.rest) + std::fabs(small)) * kDoubt);
  } else {
    const double power = kPowers[-exponent];
    const double quotient = whole / power;
    const Product back = multiply(quotient, power);
    const double left = (whole - back.product) - back.rest;
    value = rounded(quotient, (left + rest) / power,
                    (std::fabs(left) + std::fabs(rest)) / power * kDoubt);
  }
  if (value && negative) value = -*value;
  return value;
}

}  // namespace marrow
