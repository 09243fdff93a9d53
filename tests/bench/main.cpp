// marrow_bench WHAT [--quick] [FILE…]: measures and writes a JSON object a line; times in
// milliseconds.
//   strokes    the strokes that are measured
//   stages     every stage and the total, per stroke; rivals on its polygon
//   growth     straight skeletons and the chordal axis as the polygon grows
//   cold       the first calls in this process
//   rig        whole characters: to the rig, opened, dragged, refined; FILEs are documents
//   quality    how good rigs are; the same on every machine; FILEs are strokes in place of ours
//   weights    of these, the rows of skin weights alone; what is bad, on the standard error
//   missed     of the joints that people place, those that rigs lack, on the standard error
//   connected  of parts that overlap, which are not put together as an animator would, likewise
//   model      characters merged, weighted, posed and written; FILEs are documents
//   character  the document of 60 strokes that is dragged and refined
#include <cstdio>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/chordal_axis.h"
#include "bench/connect_quality.h"
#include "bench/inputs.h"
#include "bench/measure.h"
#include "bench/models.h"
#include "bench/placed_joints.h"
#include "bench/quality.h"
#include "bench/rigs.h"
#include "part/part.h"

namespace marrow::bench {
namespace {

using Json = nlohmann::ordered_json;

void print(const Json& row) { std::printf("%s\n", row.dump().c_str()); }

Json toJson(const Times& times) { return {times.min_ms, times.median_ms}; }

PartOptions withPoints(int target_points) {
  PartOptions options;
  options.triangulation.target_points = target_points;
  return options;
}

struct Mode {
  const char* name;
  PartOptions options;
};

std::vector<Mode> modes() {
  return {{"1000", withPoints(1000)}, {"2500", withPoints(2500)}, {"preview", previewOptions()}};
}

const char* const kSkeletonStages[] = {"outline", "straightSkeleton", "axis", "joints"};

/// Of the stages that lead to the joints.
double skeletonTime(const Timings& timings) {
  double sum_ms = 0;
  for (const auto& [stage, ms] : timings.stages_ms) {
    for (const char* wanted : kSkeletonStages) sum_ms += std::strcmp(stage, wanted) == 0 ? ms : 0;
  }
  return sum_ms;
}

/// Until WebAssembly has been compiled for speed.
void warmUp(const std::vector<Input>& all, double budget_ms) {
  const double end_ms = now() + budget_ms;
  for (size_t i = 0; now() < end_ms; ++i) {
    const auto& stroke = all[i % all.size()].points;
    (void)buildPart(stroke, i % 2 ? PartOptions{} : previewOptions(), now);
    if (const auto outline = makeOutline(stroke)) {
      (void)chordalAxis(outline->polygon);
      (void)straightSkeletonByCgal(outline->polygon);
    }
  }
}

/// Straight skeletons and the chordal axis of one polygon.
Json rivals(const std::vector<Vec2>& polygon, Effort effort, bool with_cgal) {
  Json row;
  row["ours"] = toJson(measure([&] { (void)straightSkeleton(polygon); }, effort));
  row["chordal"] = toJson(measure([&] { (void)chordalAxis(polygon); }, effort));
  if (with_cgal) {
    effort.least = polygon.size() <= 200 ? 5 : 1;
    row["cgal"] = toJson(measure([&] { (void)straightSkeletonByCgal(polygon); }, effort));
  }
  return row;
}

void stages(bool quick) {
  const auto all = benchStrokes();
  warmUp(all, quick ? 1000 : 2000);
  const Effort effort{quick ? 10.0 : 40.0, quick ? 5 : 12};
  for (const auto& [name, stroke] : all) {
    const auto outline = makeOutline(stroke);
    if (!outline) continue;
    for (const Mode& mode : modes()) {
      std::vector<std::pair<const char*, std::vector<double>>> stages;
      std::vector<double> skeletons, totals;
      const double end_ms = now() + effort.budget_ms;
      for (int run = -1; run < effort.least || now() < end_ms; ++run) {
        const auto part = buildPart(stroke, mode.options, now);
        if (!part) break;
        const Timings& timings = part->timings;
        if (run < 0) {
          for (const auto& stage : timings.stages_ms) stages.push_back({stage.first, {}});
          continue;
        }
        for (size_t i = 0; i < stages.size(); ++i) {
          stages[i].second.push_back(timings.stages_ms[i].second);
        }
        skeletons.push_back(skeletonTime(timings));
        totals.push_back(timings.total_ms);
      }
      const auto flat = triangulate(outline->dense, mode.options.triangulation);
      Json row{{"bench", "stages"},
               {"stroke", name},
               {"mode", mode.name},
               {"samples", stroke.size()},
               {"polygon", outline->polygon.size()},
               {"vertices", flat ? flat->points.size() : 0},
               {"runs", totals.size()}};
      for (const auto& [stage, times_ms] : stages) row["ms"][stage] = toJson(summary(times_ms));
      row["ms"]["toJoints"] = toJson(summary(skeletons));
      row["ms"]["total"] = toJson(summary(totals));
      print(row);
    }
    Json row{{"bench", "polygons"}, {"stroke", name}, {"n", outline->polygon.size()}};
    row["ms"] = rivals(outline->polygon, {quick ? 3.0 : 10.0, 3}, true);
    print(row);
  }
}

void growth(bool quick) {
  warmUp(benchStrokes(), quick ? 1000 : 2000);
  const double slowest_ms = quick ? 150 : 6000;  // CGAL is left out beyond
  for (const Family& family : polygonsThatGrow()) {
    double cgal_ms = 0;
    int cgal_n = 0;
    for (const int n : {10, 20, 32, 50, 100, 135, 200, 400, 1000, 2000}) {
      const int polygons = n <= 200 ? 5 : n <= 400 ? 3 : 1;
      const double ratio = cgal_n > 0 ? static_cast<double>(n) / cgal_n : 1;
      const bool with_cgal = cgal_ms * ratio * ratio * ratio < slowest_ms;
      Random random(static_cast<uint64_t>(n));
      double size = 0;
      std::map<std::string, Times> sums;
      for (int i = 0; i < polygons; ++i) {
        const auto polygon = family.polygon(random, n);
        if (straightSkeleton(polygon)->method != StraightSkeleton::Method::wavefront) {
          std::fprintf(stderr, "%s, %d vertices: not by our wavefront\n", family.name, n);
        }
        size += static_cast<double>(polygon.size()) / polygons;
        const Json row = rivals(polygon, {quick ? 2.0 : 8.0, 3}, with_cgal);
        for (const auto& [who, times] : row.items()) {
          sums[who].min_ms += times[0].get<double>() / polygons;
          sums[who].median_ms += times[1].get<double>() / polygons;
        }
      }
      Json row{{"bench", "growth"}, {"family", family.name}, {"n", size}};
      for (const auto& [who, times] : sums) row["ms"][who] = toJson(times);
      print(row);
      if (with_cgal) {
        cgal_ms = sums["cgal"].min_ms;
        cgal_n = n;
      }
    }
  }
}

void cold() {
  const auto stroke = typicalStroke();
  for (int run = 1; run <= 100; ++run) {
    const double start_ms = now();
    const auto part = buildPart(stroke, {}, now);
    const double took_ms = now() - start_ms;
    if (!part) return;
    if (run != 1 && run != 2 && run != 10 && run != 100) continue;
    Json row{{"bench", "cold"}, {"call", run}, {"ms", {{"total", took_ms}}}};
    row["ms"]["toJoints"] = skeletonTime(part->timings);
    print(row);
  }
}

void printStrokes() {
  for (const auto& [name, stroke] : benchStrokes()) {
    Json row{{"stroke", name}, {"points", Json::array()}};
    for (const Vec2 p : stroke) row["points"].push_back({p.x, p.y});
    print(row);
  }
}

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  bool quick = false;
  std::vector<std::string> files;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--quick") {
      quick = true;
    } else {
      files.push_back(word);
    }
  }
  if (what == "strokes") {
    printStrokes();
  } else if (what == "stages") {
    stages(quick);
  } else if (what == "growth") {
    growth(quick);
  } else if (what == "cold") {
    cold();
  } else if (what == "character") {
    print({{"document", characterOfManyParts()}});
  } else if (what == "rig") {
    rigs(quick, files);
  } else if (what == "quality") {
    quality(files);
  } else if (what == "weights") {
    weights();
  } else if (what == "missed") {
    missedJoints();
  } else if (what == "connected") {
    printQuality(connectQuality(true));
  } else if (what == "model") {
    models(quick, files);
  } else {
    std::fprintf(stderr,
                 "marrow_bench "
                 "strokes|stages|growth|cold|rig|model|quality|weights|missed|connected|character "
                 "[--quick] [FILE…]\n");
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace marrow::bench

int main(int argc, char** argv) { return marrow::bench::run(argc, argv); }
