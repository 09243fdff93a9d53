#include "bench/rigs.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/creatures.h"
#include "bench/measure.h"
#include "document/evaluation.h"
#include "rig/connect.h"

namespace marrow::bench {
namespace {

/// What a stroke's skeleton is made of, as buildPart does it.
struct SubSkeleton {
  Outline outline;
  PartSkeleton skeleton;
};

bool makeSubSkeleton(const std::vector<Vec2>& stroke, SubSkeleton& made,
                     std::array<double, 4>& stages_ms) {
  auto part = buildSkeleton(stroke, {}, now);
  if (!part) return false;
  for (size_t stage = 0; stage < stages_ms.size(); ++stage) {
    stages_ms[stage] += part->timings.stages_ms[stage].second;
  }
  made.outline = std::move(part->outline);
  made.skeleton = std::move(part->skeleton);
  return true;
}

/// From the strokes to the rig; meshes and proxies are there already.
void wholeRig(const Creature& creature, Effort effort) {
  Evaluation evaluation;
  evaluation.update(creature.document);
  const std::vector<RigPart> parts = evaluation.rigParts();
  const char* const names[] = {"outline",    "straightSkeleton", "axis", "joints",
                               "connection", "refinement",       "total"};
  std::array<std::vector<double>, 7> times;
  size_t joints = 0;
  std::vector<SubSkeleton> made(creature.document.parts.size());
  const double end_ms = now() + effort.budget_ms;
  for (int run = -1; run < effort.least || now() < end_ms; ++run) {
    std::array<double, 4> stages_ms{};
    const double start_ms = now();
    for (size_t i = 0; i < made.size(); ++i) {
      (void)makeSubSkeleton(creature.document.parts[i]->stroke, made[i], stages_ms);
    }
    const double skeletons_ms = now();
    const std::vector<Connection> connections = connectParts(parts);
    const double connected_ms = now();
    const Rig rig = refineRig(parts, connections, creature.document.refine);
    const double refined_ms = now();
    if (run < 0) continue;
    joints = rig.joints.size();
    for (size_t i = 0; i < 4; ++i) times[i].push_back(stages_ms[i]);
    times[4].push_back(connected_ms - skeletons_ms);
    times[5].push_back(refined_ms - connected_ms);
    times[6].push_back(refined_ms - start_ms);
  }
  Json row{{"bench", "rig"},
           {"creature", creature.name},
           {"strokes", creature.document.parts.size()},
           {"parts", parts.size()},
           {"joints", joints}};
  for (size_t i = 0; i < times.size(); ++i) row["ms"][names[i]] = toJson(std::move(times[i]));
  print(row);
}

void opening(const Creature& creature, Effort effort) {
  std::vector<double> read_ms, all_ms;
  const double end_ms = now() + effort.budget_ms;
  for (int run = 0; run < effort.least || now() < end_ms; ++run) {
    const double start_ms = now();
    auto document = readDocument(creature.text);
    const double lap_ms = now();
    Evaluation evaluation;
    evaluation.update(*document);
    all_ms.push_back(now() - start_ms);
    read_ms.push_back(lap_ms - start_ms);
  }
  Json row{{"bench", "open"},
           {"creature", creature.name},
           {"strokes", creature.document.parts.size()},
           {"bytes", creature.text.size()}};
  row["ms"]["read"] = toJson(read_ms);
  row["ms"]["total"] = toJson(all_ms);
  print(row);
}

/// Times `frames` updates, each of the document that `next` makes.
template <typename Next>
std::vector<double> updates(const Creature& creature, int frames, Next next) {
  Evaluation evaluation;
  evaluation.update(creature.document);
  std::vector<double> times_ms;
  for (int frame = 0; frame < frames; ++frame) {
    const Document document = next(frame);
    const double start_ms = now();
    evaluation.update(document);
    times_ms.push_back(now() - start_ms);
  }
  return times_ms;
}

/// One part at a time to and fro, as far as a hand would, over those that hold it.
void dragging(const Creature& creature, int frames) {
  std::vector<double> all_ms;
  const size_t count = creature.document.parts.size();
  for (const size_t dragged : {size_t{0}, count / 3, count / 2, count - 1}) {
    const auto times_ms = updates(creature, frames, [&](int frame) {
      Document document = creature.document;
      auto part = std::make_shared<PartSource>(*document.parts[dragged]);
      const double t = static_cast<double>(frame % 40 - 20);
      part->frame.origin = part->frame.origin + Vec3{3 * t, 2 * t, t};
      document.parts[dragged] = std::move(part);
      return document;
    });
    all_ms.insert(all_ms.end(), times_ms.begin(), times_ms.end());
  }
  Json row{{"bench", "drag"}, {"creature", creature.name}, {"strokes", count}};
  row["ms"]["update"] = toJson(std::move(all_ms));
  print(row);
}

void sliders(const Creature& creature, int frames) {
  const std::pair<const char*, std::optional<double> Refinement::*> thresholds[] = {
      {"simplify", &Refinement::simplify},
      {"merge", &Refinement::merge},
      {"prune", &Refinement::prune},
      {"collapse", &Refinement::collapse}};
  Json row{{"bench", "slider"},
           {"creature", creature.name},
           {"strokes", creature.document.parts.size()}};
  for (const auto& [name, threshold] : thresholds) {
    const auto member = threshold;
    row["ms"][name] = toJson(updates(creature, frames, [&](int frame) {
      Document document = creature.document;
      document.refine.*member = static_cast<double>(frame * 7 % 120) / 2;
      return document;
    }));
  }
  print(row);
}

}  // namespace

void rigs(bool quick, const std::vector<std::string>& paths) {
  std::vector<Creature> all = samples(paths);
  const size_t small = all.size(), large = small + 1;
  all.push_back(fourLegged());
  all.push_back(sixtyParts());

  // Until WebAssembly has been compiled for speed.
  const double warm_ms = now() + (quick ? 1500 : 3000);
  for (size_t i = 0; now() < warm_ms; ++i) {
    Evaluation evaluation;
    evaluation.update(all[i % large].document);
  }
  const Effort effort{quick ? 30.0 : 150.0, quick ? 5 : 20};
  for (const Creature& creature : all) wholeRig(creature, effort);
  for (const Creature& creature : all) opening(creature, {effort.budget_ms, 3});
  for (const size_t i : {small, large}) {
    dragging(all[i], quick ? 40 : 120);
    sliders(all[i], quick ? 40 : 120);
  }
}

std::string characterOfManyParts() { return sixtyParts().text; }

}  // namespace marrow::bench
