#include "figure/workshop.h"

#include <array>
#include <utility>

#include "document/symmetry.h"
#include "figure/figure.h"
#include "io/document_json.h"
#include "io/glb.h"
#include "io/json.h"
#include "io/mesh_export.h"
#include "render/scene.h"

namespace marrow {
namespace {

using Format = FileOptions::Format;
constexpr std::array<Format, 5> kFormats{Format::glb, Format::gltf, Format::obj, Format::stl,
                                         Format::ply};

uint64_t mixed(uint64_t seed, const std::string& text) {
  return fingerprint(text.data(), text.size(), seed);
}
template <typename T>
uint64_t mixedNumbers(uint64_t seed, const T& numbers) {
  return fingerprint(&numbers, sizeof numbers, seed);
}

Json toJson(const FileOptions& options) {
  return {{"format", toString(options.format)},
          {"name", options.name},
          {"scale", options.metres_per_unit},
          {"parts", options.parts},
          {"weights", options.weights},
          {"pose", options.pose},
          {"dual", options.skinning == Skinning::dualQuaternions}};
}

FileOptions optionsIn(const Json& json) {
  FileOptions options;
  const std::string format = json.value("format", "");
  for (const Format one : kFormats) {
    if (format == toString(one)) options.format = one;
  }
  options.name = json.value("name", "");
  options.metres_per_unit = json.value("scale", options.metres_per_unit);
  options.parts = json.value("parts", false);
  options.weights = json.value("weights", true);
  options.pose = json.value("pose", "");
  if (json.value("dual", false)) options.skinning = Skinning::dualQuaternions;
  return options;
}

const Error kStopped{Status::meshFailed, "It was given up."};

}  // namespace

uint64_t partsKey(const Evaluation& evaluation) {
  uint64_t key = 0;
  for (const PlacedPart& placed : evaluation.placed()) {
    const EvaluatedPart& part = evaluation.parts()[placed.source];
    if (!part.part || !part.source->visible) continue;
    key = mixed(mixedNumbers(key + 1, part.meshOf(placed)), placed.id);
    key = mixedNumbers(key, placed.frame);
  }
  return key;
}

uint64_t meshKey(const Document& document, const Evaluation& evaluation) {
  const uint64_t key = partsKey(evaluation);
  return key == 0 ? 0 : mixedNumbers(key, document.blend);
}

uint64_t bodyKey(const Document& document, const Evaluation& evaluation) {
  uint64_t key = meshKey(document, evaluation);
  if (key == 0) return 0;
  for (const Rig::Joint& joint : evaluation.rig().joints) {
    key = mixed(mixedNumbers(key, joint.position), joint.id);
    key = mixedNumbers(key, joint.parent);
  }
  if (const auto plane = symmetryPlane(document)) key = mixedNumbers(key, *plane);
  return key;
}

uint64_t strokesKey(const Document& document) {
  uint64_t key = 1;
  for (const auto& stroke : document.weight_strokes) {
    key = mixed(mixed(mixedNumbers(key, stroke->kind), stroke->part), stroke->joint);
    key = mixedNumbers(mixedNumbers(key, stroke->radius), stroke->strength);
    key = fingerprint(stroke->points.data(), stroke->points.size() * sizeof(Vec3), key);
  }
  return key;
}

std::string figureRequest(const Document& document) {
  Document needed = document;
  needed.references.clear();
  needed.poses.clear();
  return "{}\n" + writeDocument(needed);
}

std::string fileRequest(const Document& document, const FileOptions& options) {
  Document needed = document;
  if (!options.hasBones()) needed.references.clear();  // the others hold the whole drawing
  return toText(Json{{"file", toJson(options)}}) + "\n" + writeDocument(needed);
}

std::string toBytes(const MadeFile& file) {
  return toText(Json{{"leftOut", file.left_out}, {"size", file.bytes.size()}}) + "\n" + file.bytes;
}

Result<MadeFile> fileFromBytes(const std::string& bytes) {
  const size_t end = bytes.find('\n');
  const auto head = parseJson(bytes.substr(0, end));
  const Error broken{Status::unreadable, "The file did not arrive whole."};
  if (end == std::string::npos || !head || !head->is_object()) return broken;
  MadeFile file;
  file.bytes = bytes.substr(end + 1);
  const Json *size = field(*head, "size"), *left_out = field(*head, "leftOut");
  if (!size || *size != file.bytes.size() || !left_out || !left_out->is_array()) return broken;
  for (const Json& sentence : *left_out) {
    if (sentence.is_string()) file.left_out.push_back(sentence.get<std::string>());
  }
  return file;
}

Result<bool> Workshop::work(const std::string& request, const WorkTeller& tell, Clock clock) {
  const size_t end = request.find('\n');
  const auto head = parseJson(request.substr(0, end));
  if (!head || !head->is_object() || end == std::string::npos) {
    return {Status::unreadable, "The order could not be read."};
  }
  const auto document = readDocument(request.substr(end + 1));
  if (!document) return document.error();
  evaluation_.update(*document);
  const Json* file = field(*head, "file");
  return file ? makeFile(*document, optionsIn(*file), tell, clock)
              : makeFigure(*document, tell, clock);
}

bool Workshop::makeBody(const Document& document, const CharacterWatch& watch, Clock clock) {
  const uint64_t key = bodyKey(document, evaluation_);
  CharacterOptions options = characterOptions(document, evaluation_.rig());
  const std::vector<PlacedWeightStroke> strokes = std::move(options.strokes);
  options.strokes.clear();
  const bool is_new = key == 0 || key != made_of_;
  if (is_new) {
    made_of_ = 0;
    painting_.reset();
    bool stopped = false;
    CharacterWatch own;
    own.progress = [&](double done) {
      stopped = stopped || !watch.progress(done);
      return !stopped;
    };
    if (watch.first_guess) {
      own.first_guess = [&](const Character& guess) {
        if (strokes.empty()) return watch.first_guess(guess);
        Painting painting(guess, evaluation_.rig());
        stopped = !painting.set(strokes, [&](double) { return watch.progress(0); });
        if (stopped) return;
        Character painted = guess;
        if (!guess.unpainted.empty()) painted.meshes.front().skin = painting.skin();
        watch.first_guess(painted);
      };
    }
    body_ = makeCharacter(evaluation_, options, clock, own);
    if (stopped) return false;
    made_of_ = key;
  }
  body_.paints = paintsOf(evaluation_);
  if (body_.unpainted.empty() || (strokes.empty() && !painting_)) return true;
  if (!painting_) painting_ = std::make_unique<Painting>(body_, evaluation_.rig());
  const bool whole =
      painting_->set(strokes, [&](double done) { return watch.progress(is_new ? 1 : done); });
  body_.meshes.front().skin = painting_->skin();
  return whole;
}

Result<bool> Workshop::makeFigure(const Document& document, const WorkTeller& tell, Clock clock) {
  const double start_ms = clock();
  const auto send = [&](const Character& character, bool guessed) -> Result<bool> {
    auto figure = figureOf(character, evaluation_);
    if (!figure) return figure.error();
    figure->guessed = guessed;
    figure->made_ms = clock() - start_ms;
    tell.made(toBytes(*figure));
    return true;
  };
  const CharacterWatch watch{[&](const Character& guess) { send(guess, true); }, tell.progress};
  if (!makeBody(document, watch, clock)) return kStopped;
  if (!body_.no_weights.empty()) return {Status::meshFailed, body_.no_weights};
  return send(body_, false);
}

Result<bool> Workshop::makeFile(const Document& document, const FileOptions& options,
                                const WorkTeller& tell, Clock clock) {
  if (meshKey(document, evaluation_) == 0) {
    return {Status::meshFailed, "There is nothing to be saved: no part is shown."};
  }
  const Rig& rig = evaluation_.rig();
  const bool is_gltf = options.hasBones();
  const NamedPose* pose = document.findPose(options.pose);
  const bool needs_weights = is_gltf ? options.weights : pose != nullptr;
  CharacterWatch watch;
  watch.progress = tell.progress;
  Character own;  // what is no merged body with weights is made for this file alone
  const bool is_own = (is_gltf && options.parts) || !needs_weights;
  if (is_own) {
    CharacterOptions how = characterOptions(document, evaluation_.rig());
    how.merged = !(is_gltf && options.parts);
    how.weights = needs_weights;
    own = makeCharacter(evaluation_, how, clock, watch);
  } else if (!makeBody(document, watch, clock)) {
    return kStopped;
  }
  const Character& character = is_own ? own : body_;
  if (needs_weights && !character.no_weights.empty()) {
    return {Status::meshFailed, character.no_weights};
  }
  if (character.meshes.empty()) return {Status::meshFailed, leftOutOf(character).front()};
  Result<std::string> bytes{Status::meshFailed};
  if (is_gltf) {
    const GlbCharacter model = glbOf(character, rig, document, options.name);
    const GlbOptions how{options.metres_per_unit};
    bytes = options.format == Format::glb ? toGlb(model, how) : toGltf(model, how);
  } else {
    const SkinnedMesh body =
        posedMesh(character.meshes.front(), rig, pose ? pose->joints : Pose{}, options.skinning);
    bytes = options.format == Format::obj   ? Result<std::string>(toObj(body, character.paints))
            : options.format == Format::stl ? toStl(body)
                                            : toPly(body, character.paints);
  }
  if (!bytes) return {Status::meshFailed, "It is too large for such a file."};
  tell.made(toBytes(MadeFile{leftOutOf(character), std::move(*bytes)}));
  return true;
}

}  // namespace marrow
