// marrow part: a stroke's file in, the part as JSON, OBJ and SVG out.
#include <cmath>
#include <cstdio>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "io/part_export.h"
#include "io/stroke_json.h"
#include "part/part.h"

namespace marrow {
namespace {

const Options kOptions = {"stroke",
                          {"--json", "--obj", "--svg"},
                          {{"--eps-s", {0.001, 1000}}, {"--thickness", {0.001, 1000}}}};

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

}  // namespace

int runPart(const std::vector<std::string>& words) {
  const auto arguments = parseArguments(words, kOptions);
  if (!arguments) return refuse(arguments.message());
  const std::string& path = arguments->path;
  PartOptions options;
  options.joints.epsilon_s = arguments->findNumber("--eps-s").value_or(options.joints.epsilon_s);
  options.inflate.thickness =
      arguments->findNumber("--thickness").value_or(options.inflate.thickness);

  const auto text = readAll(path, kLargestFile);
  if (!text) return refuse(path + ": " + text.message());
  const auto stroke = readStroke(*text);
  if (!stroke) return refuse(path + ": " + stroke.message());
  const auto part = buildPart(stroke->points, options, milliseconds);
  if (!part) return refuse(path + ": " + part.message());
  if (!isFinite(*part)) return refuse(path + ": " + toSentence(Status::meshFailed));

  std::vector<OutputFile> files;
  if (const auto* out = arguments->findPath("--json")) {
    files.push_back({*out, partToJson(stroke->name, *part)});
  }
  if (const auto* out = arguments->findPath("--obj")) {
    files.push_back({*out, partToObj(stroke->name, *part)});
  }
  if (const auto* out = arguments->findPath("--svg")) {
    files.push_back({*out, partToSvg(stroke->name, *part)});
  }
  if (files.empty()) return printSummary(*stroke, *part);
  if (auto error = writeAll(files)) return refuse(error->message());
  return kFine;
}

}  // namespace marrow
