// What the desktop app is started with.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace marrow {

struct DesktopOptions {
  int width = 1280, height = 800;
  std::vector<std::string> strokes;  // files to be drawn, one after another, as if by hand
  std::string screenshot, dump;      // files to write before it ends by itself
  bool help = false;

  bool endsByItself() const { return !screenshot.empty() || !dump.empty(); }
};

extern const char* const kDesktopUsage;

/// Errors: unreadable, with what is wrong.
Result<DesktopOptions> readOptions(int count, char** arguments);

}  // namespace marrow
