// What the desktop app is started with.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace marrow {

struct DesktopOptions {
  int width = 1280, height = 800;
  std::vector<std::string> strokes;    // files to be drawn, one after another, as if by hand
  std::string document;                // file to open
  std::string screenshot, dump, save;  // files to write before it ends by itself
  bool restore = false;                // go on with the drawing that was kept last
  bool help = false;

  bool endsByItself() const { return !screenshot.empty() || !dump.empty() || !save.empty(); }
};

extern const char* const kDesktopUsage;

/// Errors: unreadable, with what is wrong.
Result<DesktopOptions> readOptions(int count, char** arguments);

}  // namespace marrow
