// marrow pose: a document's file in, its body in one of its poses out.
#include <cstdio>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "io/mesh_export.h"
#include "pose/pose.h"

namespace marrow {
namespace {

const Options kOptions = {
    "document", {"--obj", "--stl", "--ply"}, {{"--blend", kBlend}}, {"--pose"}, {"--dual"}};

int printPoses(const std::string& path, const Document& document) {
  std::printf("%s: poses: %zu\n", printable(fileName(path)).c_str(), document.poses.size());
  for (const auto& pose : document.poses) std::printf("  %s\n", printable(pose->name).c_str());
  return std::fflush(stdout) == 0 ? kFine : kRefused;
}

}  // namespace

int runPose(const std::vector<std::string>& words) {
  const auto arguments = parseArguments(words, kOptions);
  if (!arguments) return refuse(arguments.message());
  const std::string& path = arguments->path;
  const auto document = openDocument(path);
  if (!document) return refuse(document.message());
  const NamedPose* pose = nullptr;
  if (const auto name = arguments->texts.find("--pose"); name != arguments->texts.end()) {
    pose = document->findPose(name->second);
    if (!pose) return refuse(path + ": there is no pose \"" + name->second + "\"");
  }
  if (arguments->paths.empty()) return printPoses(path, *document);

  Evaluation evaluation({}, milliseconds);
  evaluation.update(*document);
  if (!isFinite(evaluation)) return refuse(path + ": " + toSentence(Status::meshFailed));
  CharacterOptions options = characterOptions(*document, evaluation.rig());
  options.weights = pose != nullptr;
  options.blend = arguments->findNumber("--blend").value_or(options.blend);
  const Character made = makeCharacter(evaluation, options, milliseconds);
  if (!made.no_weights.empty()) {
    return refuse(path + ": the body follows no bone: " + made.no_weights);
  }
  const auto left_out = leftOutOf(made);
  if (made.meshes.empty() && !left_out.empty()) return refuse(path + ": " + left_out.front());
  SkinnedMesh body;
  if (!made.meshes.empty()) {
    const Skinning how = arguments->has("--dual") ? Skinning::dualQuaternions : Skinning::linear;
    body = posedMesh(made.meshes[0], evaluation.rig(), pose ? pose->joints : Pose{}, how);
  }

  std::vector<OutputFile> files;
  if (const auto* out = arguments->findPath("--obj")) {
    files.push_back({*out, toObj(body, made.paints)});
  }
  const auto add = [&](const char* option, const auto& write) {
    const auto* out = arguments->findPath(option);
    if (!out) return true;
    const Result<std::string> bytes = write();
    if (bytes) files.push_back({*out, *bytes});
    return static_cast<bool>(bytes);
  };
  if (!add("--stl", [&] { return toStl(body); }) ||
      !add("--ply", [&] { return toPly(body, made.paints); })) {
    return refuse(path + ": it is too large for such a file");
  }
  if (auto error = writeAll(files)) return refuse(error->message());
  for (const std::string& sentence : left_out) warn(path + ": " + sentence);
  return kFine;
}

}  // namespace marrow
