#include "figure/figure_keeper.h"

#include <utility>

#include "figure/workshop.h"

namespace marrow {
void FigureKeeper::see(const Document& document, const Evaluation& evaluation, double now_ms) {
  const Keys now{partsKey(evaluation), meshKey(document, evaluation), bodyKey(document, evaluation),
                 strokesKey(document)};
  if (now.body != wanted_.body) changed_ms_ = now_ms;
  if (!(now == wanted_)) failure_.clear();
  wanted_ = now;
  shown_ = made_ && of_.parts == wanted_.parts ? made_ : nullptr;
}

std::optional<WorkOrder> FigureKeeper::update(const Document& document, bool busy, bool posing,
                                              double now_ms) {
  due_ms_ = std::numeric_limits<double>::infinity();
  if (number_ != 0 && begun_.body != wanted_.body) {
    number_ = 0;
    begun_ = {};
    return WorkOrder{};
  }
  if (number_ != 0 || wanted_.body == 0 || !failure_.empty() || ready()) return std::nullopt;
  // Other strokes over the same weights take no time to speak of.
  const bool only_painted = shown_ && of_.body == wanted_.body && !shown_->guessed;
  if (!only_painted) {
    if (busy) return std::nullopt;
    const double begin_ms = changed_ms_ + (posing ? kCalmWhilePosing_ms : kCalm_ms);
    if (now_ms < begin_ms) {
      due_ms_ = begin_ms;
      return std::nullopt;
    }
  }
  begun_ = wanted_;
  done_ = 0;
  number_ = ++ordered_;
  return WorkOrder{number_, figureRequest(document)};
}

void FigureKeeper::made(uint64_t number, const std::string& bytes) {
  if (number != number_ || number == 0) return;
  auto figure = figureFromBytes(bytes);
  if (!figure) {
    failure_ = figure.message();
    return;
  }
  const bool is_same_mesh = made_ && of_.mesh == begun_.mesh;
  // The weights of the rig before are better than a guess of the new ones.
  if (figure->guessed && is_same_mesh && !made_->guessed) return;
  made_ = std::make_shared<const Figure>(std::move(*figure));
  outermost_ = marrow::outermost(*made_);
  of_ = begun_;
  ++mesh_id_;
  shown_ = of_.parts == wanted_.parts ? made_ : nullptr;
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
