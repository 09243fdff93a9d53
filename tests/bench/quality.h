// How good rigs are, as an animator would judge them: figures that later work must not worsen.
// No times, so any machine gives the same.
#pragma once

#include <string>
#include <vector>

namespace marrow::bench {

/// One row of the table of rig quality.
struct QualityRow {
  std::string what;
  double value = 0;   // in `unit`
  double wanted = 0;  // at most, or at least where `at_least`
  bool at_least = false;
  std::string unit;  // "%", "", …
  std::string note;  // of how many; the worst
};

/// Writes a JSON object a line.
void printQuality(const std::vector<QualityRow>& rows);

/// Measures and writes all rows; with paths of strokes, only those that need nothing but strokes,
/// and what is worst to the standard error.
void quality(const std::vector<std::string>& paths);

/// The rows of skin weights alone, and what is bad to the standard error.
void weights();

}  // namespace marrow::bench
