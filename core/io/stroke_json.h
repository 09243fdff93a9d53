// A single stroke's file: {"name", "closed", "points": [[x, y], …]}, y up.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace marrow {

struct StrokeFile {
  std::string name;
  std::vector<Vec2> points;
};

/// "points" is needed; whether "closed" or not, a stroke is closed. Other fields are not looked at.
/// Errors, each with a sentence that says what and where: unreadable.
Result<StrokeFile> readStroke(const std::string& text);

}  // namespace marrow
