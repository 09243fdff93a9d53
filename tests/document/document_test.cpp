#include "document/document.h"

#include <set>

#include "support/catch.h"

using namespace marrow;

TEST_CASE("document: a colour's text is read back as that colour", "[document]") {
  for (int i = 0; i < 256; ++i) {
    const auto c = static_cast<uint8_t>(i);
    const Color color{c, static_cast<uint8_t>(255 - c), static_cast<uint8_t>(c * 7)};
    REQUIRE(parseColor(toString(color)) == color);
  }
  REQUIRE(toString(Color{255, 0, 10}) == "#ff000a");
  REQUIRE(parseColor("#FF00aB") == Color{255, 0, 171});
}

TEST_CASE("document: what is no colour's text is nothing", "[document]") {
  for (const char* text : {"", "#", "#fff", "ff00ab", "#ff00a", "#ff00abc", "#ff00ag", "#-f00ab",
                           "#ff 0ab", "red", "#ff00a\xc3"}) {
    CAPTURE(text);
    REQUIRE_FALSE(parseColor(text));
  }
  REQUIRE_FALSE(parseColor(std::string("#ff\0aab", 7)));
}

TEST_CASE("document: the first seven part colours differ, then they come again", "[document]") {
  std::set<std::string> colors;
  for (size_t i = 0; i < 7; ++i) colors.insert(toString(partColor(i)));
  REQUIRE(colors.size() == 7);
  REQUIRE(partColor(7) == partColor(0));
  REQUIRE(partColor(SIZE_MAX) == partColor(SIZE_MAX % 7));
}

TEST_CASE("document: only ids of the form part-n have a number", "[document]") {
  REQUIRE(partNumber("part-1") == 1);
  REQUIRE(partNumber("part-999999999999999") == 999999999999999);
  REQUIRE(partNumber(partId(42)) == 42);
  for (const char* id : {"", "part", "part-", "part-0", "part-01", "part-1x", "Part-1", "part--1",
                         "part- 1", "part-9999999999999999", "part-99999999999999999999999"}) {
    CAPTURE(id);
    REQUIRE(partNumber(id) == 0);
  }
}

TEST_CASE("document: a number that a foreign id took is not given again", "[document]") {
  Document document;
  auto part = std::make_shared<PartSource>();
  part->id = "part-2";
  document.parts.push_back(part);
  REQUIRE(takePartNumber(document) == 1);
  REQUIRE(takePartNumber(document) == 3);
}

TEST_CASE("document: only finite points that are not too far away can be drawn", "[document]") {
  REQUIRE(isDrawable(Vec2{0, 0}));
  REQUIRE(isDrawable(Vec2{-kLargestCoordinate, kLargestCoordinate}));
  REQUIRE_FALSE(isDrawable(Vec2{0, 2 * kLargestCoordinate}));
  REQUIRE_FALSE(isDrawable(Vec2{HUGE_VAL, 0}));
  REQUIRE_FALSE(isDrawable(Vec2{0, -HUGE_VAL}));
  REQUIRE_FALSE(isDrawable(Vec2{std::nan(""), 0}));
}
