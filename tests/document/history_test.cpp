#include "document/history.h"

#include "document/command.h"
#include "io/document_json.h"
#include "support/catch.h"
#include "support/drawings.h"

using namespace marrow;

TEST_CASE("history: there is nothing to undo or redo at first", "[history]") {
  History history;
  REQUIRE_FALSE(history.canUndo());
  REQUIRE_FALSE(history.canRedo());
  REQUIRE(history.undoName().empty());
  REQUIRE(history.redoName().empty());
  history.undo();
  history.redo();
  REQUIRE(history.current().parts.empty());
}

TEST_CASE("history: undo and redo restore every document byte for byte", "[history]") {
  History history;
  std::vector<std::string> texts{writeDocument(history.current())};
  const std::vector<Command> commands = {
      AddPart{softStar(3, 50)},         AddPart{softStar(4, 70, {200, 0})},
      SetThickness{{"part-1"}, 1.5},    simplify("part-2", 9.0),
      SetColor{{"part-1"}, {9, 8, 7}},  RenamePart{"part-1", "Head"},
      DeleteParts{{"part-2"}},          AddPart{softStar(5, 60)},
      simplify("part-3", std::nullopt), ReplaceDocument{{}, "New drawing"},
  };
  std::vector<std::string> names;
  for (const Command& command : commands) {
    auto next = apply(history.current(), command);
    REQUIRE(next);
    names.push_back(describe(history.current(), command));
    history.push(*next, names.back());
    texts.push_back(writeDocument(history.current()));
  }
  for (size_t i = commands.size(); i-- > 0;) {
    REQUIRE(history.undoName() == names[i]);
    history.undo();
    REQUIRE(history.redoName() == names[i]);
    REQUIRE(writeDocument(history.current()) == texts[i]);
  }
  REQUIRE_FALSE(history.canUndo());
  for (size_t i = 0; i < commands.size(); ++i) {
    history.redo();
    REQUIRE(writeDocument(history.current()) == texts[i + 1]);
  }
  REQUIRE_FALSE(history.canRedo());
}

TEST_CASE("history: undo brings back the parts themselves", "[history]") {
  History history(drawnDocument(2));
  const auto parts = history.current().parts;
  history.push(*apply(history.current(), SetThickness{{"part-2"}, 3}), "Thickness");
  REQUIRE(history.current().parts[0] == parts[0]);
  history.undo();
  REQUIRE(history.current().parts == parts);
}

TEST_CASE("history: a new step forgets what was undone", "[history]") {
  History history(drawnDocument(3));
  history.push(*apply(history.current(), DeleteParts{{"part-1"}}), "Delete part 1");
  history.push(*apply(history.current(), DeleteParts{{"part-2"}}), "Delete part 2");
  history.undo();
  history.undo();
  history.push(*apply(history.current(), DeleteParts{{"part-3"}}), "Delete part 3");
  REQUIRE_FALSE(history.canRedo());
  REQUIRE(history.undoName() == "Delete part 3");
  history.undo();
  REQUIRE(history.current().parts.size() == 3);
  REQUIRE_FALSE(history.canUndo());
}

TEST_CASE("history: a thousand steps can be undone, and no more", "[history]") {
  History history;
  for (size_t i = 0; i < History::kSteps + 234; ++i) {
    Document next;
    next.last_part = i + 1;
    history.push(next, std::to_string(i));
  }
  size_t undone = 0;
  for (; history.canUndo(); ++undone) history.undo();
  REQUIRE(undone == History::kSteps);
  REQUIRE(history.current().last_part == 234);
  for (size_t i = 0; i < undone; ++i) history.redo();
  REQUIRE(history.current().last_part == History::kSteps + 234);
}
