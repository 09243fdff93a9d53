#include "figure/figure_keeper.h"

#include <utility>

#include "document/symmetry.h"
#include "figure/work.h"
#include "render/scene.h"

namespace marrow {
namespace {

uint64_t mixed(uint64_t seed, const std::string& text) {
  return fingerprint(text.data(), text.size(), seed);
}

/// Of all that the mesh is made of; 0 where nothing is shown.
uint64_t meshKey(const Evaluation& evaluation) {
  uint64_t key = 0;
  for (const PlacedPart& placed : evaluation.placed()) {
    const EvaluatedPart& part = evaluation.parts()[placed.source];
    if (!part.part || !part.source->visible) continue;
    key = mixed(fingerprint(&part.mesh_id, sizeof part.mesh_id, key + 1), placed.id);
    key = fingerprint(&placed.frame, sizeof placed.frame, key);
  }
  return key;
}

/// Of what the weights depend on besides.
uint64_t rigKey(uint64_t mesh_key, const Document& document, const Evaluation& evaluation) {
  uint64_t key = mesh_key;
  for (const Rig::Joint& joint : evaluation.rig().joints) {
    key = mixed(fingerprint(&joint.position, sizeof joint.position, key), joint.id);
    key = fingerprint(&joint.parent, sizeof joint.parent, key);
  }
  if (const auto plane = symmetryPlane(document)) key = fingerprint(&*plane, sizeof *plane, key);
  return key;
}

}  // namespace

void FigureKeeper::see(const Document& document, const Evaluation& evaluation, double now_ms) {
  const uint64_t mesh = meshKey(evaluation);
  const uint64_t rig = mesh == 0 ? 0 : rigKey(mesh, document, evaluation);
  if (rig != wanted_rig_) {
    wanted_mesh_ = mesh;
    wanted_rig_ = rig;
    changed_ms_ = now_ms;
    failure_.clear();
  }
  shown_ = made_ && of_mesh_ == wanted_mesh_ ? made_ : nullptr;
}

std::optional<FigureKeeper::Order> FigureKeeper::update(const Document& document, bool busy,
                                                        bool posing, double now_ms) {
  due_ms_ = std::numeric_limits<double>::infinity();
  const bool is_stale = number_ != 0 && begun_ != wanted_rig_;
  if (wanted_rig_ == 0 || ready() || begun_ == wanted_rig_ || busy) {
    if (!is_stale) return std::nullopt;
    number_ = begun_ = 0;
    return Order{};
  }
  const double begin_ms = changed_ms_ + (posing ? kCalmWhilePosing_ms : kCalm_ms);
  if (now_ms < begin_ms) {
    due_ms_ = begin_ms;
    if (!is_stale) return std::nullopt;
    number_ = begun_ = 0;
    return Order{};
  }
  begun_ = wanted_rig_;
  begun_mesh_ = wanted_mesh_;
  done_ = 0;
  number_ = ++ordered_;
  return Order{number_, figureRequest(document)};
}

void FigureKeeper::made(uint64_t number, const std::string& bytes) {
  if (number != number_ || number == 0) return;
  auto figure = figureFromBytes(bytes);
  if (!figure) {
    failure_ = figure.message();
    return;
  }
  const bool is_same_mesh = made_ && of_mesh_ == begun_mesh_ && of_rig_ != begun_;
  // The weights of the rig before are better than a guess of the new ones.
  if (figure->guessed && is_same_mesh && !made_->guessed) return;
  made_ = std::make_shared<const Figure>(std::move(*figure));
  of_mesh_ = begun_mesh_;
  of_rig_ = begun_;
  ++mesh_id_;
  shown_ = of_mesh_ == wanted_mesh_ ? made_ : nullptr;
}

void FigureKeeper::progress(uint64_t number, double done) {
  if (number == number_) done_ = done;
}

void FigureKeeper::ended(uint64_t number, const std::string& why) {
  if (number != number_ || number == 0) return;
  number_ = 0;
  if (!why.empty()) failure_ = why;
}

}  // namespace marrow
