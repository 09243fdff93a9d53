#include "io/document_json.h"

#include <cstring>
#include <limits>

#include "document/command.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/drawings.h"

using namespace marrow;

namespace {

Document must(const std::string& text) {
  CAPTURE(text.substr(0, 500));
  auto document = readDocument(text);
  REQUIRE(document);
  return *document;
}

/// Text of one part, in a document around it.
std::string withPart(const std::string& part) {
  return R"({"format": "marrow", "version": 1, "parts": [)" + part + "]}";
}

constexpr char kTriangle[] = R"("stroke": {"points": [[0, 0], [9, 0], [0, 9]]})";

uint64_t bitsOf(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

TEST_CASE("document file: the text has the form that is documented", "[document_json]") {
  PartSource part;
  part.id = "part-1";
  part.name = "Head \"A\"";
  part.stroke = {{0, 0.5}, {100, -2}, {1e-7, 1e21}};
  part.thickness = 1.25;
  part.color = {255, 0, 16};
  part.refine.simplify = 7.5;
  Document document;
  document.parts.push_back(std::make_shared<const PartSource>(part));
  const std::string plain =
      R"({"id":"part-1","name":"Head \"A\"",)"
      R"("stroke":{"points":[[0,0.5],[100,-2],[1e-07,1e+21]]},)"
      R"("frame":{"origin":[0,0,0],"x":[1,0,0],"y":[0,1,0]},"thickness":1.25,"mirror":null,)"
      R"("skeleton":true,"color":"#ff0010","visible":true,"refine":{"simplify":7.5}})";
  REQUIRE(writeDocument(document) == R"({"format":"marrow","version":1,"parts":[)" + plain + "]}");

  part.id = "x";
  part.refine = {1, 2, 3, 4};
  part.branches = {{"b1", 0.5}};
  part.frame = {{1, 2, 3}, {0, 2, 0}, {0, 0, 2}};
  part.mirror = Plane{{0, 1, 0}, -0.5};
  part.skeleton = part.visible = false;
  part.locked = part.root = true;
  part.attachment = Attachment{"part-1:twin", {5, 6}};
  document.parts.push_back(std::make_shared<const PartSource>(part));
  document.refine.prune = 12;
  document.symmetry = Plane{{1, 0, 0}, 0};
  Reference reference;
  reference.view = Reference::View::right;
  reference.image = std::make_shared<const std::string>("data:image/png;base64,AAAA");
  document.references.push_back(std::make_shared<const Reference>(reference));
  document.last_part = 9;
  REQUIRE(
      writeDocument(document) ==
      R"({"format":"marrow","version":1,"parts":[)" + plain +
          R"(,{"id":"x","name":"Head \"A\"","stroke":{"points":[[0,0.5],[100,-2],[1e-07,1e+21]]},)"
          R"("frame":{"origin":[1,2,3],"x":[0,2,0],"y":[0,0,2]},"thickness":1.25,)"
          R"("mirror":{"plane":[0,1,0,-0.5]},"skeleton":false,"color":"#ff0010","visible":false,)"
          R"("locked":true,"root":true,"refine":{"simplify":1,"merge":2,"prune":3,"collapse":4,)"
          R"("branches":{"b1":0.5}},"attachment":{"part":"part-1:twin","at":[5,6]}}],)"
          R"("refine":{"prune":12},"symmetry":{"plane":[1,0,0,0]},)"
          R"("references":[{"view":"right","image":"data:image/png;base64,AAAA","opacity":0.5,)"
          R"("position":[0,0],"scale":1}],"lastPart":9})");
  REQUIRE(writeDocument({}) == R"({"format":"marrow","version":1,"parts":[]})");
}

TEST_CASE("document file: what was written is read back to the bit", "[document_json]") {
  Random random(3);
  Document document = drawnDocument(5);
  for (int i = 0; i < 200; ++i) {
    PartSource part = *document.parts[static_cast<size_t>(i % 5)];
    part.id = "x" + std::to_string(i);
    part.name = i % 2 ? "Größe \t\n\"\\/ 猫 🐈" : "";
    part.name += std::to_string(i);
    part.stroke = randomPoints(random, 5);
    // Any bits that are a drawable number.
    for (Vec2& point : part.stroke) {
      uint64_t bits = static_cast<uint64_t>(random.unit() * 0x1p53) * 2049 + 1;
      double value;
      std::memcpy(&value, &bits, sizeof value);
      if (isDrawable(Vec2{value, 0})) point.x = random.below(2) ? value : -value;
    }
    part.stroke.push_back({-0.0, std::numeric_limits<double>::denorm_min()});
    part.stroke.push_back({kLargestCoordinate, 9007199254740993.0});
    part.thickness = random.between(kMinThickness, kMaxThickness);
    if (random.below(2)) part.refine.simplify = random.between(0, Refinement::kLargest);
    document.parts.push_back(std::make_shared<const PartSource>(part));
  }
  const std::string text = writeDocument(document);
  const Document read = must(text);
  REQUIRE(writeDocument(read) == text);
  REQUIRE(read.last_part == document.last_part);
  REQUIRE(read.parts.size() == document.parts.size());
  for (size_t i = 0; i < read.parts.size(); ++i) {
    const PartSource &a = *document.parts[i], &b = *read.parts[i];
    REQUIRE(a.id == b.id);
    REQUIRE(a.name == b.name);
    REQUIRE(bitsOf(a.thickness) == bitsOf(b.thickness));
    REQUIRE(a.refine == b.refine);
    REQUIRE(a.color == b.color);
    REQUIRE(a.stroke.size() == b.stroke.size());
    for (size_t k = 0; k < a.stroke.size(); ++k) {
      REQUIRE(bitsOf(a.stroke[k].x) == bitsOf(b.stroke[k].x));
      REQUIRE(bitsOf(a.stroke[k].y) == bitsOf(b.stroke[k].y));
    }
  }
}

TEST_CASE("document file: every platform writes the same text", "[document_json]") {
  Random random(11);
  auto part = std::make_shared<PartSource>();
  part->id = "part-1";
  for (int i = 0; i < 5000; ++i) {
    const uint64_t bits = (static_cast<uint64_t>(random.unit() * 0x1p32) << 32) ^
                          static_cast<uint64_t>(random.unit() * 0x1p53);
    Vec2 point{0, random.between(-400, 400)};
    std::memcpy(&point.x, &bits, sizeof bits);
    if (isDrawable(point)) part->stroke.push_back(point);
  }
  Document document;
  document.parts.push_back(part);
  uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (unsigned char c : writeDocument(document)) hash = (hash ^ c) * 1099511628211u;
  REQUIRE(hash == 2877452835769650071u);
}

TEST_CASE("document file: fields of later versions are kept where they stand", "[document_json]") {
  const std::string text =
      R"({"format":"marrow","version":1,"parts":[{"id":"part-1","name":"A",)"
      R"("stroke":{"points":[[0,0],[1.5,0],[0,1]],"pressure":[0.5,1,-0.0],"b":null,"a":1},)"
      R"("frame":{"origin":[0,0,0],"x":[1,0,0],"y":[0,1,0],"z":1e+30},"thickness":1,)"
      R"("mirror":{"plane":[0,1,0,3],"a":18446744073709551615},"skeleton":true,)"
      R"("color":"#010203","visible":true,"refine":{"merge":30.25,"fold":{"z":[],"y":{}}},)"
      R"("attachment":{"part":"","at":[0,0],"firmly":true},"zebra":true}],)"
      R"("refine":{"fold":5},"symmetry":{"plane":[1,0,0,0],"b":"c"},)"
      R"("references":[{"view":"top","image":"data:image/webp;base64,AA==","opacity":1,)"
      R"("position":[1,2],"scale":2,"tint":"red"}],)"
      R"("poses":[{"name":"Sit","joints":{"b":{"rotation":[0,0.6,0,0.8],"move":[1,2,3],"c":{}},)"
      R"("part-1/n0":{"move":[0.5,0,0]}},"mood":[1]}],)"
      R"("lastPart":7,"view":{"yaw":0.1},"author":"ü"})";
  REQUIRE(writeDocument(must(text)) == text);

  SECTION("also when the part is changed") {
    const auto next = apply(must(text), simplify("part-1", 8.0));
    REQUIRE(next);
    const std::string changed = writeDocument(*next);
    REQUIRE(changed.find(R"("refine":{"simplify":8,"merge":30.25,"fold")") != std::string::npos);
    REQUIRE(changed.find(R"("zebra":true)") != std::string::npos);
    REQUIRE(writeDocument(must(changed)) == changed);
  }
}

TEST_CASE("document file: missing fields get their defaults", "[document_json]") {
  const Document document =
      must(withPart(std::string("{") + kTriangle + R"(}, {"id": "part-4", )" + kTriangle +
                    R"(}, {"id": "tail", )" + kTriangle + R"(}, {)" + kTriangle + "}"));
  REQUIRE(document.parts.size() == 4);
  REQUIRE(document.parts[0]->id == "part-5");
  REQUIRE(document.parts[0]->name == "Part 5");
  REQUIRE(document.parts[0]->thickness == 1);
  REQUIRE(document.parts[0]->color == partColor(4));
  REQUIRE_FALSE(document.parts[0]->refine.simplify);
  REQUIRE(document.parts[1]->name == "Part 4");
  REQUIRE(document.parts[2]->name == "Part 3");
  REQUIRE(document.parts[3]->id == "part-6");
  REQUIRE(document.last_part == 6);
  REQUIRE(must(R"({"format": "marrow", "version": 1})").parts.empty());
}

TEST_CASE("document file: settings out of range are brought into it", "[document_json]") {
  const Document document = must(withPart(R"({"thickness": -5, "refine": {"simplify": 1e9}, )" +
                                          std::string(kTriangle) + "}"));
  REQUIRE(document.parts[0]->thickness == kMinThickness);
  REQUIRE(document.parts[0]->refine.simplify == Refinement::kLargest);
}

TEST_CASE("document file: a later version is told from an unreadable text", "[document_json]") {
  const auto status = [](const std::string& version) {
    return readDocument(R"({"format": "marrow", "version": )" + version + R"(, "parts": 5})")
        .status();
  };
  REQUIRE(status("2") == Status::newerVersion);
  REQUIRE(status("18446744073709551615") == Status::newerVersion);
  REQUIRE(status("1e300") == Status::newerVersion);
  for (const char* version : {"1", "0", "-1", "1.5", "\"2\"", "null", "[2]", "1e-300"}) {
    CAPTURE(version);
    REQUIRE(status(version) == Status::unreadable);
  }
  REQUIRE(readDocument(R"({"format": "marrow", "version": 2})").message() ==
          toSentence(Status::newerVersion));
}

TEST_CASE("document file: a fault is said in one sentence that says where", "[document_json]") {
  const std::string triangle = kTriangle;
  const std::pair<std::string, std::string> faults[] = {
      {"", "It is empty."},
      {"[1, 2]", "It is not a Marrow drawing: not an object."},
      {"{}", "It is not a Marrow drawing: format is not \"marrow\"."},
      {R"({"format": "bone", "version": 1})",
       "It is not a Marrow drawing: format is not \"marrow\"."},
      {R"({"format": 1, "version": 1})", "It is not a Marrow drawing: format is not \"marrow\"."},
      {R"({"format": "marrow"})", "version is missing."},
      {R"({"format": "marrow", "version": 1, "parts": {}})", "parts is not a list."},
      {R"({"format": "marrow", "version": 1, "lastPart": -1})",
       "lastPart is not a whole number from 0."},
      {withPart("7"), "parts[0] is not an object."},
      {withPart("{" + triangle + "}, null"), "parts[1] is not an object."},
      {withPart("{}"), "parts[0].stroke is missing."},
      {withPart(R"({"stroke": []})"), "parts[0].stroke is not an object."},
      {withPart(R"({"stroke": {}})"), "parts[0].stroke.points is missing."},
      {withPart(R"({"stroke": {"points": 1}})"), "parts[0].stroke.points is not a list of points."},
      {withPart(R"({"stroke": {"points": [[1, 2], [1, "2"]]}})"),
       "parts[0].stroke.points[1] is not a pair of numbers."},
      {withPart(R"({"stroke": {"points": [[1, -1e60]]}})"),
       "parts[0].stroke.points[0] is too far away."},
      {withPart(R"({"id": 4, )" + triangle + "}"), "parts[0].id is not a text."},
      {withPart(R"({"id": "", )" + triangle + "}"), "parts[0].id is empty."},
      {withPart(R"({"id": "a", )" + triangle + R"(}, {"id": "a", )" + triangle + "}"),
       "parts[1].id is used twice."},
      {withPart(R"({"name": [], )" + triangle + "}"), "parts[0].name is not a text."},
      {withPart(R"({"thickness": "1", )" + triangle + "}"), "parts[0].thickness is not a number."},
      {withPart(R"({"color": 5, )" + triangle + "}"), "parts[0].color is not a text."},
      {withPart(R"({"color": "red", )" + triangle + "}"),
       "parts[0].color is not of the form \"#rrggbb\"."},
      {withPart(R"({"refine": 5, )" + triangle + "}"), "parts[0].refine is not an object."},
      {withPart(R"({"refine": {"simplify": true}, )" + triangle + "}"),
       "parts[0].refine.simplify is not a number."},
      {withPart(R"({"id": "a:twin", )" + triangle + "}"), "parts[0].id holds a colon."},
      {withPart(R"({"frame": {"x": [0, 0, 0]}, )" + triangle + "}"),
       "parts[0].frame is no plane: x and y are zero or parallel."},
      {withPart(R"({"frame": {"y": [3, 0, 0]}, )" + triangle + "}"),
       "parts[0].frame is no plane: x and y are zero or parallel."},
      {withPart(R"({"frame": {"origin": [0, 1]}, )" + triangle + "}"),
       "parts[0].frame.origin is not a list of 3 numbers."},
      {withPart(R"({"frame": {"origin": [0, 1, 1e51]}, )" + triangle + "}"),
       "parts[0].frame.origin is too far away."},
      {withPart(R"({"frame": {"x": [1e50, 0, 0], "y": [0, 1e50, 0]}, )" + triangle + "}"),
       "parts[0].frame puts the stroke too far away."},
      {withPart(R"({"mirror": {"plane": [0, 0, 0, 1]}, )" + triangle + "}"),
       "parts[0].mirror.plane is no plane."},
      {withPart(R"({"mirror": {}, )" + triangle + "}"), "parts[0].mirror.plane is missing."},
      {withPart(R"({"visible": 1, )" + triangle + "}"),
       "parts[0].visible is neither true nor false."},
      {withPart(R"({"attachment": {"part": 1}, )" + triangle + "}"),
       "parts[0].attachment.part is not a text."},
      {R"({"format": "marrow", "version": 1, "symmetry": 5})", "symmetry is not an object."},
      {R"({"format": "marrow", "version": 1, "refine": {"prune": []}})",
       "refine.prune is not a number."},
      {R"({"format": "marrow", "version": 1, "poses": [{}]})", "poses[0].name is missing."},
      {R"({"format": "marrow", "version": 1, "poses": [{"name": "A"}, {"name": "A"}]})",
       "poses[1].name is used twice."},
      {R"({"format": "marrow", "version": 1, "poses": [{"name": "A", "joints": {"b": 1}}]})",
       "poses[0].joints.b is not an object."},
      {R"({"format": "marrow", "version": 1, "poses": [{"name": "A", "joints": {"b":)"
       R"({"rotation": [0, 0, 0, 0]}}}]})",
       "poses[0].joints.b.rotation is no rotation."},
      {R"({"format": "marrow", "version": 1, "references": [3]})",
       "references[0] is not an object."},
      {R"({"format": "marrow", "version": 1, "references": [{"image": "x"}]})",
       "references[0].image is no PNG, JPEG or WebP picture of up to 16 MB as a data URL."},
      {R"({"format": "marrow", "version": 1, "references": [{"image": "data:image/png;base64,AAAA"},)"
       R"({"image": "data:image/png;base64,AAAA", "view": "front"}]})",
       "references[1].view is used twice."},
      {R"({"format": "marrow", "version": 1, "references": [{"view": "back",)"
       R"("image": "data:image/png;base64,AAAA"}]})",
       "references[0].view is neither \"front\", \"right\" nor \"top\"."},
  };
  for (const auto& [text, sentence] : faults) {
    CAPTURE(text);
    const auto document = readDocument(text);
    REQUIRE(document.status() == Status::unreadable);
    REQUIRE(document.message() == sentence);
  }
}

TEST_CASE("document file: a name that is not UTF-8 is written as text that can be read",
          "[document_json]") {
  const auto renamed = apply(drawnDocument(1), RenamePart{"part-1", "bad \xff\xc3 end"});
  REQUIRE(renamed);
  const std::string text = writeDocument(*renamed);
  REQUIRE(writeDocument(must(text)) == text);
}

TEST_CASE("document file: any broken copy is an error or a sound document", "[document_json]") {
  Document document = drawnDocument(3);
  document = *apply(document, simplify("part-2", 12.5));
  document = *apply(document, DeleteParts{{"part-3"}});
  auto short_part = std::make_shared<PartSource>(*document.parts[0]);
  short_part->stroke.resize(12);
  short_part->extra = R"({"x":[1,{"y":null}],"stroke":{"p":[0.5]},"refine":{"q":"r"}})";
  document.parts[0] = short_part;
  auto other = std::make_shared<PartSource>(*document.parts[1]);
  other->stroke.resize(12);
  document.parts[1] = other;
  const std::string whole = writeDocument(document);

  const char* tokens[] = {"{",          "}",          "[",
                          "]",          ",",          ":",
                          "null",       "true",       "\"",
                          "1e999",      "-",          "0",
                          "\"id\"",     "\"points\"", "[[",
                          "{}",         "\\u0000",    "\\ud800",
                          "1e",         "NaN",        "\xef\xbb\xbf",
                          "\"marrow\"", "\"part-1\"", "99999999999999999999"};
  constexpr int kTokens = sizeof tokens / sizeof tokens[0];
  Random random(99);
  const auto place = [&](const std::string& text) {
    return static_cast<size_t>(random.below(static_cast<int>(text.size()) + 1));
  };
  int sound = 0;
  for (int run = 0; run < 3000; ++run) {
    std::string text = whole;
    for (int edits = 1 + random.below(3); edits > 0; --edits) {
      const size_t at = place(text);
      switch (random.below(6)) {
        case 0:  // a flipped bit
          if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
          break;
        case 1:  // cut off
          if (random.below(4) == 0) text.resize(at);
          break;
        case 2:  // a foreign token
          text.insert(at, tokens[random.below(kTokens)]);
          break;
        case 3:  // a token instead of a stretch
          text.replace(at, static_cast<size_t>(random.below(12)), tokens[random.below(kTokens)]);
          break;
        case 4:  // a stretch moved
          text.insert(place(text), text.substr(at, static_cast<size_t>(random.below(40))));
          break;
        case 5:  // a stretch lost
          text.erase(at, static_cast<size_t>(random.below(20)));
          break;
      }
    }
    const auto read = readDocument(text);
    if (!read) {
      REQUIRE((read.status() == Status::unreadable || read.status() == Status::newerVersion));
      REQUIRE(read.message().find('\n') == std::string::npos);
      continue;
    }
    ++sound;
    const std::string written = writeDocument(*read);
    const auto again = readDocument(written);
    REQUIRE(again);
    REQUIRE(writeDocument(*again) == written);
    for (const auto& part : read->parts) {
      REQUIRE_FALSE(part->id.empty());
      for (Vec2 point : part->stroke) REQUIRE(isDrawable(point));
    }
  }
  REQUIRE(sound > 100);
}

TEST_CASE("document file: a fault stays on one line, whatever a field is called",
          "[document_json]") {
  const auto read = readDocument(
      withPart(std::string(R"({"refine": {"branches": {"a\nb\u007f": "x"}}, )") + kTriangle + "}"));
  REQUIRE(read.message() == "parts[0].refine.branches.a b  is not a number.");
}

TEST_CASE("document file: a frame that is none yet becomes one, and the stroke stays in place",
          "[document_json]") {
  const Document document = must(withPart(
      R"({"frame": {"origin": [1, 2, 3], "x": [2, 0, 0], "y": [1, 0, 0.5]}, "thickness": 1.5, )" +
      std::string(kTriangle) + "}"));
  const PartSource& part = *document.parts[0];
  REQUIRE(part.frame.scale() == 1);
  REQUIRE(part.frame.x == Vec3{1, 0, 0});
  REQUIRE(part.frame.y == Vec3{0, 0, 1});
  REQUIRE(part.stroke == std::vector<Vec2>{{0, 0}, {18, 0}, {9, 4.5}});
  REQUIRE(part.thickness == 1.5);
  REQUIRE(must(writeDocument(document)).parts[0]->stroke == part.stroke);
}

TEST_CASE("document file: a sound frame is kept to the bit", "[document_json]") {
  Random random(12);
  for (int run = 0; run < 100; ++run) {
    const Document document = randomCreature(random, 1 + random.below(10), {20});
    const Document read = must(writeDocument(document));
    for (size_t i = 0; i < read.parts.size(); ++i) {
      REQUIRE(read.parts[i]->frame == document.parts[i]->frame);
      REQUIRE(read.parts[i]->stroke == document.parts[i]->stroke);
      REQUIRE(read.parts[i]->mirror == document.parts[i]->mirror);
      REQUIRE(read.parts[i]->attachment == document.parts[i]->attachment);
      REQUIRE(read.parts[i]->refine == document.parts[i]->refine);
      REQUIRE(read.parts[i]->skeleton == document.parts[i]->skeleton);
      REQUIRE(read.parts[i]->visible == document.parts[i]->visible);
      REQUIRE(read.parts[i]->root == document.parts[i]->root);
    }
    REQUIRE(read.symmetry == document.symmetry);
    REQUIRE(read.last_part == document.last_part);
  }
}

TEST_CASE("document file: a plane gets a unit normal", "[document_json]") {
  const Document document =
      must(R"({"format": "marrow", "version": 1, "symmetry": {"plane": [0, 0, -4, 2]}})");
  REQUIRE(document.symmetry == Plane{{0, 0, -1}, 0.5});
}

TEST_CASE("document file: as many unknown fields as can be written again", "[document_json]") {
  const auto fields = [](int count) {
    std::string text = R"({"format": "marrow", "version": 1)";
    for (int i = 0; i < count; ++i) text += ",\"u" + std::to_string(i) + "\": 0";
    return text + "}";
  };
  REQUIRE(writeDocument(must(writeDocument(must(fields(900))))) ==
          writeDocument(must(fields(900))));
  REQUIRE(readDocument(fields(990)).message() == "It has too many fields.");
}

TEST_CASE("document file: parts beyond any drawing are refused", "[document_json]") {
  std::string parts = "{" + std::string(kTriangle) + "}";
  for (size_t i = 0; i < Document::kMostParts; ++i) parts += ",{\"stroke\":{\"points\":[]}}";
  REQUIRE(readDocument(withPart(parts)).message() == "parts are more than a drawing holds.");
}

TEST_CASE("document file: the last number of all is no dead end", "[document_json]") {
  Document document = must(R"({"format": "marrow", "version": 1, "lastPart": 999999999999999})");
  for (const char* id : {"part-1", "part-2"}) {
    const auto next = apply(document, AddPart{softStar(3, 50)});
    REQUIRE(next);
    REQUIRE(next->parts.back()->id == id);
    document = must(writeDocument(*next));
  }
}
