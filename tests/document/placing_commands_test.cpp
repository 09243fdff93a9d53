// Commands that place, copy and mirror parts, and hang them on each other.
#include <algorithm>

#include "io/document_json.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/drawings.h"
#include "support/soundness.h"

using namespace marrow;

namespace {

Document must(const Result<Document>& result) {
  REQUIRE(result);
  return *result;
}

const PartSource& partOf(const Document& document, const std::string& id) {
  const auto index = document.find(id);
  REQUIRE(index);
  return *document.parts[*index];
}

Frame frameOf(const Document& document, const std::string& placed_id) {
  for (const PlacedPart& placed : placedParts(document)) {
    if (placed.id == placed_id) return placed.frame;
  }
  FAIL("no " + placed_id);
  return {};
}

bool isNear(Vec3 a, Vec3 b) { return distance(a, b) < 1e-9 * (1 + length(b)); }
bool isNear(const Frame& a, const Frame& b) {
  return isNear(a.origin, b.origin) && isNear(a.x, b.x) && isNear(a.y, b.y);
}
bool isMapped(const Frame& after, const Frame& before, const Affine& map) {
  return isNear(after, {map(before.origin), map.direction(before.x), map.direction(before.y)});
}

std::vector<std::string> idsOf(const Document& document) {
  std::vector<std::string> ids;
  for (const auto& part : document.parts) ids.push_back(part->id);
  return ids;
}

const Plane kMiddle{{1, 0, 0}, 0};
const Affine kMove{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {10, 20, 30}};

}  // namespace

TEST_CASE("placing: a part's twin follows as seen in the mirror, and the other way round",
          "[placing_commands]") {
  Random random(1);
  for (int run = 0; run < 100; ++run) {
    Document document = drawnDocument(1);
    const Plane plane = randomPlane(random, {40, 0, 9});
    document = must(apply(document, SetMirror{{"part-1"}, plane}));
    const Affine map = randomSimilarity(random);
    const Frame part = frameOf(document, "part-1"), twin = frameOf(document, "part-1:twin");

    const Document by_part = must(apply(document, TransformParts{{"part-1"}, map}));
    REQUIRE(isMapped(frameOf(by_part, "part-1"), part, map));
    REQUIRE(isMapped(frameOf(by_part, "part-1:twin"), twin, mirrored(map, plane)));
    REQUIRE(by_part.parts[0]->mirror == document.parts[0]->mirror);

    const Document by_twin = must(apply(document, TransformParts{{"part-1:twin"}, map}));
    REQUIRE(isMapped(frameOf(by_twin, "part-1:twin"), twin, map));
    REQUIRE(isMapped(frameOf(by_twin, "part-1"), part, mirrored(map, plane)));
    REQUIRE(by_twin.parts[0]->mirror == document.parts[0]->mirror);

    const Ids both{"part-1:twin", "part-1"};
    const Document by_both = must(apply(document, TransformParts{both, map}));
    REQUIRE(isMapped(frameOf(by_both, "part-1"), part, map));
    REQUIRE(isMapped(frameOf(by_both, "part-1:twin"), twin, map));
  }
}

TEST_CASE("placing: a moved twin leaves the directions of both to the bit", "[placing_commands]") {
  Document document = drawnDocument(1);
  document = must(apply(document, SetMirror{{"part-1"}, Plane{{0.6, 0.8, 0}, -7}}));
  const Document moved = must(apply(document, TransformParts{{"part-1:twin"}, kMove}));
  REQUIRE(moved.parts[0]->frame.x == document.parts[0]->frame.x);
  REQUIRE(moved.parts[0]->frame.y == document.parts[0]->frame.y);
}

TEST_CASE("placing: the plane of symmetry goes along with the whole character alone",
          "[placing_commands]") {
  Document document = drawnDocument(2);
  document = must(apply(document, SetMirror{{"part-2"}, kMiddle}));
  document = must(apply(document, SetSymmetry{kMiddle}));
  const auto symmetryAfter = [&](const Document& before, const Ids& ids) {
    return must(apply(before, TransformParts{ids, kMove})).symmetry;
  };
  const Ids all{"part-1", "part-2", "part-2:twin"};
  REQUIRE(symmetryAfter(document, all) == Plane{{1, 0, 0}, -10});
  REQUIRE(symmetryAfter(document, {"part-1", "part-2"}) == kMiddle);
  REQUIRE(symmetryAfter(document, {"part-1", "part-2:twin"}) == kMiddle);
  REQUIRE(symmetryAfter(document, {"part-2", "part-2:twin"}) == kMiddle);
  const Document locked = must(apply(document, SetLocked{{"part-1"}, true}));
  REQUIRE(symmetryAfter(locked, all) == kMiddle);
  const Document without = must(apply(document, SetSymmetry{}));
  REQUIRE_FALSE(symmetryAfter(without, all));
}

TEST_CASE("placing: one part that cannot go keeps all where they are", "[placing_commands]") {
  const Document document = drawnDocument(2);
  Affine flat;
  flat.x = {};
  const auto refused = apply(document, TransformParts{{"part-1", "part-2"}, flat});
  REQUIRE(refused.status() == Status::noArea);
  REQUIRE(refused.message() == "Part 1 would be flat, or too far away.");
}

TEST_CASE("placing: copies come after their originals, with all that is set for them",
          "[placing_commands]") {
  Document document = drawnDocument(3);
  document = must(apply(document, RenamePart{"part-2", "Leg"}));
  document = must(apply(document, SetThickness{{"part-2"}, 1.5}));
  document = must(apply(document, SetMirror{{"part-2"}, kMiddle}));
  document = must(apply(document, SetLocked{{"part-2"}, true}));
  document = must(apply(document, SetAttachment{"part-3", Attachment{"part-2:twin", {1, 2}}}));
  const Document copied =
      must(apply(document, DuplicateParts{{"part-3", "part-2:twin", "part-2"}, {5, 0, 0}}));
  REQUIRE(idsOf(copied) ==
          std::vector<std::string>{"part-1", "part-2", "part-4", "part-3", "part-5"});
  const PartSource& leg = partOf(copied, "part-4");
  REQUIRE(leg.name == "Leg 2");
  REQUIRE(leg.thickness == 1.5);
  REQUIRE(leg.mirror == kMiddle);
  REQUIRE_FALSE(leg.locked);
  REQUIRE(leg.frame.origin == Vec3{5, 0, 0});
  REQUIRE(leg.stroke == document.parts[1]->stroke);
  REQUIRE(leg.color == document.parts[1]->color);
  REQUIRE(partOf(copied, "part-5").name == "Part 5");
  REQUIRE(partOf(copied, "part-5").attachment == Attachment{"part-4:twin", {1, 2}});
  REQUIRE(copied.parts[0] == document.parts[0]);
  REQUIRE(copied.parts[1] == document.parts[1]);
  REQUIRE(copied.parts[3] == document.parts[2]);

  const Document again = must(apply(copied, DuplicateParts{{"part-4"}, {}}));
  REQUIRE(partOf(again, "part-6").name == "Leg 3");
  const Document third = must(apply(copied, DuplicateParts{{"part-3"}, {}}));
  REQUIRE(partOf(third, "part-6").attachment == document.parts[2]->attachment);
}

TEST_CASE("placing: separated twins lie where they lay, and what hung on them still does",
          "[placing_commands]") {
  Document document = drawnDocument(3);
  document = must(apply(document, RenamePart{"part-2", "Leg"}));
  document = must(apply(document, SetMirror{{"part-2"}, kMiddle}));
  document = must(apply(document, SetAttachment{"part-2", Attachment{"part-1", {30, 5}}}));
  document = must(apply(document, SetAttachment{"part-3", Attachment{"part-2:twin", {1, 2}}}));
  const Document apart = must(apply(document, SeparateTwins{{"part-2", "part-1"}}));
  REQUIRE(idsOf(apart) == std::vector<std::string>{"part-1", "part-2", "part-4", "part-3"});
  const PartSource &one = partOf(apart, "part-2"), &other = partOf(apart, "part-4");
  REQUIRE_FALSE(one.mirror);
  REQUIRE_FALSE(other.mirror);
  REQUIRE(one.name == "Leg.L");
  REQUIRE(other.name == "Leg.R");
  REQUIRE(one.frame == frameOf(document, "part-2"));
  REQUIRE(other.frame == frameOf(document, "part-2:twin"));
  REQUIRE(other.stroke == one.stroke);
  REQUIRE(one.attachment == Attachment{"part-1", {30, 5}});
  REQUIRE(other.attachment == Attachment{"part-1", {-30, 5}});
  REQUIRE(partOf(apart, "part-3").attachment == Attachment{"part-4", {1, 2}});
  REQUIRE(apart.parts[0] == document.parts[0]);

  const Document same = must(apply(apart, SeparateTwins{{"part-2"}}));
  REQUIRE(same.parts == apart.parts);
}

TEST_CASE("placing: twins that hang on twins do so after they were separated",
          "[placing_commands]") {
  Document document = drawnDocument(3);
  document = must(apply(document, SetMirror{{"part-1", "part-2", "part-3"}, kMiddle}));
  document = must(apply(document, SetAttachment{"part-2", Attachment{"part-1", {3, 4}}}));
  document = must(apply(document, SetAttachment{"part-3", Attachment{"part-2:twin", {5, 6}}}));
  const Document apart = must(apply(document, SeparateTwins{{"part-1", "part-2", "part-3"}}));
  REQUIRE(idsOf(apart) ==
          std::vector<std::string>{"part-1", "part-4", "part-2", "part-5", "part-3", "part-6"});
  REQUIRE(partOf(apart, "part-2").attachment == Attachment{"part-1", {3, 4}});
  REQUIRE(partOf(apart, "part-5").attachment == Attachment{"part-4", {3, 4}});
  REQUIRE(partOf(apart, "part-3").attachment == Attachment{"part-5", {5, 6}});
  REQUIRE(partOf(apart, "part-6").attachment == Attachment{"part-2", {5, 6}});
}

TEST_CASE("placing: any creature looks the same with its twins separated", "[placing_commands]") {
  Random random(2);
  for (int run = 0; run < 60; ++run) {
    const Document document = randomCreature(random, 2 + random.below(20), {20});
    const Document apart = must(apply(document, SeparateTwins{allPlacedIds(document)}));
    const auto before = placedParts(document), after = placedParts(apart);
    REQUIRE(before.size() == after.size());
    for (size_t i = 0; i < before.size(); ++i) {
      REQUIRE(after[i].frame == before[i].frame);
      REQUIRE(apart.parts[i]->stroke == document.parts[before[i].source]->stroke);
      REQUIRE_FALSE(apart.parts[i]->mirror);
    }
  }
}

TEST_CASE("placing: a part hangs where the user says, but not on itself", "[placing_commands]") {
  Document document = drawnDocument(2);
  const auto attach = [&](const std::string& id, std::optional<Attachment> attachment) {
    return apply(document, SetAttachment{id, std::move(attachment)});
  };
  REQUIRE(must(attach("part-2", Attachment{"part-1", {1, 2}})).parts[1]->attachment->at ==
          Vec2{1, 2});
  REQUIRE(must(attach("part-2", Attachment{})).parts[1]->attachment->part.empty());
  REQUIRE_FALSE(must(attach("part-2", std::nullopt)).parts[1]->attachment);
  REQUIRE(attach("part-2", Attachment{"part-1:twin", {}}).status() == Status::notFound);
  REQUIRE(attach("part-2", Attachment{"part-9", {}}).status() == Status::notFound);
  REQUIRE(attach("part-2", Attachment{"part-2", {}}).message() == "A part cannot hang on itself.");
  REQUIRE(attach("part-2", Attachment{"part-1", {0, HUGE_VAL}}).status() == Status::noArea);

  document = must(attach("part-2", Attachment{"part-1", {1, 2}}));
  document = must(apply(document, DeleteParts{{"part-1"}}));
  REQUIRE(document.parts[0]->attachment->part == "part-1");
  REQUIRE(faultOf(document).empty());
}

TEST_CASE("placing: what hangs on a stretched part hangs at the same place of it",
          "[placing_commands]") {
  Random random(3);
  CreatureOptions options;
  options.points = 20;
  options.overruled = 0.8;
  size_t stretched = 0;
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    const Document document = randomCreature(random, 2 + random.below(10), options);
    Affine map = randomSimilarity(random);
    if (run % 3 > 0) map.y = map.y * 1.7;
    if (run % 3 > 1) map.x = map.x + map.z * 0.4;
    Ids ids = allPlacedIds(document);
    if (run % 2 == 1) ids = {"part-1", "part-2"};
    const Document after = must(apply(document, TransformParts{ids, map}));
    REQUIRE(faultOf(after) == "");
    for (size_t i = 0; i < after.parts.size(); ++i) {
      const auto &was = document.parts[i]->attachment, &is = after.parts[i]->attachment;
      REQUIRE(was.has_value() == is.has_value());
      if (!was || was->part.empty()) continue;
      REQUIRE(is->part == was->part);
      const PartSource &before = partOf(document, sourceId(was->part)),
                       &now = partOf(after, sourceId(was->part));
      if (now.stroke == before.stroke) {
        REQUIRE(is->at == was->at);
        continue;
      }
      ++stretched;
      REQUIRE(isNear(now.frame.toWorld(is->at), map(before.frame.toWorld(was->at))));
    }
  }
  REQUIRE(stretched > 50);
}

TEST_CASE("placing: one root in a tree", "[placing_commands]") {
  Document document = drawnDocument(4);
  document = must(apply(document, SetRoot{"part-1", {}}));
  document = must(apply(document, SetRoot{"part-4", {}}));
  document = must(apply(document, SetRoot{"part-2", {"part-1", "part-2", "part-3"}}));
  const bool roots[] = {false, true, false, true};
  for (size_t i = 0; i < 4; ++i) REQUIRE(document.parts[i]->root == roots[i]);
}

TEST_CASE("placing: a part is drawn in any plane, and mirrored at once", "[placing_commands]") {
  const Frame frame{{1, 2, 3}, {0, 0, -2}, {0, 2, 0}};
  const Document document = must(apply({}, AddPart{softStar(3, 50), frame, Plane{{0, 0, 3}, 6}}));
  REQUIRE(document.parts[0]->frame == frame);
  REQUIRE(document.parts[0]->mirror == Plane{{0, 0, 1}, 2});
  REQUIRE(placedParts(document).size() == 2);

  const Frame uneven{{}, {2, 0, 0}, {0, 1, 0}};
  const Document baked = must(apply({}, AddPart{softStar(3, 50), uneven}));
  REQUIRE(isSound(baked.parts[0]->frame));
  for (size_t i = 0; i < 150; ++i) {
    const Vec2 p = softStar(3, 50)[i];
    REQUIRE(isNear(baked.parts[0]->frame.toWorld(baked.parts[0]->stroke[i]), uneven.toWorld(p)));
  }
  const auto refused = [&](const Frame& where, std::optional<Plane> mirror) {
    return apply({}, AddPart{softStar(3, 50), where, mirror}).status() == Status::noArea;
  };
  REQUIRE(refused({{}, {1, 0, 0}, {1, 0, 0}}, {}));
  REQUIRE(refused({{HUGE_VAL, 0, 0}}, {}));
  REQUIRE(refused({{1e50, 0, 0}, {1e49, 0, 0}, {0, 1e49, 0}}, {}));
  REQUIRE(refused({}, Plane{{0, 0, 0}, 1}));
}

TEST_CASE("placing: pictures behind the strokes, one in a view", "[placing_commands]") {
  Document document;
  const auto set = [&](Reference::View view, const char* image, double opacity = 0.5) {
    Reference reference;
    reference.view = view;
    reference.opacity = opacity;
    reference.scale = 1e300;
    if (image) reference.image = std::make_shared<const std::string>(image);
    const Command command = SetReference{reference};
    document = must(apply(document, command));
  };
  set(Reference::View::front, "data:image/png;base64,AAAA");
  set(Reference::View::top, "data:image/jpeg;base64,AAA=", 7);
  set(Reference::View::front, "data:image/webp;base64,AA==", std::nan(""));
  REQUIRE(document.references.size() == 2);
  REQUIRE(*document.references[0]->image == "data:image/webp;base64,AA==");
  REQUIRE(document.references[0]->opacity == 0);
  REQUIRE(document.references[1]->opacity == 1);
  REQUIRE(document.references[1]->scale == Reference::kMaxScale);
  REQUIRE(faultOf(document).empty());
  set(Reference::View::front, nullptr);
  set(Reference::View::right, nullptr);
  REQUIRE(document.references.size() == 1);
  REQUIRE(document.references[0]->view == Reference::View::top);

  Reference wrong;
  for (const char* image :
       {"", "data:image/gif;base64,AAAA", "data:image/png;base64,A", "data:image/png;base64,",
        "data:image/png;base64,AA!A", "data:image/png;base64,A===", "data:image/png,AAAA"}) {
    wrong.image = std::make_shared<const std::string>(image);
    REQUIRE(apply(document, SetReference{wrong}).status() == Status::unreadable);
  }
}
