#include "bench/quality.h"

#include "bench/creatures.h"

namespace marrow::bench {
namespace {

void print(const std::vector<QualityRow>& rows) {
  for (const QualityRow& row : rows) {
    Json json{{"bench", "quality"}, {"what", row.what}, {"value", row.value}};
    json[row.at_least ? "least" : "most"] = row.wanted;
    json["unit"] = row.unit;
    json["note"] = row.note;
    bench::print(json);
  }
}

}  // namespace

void quality() { print({}); }

}  // namespace marrow::bench
