#include "document/history.h"

#include <utility>

namespace marrow {

History::History(Document first) { steps_.push_back({std::move(first), {}}); }

const Document& History::current() const { return steps_[cursor_].document; }

void History::push(Document next, std::string name) {
  steps_.resize(cursor_ + 1);
  steps_.push_back({std::move(next), std::move(name)});
  if (steps_.size() > kSteps + 1) steps_.pop_front();
  cursor_ = steps_.size() - 1;
}

bool History::canUndo() const { return cursor_ > 0; }

bool History::canRedo() const { return cursor_ + 1 < steps_.size(); }

std::string History::undoName() const { return canUndo() ? steps_[cursor_].name : std::string(); }

std::string History::redoName() const {
  return canRedo() ? steps_[cursor_ + 1].name : std::string();
}

void History::undo() {
  if (canUndo()) --cursor_;
}

void History::redo() {
  if (canRedo()) ++cursor_;
}

}  // namespace marrow
