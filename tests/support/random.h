// Random numbers for tests: the same on every platform and standard library.
#pragma once

#include <cstdint>
#include <random>

namespace marrow {

class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// One of 0 … count − 1.
  int below(int count) { return static_cast<int>(unit() * count); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace marrow
