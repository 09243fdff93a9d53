#include "bench/quality.h"

#include "bench/creatures.h"
#include "bench/placed_joints.h"

namespace marrow::bench {

void printQuality(const std::vector<QualityRow>& rows) {
  for (const QualityRow& row : rows) {
    Json json{{"bench", "quality"}, {"what", row.what}, {"value", row.value}};
    json[row.at_least ? "least" : "most"] = row.wanted;
    json["unit"] = row.unit;
    json["note"] = row.note;
    bench::print(json);
  }
}

void quality() { printQuality(placedJoints()); }

}  // namespace marrow::bench
