#include "document/command.h"

#include <limits>
#include <map>

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

TEST_CASE("command: steps of every kind have names of their own", "[command]") {
  Document document = drawnDocument(3);
  document = must(apply(document, RenamePart{"part-2", "Leg"}));
  const auto name = [&](const Command& command) { return describe(document, command); };
  const auto merge = &Refinement::merge, prune = &Refinement::prune;
  Reference reference;
  reference.image = std::make_shared<const std::string>("data:image/png;base64,AAAA");
  const std::pair<std::string, Command> names[] = {
      {"Move Leg", TransformParts{{"part-2"}, {}}},
      {"Turn Leg", TransformParts{{"part-2", "part-2:twin"}, {}, "Turn"}},
      {"Scale 2 parts", TransformParts{{"part-2", "part-1"}, {}, "Scale"}},
      {"Delete 3 parts", DeleteParts{{"part-1", "part-2", "part-3"}}},
      {"Duplicate Leg", DuplicateParts{{"part-2"}, {}}},
      {"Hide Leg", SetVisible{{"part-2"}, false}},
      {"Show Leg", SetVisible{{"part-2"}, true}},
      {"Lock Leg", SetLocked{{"part-2"}, true}},
      {"Unlock Leg", SetLocked{{"part-2"}, false}},
      {"No skeleton for Leg", SetSkeleton{{"part-2"}, false}},
      {"Skeleton for Leg", SetSkeleton{{"part-2"}, true}},
      {"Reshape Leg", SetStroke{"part-2", {}}},
      {"Mirror Leg", SetMirror{{"part-2"}, Plane{}}},
      {"No mirror for Leg", SetMirror{{"part-2"}, {}}},
      {"Separate twins of Leg", SeparateTwins{{"part-2"}}},
      {"Set symmetry plane", SetSymmetry{Plane{}}},
      {"Remove symmetry plane", SetSymmetry{}},
      {"Merge joints everywhere", SetRefinement{{}, "", merge, 5}},
      {"Merge joints of Leg", SetRefinement{{"part-2"}, "", merge, 5}},
      {"Prune 2 parts", SetRefinement{{"part-2", "part-3"}, "", prune, 5}},
      {"Simplify a branch of Leg", SetRefinement{{"part-2"}, "b0", &Refinement::simplify, 5}},
      {"Reset refinement", ResetRefinement{}},
      {"Reset refinement of Leg", ResetRefinement{{"part-2"}, "", false}},
      {"Attach Leg to part 1", SetAttachment{"part-2", Attachment{"part-1", {}}}},
      {"Detach Leg", SetAttachment{"part-2", Attachment{}}},
      {"Attach Leg by itself", SetAttachment{"part-2", {}}},
      {"Begin at Leg", SetRoot{"part-2", {}}},
      {"Add picture", SetReference{reference}},
      {"Remove picture", SetReference{}}};
  for (const auto& [expected, command] : names) REQUIRE(name(command) == expected);
  document = must(apply(document, SetReference{reference}));
  REQUIRE(name(SetReference{reference}) == "Change picture");
}

TEST_CASE("command: what is locked stays until it is unlocked", "[command]") {
  Document document = drawnDocument(2);
  document = must(apply(document, RenamePart{"part-2", "Leg\n2"}));
  document = must(apply(document, SetLocked{{"part-2"}, true}));
  const Command commands[] = {DeleteParts{{"part-2"}},
                              TransformParts{{"part-2"}, {}},
                              SetThickness{{"part-2"}, 2},
                              SetColor{{"part-2"}, {1, 2, 3}},
                              SetSkeleton{{"part-2"}, false},
                              SetStroke{"part-2", softStar(3, 30)},
                              SetMirror{{"part-2"}, Plane{}},
                              SeparateTwins{{"part-2"}},
                              simplify("part-2", 3),
                              ResetRefinement{{"part-2"}, ""},
                              SetAttachment{"part-2", Attachment{}}};
  for (const Command& command : commands) {
    const auto refused = apply(document, command);
    REQUIRE(refused.status() == Status::locked);
    REQUIRE(refused.message() == "Leg 2 is locked. Unlock it to change it.");
  }
  const Document one_left = must(apply(document, DeleteParts{{"part-1", "part-2"}}));
  REQUIRE(one_left.parts.size() == 1);
  REQUIRE(one_left.parts[0] == document.parts[1]);
  REQUIRE_FALSE(must(apply(document, SetVisible{{"part-2"}, false})).parts[1]->visible);
  document = must(apply(document, SetLocked{{"part-1", "part-2"}, true}));
  REQUIRE(apply(document, DeleteParts{{"part-1", "part-2"}}).message() ==
          "These parts are locked. Unlock them to change them.");
  document = must(apply(document, SetLocked{{"part-1", "part-2"}, false}));
  REQUIRE(must(apply(document, DeleteParts{{"part-1", "part-2"}})).parts.empty());
}

TEST_CASE("command: a threshold is set where it is asked for, and reset with all within",
          "[command]") {
  Document document = drawnDocument(2);
  document = must(apply(document, SetRefinement{{}, "", &Refinement::prune, 40}));
  document = must(apply(document, SetRefinement{{"part-1"}, "", &Refinement::collapse, 1e9}));
  document = must(apply(document, SetRefinement{{"part-1"}, "b1", &Refinement::simplify, 7}));
  document = must(apply(document, SetRefinement{{"part-1"}, "b2", &Refinement::simplify, 8}));
  document = must(apply(document, SetRefinement{{"part-1"}, "b2", &Refinement::merge, 9}));
  REQUIRE(document.refine.prune == 40);
  REQUIRE(document.parts[0]->refine.collapse == Refinement::kLargest);
  REQUIRE(document.parts[0]->branches == std::map<std::string, double>{{"b1", 7}, {"b2", 8}});
  REQUIRE(document.parts[1]->refine == Refinement{});

  const Document branch = must(apply(document, ResetRefinement{{"part-1"}, "b1", false}));
  REQUIRE(branch.parts[0]->branches == std::map<std::string, double>{{"b2", 8}});
  const Document part = must(apply(document, ResetRefinement{{"part-1"}, "", false}));
  REQUIRE(part.parts[0]->refine == Refinement{});
  REQUIRE(part.parts[0]->branches.size() == 2);
  REQUIRE(must(apply(document, ResetRefinement{{"part-1"}, "", true})).parts[0]->branches.empty());
  const Document model = must(apply(document, ResetRefinement{}));
  REQUIRE(model.refine == Refinement{});
  REQUIRE(model.parts == document.parts);
  const Document all = must(apply(document, ResetRefinement{{}, "", true}));
  REQUIRE(all.refine == Refinement{});
  REQUIRE(all.parts[0]->refine == Refinement{});
  REQUIRE(all.parts[0]->branches.empty());
  REQUIRE(all.parts[1] == document.parts[1]);
}

TEST_CASE("command: no more branches can be set apart than can be saved", "[command]") {
  Document document = drawnDocument(1);
  const auto set = [&](size_t branch) {
    return apply(document,
                 SetRefinement{{"part-1"}, "b" + std::to_string(branch), &Refinement::simplify, 5});
  };
  for (size_t i = 0; i < PartSource::kMostBranches; ++i) document = must(set(i));
  REQUIRE(set(PartSource::kMostBranches).status() == Status::tooMany);
  REQUIRE(set(7));
  REQUIRE(readDocument(writeDocument(document)));
}
