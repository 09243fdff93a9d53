#include "io/stroke_json.h"

#include "support/catch.h"

using namespace marrow;

TEST_CASE("stroke file: name and points are read, other fields are not looked at",
          "[stroke_json]") {
  const auto stroke = readStroke(
      R"({"name": "ear", "source": {"a": [1]}, "closed": false, "points": [[1, 2], [3.5, -4e1]]})");
  REQUIRE(stroke);
  REQUIRE(stroke->name == "ear");
  REQUIRE(stroke->points == std::vector<Vec2>{{1, 2}, {3.5, -40}});
}

TEST_CASE("stroke file: only the points are needed, a byte order mark does no harm",
          "[stroke_json]") {
  const auto stroke = readStroke("\xef\xbb\xbf{\"points\": []}\r\n");
  REQUIRE(stroke);
  REQUIRE(stroke->name.empty());
  REQUIRE(stroke->points.empty());
}

TEST_CASE("stroke file: whole numbers of any size are coordinates", "[stroke_json]") {
  const auto stroke =
      readStroke(R"({"points": [[18446744073709551616, -9007199254740993], [-0, 1e-400]]})");
  REQUIRE(stroke);
  REQUIRE(stroke->points[0] == Vec2{18446744073709551616.0, -9007199254740992.0});
  REQUIRE(stroke->points[1] == Vec2{0, 0});
}

TEST_CASE("stroke file: a fault is said in one sentence that says where", "[stroke_json]") {
  const std::pair<const char*, const char*> faults[] = {
      {"", "It is empty."},
      {"[]", "It is not a stroke: not an object."},
      {"{", "It is not valid JSON (line 1, column 2)."},
      {"{\"points\":\n [[1, 2],, [3, 4]]}", "It is not valid JSON (line 2, column 10)."},
      {"{\"points\": [[1, 1e999]]}", "It holds a number that is too large (line 1, column 21)."},
      {"{\"a\": \"\xff\"}", "It is not valid JSON (line 1, column 8)."},
      {"{\"name\": 1, \"points\": []}", "name is not a text."},
      {"{\"closed\": 1, \"points\": []}", "closed is neither true nor false."},
      {"{}", "points is missing."},
      {"{\"points\": 5}", "points is not a list of points."},
      {"{\"points\": [[1, 2], [3]]}", "points[1] is not a pair of numbers."},
      {"{\"points\": [[1, 2], [3, 4, 5]]}", "points[1] is not a pair of numbers."},
      {"{\"points\": [[null, 2]]}", "points[0] is not a pair of numbers."},
      {"{\"points\": [[1, 2e51]]}", "points[0] is too far away."},
  };
  for (const auto& [text, sentence] : faults) {
    CAPTURE(text);
    const auto stroke = readStroke(text);
    REQUIRE(stroke.status() == Status::unreadable);
    REQUIRE(stroke.message() == sentence);
  }
}

TEST_CASE("stroke file: no nesting is too deep to be refused", "[stroke_json]") {
  for (const std::string& bracket : {std::string("["), std::string("{\"a\":")}) {
    std::string text = "{\"points\": ";
    for (int i = 0; i < 1'000'000; ++i) text += bracket;
    const auto stroke = readStroke(text);
    REQUIRE(stroke.status() == Status::unreadable);
    REQUIRE(stroke.message() == "It is nested too deeply.");
  }
}

TEST_CASE("stroke file: an object of many fields is refused before it costs time",
          "[stroke_json]") {
  std::string text = "{\"points\": []";
  for (int i = 0; i < 300'000; ++i) text += ",\"field" + std::to_string(i) + "\":0";
  REQUIRE(readStroke(text + "}").message() == "An object in it has too many fields.");
}
