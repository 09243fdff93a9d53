// Undo and redo: documents and a cursor, no inverse operations anywhere.
#pragma once

#include <deque>
#include <string>

#include "document/document.h"

namespace marrow {

class History {
 public:
  static constexpr size_t kSteps = 1000;  // that can be undone; older ones are forgotten

  explicit History(Document first = {});

  const Document& current() const;
  /// Makes `next` current and forgets what was undone.
  void push(Document next, std::string name);
  bool canUndo() const;
  bool canRedo() const;
  /// Names of the step that undo takes back and of the one that redo brings again; empty if none.
  std::string undoName() const;
  std::string redoName() const;
  void undo();
  void redo();

 private:
  struct Step {
    Document document;
    std::string name;  // of the command that led here
  };
  std::deque<Step> steps_;
  size_t cursor_ = 0;
};

}  // namespace marrow
