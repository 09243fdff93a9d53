#include "document/evaluation.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "rig/connect.h"

namespace marrow {
namespace {

/// Whether nothing changed that decides where parts hang.
bool hangsAsBefore(const EvaluatedPart& before, const EvaluatedPart& now) {
  const PartSource &was = *before.source, &is = *now.source;
  return was.id == is.id && before.part == now.part && was.frame == is.frame &&
         was.mirror == is.mirror && was.skeleton == is.skeleton && was.attachment == is.attachment;
}

using SharedMesh = std::shared_ptr<const Mesh>;
bool isSameMesh(const SharedMesh& a, const SharedMesh& b) {
  return a == b || (a && b && a->positions == b->positions && a->triangles == b->triangles);
}

}  // namespace

Evaluation::Evaluation(PartOptions options, Clock clock)
    : options_(std::move(options)), clock_(clock) {}

void Evaluation::update(const Document& document) {
  std::unordered_map<std::string_view, const EvaluatedPart*> before;
  for (const EvaluatedPart& part : parts_) before.emplace(part.source->id, &part);

  recomputed_ = 0;
  timings_ = {};
  std::vector<EvaluatedPart> parts;
  parts.reserve(document.parts.size());
  bool same_places = rig_id_ > 0 && parts_.size() == document.parts.size();
  bool same = same_places && refine_ == document.refine;
  for (const auto& source : document.parts) {
    const auto found = before.find(source->id);
    parts.push_back(evaluate(source, found == before.end() ? nullptr : found->second));
    if (same) same = parts_[parts.size() - 1].source == source;
    if (same_places) same_places = hangsAsBefore(parts_[parts.size() - 1], parts.back());
  }
  parts_ = std::move(parts);
  if (!same) updateRig(document, same_places);
}

EvaluatedPart Evaluation::evaluate(const std::shared_ptr<const PartSource>& source,
                                   const EvaluatedPart* before) {
  if (!before) return rebuild(source);
  if (source == before->source) return *before;
  if (source->stroke != before->source->stroke || !isSameMesh(source->mesh, before->source->mesh)) {
    return rebuild(source);
  }

  EvaluatedPart next = *before;
  next.source = source;
  if (source->thickness == before->source->thickness || !before->part) return next;
  ++recomputed_;
  next.mesh_id = next_id_++;
  next.skeleton_id = next_id_++;
  next.part = std::make_shared<const Part>(withThickness(*next.part, source->thickness, clock_));
  timings_.add(next.part->timings);
  addTwin(next);
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
  auto part = source->mesh ? importPart(*source->mesh, source->stroke, options, clock_)
                           : buildPart(source->stroke, options, clock_);
  if (part) {
    timings_.add(part->timings);
    next.part = std::make_shared<const Part>(std::move(*part));
    addTwin(next);
  } else {
    next.error = part.error();
  }
  return next;
}

void Evaluation::addTwin(EvaluatedPart& evaluated) {
  if (!evaluated.part->imported) return;
  evaluated.twin = std::make_shared<const Part>(flipped(*evaluated.part));
  evaluated.twin_mesh_id = next_id_++;
}

void Evaluation::updateRig(const Document& document, bool same_places) {
  placed_ = placedParts(document);
  refine_ = document.refine;
  Timings timings;
  Stopwatch watch(clock_, timings);
  const std::vector<RigPart> parts = rigParts();
  if (!same_places) connections_ = connectParts(parts);
  watch.lap("connection");
  Rig rig = refineRig(parts, connections_, refine_);
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
    parts.push_back({&placed, part.source.get(), part.shapeOf(placed).get()});
  }
  return parts;
}

}  // namespace marrow
