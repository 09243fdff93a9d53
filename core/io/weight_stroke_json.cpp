#include "io/weight_stroke_json.h"

#include "document/document.h"
#include "io/part_json.h"

namespace marrow {
namespace {

constexpr const char* kKinds[] = {"add", "take", "smooth"};

std::vector<Vec3> readPoints(ObjectReader& reader) {
  std::vector<Vec3> points;
  const Json* list = reader.value("points");
  if (!list || !list->is_array()) {
    reader.say("points", list ? "is not a list of points." : "is missing.");
    return points;
  }
  if (list->size() > WeightStroke::kMostPoints) {
    reader.say("points", "are too many.");
    return points;
  }
  for (const Json& one : *list) {
    const std::string key = "points[" + std::to_string(points.size()) + "]";
    bool numbers = one.is_array() && one.size() == 3;
    for (size_t k = 0; numbers && k < 3; ++k) numbers = one[k].is_number();
    if (!numbers) {
      reader.say(key, "is not a list of 3 numbers.");
      break;
    }
    points.push_back({one[0].get<double>(), one[1].get<double>(), one[2].get<double>()});
    if (isDrawable(points.back())) continue;
    reader.say(key, "is too far away.");
    break;
  }
  return points;
}

}  // namespace

Json weightStrokeToTree(const WeightStroke& stroke) {
  Json tree = Json::object();
  tree["kind"] = kKinds[static_cast<size_t>(stroke.kind)];
  tree["part"] = stroke.part;
  tree["joint"] = stroke.joint;
  tree["radius"] = toJson(stroke.radius);
  tree["strength"] = toJson(stroke.strength);
  Json& points = tree["points"] = Json::array();
  for (const Vec3 p : stroke.points) points.push_back(toJson(p));
  appendFields(tree, extraFields(stroke.extra));
  return tree;
}

WeightStroke readWeightStroke(const Json& tree, const std::string& where, Fault& fault) {
  WeightStroke stroke;
  ObjectReader reader(tree, where, fault);
  const std::string kind = reader.text("kind");
  bool known = !reader.has("kind");
  for (size_t i = 0; i < std::size(kKinds); ++i) {
    if (kind != kKinds[i]) continue;
    stroke.kind = static_cast<WeightStroke::Kind>(i);
    known = true;
  }
  if (!known) reader.say("kind", "is neither \"add\", \"take\" nor \"smooth\".");
  stroke.part = reader.text("part");
  stroke.joint = reader.text("joint");
  stroke.radius = reader.number("radius", WeightStroke::kMinRadius, WeightStroke::kMaxRadius)
                      .value_or(stroke.radius);
  stroke.strength = reader.number("strength", 0, 1).value_or(stroke.strength);
  stroke.points = readPoints(reader);
  stroke.extra = toText(reader.rest());
  return stroke;
}

}  // namespace marrow
