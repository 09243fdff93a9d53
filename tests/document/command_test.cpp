#include "document/command.h"

#include <limits>

#include "io/document_json.h"
#include "support/catch.h"
#include "support/drawings.h"

using namespace marrow;

namespace {

Document must(Result<Document> result) {
  REQUIRE(result);
  return *result;
}

}  // namespace

TEST_CASE("command: drawn parts get ids, names and colours in turn", "[command]") {
  const Document document = drawnDocument(3);
  REQUIRE(document.parts.size() == 3);
  for (size_t i = 0; i < 3; ++i) {
    const PartSource& part = *document.parts[i];
    REQUIRE(part.id == "part-" + std::to_string(i + 1));
    REQUIRE(part.name == "Part " + std::to_string(i + 1));
    REQUIRE(part.color == partColor(i));
    REQUIRE(part.thickness == 1);
    REQUIRE_FALSE(part.refine.simplify);
    REQUIRE(document.find(part.id) == i);
  }
  REQUIRE_FALSE(document.find("part-4"));
}

TEST_CASE("command: the id of a deleted part is never given again", "[command]") {
  Document document = drawnDocument(3);
  document = must(apply(document, DeleteParts{{"part-3"}}));
  document = must(apply(document, AddPart{softStar(3, 50)}));
  REQUIRE(document.parts.back()->id == "part-4");
  for (const char* id : {"part-1", "part-2", "part-4"}) {
    document = must(apply(document, DeleteParts{{id}}));
  }
  REQUIRE(document.parts.empty());

  SECTION("not even after saving and opening") {
    document = must(readDocument(writeDocument(document)));
  }
  document = must(apply(document, AddPart{softStar(3, 50)}));
  REQUIRE(document.parts.back()->id == "part-5");
}

TEST_CASE("command: a stroke that encloses nothing is refused, with the reason", "[command]") {
  const Document document = drawnDocument(1);
  REQUIRE(apply(document, AddPart{}).status() == Status::tooFewPoints);
  REQUIRE(apply(document, AddPart{{{1, 2}, {3, 4}, {1, 2}}}).status() == Status::tooFewPoints);
  REQUIRE(apply(document, AddPart{{{0, 0}, {1, 1}, {3, 3}}}).status() == Status::noArea);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = apply(document, AddPart{{{0, 0}, {nan, 5}, {5, 0}, {0, HUGE_VAL}}});
  REQUIRE(refused.status() == Status::tooFewPoints);
  REQUIRE(refused.message() == toSentence(Status::tooFewPoints));
}

TEST_CASE("command: samples that cannot be drawn are left out of a part", "[command]") {
  std::vector<Vec2> stroke = softStar(4, 80);
  const std::vector<Vec2> clean = stroke;
  stroke.insert(stroke.begin() + 5, {std::numeric_limits<double>::quiet_NaN(), 0});
  stroke.push_back({0, HUGE_VAL});
  REQUIRE(must(apply({}, AddPart{stroke})).parts[0]->stroke == clean);
}

TEST_CASE("command: a command leaves the given document and the other parts alone", "[command]") {
  const Document before = drawnDocument(3);
  const std::string text = writeDocument(before);
  const std::vector<Command> commands = {
      AddPart{softStar(3, 30)},           DeleteParts{{"part-2"}},
      SetThickness{{"part-2"}, 2.5},      simplify("part-2", 12.0),
      SetColor{{"part-2"}, {1, 2, 3}},    RenamePart{"part-2", "Head"},
      ReplaceDocument{{}, "New drawing"},
  };
  for (const Command& command : commands) {
    const Document after = must(apply(before, command));
    REQUIRE(writeDocument(before) == text);
    REQUIRE(writeDocument(after) != text);
    for (const auto& part : after.parts) {
      const auto old = before.find(part->id);
      if (old && part->id != "part-2") REQUIRE(part == before.parts[*old]);
    }
  }
}

TEST_CASE("command: settings out of range are brought into it", "[command]") {
  const Document document = drawnDocument(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto thickness = [&](double wanted) {
    return must(apply(document, SetThickness{{"part-1"}, wanted})).parts[0]->thickness;
  };
  REQUIRE(thickness(0.5) == 0.5);
  REQUIRE(thickness(-3) == kMinThickness);
  REQUIRE(thickness(1e300) == kMaxThickness);
  REQUIRE(thickness(HUGE_VAL) == kMaxThickness);
  REQUIRE(thickness(nan) == kMinThickness);
  const auto epsilon_s = [&](std::optional<double> wanted) {
    return must(apply(document, simplify("part-1", wanted))).parts[0]->refine.simplify;
  };
  REQUIRE(epsilon_s(7.0) == 7.0);
  REQUIRE(epsilon_s(-7.0) == 0);
  REQUIRE(epsilon_s(HUGE_VAL) == Refinement::kLargest);
  REQUIRE(epsilon_s(nan) == 0);
  REQUIRE_FALSE(epsilon_s(std::nullopt));
}

TEST_CASE("command: a change that changes nothing keeps the part itself", "[command]") {
  const Document before = drawnDocument(2);
  const PartSource& part = *before.parts[0];
  const std::vector<Command> commands = {
      SetThickness{{part.id}, part.thickness}, simplify(part.id, part.refine.simplify),
      SetColor{{part.id}, part.color}, RenamePart{part.id, part.name}, RenamePart{part.id, ""}};
  for (const Command& command : commands) {
    REQUIRE(must(apply(before, command)).parts[0] == before.parts[0]);
  }
}

TEST_CASE("command: a part that is not there is not found", "[command]") {
  const Document document = drawnDocument(1);
  const std::vector<Command> commands = {DeleteParts{{"part-9"}}, SetThickness{{""}, 1},
                                         simplify("Part 1", 1.0), SetColor{{"part-10"}, {}},
                                         RenamePart{"part", "x"}};
  for (const Command& command : commands) {
    const auto result = apply(document, command);
    REQUIRE(result.status() == Status::notFound);
    REQUIRE(result.message().find('\n') == std::string::npos);
    REQUIRE_FALSE(describe(document, command).empty());
  }
}

TEST_CASE("command: steps are named for the menu", "[command]") {
  Document document = drawnDocument(3);
  REQUIRE(describe(document, AddPart{}) == "Draw part 4");
  REQUIRE(describe(document, DeleteParts{{"part-3"}}) == "Delete part 3");
  REQUIRE(describe(document, SetThickness{{"part-3"}, 2}) == "Thickness of part 3");
  REQUIRE(describe(document, simplify("part-3", 2.0)) == "Simplify part 3");
  REQUIRE(describe(document, SetColor{{"part-3"}, {}}) == "Colour of part 3");
  REQUIRE(describe(document, RenamePart{"part-3", "Tail"}) == "Rename part 3");
  REQUIRE(describe(document, ReplaceDocument{{}, "Open"}) == "Open");
  document = must(apply(document, RenamePart{"part-3", "Tail"}));
  REQUIRE(describe(document, DeleteParts{{"part-3"}}) == "Delete Tail");
  document = must(apply(document, DeleteParts{{"part-3"}}));
  REQUIRE(describe(document, AddPart{}) == "Draw part 4");
}
