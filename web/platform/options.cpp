#include "platform/options.h"

#include <cstdio>

namespace marrow {

const char* const kDesktopUsage =
    "marrow-app [DOCUMENT.json] [--restore] [--size WIDTHxHEIGHT] [--play STROKE.json]…\n"
    "           [--screenshot OUT.png] [--dump OUT.json] [--save OUT.json]\n"
    "  DOCUMENT.json  a drawing to open, a 3D model to import, or a picture to draw after\n"
    "  --restore      goes on with the drawing that was kept last\n"
    "  --play         draws a stroke as a pointer would\n"
    "  --screenshot   writes what is shown, then ends\n"
    "  --dump         writes the parts as JSON, then ends\n"
    "  --save         writes the drawing, then ends\n";

Result<DesktopOptions> readOptions(int count, char** arguments) {
  DesktopOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string name = arguments[i];
    if (name == "--help") {
      options.help = true;
      return options;
    }
    if (name == "--restore") {
      options.restore = true;
      continue;
    }
    if (name.rfind("-", 0) != 0 && options.document.empty()) {
      options.document = name;
      continue;
    }
    const bool known = name == "--size" || name == "--play" || name == "--screenshot" ||
                       name == "--dump" || name == "--save";
    if (!known) return {Status::unreadable, "There is no option " + name + "."};
    if (i + 1 == count) return {Status::unreadable, name + " needs a value."};
    const std::string value = arguments[++i];
    if (name == "--play") options.strokes.push_back(value);
    if (name == "--screenshot") options.screenshot = value;
    if (name == "--dump") options.dump = value;
    if (name == "--save") options.save = value;
    if (name == "--size") {
      const bool ok = std::sscanf(value.c_str(), "%dx%d", &options.width, &options.height) == 2 &&
                      options.width >= 100 && options.height >= 100 && options.width <= 16384 &&
                      options.height <= 16384;
      if (!ok) return {Status::unreadable, "--size wants WIDTHxHEIGHT, such as 1280x800."};
    }
  }
  return options;
}

}  // namespace marrow
