#include "io/document_json.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "document/reference_image.h"
#include "io/json.h"
#include "io/object_reader.h"
#include "io/part_json.h"
#include "io/pose_json.h"
#include "io/weight_stroke_json.h"

namespace marrow {
namespace {

constexpr char kFormat[] = "marrow";

Error unreadable(std::string sentence) { return {Status::unreadable, std::move(sentence)}; }

constexpr struct {
  Reference::View view;
  const char* name;
} kViews[] = {{Reference::View::front, "front"},
              {Reference::View::right, "right"},
              {Reference::View::top, "top"}};

Json referenceToTree(const Reference& reference) {
  Json tree = Json::object();
  for (const auto& view : kViews) {
    if (view.view == reference.view) tree["view"] = view.name;
  }
  tree["image"] = *reference.image;
  tree["opacity"] = toJson(reference.opacity);
  tree["position"] = toJson(reference.position);
  tree["scale"] = toJson(reference.scale);
  appendFields(tree, extraFields(reference.extra));
  return tree;
}

Reference readReference(const Json& tree, const std::string& where, Fault& fault) {
  Reference reference;
  ObjectReader reader(tree, where, fault);
  std::string name = reader.text("view");
  if (!reader.has("view")) name = kViews[0].name;
  const auto* view = std::find_if(std::begin(kViews), std::end(kViews),
                                  [&](const auto& one) { return one.name == name; });
  if (view == std::end(kViews)) {
    reader.say("view", "is neither \"front\", \"right\" nor \"top\".");
  } else {
    reference.view = view->view;
  }
  std::string image = reader.text("image");
  if (!isReferenceImage(image)) {
    reader.say("image", "is no PNG, JPEG or WebP picture of up to 16 MB as a data URL.");
  }
  reference.image = std::make_shared<const std::string>(std::move(image));
  reference.opacity = reader.number("opacity", 0, 1).value_or(reference.opacity);
  reference.position = reader.point("position");
  reference.scale =
      reader.number("scale", Reference::kMinScale, Reference::kMaxScale).value_or(reference.scale);
  reference.extra = toText(reader.rest());
  return reference;
}

/// Largest number of the document's ids.
uint64_t largestPartNumber(const Document& document) {
  uint64_t largest = 0;
  for (const auto& part : document.parts) largest = std::max(largest, partNumber(part->id));
  return largest;
}

/// Nothing when the text's format and version are ours.
std::optional<Error> checkFormat(const Json& tree) {
  if (!tree.is_object()) return unreadable("It is not a Marrow drawing: not an object.");
  const Json* format = field(tree, "format");
  if (!format || !format->is_string() || format->get_ref<const std::string&>() != kFormat) {
    return unreadable("It is not a Marrow drawing: format is not \"marrow\".");
  }
  const Json* version = field(tree, "version");
  if (!version) return unreadable("version is missing.");
  const double number = version->is_number() ? version->get<double>() : 0;
  if (number < 1 || number != std::floor(number)) {
    return unreadable("version is not a whole number from 1.");
  }
  if (number > Document::kVersion) return Error{Status::newerVersion, {}};
  return std::nullopt;
}

/// The objects of a list that may be missing.
std::vector<const Json*> readList(ObjectReader& reader, const char* key, Fault& fault) {
  std::vector<const Json*> objects;
  const Json* list = reader.value(key);
  if (list && !list->is_array()) reader.say(key, "is not a list.");
  if (!list || !list->is_array()) return objects;
  for (const Json& one : *list) {
    if (!one.is_object()) {
      fault.say(std::string(key) + "[" + std::to_string(objects.size()) + "] is not an object.");
      break;
    }
    objects.push_back(&one);
  }
  return objects;
}

std::string place(const char* list, size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

void readReferences(ObjectReader& reader, Document& document, Fault& fault) {
  std::set<Reference::View> views;
  for (const Json* tree : readList(reader, "references", fault)) {
    const std::string where = place("references", document.references.size());
    Reference reference = readReference(*tree, where, fault);
    if (!views.insert(reference.view).second) fault.say(where + ".view is used twice.");
    if (fault.error()) return;
    document.references.push_back(std::make_shared<const Reference>(std::move(reference)));
  }
}

void readPoses(ObjectReader& reader, Document& document, Fault& fault) {
  std::set<std::string> names;
  for (const Json* tree : readList(reader, "poses", fault)) {
    const std::string where = place("poses", document.poses.size());
    if (document.poses.size() == Document::kMostPoses) fault.say("poses are more than 1,000.");
    NamedPose pose = readPose(*tree, where, fault);
    if (!names.insert(pose.name).second) fault.say(where + ".name is used twice.");
    if (fault.error()) return;
    document.poses.push_back(std::make_shared<const NamedPose>(std::move(pose)));
  }
}

void readWeightStrokes(ObjectReader& reader, Document& document, Fault& fault) {
  auto& strokes = document.weight_strokes;
  for (const Json* tree : readList(reader, "weightStrokes", fault)) {
    const std::string where = place("weightStrokes", strokes.size());
    if (strokes.size() == Document::kMostWeightStrokes) {
      fault.say("weightStrokes are more than a drawing holds.");
    }
    WeightStroke stroke = readWeightStroke(*tree, where, fault);
    if (fault.error()) return;
    strokes.push_back(std::make_shared<const WeightStroke>(std::move(stroke)));
  }
}

/// Ids, names and colours of parts that came without.
void nameParts(std::vector<ReadPart>& read, const std::set<std::string>& ids, Document& document) {
  for (const ReadPart& one : read) {
    document.last_part = std::max(document.last_part, partNumber(one.part.id));
  }
  for (ReadPart& one : read) {
    PartSource& part = one.part;
    while (part.id.empty()) {
      const std::string id = partId(takePartNumber(document));
      if (ids.count(id) == 0) part.id = id;
    }
    const uint64_t own = partNumber(part.id);
    const uint64_t number = own > 0 ? own : document.parts.size() + 1;
    if (part.name.empty()) part.name = defaultPartName(number);
    if (!one.has_color) part.color = partColor(static_cast<size_t>(number - 1));
    document.parts.push_back(std::make_shared<const PartSource>(std::move(part)));
  }
}

void readParts(ObjectReader& reader, Document& document, Fault& fault) {
  std::vector<ReadPart> read;
  std::set<std::string> ids;
  for (const Json* tree : readList(reader, "parts", fault)) {
    const std::string where = place("parts", read.size());
    if (read.size() == Document::kMostParts) fault.say("parts are more than a drawing holds.");
    read.push_back(readPart(*tree, where, fault));
    const std::string& id = read.back().part.id;
    if (!id.empty() && !ids.insert(id).second) fault.say(where + ".id is used twice.");
    if (fault.error()) return;
  }
  nameParts(read, ids, document);
}

void readLastPart(ObjectReader& reader, Document& document) {
  const Json* value = reader.value("lastPart");
  if (!value) return;
  const double number = value->is_number() ? value->get<double>() : -1;
  if (number < 0 || number > static_cast<double>(kLargestPartNumber) ||
      number != std::floor(number)) {
    reader.say("lastPart", "is not a whole number from 0.");
    return;
  }
  document.last_part = static_cast<uint64_t>(number);
}

}  // namespace

std::string writeDocument(const Document& document) {
  Json extra = extraFields(document.extra);
  Json tree = Json::object();
  tree["format"] = kFormat;
  tree["version"] = Document::kVersion;
  Json& parts = tree["parts"] = Json::array();
  for (const auto& part : document.parts) parts.push_back(partToTree(*part));
  Json refine = refinementToTree(document.refine, takeInner(extra, "refine"));
  if (!refine.empty()) tree["refine"] = std::move(refine);
  const Json symmetry_extra = takeInner(extra, "symmetry");
  if (document.symmetry) tree["symmetry"] = planeToTree(*document.symmetry, symmetry_extra);
  if (!document.references.empty()) {
    Json& references = tree["references"] = Json::array();
    for (const auto& one : document.references) references.push_back(referenceToTree(*one));
  }
  if (!document.poses.empty()) {
    Json& poses = tree["poses"] = Json::array();
    for (const auto& one : document.poses) poses.push_back(poseToTree(*one));
  }
  if (document.blend > 0) tree["blend"] = toJson(document.blend);
  if (!document.weight_strokes.empty()) {
    Json& strokes = tree["weightStrokes"] = Json::array();
    for (const auto& one : document.weight_strokes) strokes.push_back(weightStrokeToTree(*one));
  }
  if (document.last_part > largestPartNumber(document)) tree["lastPart"] = document.last_part;
  appendFields(tree, extra);
  return toText(tree);
}

Result<Document> readDocument(const std::string& text) {
  auto parsed = parseJson(text);
  if (!parsed) return parsed.error();
  const Json& tree = *parsed;
  if (auto error = checkFormat(tree)) return *error;

  Document document;
  Fault fault;
  ObjectReader reader(tree, "", fault);
  reader.asked("format");
  reader.asked("version");
  readLastPart(reader, document);
  readParts(reader, document, fault);
  if (const Json* refine = reader.object("refine")) {
    ObjectReader inner(*refine, "refine", fault);
    document.refine = readRefinement(inner);
    reader.keepInner("refine", inner);
  }
  document.symmetry = reader.plane("symmetry");
  readReferences(reader, document, fault);
  readPoses(reader, document, fault);
  document.blend = reader.number("blend", 0, Document::kLargestBlend).value_or(0);
  readWeightStrokes(reader, document, fault);
  document.extra = toText(reader.rest());
  if (fault.error()) return *fault.error();
  return document;
}

}  // namespace marrow
