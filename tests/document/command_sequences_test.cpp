// What holds for any sequence of commands on any creature.
#include <map>

#include "document/history.h"
#include "io/document_json.h"
#include "support/catch.h"
#include "support/commands.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

Command anyCommand(Random& random, const Document& document) {
  TameNumbers numbers(random);
  return AnyCommand<TameNumbers>(numbers, document)();
}

bool mayChangeLocked(const Command& command) {
  return std::holds_alternative<SetLocked>(command.step) ||
         std::holds_alternative<SetVisible>(command.step) ||
         std::holds_alternative<RenamePart>(command.step) ||
         std::holds_alternative<SetRoot>(command.step) ||
         std::holds_alternative<ReplaceDocument>(command.step);
}

}  // namespace

TEST_CASE("commands: every one gives a sound document and leaves the given one alone",
          "[command_sequences]") {
  Random random(1);
  std::map<size_t, int> done;
  for (int run = 0; run < 40; ++run) {
    Document document = randomCreature(random, 2 + random.below(20), {20});
    for (int step = 0; step < 60; ++step) {
      const Command command = anyCommand(random, document);
      const std::string before = writeDocument(document);
      const auto next = apply(document, command);
      CAPTURE(run, step, describe(document, command));
      REQUIRE(writeDocument(document) == before);
      REQUIRE_FALSE(describe(document, command).empty());
      if (!next) {
        REQUIRE(next.message().find('\n') == std::string::npos);
        REQUIRE(next.message().back() == '.');
        continue;
      }
      ++done[command.step.index()];
      REQUIRE(faultOf(*next) == "");
      document = *next;
    }
  }
  REQUIRE(done.size() == std::variant_size_v<Command::Step>);
}

TEST_CASE("commands: undoing any sequence gives the first document back, byte for byte",
          "[command_sequences]") {
  Random random(2);
  for (int run = 0; run < 12; ++run) {
    History history(randomCreature(random, 2 + run * 5, {20}));
    std::vector<std::string> texts{writeDocument(history.current())};
    while (texts.size() < 60) {
      const Command command = anyCommand(random, history.current());
      const auto next = apply(history.current(), command);
      if (!next) continue;
      history.push(*next, describe(history.current(), command));
      texts.push_back(writeDocument(*next));
    }
    for (size_t i = texts.size(); i-- > 1;) {
      REQUIRE(writeDocument(history.current()) == texts[i]);
      history.undo();
    }
    REQUIRE(writeDocument(history.current()) == texts[0]);
    REQUIRE_FALSE(history.canUndo());
    for (size_t i = 1; i < texts.size(); ++i) {
      history.redo();
      REQUIRE(writeDocument(history.current()) == texts[i]);
    }
  }
}

TEST_CASE("commands: a document that was saved and opened goes on in the same way",
          "[command_sequences]") {
  Random random(3);
  for (int run = 0; run < 12; ++run) {
    Document document = randomCreature(random, 2 + random.below(20), {20});
    for (int step = 0; step < 30; ++step) {
      const auto opened = readDocument(writeDocument(document));
      REQUIRE(opened);
      const Command command = anyCommand(random, document);
      const auto next = apply(document, command), same = apply(*opened, command);
      REQUIRE(static_cast<bool>(next) == static_cast<bool>(same));
      REQUIRE(next.message() == same.message());
      REQUIRE(describe(document, command) == describe(*opened, command));
      if (!next) continue;
      REQUIRE(writeDocument(*next) == writeDocument(*same));
      document = *next;
    }
  }
}

TEST_CASE("commands: no command but a few changes a locked part, and none deletes it",
          "[command_sequences]") {
  Random random(4);
  int refused = 0;
  for (int run = 0; run < 30; ++run) {
    Document document = randomCreature(random, 2 + random.below(10), {20});
    for (const auto& part : document.parts) {
      if (random.below(2)) document = *apply(document, SetLocked{{part->id}, true});
    }
    for (int step = 0; step < 60; ++step) {
      const Command command = anyCommand(random, document);
      if (mayChangeLocked(command)) continue;
      const auto next = apply(document, command);
      CAPTURE(describe(document, command));
      if (!next) {
        refused += next.status() == Status::locked ? 1 : 0;
        continue;
      }
      for (const auto& part : document.parts) {
        if (!part->locked) continue;
        const auto index = next->find(part->id);
        REQUIRE(index);
        PartSource after = *next->parts[*index];
        // A part that it hung on became two.
        if (std::holds_alternative<SeparateTwins>(command.step))
          after.attachment = part->attachment;
        Document alone, alone_after;
        alone.parts.push_back(part);
        alone_after.parts.push_back(std::make_shared<const PartSource>(after));
        REQUIRE(writeDocument(alone_after) == writeDocument(alone));
      }
      document = *next;
    }
  }
  REQUIRE(refused > 50);
}

TEST_CASE("commands: parts that a command does not change are shared", "[command_sequences]") {
  Random random(5);
  for (int run = 0; run < 300; ++run) {
    const Document document = randomCreature(random, 2 + random.below(10), {20});
    const Command command = anyCommand(random, document);
    if (std::holds_alternative<ReplaceDocument>(command.step)) continue;
    const auto next = apply(document, command);
    if (!next) continue;
    CAPTURE(describe(document, command));
    for (const auto& part : next->parts) {
      const auto before = document.find(part->id);
      if (!before || document.parts[*before] == part) continue;
      Document alone, alone_before;
      alone.parts.push_back(part);
      alone_before.parts.push_back(document.parts[*before]);
      REQUIRE(writeDocument(alone) != writeDocument(alone_before));
    }
  }
}
