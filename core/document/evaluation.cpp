#include "document/evaluation.h"

#include <algorithm>
#include <cstring>
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

bool isSameShape(const PartSource& a, const PartSource& b) {
  return a.stroke == b.stroke && isSameMesh(a.mesh, b.mesh);
}

uint64_t mixed(uint64_t hash, double number) {
  number += 0.0;  // −0 is 0
  uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return (hash ^ bits ^ (bits >> 32)) * 0x100000001B3ull;
}

/// The same for parts of the same shape [FNV-1a, by words].
uint64_t hashOfShape(const PartSource& part) {
  uint64_t hash = 0xCBF29CE484222325ull;
  for (const Vec2 p : part.stroke) hash = mixed(mixed(hash, p.x), p.y);
  return part.mesh ? mixed(hash, static_cast<double>(part.mesh->positions.size())) : hash;
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
  known_.clear();
  if (!same) updateRig(document, same_places);
}

EvaluatedPart Evaluation::evaluate(const std::shared_ptr<const PartSource>& source,
                                   const EvaluatedPart* before) {
  if (!before) return rebuild(source);
  if (source == before->source) return *before;
  if (!isSameShape(*source, *before->source)) return rebuild(source);

  EvaluatedPart next = *before;
  next.source = source;
  if (source->thickness == before->source->thickness || !before->part) return next;
  return rebuild(source);
}

EvaluatedPart Evaluation::rebuild(const std::shared_ptr<const PartSource>& source) {
  const EvaluatedPart* like = findLike(*source);
  EvaluatedPart next;
  if (like) next = *like;
  next.source = source;
  next.skeleton_id = next_id_++;
  if (like && (!like->part || source->thickness == like->source->thickness)) return next;
  ++recomputed_;
  next.mesh_id = next_id_++;
  if (like) {
    next.part = std::make_shared<const Part>(withThickness(*like->part, source->thickness, clock_));
    timings_.add(next.part->timings);
    addTwin(next);
  } else {
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
  }
  remember(next);
  return next;
}

/// A part of the same shape that is there already; of the same thickness, if there is one.
const EvaluatedPart* Evaluation::findLike(const PartSource& source) {
  if (known_.empty()) {
    for (const EvaluatedPart& part : parts_) remember(part);
  }
  const uint64_t shape = hashOfShape(source);
  const EvaluatedPart* same = findKnown(source, mixed(shape, source.thickness), true);
  return same ? same : findKnown(source, shape, false);
}

const EvaluatedPart* Evaluation::findKnown(const PartSource& source, uint64_t hash,
                                           bool of_thickness) const {
  const auto [first, end] = known_.equal_range(hash);
  for (auto at = first; at != end; ++at) {
    const PartSource& one = *at->second.source;
    if (of_thickness && one.thickness != source.thickness) continue;
    if (isSameShape(one, source)) return &at->second;
  }
  return nullptr;
}

/// One of each shape and one of each thickness of it are enough.
void Evaluation::remember(const EvaluatedPart& part) {
  const PartSource& source = *part.source;
  const uint64_t shape = hashOfShape(source), body = mixed(shape, source.thickness);
  if (!findKnown(source, shape, false)) known_.emplace(shape, part);
  if (!findKnown(source, body, true)) known_.emplace(body, part);
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
