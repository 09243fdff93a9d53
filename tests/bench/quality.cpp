#include "bench/quality.h"

#include "bench/connect_quality.h"
#include "bench/creatures.h"
#include "bench/placed_joints.h"
#include "bench/skeleton_quality.h"
#include "bench/weight_quality.h"

namespace marrow::bench {
namespace {

std::vector<strokes::NamedStroke> ourDrawings() {
  std::vector<strokes::NamedStroke> drawings = strokes::realStrokes();
  for (PlacedDrawing& drawing : placedDrawings()) {
    const bool known = std::any_of(drawings.begin(), drawings.end(),
                                   [&](const auto& one) { return one.name == drawing.name; });
    if (!known) drawings.push_back({drawing.name, std::move(drawing.points)});
  }
  return drawings;
}

}  // namespace

void printQuality(const std::vector<QualityRow>& rows) {
  for (const QualityRow& row : rows) {
    Json json{{"bench", "quality"}, {"what", row.what}, {"value", row.value}};
    json[row.at_least ? "least" : "most"] = row.wanted;
    json["unit"] = row.unit;
    json["note"] = row.note;
    bench::print(json);
  }
}

void quality(const std::vector<std::string>& paths) {
  if (paths.empty()) {
    printQuality(placedJoints());
    printQuality(connectQuality());
    printQuality(skeletonQuality(ourDrawings()));
    printQuality(weightQuality(ourDrawings()));
    return;
  }
  std::vector<strokes::NamedStroke> drawings;
  for (const std::string& path : paths) {
    const auto json = nlohmann::json::parse(strokes::readText(path));
    drawings.push_back({json.value("name", path), strokes::toStroke(json.at("points"))});
  }
  printQuality(skeletonQuality(drawings, true));
}

void weights() { printQuality(weightQuality(ourDrawings(), true)); }

}  // namespace marrow::bench
