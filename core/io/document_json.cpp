#include "io/document_json.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <utility>

#include "io/json.h"

namespace marrow {
namespace {

constexpr char kFormat[] = "marrow";
constexpr double kLargestPartNumber = 999'999'999'999'999;

Error unreadable(std::string sentence) { return {Status::unreadable, std::move(sentence)}; }

Json without(Json object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) object.erase(key);
  return object;
}

/// The object that `text` holds, or an empty one.
Json extraFields(const std::string& text) {
  auto extra = parseJson(text);
  return extra && extra->is_object() ? std::move(*extra) : Json::object();
}

void append(Json& object, const Json& fields) {
  for (const auto& item : fields.items()) {
    if (!object.contains(item.key())) object[item.key()] = item.value();
  }
}

/// The unknown fields of the inner object `key`, taken out of `extra`.
Json takeInner(Json& extra, const char* key) {
  const Json* inner = field(extra, key);
  Json fields = inner && inner->is_object() ? *inner : Json::object();
  extra.erase(key);
  return fields;
}

Json partToTree(const PartSource& part) {
  Json extra = extraFields(part.extra);
  Json stroke = Json::object(), refine = Json::object();
  stroke["points"] = toJson(part.stroke);
  append(stroke, takeInner(extra, "stroke"));
  if (part.epsilon_s) refine["simplify"] = toJson(*part.epsilon_s);
  append(refine, takeInner(extra, "refine"));

  Json tree = Json::object();
  tree["id"] = part.id;
  tree["name"] = part.name;
  tree["stroke"] = std::move(stroke);
  tree["thickness"] = toJson(part.thickness);
  tree["color"] = toString(part.color);
  if (!refine.empty()) tree["refine"] = std::move(refine);
  append(tree, extra);
  return tree;
}

/// Largest number of the document's ids.
uint64_t largestPartNumber(const Document& document) {
  uint64_t largest = 0;
  for (const auto& part : document.parts) largest = std::max(largest, partNumber(part->id));
  return largest;
}

/// A field that may be missing; its value must be a text.
Result<std::string> readText(const Json& object, const char* key, const std::string& where) {
  const Json* value = field(object, key);
  if (!value) return std::string();
  if (!value->is_string()) return unreadable(where + "." + key + " is not a text.");
  return value->get<std::string>();
}

/// A field that may be missing; its value must be a number, and is brought into the range.
Result<std::optional<double>> readNumber(const Json& object, const char* key, double low,
                                         double high, const std::string& where) {
  const Json* value = field(object, key);
  if (!value) return std::optional<double>();
  if (!value->is_number()) return unreadable(where + "." + key + " is not a number.");
  return std::optional<double>(std::clamp(value->get<double>(), low, high));
}

/// Everything but what another part's id decides: id, name and colour stay empty where missing.
struct ReadPart {
  PartSource part;
  bool has_color = false;
};

Result<ReadPart> readPart(const Json& tree, const std::string& where) {
  ReadPart read;
  PartSource& part = read.part;
  if (!tree.is_object()) return unreadable(where + " is not an object.");

  auto id = readText(tree, "id", where);
  if (!id) return id.error();
  part.id = std::move(*id);
  auto name = readText(tree, "name", where);
  if (!name) return name.error();
  part.name = std::move(*name);

  const Json* stroke = field(tree, "stroke");
  if (!stroke) return unreadable(where + ".stroke is missing.");
  if (!stroke->is_object()) return unreadable(where + ".stroke is not an object.");
  const Json* points = field(*stroke, "points");
  if (!points) return unreadable(where + ".stroke.points is missing.");
  auto samples = readPoints(*points, where + ".stroke.points");
  if (!samples) return samples.error();
  part.stroke = std::move(*samples);

  auto thickness = readNumber(tree, "thickness", kMinThickness, kMaxThickness, where);
  if (!thickness) return thickness.error();
  part.thickness = thickness->value_or(1);

  auto color_text = readText(tree, "color", where);
  if (!color_text) return color_text.error();
  read.has_color = tree.contains("color");
  if (read.has_color) {
    const auto color = parseColor(*color_text);
    if (!color) return unreadable(where + ".color is not of the form \"#rrggbb\".");
    part.color = *color;
  }

  Json extra = without(tree, {"id", "name", "stroke", "thickness", "color", "refine"});
  Json stroke_extra = without(*stroke, {"points"});
  if (!stroke_extra.empty()) extra["stroke"] = std::move(stroke_extra);
  if (const Json* refine = field(tree, "refine")) {
    if (!refine->is_object()) return unreadable(where + ".refine is not an object.");
    auto simplify = readNumber(*refine, "simplify", kMinEpsilonS, kMaxEpsilonS, where + ".refine");
    if (!simplify) return simplify.error();
    part.epsilon_s = *simplify;
    Json refine_extra = without(*refine, {"simplify"});
    if (!refine_extra.empty()) extra["refine"] = std::move(refine_extra);
  }
  part.extra = toText(extra);
  return read;
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

/// The number below which no id is given again, where the text says it.
Result<uint64_t> readLastPart(const Json& tree) {
  const Json* value = field(tree, "lastPart");
  if (!value) return uint64_t{0};
  const double number = value->is_number() ? value->get<double>() : -1;
  if (number < 0 || number > kLargestPartNumber || number != std::floor(number)) {
    return unreadable("lastPart is not a whole number from 0.");
  }
  return static_cast<uint64_t>(number);
}

}  // namespace

std::string writeDocument(const Document& document) {
  Json tree = Json::object();
  tree["format"] = kFormat;
  tree["version"] = Document::kVersion;
  Json& parts = tree["parts"] = Json::array();
  for (const auto& part : document.parts) parts.push_back(partToTree(*part));
  if (document.last_part > largestPartNumber(document)) tree["lastPart"] = document.last_part;
  append(tree, extraFields(document.extra));
  return toText(tree);
}

Result<Document> readDocument(const std::string& text) {
  auto parsed = parseJson(text);
  if (!parsed) return parsed.error();
  const Json& tree = *parsed;
  if (auto error = checkFormat(tree)) return *error;

  std::vector<ReadPart> read;
  std::set<std::string> ids;
  if (const Json* parts = field(tree, "parts")) {
    if (!parts->is_array()) return unreadable("parts is not a list.");
    for (const Json& part : *parts) {
      const std::string where = "parts[" + std::to_string(read.size()) + "]";
      auto one = readPart(part, where);
      if (!one) return one.error();
      const std::string& id = one->part.id;
      if (id.empty() ? part.contains("id") : !ids.insert(id).second) {
        return unreadable(where + ".id is " + (id.empty() ? "empty." : "used twice."));
      }
      read.push_back(std::move(*one));
    }
  }

  Document document;
  auto last_part = readLastPart(tree);
  if (!last_part) return last_part.error();
  document.last_part = *last_part;
  for (const ReadPart& one : read) {
    document.last_part = std::max(document.last_part, partNumber(one.part.id));
  }
  for (ReadPart& one : read) {
    PartSource& part = one.part;
    if (part.id.empty()) {
      do {
        part.id = partId(++document.last_part);
      } while (ids.count(part.id) > 0);
    }
    const uint64_t own = partNumber(part.id);
    const uint64_t number = own > 0 ? own : document.parts.size() + 1;
    if (part.name.empty()) part.name = defaultPartName(number);
    if (!one.has_color) part.color = partColor(static_cast<size_t>(number - 1));
    document.parts.push_back(std::make_shared<const PartSource>(std::move(part)));
  }
  document.extra = toText(without(tree, {"format", "version", "parts", "lastPart"}));
  return document;
}

}  // namespace marrow
