#include "io/rig_export.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "support/catch.h"
#include "support/creatures.h"
#include "support/text.h"

using namespace marrow;

namespace {

double noTime() { return 0; }

Evaluation evaluated(const Document& document) {
  Evaluation character({}, noTime);
  character.update(document);
  return character;
}

Document small(uint64_t seed, int parts = 6) {
  Random random(seed);
  return randomCreature(random, parts);
}

/// Two lumps that touch, and `apart` others, each alone.
Document lumps(int apart) {
  Document document;
  for (int i = 0; i < 2 + apart; ++i) {
    auto part = std::make_shared<PartSource>();
    part->id = partId(takePartNumber(document));
    part->name = "Lump";
    part->stroke = unitCircle(40);
    for (Vec2& p : part->stroke) p = {p.x * 100, p.y * 40};
    part->frame.origin = {i < 2 ? 120.0 * i : 1000.0 * i, 0, 0};
    document.parts.push_back(std::move(part));
  }
  return document;
}

}  // namespace

TEST_CASE("rig export: the JSON holds the rig to the bit", "[rig_export]") {
  for (const uint64_t seed : {1, 2, 3, 4}) {
    const Evaluation character = evaluated(small(seed));
    const Rig& rig = character.rig();
    const auto& placed = character.placed();
    const auto tree = Json::parse(rigToJson(character), nullptr, false);
    REQUIRE_FALSE(tree.is_discarded());
    REQUIRE(tree["joints"].size() == rig.joints.size());
    for (size_t i = 0; i < rig.joints.size(); ++i) {
      const Rig::Joint& joint = rig.joints[i];
      const Json& one = tree["joints"][i];
      REQUIRE(one["id"] == joint.id);
      REQUIRE(one["name"] == joint.name);
      REQUIRE(one["part"] == placed[joint.part].id);
      REQUIRE(one["kind"] == toString(joint.kind));
      REQUIRE(one["radius"].get<double>() == joint.radius);
      REQUIRE(one["position"][0].get<double>() == joint.position.x);
      REQUIRE(one["position"][1].get<double>() == joint.position.y);
      REQUIRE(one["position"][2].get<double>() == joint.position.z);
      REQUIRE(one["parent"].is_null() == (joint.parent < 0));
      if (joint.parent >= 0) {
        REQUIRE(one["parent"] == rig.joints[static_cast<size_t>(joint.parent)].id);
      }
    }
    REQUIRE(tree["bones"].size() == rig.bones.size());
    for (size_t i = 0; i < rig.bones.size(); ++i) {
      REQUIRE(tree["bones"][i][0] == rig.joints[rig.bones[i][0]].id);
      REQUIRE(tree["bones"][i][1] == rig.joints[rig.bones[i][1]].id);
    }
    REQUIRE(tree["connections"].size() == rig.connections.size());
    for (size_t i = 0; i < rig.connections.size(); ++i) {
      REQUIRE(tree["connections"][i]["child"] == placed[rig.connections[i].child].id);
      REQUIRE(tree["connections"][i]["parent"] == placed[rig.connections[i].parent].id);
      REQUIRE(tree["connections"][i]["event"] == toString(rig.connections[i].event));
      REQUIRE(tree["connections"][i]["test"] == toString(rig.connections[i].test));
    }
    REQUIRE(tree["roots"].size() == rig.roots.size());
    REQUIRE(tree["carried"].size() == rig.carried.size());
    REQUIRE(tree["timings"]["total"] == 0);
    REQUIRE(tree["timings"].contains("subSkeletons"));
  }
}

TEST_CASE("rig export: unattached is what begins a tree beside the largest", "[rig_export]") {
  REQUIRE(unattachedParts(evaluated({})).empty());
  REQUIRE(unattachedParts(evaluated(lumps(0))).empty());
  REQUIRE(unattachedParts(evaluated(lumps(2))) == std::vector<uint32_t>{2, 3});
  Document late = lumps(1);
  std::rotate(late.parts.begin(), late.parts.end() - 1, late.parts.end());
  REQUIRE(unattachedParts(evaluated(late)) == std::vector<uint32_t>{0});
}

TEST_CASE("rig export: a part of which no shape comes is named with the reason", "[rig_export]") {
  Document document = lumps(0);
  auto line = std::make_shared<PartSource>(*document.parts[1]);
  line->stroke = {{0, 0}, {1, 1}, {2, 2}};
  document.parts[1] = line;
  const Evaluation character = evaluated(document);
  const Json tree = rigToTree(character);
  REQUIRE(tree["errors"].size() == 1);
  REQUIRE(tree["errors"][0]["part"] == "part-2");
  REQUIRE(tree["errors"][0]["message"] == character.parts()[1].error.message());
  REQUIRE(count(rigToObj(character), "\nf ") == character.parts()[0].part->mesh.triangles.size());
  REQUIRE(count(rigToSvg("x", character), "<path ") == 3);
}

TEST_CASE("rig export: the OBJ holds each visible part where it is in space", "[rig_export]") {
  const Evaluation character = evaluated(small(5, 8));
  std::vector<Vec3> expected;
  size_t triangles = 0, objects = 1;
  for (const RigPart& part : character.rigParts()) {
    if (!part.source->visible) continue;
    ++objects;
    triangles += part.part->mesh.triangles.size();
    for (Vec3 p : part.part->mesh.positions) expected.push_back(part.placed->frame.toWorld(p));
  }
  const size_t of_meshes = expected.size();
  for (const Rig::Joint& joint : character.rig().joints) expected.push_back(joint.position);

  std::istringstream lines(rigToObj(character));
  std::vector<Vec3> vertices;
  std::set<std::string> names;
  size_t faces = 0, bones = 0, normals = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, name;
    words >> keyword;
    if (keyword == "v" || keyword == "vn") {
      Vec3 v;
      words >> v.x >> v.y >> v.z;
      REQUIRE(words);
      if (keyword == "v") {
        vertices.push_back(v);
      } else {
        ++normals;
        REQUIRE(length(v) == Approx(1).epsilon(1e-9));
      }
    } else if (keyword == "o") {
      words >> name;
      REQUIRE(names.insert(name).second);
    }
    faces += keyword == "f";
    bones += keyword == "l";
  }
  REQUIRE(vertices == expected);
  REQUIRE(normals == of_meshes);
  REQUIRE(faces == triangles);
  REQUIRE(bones == character.rig().bones.size());
  REQUIRE(names.size() == objects);
}

TEST_CASE("rig export: the SVG shows every part, bone and joint from three sides", "[rig_export]") {
  for (const uint64_t seed : {6, 7}) {
    const Evaluation character = evaluated(small(seed));
    const std::string svg = rigToSvg("<a> & \"b\"", character);
    REQUIRE(svg.find("&lt;a&gt; &amp; &quot;b&quot;") != std::string::npos);
    size_t visible = 0;
    for (const RigPart& part : character.rigParts()) visible += part.source->visible;
    REQUIRE(count(svg, "<path ") == 3 * visible);
    REQUIRE(count(svg, "M") >= 3 * visible);
    REQUIRE(count(svg, "r=\"3.50\"") == 3 * character.rig().joints.size());
    REQUIRE(count(svg, "<polygon ") <= 3 * character.rig().bones.size());
    REQUIRE(count(svg, "nan") + count(svg, "inf\"") == 0);
  }
}

TEST_CASE("rig export: a picture is the same at any size", "[rig_export]") {
  const auto picture = [](double scale) {
    Document document = lumps(1);
    for (auto& part : document.parts) {
      auto scaled = std::make_shared<PartSource>(*part);
      for (Vec2& p : scaled->stroke) p = p * scale;
      scaled->frame.origin = scaled->frame.origin * scale;
      part = scaled;
    }
    return rigToSvg("lumps", evaluated(document));
  };
  // Powers of two change no digit on the way.
  REQUIRE(picture(1024) == picture(1));
  REQUIRE(picture(1.0 / 1024) == picture(1));
}

TEST_CASE("rig export: an empty document has texts of its own", "[rig_export]") {
  const Evaluation character = evaluated({});
  const Json tree = rigToTree(character);
  REQUIRE(tree["joints"].empty());
  REQUIRE(tree["roots"].empty());
  REQUIRE(count(rigToObj(character), "\no ") == 0);
  const std::string svg = rigToSvg("", character);
  REQUIRE(svg.rfind("<svg", 0) == 0);
  REQUIRE(svg.find("Unnamed character") != std::string::npos);
}
