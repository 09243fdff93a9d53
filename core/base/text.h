// Text that can be shown and saved.
#pragma once

#include <string>
#include <string_view>

namespace marrow {

/// Bytes of the character that `text` begins with, 1 to 4; 0 where that is not UTF-8. Shortest
/// forms alone, no surrogates [RFC 3629 §4].
size_t characterLength(std::string_view text);

/// Each byte that is not UTF-8 replaced by U+FFFD.
std::string toUtf8(const std::string& text);

/// Control characters replaced by spaces.
std::string onOneLine(std::string text);

}  // namespace marrow
