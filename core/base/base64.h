// Base64, as in data URLs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace marrow {

std::string toBase64(const std::vector<uint8_t>& bytes);
/// Nothing where the text is something else.
std::optional<std::vector<uint8_t>> fromBase64(const std::string& text);

}  // namespace marrow
