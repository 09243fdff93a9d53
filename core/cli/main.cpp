// The command line: a stroke's file in, the part as JSON, OBJ and SVG out.
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "cli/files.h"
#include "io/part_export.h"
#include "io/stroke_json.h"
#include "part/part.h"

namespace marrow {
namespace {

constexpr int kFine = 0;
constexpr int kRefused = 2;
constexpr size_t kLargestFile = 64u << 20;  // bytes

constexpr char kUsage[] =
    "Usage: marrow part STROKE.json [options]\n"
    "Makes an inflated part with a skeleton of a closed stroke,\n"
    "{\"name\", \"closed\", \"points\": [[x, y], …]}, y up.\n"
    "\n"
    "  --eps-s X       how far bones may leave the axis, 0.001 … 1000 (default 5)\n"
    "  --thickness X   scales the depth, 0.001 … 1000 (default 1)\n"
    "  --json OUT      everything about the part: outline, skeletons, joints, mesh, timings\n"
    "  --obj OUT       the mesh, and the bones as lines\n"
    "  --svg OUT       a picture of outline, skeletons, joints and radii\n"
    "  --help          this text\n"
    "\n"
    "Without an output a summary is printed. Exit code 0, or 2 when something is wrong.\n";

/// One line on stderr, whatever control characters a file's name holds.
int refuse(const std::string& fault) {
  std::string line = "marrow: " + fault;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  line += '\n';
  std::fputs(line.c_str(), stderr);
  return kRefused;
}

struct Arguments {
  std::string stroke_path;
  PartOptions options;
  std::optional<std::string> json_path, obj_path, svg_path;
};

/// A plain decimal number from 0.001 to 1000.
std::optional<double> parseNumber(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789.eE+-") != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !(value >= 0.001 && value <= 1000)) return std::nullopt;
  return value;
}

/// `words`: what follows "marrow part".
Result<Arguments> parseArguments(const std::vector<std::string>& words) {
  Arguments arguments;
  bool only_paths = false, has_stroke = false;
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (only_paths || word.compare(0, 2, "--") != 0) {
      if (has_stroke) return {Status::unreadable, "one stroke at a time: " + word};
      arguments.stroke_path = word;
      has_stroke = true;
      continue;
    }
    if (word == "--") {
      only_paths = true;
      continue;
    }
    const size_t equals = word.find('=');
    const std::string option = word.substr(0, equals);
    std::string value;
    if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (i + 1 < words.size() && words[i + 1].compare(0, 2, "--") != 0) {
      value = words[++i];
    }
    const bool is_number = option == "--eps-s" || option == "--thickness";
    const bool is_path = option == "--json" || option == "--obj" || option == "--svg";
    if (!is_number && !is_path) return {Status::unreadable, "unknown option " + option};
    if (is_path) {
      if (value.empty()) return {Status::unreadable, option + " needs a file name"};
      (option == "--json"  ? arguments.json_path
       : option == "--obj" ? arguments.obj_path
                           : arguments.svg_path) = value;
      continue;
    }
    const auto number = parseNumber(value);
    if (!number) return {Status::unreadable, option + " needs a number from 0.001 to 1000"};
    (option == "--eps-s" ? arguments.options.joints.epsilon_s
                         : arguments.options.inflate.thickness) = *number;
  }
  if (!has_stroke) return {Status::unreadable, "no stroke given"};
  return arguments;
}

double milliseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

bool isFinite(const Part& part) {
  for (Vec3 p : part.mesh.positions) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  }
  for (const auto& joint : part.skeleton.joints) {
    if (!std::isfinite(joint.position.x) || !std::isfinite(joint.position.y) ||
        !std::isfinite(joint.radius)) {
      return false;
    }
  }
  return std::isfinite(inspect(part.mesh).volume);
}

int printSummary(const StrokeFile& stroke, const Part& part) {
  const MeshReport report = inspect(part.mesh);
  std::printf("%s: %zu points, outline of %zu, polygon of %zu\n", stroke.name.c_str(),
              stroke.points.size(), part.outline.dense.size(), part.outline.polygon.size());
  std::printf("  straight skeleton: %zu nodes by %s\n", part.straight_skeleton.nodes.size(),
              toString(part.straight_skeleton.method));
  std::printf("  skeleton: %zu joints, %zu bones\n", part.skeleton.joints.size(),
              part.skeleton.bones.size());
  std::printf("  mesh: %zu vertices, %zu triangles, %s\n", part.mesh.positions.size(),
              part.mesh.triangles.size(),
              report.closed && report.manifold ? "closed" : "not closed");
  std::printf("  time: %.2f ms\n", part.timings.total_ms);
  return std::fflush(stdout) == 0 ? kFine : kRefused;
}

const std::string* pathOf(const std::optional<std::string>& path) {
  return path ? &*path : nullptr;
}

int runPart(const std::vector<std::string>& words) {
  auto arguments = parseArguments(words);
  if (!arguments) return refuse(arguments.message() + " (marrow --help tells more)");
  const std::string& path = arguments->stroke_path;

  const std::string* paths[] = {&path, pathOf(arguments->json_path), pathOf(arguments->obj_path),
                                pathOf(arguments->svg_path)};
  for (size_t i = 0; i < std::size(paths); ++i) {
    for (size_t k = i + 1; k < std::size(paths); ++k) {
      if (paths[i] && paths[k] && sameFile(*paths[i], *paths[k])) {
        return refuse(*paths[k] + ": one file cannot be two of stroke and outputs");
      }
    }
  }

  auto text = readAll(path, kLargestFile);
  if (!text) return refuse(path + ": " + text.message());
  auto stroke = readStroke(*text);
  if (!stroke) return refuse(path + ": " + stroke.message());
  auto part = buildPart(stroke->points, arguments->options, milliseconds);
  if (!part) return refuse(path + ": " + part.message());
  if (!isFinite(*part)) return refuse(path + ": " + toSentence(Status::meshFailed));

  std::vector<OutputFile> files;
  if (arguments->json_path) {
    files.push_back({*arguments->json_path, partToJson(stroke->name, *part)});
  }
  if (arguments->obj_path) files.push_back({*arguments->obj_path, partToObj(stroke->name, *part)});
  if (arguments->svg_path) files.push_back({*arguments->svg_path, partToSvg(stroke->name, *part)});
  if (files.empty()) return printSummary(*stroke, *part);
  if (auto error = writeAll(files)) return refuse(error->message());
  return kFine;
}

int run(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word == "--help" || word == "-h") {
      std::fputs(kUsage, stdout);
      return std::fflush(stdout) == 0 ? kFine : kRefused;
    }
  }
  if (words.empty()) {
    std::fputs(kUsage, stderr);
    return kRefused;
  }
  if (words[0] != "part") {
    return refuse("unknown command " + words[0] + " (marrow --help tells more)");
  }
  return runPart({words.begin() + 1, words.end()});
}

}  // namespace
}  // namespace marrow

int main(int count, char** words) {
  std::set_new_handler([] {
    std::fputs("marrow: not enough memory\n", stderr);
    std::_Exit(marrow::kRefused);
  });
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
  return marrow::run({words + (count > 0 ? 1 : 0), words + count});
}
