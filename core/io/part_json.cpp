#include "io/part_json.h"

#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "base/base64.h"
#include "document/placement.h"
#include "part/silhouette.h"

namespace marrow {
namespace {

constexpr struct {
  const char* name;
  std::optional<double> Refinement::*threshold;
} kThresholds[] = {{"simplify", &Refinement::simplify},
                   {"merge", &Refinement::merge},
                   {"prune", &Refinement::prune},
                   {"collapse", &Refinement::collapse}};

Json withExtra(Json object, const Json& extra) {
  appendFields(object, extra);
  return object;
}

/// The bytes of numbers, the lowest first, as Base64.
template <typename T, typename Values>
std::string packed(const Values& values) {
  std::vector<uint8_t> bytes;
  bytes.reserve(values.size() * 3 * sizeof(T));
  const auto put = [&](T number) {
    uint8_t raw[sizeof(T)];
    std::memcpy(raw, &number, sizeof(T));
    bytes.insert(bytes.end(), raw, raw + sizeof(T));
  };
  for (const auto& [a, b, c] : values) {
    put(static_cast<T>(a));
    put(static_cast<T>(b));
    put(static_cast<T>(c));
  }
  return toBase64(bytes);
}

/// Triples of numbers; nothing where the text is something else, or says more than `most`.
template <typename T>
std::optional<std::vector<std::array<T, 3>>> unpacked(const std::string& text, size_t most) {
  if (text.size() / 4 > most * sizeof(T)) return std::nullopt;
  const auto bytes = fromBase64(text);
  if (!bytes || bytes->size() % (3 * sizeof(T)) != 0) return std::nullopt;
  std::vector<std::array<T, 3>> values(bytes->size() / (3 * sizeof(T)));
  if (!values.empty()) std::memcpy(values.data(), bytes->data(), bytes->size());
  return values;
}

Json meshToTree(const Mesh& mesh) {
  Json tree = Json::object();
  tree["positions"] = packed<float>(mesh.positions);
  tree["triangles"] = packed<uint32_t>(mesh.triangles);
  return tree;
}

/// Null where there is none, or a fault was said.
std::shared_ptr<const Mesh> readMesh(ObjectReader& reader, Fault& fault) {
  const Json* tree = reader.object("mesh");
  if (!tree) return nullptr;
  ObjectReader inner(*tree, reader.where("mesh"), fault);
  // Every vertex of a closed surface has three triangles at least.
  const auto positions = unpacked<float>(inner.text("positions"), PartSource::kMostTriangles);
  const auto triangles = unpacked<uint32_t>(inner.text("triangles"), PartSource::kMostTriangles);
  if (!positions) inner.say("positions", "is no Base64 of up to 100,000 triples of floats.");
  if (!triangles) inner.say("triangles", "is no Base64 of up to 100,000 triples of indices.");
  reader.keepInner("mesh", inner);
  if (!positions || !triangles) return nullptr;
  Mesh mesh;
  mesh.triangles = *triangles;
  for (const auto& [x, y, z] : *positions) mesh.positions.push_back({x, y, z});
  const std::string wrong = faultIn(mesh);
  if (!wrong.empty()) reader.say("mesh", wrong + ".");
  return wrong.empty() ? std::make_shared<const Mesh>(std::move(mesh)) : nullptr;
}

std::vector<Vec2> readStroke(ObjectReader& reader, const Mesh* mesh, Fault& fault) {
  const Json* stroke = reader.object("stroke");
  if (!reader.has("stroke") && mesh) {
    auto silhouette = silhouetteOf(*mesh);
    if (silhouette) return std::move(*silhouette);
    reader.say("mesh", "has no silhouette.");
  } else if (!reader.has("stroke")) {
    reader.say("stroke", "is missing.");
  }
  if (!stroke) return {};
  ObjectReader inner(*stroke, reader.where("stroke"), fault);
  const Json* points = inner.value("points");
  reader.keepInner("stroke", inner);
  if (!points) {
    inner.say("points", "is missing.");
    return {};
  }
  auto read = readPoints(*points, inner.where("points"));
  if (read) return std::move(*read);
  fault.say(read.message());
  return {};
}

/// Directions that are no frame's are made one, and the stroke and the mesh are brought into it.
void readFrame(ObjectReader& reader, PartSource& part, Fault& fault) {
  Frame& frame = part.frame;
  if (const Json* tree = reader.object("frame")) {
    ObjectReader inner(*tree, reader.where("frame"), fault);
    frame.origin = inner.vector("origin", frame.origin);
    frame.x = inner.vector("x", frame.x);
    frame.y = inner.vector("y", frame.y);
    reader.keepInner("frame", inner);
  }
  if (!fitInFrame(part)) {
    reader.say("frame", "is no plane: x and y are zero or parallel.");
    return;
  }
  if (!isDrawable(part)) reader.say("frame", "puts the stroke too far away.");
  if (part.mesh && !faultIn(*part.mesh).empty()) reader.say("frame", "flattens the mesh.");
}

std::map<std::string, double> readBranches(ObjectReader& refine, Fault& fault) {
  std::map<std::string, double> branches;
  const Json* tree = refine.object("branches");
  if (!tree) return branches;
  ObjectReader reader(*tree, refine.where("branches"), fault);
  for (const auto& item : tree->items()) {
    const std::string& key = item.key();
    if (const auto value = reader.number(key, 0, Refinement::kLargest)) branches[key] = *value;
  }
  if (branches.size() > PartSource::kMostBranches) refine.say("branches", "are too many.");
  return branches;
}

std::optional<Attachment> readAttachment(ObjectReader& reader, Fault& fault) {
  const Json* tree = reader.object("attachment", /*may_be_null=*/true);
  if (!tree) return std::nullopt;
  ObjectReader inner(*tree, reader.where("attachment"), fault);
  Attachment attachment;
  attachment.part = inner.text("part");
  attachment.at = inner.point("at");
  reader.keepInner("attachment", inner);
  return attachment;
}

}  // namespace

Json extraFields(const std::string& text) {
  if (text == "{}") return Json::object();
  auto extra = parseJson(text);
  return extra && extra->is_object() ? std::move(*extra) : Json::object();
}

Json takeInner(Json& extra, const char* key) {
  const Json* inner = field(extra, key);
  Json fields = inner && inner->is_object() ? *inner : Json::object();
  extra.erase(key);
  return fields;
}

void appendFields(Json& object, const Json& fields) {
  for (const auto& item : fields.items()) {
    if (!object.contains(item.key())) object[item.key()] = item.value();
  }
}

Json refinementToTree(const Refinement& refine, const Json& extra) {
  Json tree = Json::object();
  for (const auto& [name, threshold] : kThresholds) {
    if (refine.*threshold) tree[name] = marrow::toJson(*(refine.*threshold));
  }
  return withExtra(std::move(tree), extra);
}

Refinement readRefinement(ObjectReader& reader) {
  Refinement refine;
  for (const auto& [name, threshold] : kThresholds) {
    refine.*threshold = reader.number(name, 0, Refinement::kLargest);
  }
  return refine;
}

Json planeToTree(const Plane& plane, const Json& extra) {
  Json numbers = toJson(plane.normal);
  numbers.push_back(marrow::toJson(plane.offset));
  Json tree = Json::object();
  tree["plane"] = std::move(numbers);
  return withExtra(std::move(tree), extra);
}

Json partToTree(const PartSource& part) {
  Json extra = extraFields(part.extra);
  Json stroke = Json::object(), frame = Json::object();
  stroke["points"] = marrow::toJson(part.stroke);
  frame["origin"] = toJson(part.frame.origin);
  frame["x"] = toJson(part.frame.x);
  frame["y"] = toJson(part.frame.y);
  const Json mirror_extra = takeInner(extra, "mirror");
  const Json attachment_extra = takeInner(extra, "attachment");
  const Json refine_extra = takeInner(extra, "refine");
  Json refine = refinementToTree(part.refine, Json::object());
  if (!part.branches.empty()) {
    Json& branches = refine["branches"] = Json::object();
    for (const auto& [key, value] : part.branches) branches[key] = marrow::toJson(value);
  }
  appendFields(refine, refine_extra);

  Json tree = Json::object();
  tree["id"] = part.id;
  tree["name"] = part.name;
  tree["stroke"] = withExtra(std::move(stroke), takeInner(extra, "stroke"));
  const Json mesh_extra = takeInner(extra, "mesh");
  if (part.mesh) tree["mesh"] = withExtra(meshToTree(*part.mesh), mesh_extra);
  tree["frame"] = withExtra(std::move(frame), takeInner(extra, "frame"));
  tree["thickness"] = marrow::toJson(part.thickness);
  tree["mirror"] = part.mirror ? planeToTree(*part.mirror, mirror_extra) : Json();
  tree["skeleton"] = part.skeleton;
  tree["color"] = toString(part.color);
  tree["visible"] = part.visible;
  if (part.locked) tree["locked"] = true;
  if (part.root) tree["root"] = true;
  if (!refine.empty()) tree["refine"] = std::move(refine);
  if (part.attachment) {
    Json attachment = Json::object();
    attachment["part"] = part.attachment->part;
    attachment["at"] = marrow::toJson(part.attachment->at);
    tree["attachment"] = withExtra(std::move(attachment), attachment_extra);
  }
  appendFields(tree, extra);
  return tree;
}

ReadPart readPart(const Json& tree, const std::string& where, Fault& fault) {
  ReadPart read;
  PartSource& part = read.part;
  ObjectReader reader(tree, where, fault);
  part.id = reader.text("id");
  if (part.id.empty() && reader.has("id")) reader.say("id", "is empty.");
  if (part.id.find(':') != std::string::npos) reader.say("id", "holds a colon.");
  part.name = reader.text("name");
  part.mesh = readMesh(reader, fault);
  part.stroke = readStroke(reader, part.mesh.get(), fault);
  readFrame(reader, part, fault);
  part.thickness = reader.number("thickness", kMinThickness, kMaxThickness).value_or(1);
  part.mirror = reader.plane("mirror");
  part.skeleton = reader.flag("skeleton", true);
  const std::string color_text = reader.text("color");
  read.has_color = reader.has("color");
  if (const auto color = parseColor(color_text)) {
    part.color = *color;
  } else if (read.has_color) {
    reader.say("color", "is not of the form \"#rrggbb\".");
  }
  part.visible = reader.flag("visible", true);
  part.locked = reader.flag("locked", false);
  part.root = reader.flag("root", false);
  if (const Json* refine = reader.object("refine")) {
    ObjectReader inner(*refine, reader.where("refine"), fault);
    part.refine = readRefinement(inner);
    part.branches = readBranches(inner, fault);
    reader.keepInner("refine", inner);
  }
  part.attachment = readAttachment(reader, fault);
  part.extra = toText(reader.rest());
  return read;
}

}  // namespace marrow
