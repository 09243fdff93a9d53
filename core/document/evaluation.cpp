#include "document/evaluation.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "rig/connect.h"

namespace marrow {

Evaluation::Evaluation(PartOptions options, Clock clock)
    : options_(std::move(options)), clock_(clock) {}

void Evaluation::update(const Document& document) {
  std::unordered_map<std::string_view, const EvaluatedPart*> before;
  for (const EvaluatedPart& part : parts_) before.emplace(part.source->id, &part);

  recomputed_ = 0;
  timings_ = {};
  std::vector<EvaluatedPart> parts;
  parts.reserve(document.parts.size());
  bool same = rig_id_ > 0 && parts_.size() == document.parts.size() && refine_ == document.refine;
  for (const auto& source : document.parts) {
    same = same && parts_[parts.size()].source == source;
    const auto found = before.find(source->id);
    parts.push_back(evaluate(source, found == before.end() ? nullptr : found->second));
  }
  parts_ = std::move(parts);
  if (!same) updateRig(document);
}

EvaluatedPart Evaluation::evaluate(const std::shared_ptr<const PartSource>& source,
                                   const EvaluatedPart* before) {
  if (!before) return rebuild(source);
  if (source == before->source) return *before;
  if (source->stroke != before->source->stroke) return rebuild(source);

  EvaluatedPart next = *before;
  next.source = source;
  if (source->thickness == before->source->thickness || !before->part) return next;
  ++recomputed_;
  next.mesh_id = next_id_++;
  next.skeleton_id = next_id_++;
  next.part = std::make_shared<const Part>(withThickness(*next.part, source->thickness, clock_));
  timings_.add(next.part->timings);
  return next;
}

EvaluatedPart Evaluation::rebuild(const std::shared_ptr<const PartSource>& source) {
  ++recomputed_;
  EvaluatedPart next;
  next.source = source;
  next.mesh_id = next_id_++;
  next.skeleton_id = next_id_++;
  PartOptions options = options_;
  options.inflate.thickness = source->thickness;
  auto part = buildPart(source->stroke, options, clock_);
  if (part) {
    timings_.add(part->timings);
    next.part = std::make_shared<const Part>(std::move(*part));
  } else {
    next.error = part.error();
  }
  return next;
}

void Evaluation::updateRig(const Document& document) {
  placed_ = placedParts(document);
  refine_ = document.refine;
  Timings timings;
  Stopwatch watch(clock_, timings);
  const std::vector<RigPart> parts = rigParts();
  const std::vector<Connection> connections = connectParts(parts);
  watch.lap("connection");
  Rig rig = refineRig(parts, connections, refine_);
  watch.lap("refinement");
  timings_.add(timings);
  if (rig_id_ > 0 && rig == rig_) return;
  rig_ = std::move(rig);
  rig_id_ = next_id_++;
}

std::vector<RigPart> Evaluation::rigParts() const {
  std::vector<RigPart> parts;
  parts.reserve(placed_.size());
  for (const PlacedPart& placed : placed_) {
    const EvaluatedPart& part = parts_[placed.source];
    parts.push_back({&placed, part.source.get(), part.part.get()});
  }
  return parts;
}

}  // namespace marrow
