// What tests ask of a text.
#pragma once

#include <cstddef>
#include <string>

namespace marrow {

/// How often a piece, not empty, occurs.
inline size_t count(const std::string& text, const std::string& piece) {
  size_t found = 0;
  for (size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) {
    ++found;
  }
  return found;
}

}  // namespace marrow
