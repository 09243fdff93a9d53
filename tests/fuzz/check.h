// What a fuzz target does with what must not be.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace marrow {

inline void check(bool holds, const std::string& claim) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", claim.c_str());
  std::abort();
}

}  // namespace marrow
