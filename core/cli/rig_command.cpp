// marrow rig: a document's file in, the character with its skeleton as JSON, OBJ and SVG out.
#include <array>
#include <cstdio>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "document/evaluation.h"
#include "io/export_text.h"
#include "io/glb.h"
#include "io/rig_export.h"

namespace marrow {
namespace {

constexpr Range kThreshold = {0, Refinement::kLargest};
const Options kOptions = {"document",
                          {"--json", "--obj", "--svg", "--glb", "--gltf"},
                          {{"--eps-s", kThreshold},
                           {"--eps-m", kThreshold},
                           {"--eps-t", kThreshold},
                           {"--eps-c", kThreshold},
                           {"--blend", kBlend},
                           {"--scale", {GlbOptions::kLeastScale, GlbOptions::kLargestScale}}},
                          {},
                          {"--merge", "--parts", "--no-weights"}};
constexpr struct {
  const char* option;
  std::optional<double> Refinement::*threshold;
} kThresholds[] = {{"--eps-s", &Refinement::simplify},
                   {"--eps-m", &Refinement::merge},
                   {"--eps-t", &Refinement::prune},
                   {"--eps-c", &Refinement::collapse}};

/// A file's name without its ending.
std::string stem(const std::string& name) { return name.substr(0, name.find_last_of('.')); }

/// "Leg (part-3)"
std::string partName(const Evaluation& character, uint32_t part) {
  const PlacedPart& placed = character.placed()[part];
  return printable(character.parts()[placed.source].source->name + " (" + placed.id + ")");
}

double stageTime(const Timings& timings, const std::string& name) {
  for (const auto& [stage, ms] : timings.stages_ms) {
    if (name == stage) return ms;
  }
  return 0;
}

int printSummary(const std::string& path, const Evaluation& character) {
  const Rig& rig = character.rig();
  const size_t parts = character.parts().size(), twins = character.placed().size() - parts;
  std::array<size_t, 3> kinds{};
  for (const Rig::Joint& joint : rig.joints) ++kinds[static_cast<size_t>(joint.kind)];

  std::printf("%s: %zu parts, %zu twins\n", printable(fileName(path)).c_str(), parts, twins);
  std::printf("  joints: %zu (%zu terminal, %zu sleeve, %zu junction), %zu bones\n",
              rig.joints.size(), kinds[0], kinds[1], kinds[2], rig.bones.size());
  for (const uint32_t root : rig.roots) {
    const Rig::Joint& joint = rig.joints[root];
    std::printf("  root: %s of %s\n", printable(joint.name).c_str(),
                partName(character, joint.part).c_str());
  }
  for (const Connection& connection : rig.connections) {
    std::printf("  %s hangs on %s (%s, by %s)\n", partName(character, connection.child).c_str(),
                partName(character, connection.parent).c_str(), toString(connection.event),
                toString(connection.test));
  }
  for (const auto& [part, joint] : rig.carried) {
    std::printf("  %s has no bones and %s%s\n", partName(character, part).c_str(),
                joint < 0 ? "hangs on nothing" : "moves with ",
                joint < 0 ? "" : printable(rig.joints[static_cast<size_t>(joint)].name).c_str());
  }
  for (const uint32_t part : unattachedParts(character)) {
    std::printf("  unattached: %s\n", partName(character, part).c_str());
  }
  for (const EvaluatedPart& part : character.parts()) {
    if (part.part) continue;
    std::printf("  left out: %s: %s\n", printable(part.source->id).c_str(),
                printable(part.error.message()).c_str());
  }
  const Timings& timings = character.timings();
  double skeletons_ms = 0;
  for (const char* stage : {"outline", "straightSkeleton", "axis", "joints"}) {
    skeletons_ms += stageTime(timings, stage);
  }
  std::printf("  time: skeletons %.2f ms, connection %.2f ms, refinement %.2f ms, all %.2f ms\n",
              skeletons_ms, stageTime(timings, "connection"), stageTime(timings, "refinement"),
              timings.total_ms);
  return std::fflush(stdout) == 0 ? kFine : kRefused;
}

}  // namespace

int runRig(const std::vector<std::string>& words) {
  const auto arguments = parseArguments(words, kOptions);
  if (!arguments) return refuse(arguments.message());
  const std::string& path = arguments->path;

  auto document = openDocument(path);
  if (!document) return refuse(document.message());
  for (const auto& [option, threshold] : kThresholds) {
    if (const auto value = arguments->findNumber(option)) document->refine.*threshold = value;
  }
  Evaluation character({}, milliseconds);
  character.update(*document);
  if (!isFinite(character)) return refuse(path + ": " + toSentence(Status::meshFailed));

  const bool merge = arguments->has("--merge"), parts = arguments->has("--parts");
  if (merge && parts) return refuse("--merge or --parts, not both (marrow --help tells more)");
  const auto *glb = arguments->findPath("--glb"), *gltf = arguments->findPath("--gltf");
  std::vector<OutputFile> files;
  const auto* json = arguments->findPath("--json");
  Json tree = json ? rigToTree(character) : Json();
  std::vector<std::string> warnings;
  if (glb || gltf || merge || parts) {
    CharacterOptions options = characterOptions(*document, character.rig());
    options.merged = !parts;
    options.weights = !arguments->has("--no-weights");
    options.blend = arguments->findNumber("--blend").value_or(options.blend);
    const Character made = makeCharacter(character, options, milliseconds);
    const auto left_out = leftOutOf(made);
    if (made.meshes.empty() && !left_out.empty()) return refuse(path + ": " + left_out.front());
    for (const std::string& sentence : left_out) warnings.push_back(path + ": " + sentence);
    if (!made.no_weights.empty()) {
      warnings.push_back(path + ": the meshes follow no bone: " + made.no_weights);
    }
    if (glb || gltf) {
      const GlbCharacter model = glbOf(made, character.rig(), *document, stem(fileName(path)));
      GlbOptions how;
      how.metres_per_unit = arguments->findNumber("--scale").value_or(how.metres_per_unit);
      const auto add = [&](const std::string* out, const auto& write) {
        if (!out) return true;
        const Result<std::string> bytes = write(model, how);
        if (bytes) files.push_back({*out, *bytes});
        return static_cast<bool>(bytes);
      };
      if (!add(glb, toGlb) || !add(gltf, toGltf)) {
        return refuse(path + ": it is too large for a glTF file");
      }
    }
    if (json) addCharacter(tree, made);
  }
  if (json) files.push_back({*json, toLines(tree)});
  if (const auto* out = arguments->findPath("--obj")) files.push_back({*out, rigToObj(character)});
  if (const auto* out = arguments->findPath("--svg")) {
    files.push_back({*out, rigToSvg(fileName(path), character)});
  }
  if (auto error = writeAll(files)) return refuse(error->message());
  for (const std::string& warning : warnings) warn(warning);
  return files.empty() ? printSummary(path, character) : kFine;
}

}  // namespace marrow
