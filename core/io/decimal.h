// Decimal numbers → doubles.
#pragma once

#include <optional>
#include <string_view>

namespace marrow {

/// The double nearest to a number as JSON writes it, or nothing where that is not found by a short
/// way: for more than 19 digits, exponents beyond ±22, and what lies all but exactly between two
/// doubles. text: a valid JSON number.
std::optional<double> quickDouble(std::string_view text);

}  // namespace marrow
