#include "document/evaluation.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
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

constexpr size_t kFull = 64;  // parts, the first ones, that have all their points

uint64_t mixed(uint64_t hash, Vec3 p) { return mixed(mixed(mixed(hash, p.x), p.y), p.z); }

/// One per part. Parts of the same shape in the same place count as one.
std::vector<int> pointsOfParts(const Document& document, int full) {
  const size_t count = document.parts.size();
  std::vector<int> points(count, full);
  if (count <= kFull) return points;
  struct Copies {
    std::vector<size_t> parts, places;  // places: one of each, by their number
  };
  std::unordered_map<uint64_t, Copies> by_shape;
  std::unordered_set<uint64_t> places;
  for (size_t i = 0; i < count; ++i) {
    const PartSource& part = *document.parts[i];
    const uint64_t shape = hashOfShape(part);
    Copies& copies = by_shape[shape];
    copies.parts.push_back(i);
    const Frame& frame = part.frame;
    const uint64_t place = mixed(mixed(mixed(shape, frame.origin), frame.x), frame.y);
    if (places.insert(place).second) copies.places.push_back(places.size() - 1);
  }
  for (const auto& [shape, copies] : by_shape) {
    if (document.parts[copies.parts[0]]->mesh) continue;
    const int own = pointsOfPart(copies.places[(copies.places.size() - 1) / 2], full);
    for (const size_t i : copies.parts) points[i] = own;
  }
  return points;
}

}  // namespace

int pointsOfPart(size_t index, int full) {
  int points = index < kFull ? full : full / 4;
  for (size_t end = 2 * kFull; index >= end; end *= 2) points /= 2;
  return std::max(points, std::min(full, TriangulationOptions::kFewest));
}

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
  const std::vector<int> points = pointsOfParts(document, options_.triangulation.target_points);
  for (const auto& source : document.parts) {
    const auto found = before.find(source->id);
    parts.push_back(
        evaluate(source, points[parts.size()], found == before.end() ? nullptr : found->second));
    if (same) same = parts_[parts.size() - 1].source == source;
    if (same_places) same_places = hangsAsBefore(parts_[parts.size() - 1], parts.back());
  }
  parts_ = std::move(parts);
  known_.clear();
  if (!same) updateRig(document, same_places);
}

EvaluatedPart Evaluation::evaluate(const std::shared_ptr<const PartSource>& source, int points,
                                   const EvaluatedPart* before) {
  if (!before || before->points != points) return rebuild(source, points);
  if (source == before->source) return *before;
  if (!isSameShape(*source, *before->source)) return rebuild(source, points);

  EvaluatedPart next = *before;
  next.source = source;
  if (source->thickness == before->source->thickness || !before->part) return next;
  return rebuild(source, points);
}

EvaluatedPart Evaluation::rebuild(const std::shared_ptr<const PartSource>& source, int points) {
  const EvaluatedPart* like = findLike(*source, points);
  EvaluatedPart next;
  if (like) next = *like;
  next.source = source;
  next.points = points;
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
    options.triangulation.target_points = points;
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
const EvaluatedPart* Evaluation::findLike(const PartSource& source, int points) {
  if (known_.empty()) {
    for (const EvaluatedPart& part : parts_) remember(part);
  }
  const uint64_t shape = mixed(hashOfShape(source), points);
  const EvaluatedPart* same = findKnown(source, points, mixed(shape, source.thickness), true);
  return same ? same : findKnown(source, points, shape, false);
}

const EvaluatedPart* Evaluation::findKnown(const PartSource& source, int points, uint64_t hash,
                                           bool of_thickness) const {
  const auto [first, end] = known_.equal_range(hash);
  for (auto at = first; at != end; ++at) {
    const EvaluatedPart& one = at->second;
    if (one.points != points) continue;
    if (of_thickness && one.source->thickness != source.thickness) continue;
    if (isSameShape(*one.source, source)) return &one;
  }
  return nullptr;
}

/// One of each shape and one of each thickness of it are enough.
void Evaluation::remember(const EvaluatedPart& part) {
  const PartSource& source = *part.source;
  const uint64_t shape = mixed(hashOfShape(source), part.points);
  const uint64_t body = mixed(shape, source.thickness);
  if (!findKnown(source, part.points, shape, false)) known_.emplace(shape, part);
  if (!findKnown(source, part.points, body, true)) known_.emplace(body, part);
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
