#include "io/part_export.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.h"
#include "support/drawings.h"
#include "support/text.h"

using namespace marrow;

namespace {

Part star() {
  auto part = buildPart(softStar(5, 100));
  REQUIRE(part);
  return *part;
}

}  // namespace

TEST_CASE("export: the JSON holds the part's numbers to the bit", "[part_export]") {
  const Part part = star();
  const auto tree = nlohmann::json::parse(partToJson("a \"b\"\n", part), nullptr, false);
  REQUIRE_FALSE(tree.is_discarded());
  REQUIRE(tree["name"] == "a \"b\"\n");
  REQUIRE(tree["outline"].size() == part.outline.dense.size());
  REQUIRE(tree["polygon"].size() == part.outline.polygon.size());
  for (size_t i = 0; i < part.outline.dense.size(); ++i) {
    REQUIRE(tree["outline"][i][0].get<double>() == part.outline.dense[i].x);
    REQUIRE(tree["outline"][i][1].get<double>() == part.outline.dense[i].y);
  }
  const auto& straight = tree["straightSkeleton"];
  REQUIRE(straight["method"] == toString(part.straight_skeleton.method));
  REQUIRE(straight["edges"].size() == part.straight_skeleton.edges.size());
  for (size_t i = 0; i < part.straight_skeleton.nodes.size(); ++i) {
    REQUIRE(straight["nodes"][i][0].get<double>() == part.straight_skeleton.nodes[i].x);
    REQUIRE(straight["nodes"][i][2].get<double>() == part.straight_skeleton.times[i]);
  }
  REQUIRE(straight["edges"][0][2] == "border");
  const auto& joints = tree["skeleton"]["joints"];
  REQUIRE(joints.size() == part.skeleton.joints.size());
  for (size_t i = 0; i < joints.size(); ++i) {
    REQUIRE(joints[i]["kind"] == toString(part.skeleton.joints[i].kind));
    REQUIRE(joints[i]["position"][1].get<double>() == part.skeleton.joints[i].position.y);
    REQUIRE(joints[i]["position"][2] == 0);
    REQUIRE(joints[i]["radius"].get<double>() == part.skeleton.joints[i].radius);
  }
  REQUIRE(tree["skeleton"]["bones"].size() == part.skeleton.bones.size());
  REQUIRE(tree["mesh"]["vertices"] == part.mesh.positions.size());
  REQUIRE(tree["mesh"]["triangles"] == part.mesh.triangles.size());
  REQUIRE(tree["mesh"]["closed"] == true);
  REQUIRE(tree["mesh"]["manifold"] == true);
  REQUIRE(tree["mesh"]["volume"].get<double>() == inspect(part.mesh).volume);
  REQUIRE(tree["timings"].size() == part.timings.stages_ms.size() + 1);
  REQUIRE(tree["timings"]["total"] == 0);
}

TEST_CASE("export: the OBJ read back is the mesh and the bones", "[part_export]") {
  const Part part = star();
  std::istringstream lines(partToObj("big star", part));
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> faces;
  size_t normals = 0, bones = 0, objects = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      Vec3 v;
      words >> v.x >> v.y >> v.z;
      vertices.push_back(v);
    } else if (keyword == "f") {
      std::array<uint32_t, 3> corners;
      for (uint32_t& corner : corners) {
        uint32_t normal = 0;
        char slash;
        words >> corner >> slash >> slash >> normal;
        REQUIRE(normal == corner);
        --corner;
      }
      faces.push_back(corners);
    } else if (keyword == "l") {
      uint32_t a, b;
      words >> a >> b;
      const auto& bone = part.skeleton.bones[bones++];
      const Vec2 joint = part.skeleton.joints[bone[0]].position;
      REQUIRE(vertices[a - 1].x == joint.x);
      REQUIRE(vertices[a - 1].y == joint.y);
      REQUIRE(vertices[b - 1].z == 0);
    }
    normals += keyword == "vn";
    objects += keyword == "o";
    REQUIRE(words);
  }
  REQUIRE(objects == 2);
  REQUIRE(faces == part.mesh.triangles);
  REQUIRE(normals == part.mesh.positions.size());
  REQUIRE(bones == part.skeleton.bones.size());
  for (size_t i = 0; i < part.mesh.positions.size(); ++i) {
    REQUIRE(vertices[i].x == part.mesh.positions[i].x);
    REQUIRE(vertices[i].y == part.mesh.positions[i].y);
    REQUIRE(vertices[i].z == part.mesh.positions[i].z);
  }
}

TEST_CASE("export: an OBJ name is one word on one line", "[part_export]") {
  const Part part = star();
  const std::string obj = partToObj("a b\nv 1 2 3\r\tc", part);
  REQUIRE(obj.find("o a_b_v_1_2_3__c\n") != std::string::npos);
  REQUIRE(partToObj("", part).find("o part\n") != std::string::npos);
}

TEST_CASE("export: the SVG shows every joint, ball and bone", "[part_export]") {
  const Part part = star();
  const std::string svg = partToSvg("<star> & \"co\"", part);
  REQUIRE(svg.find("&lt;star&gt; &amp; &quot;co&quot;") != std::string::npos);
  REQUIRE(count(svg, "<star>") == 0);
  const auto group = [&](const std::string& id) {
    const size_t start = svg.find("<g id=\"" + id + "\"");
    REQUIRE(start != std::string::npos);
    return svg.substr(start, svg.find("</g>", start) - start);
  };
  REQUIRE(count(group("joints"), "<circle") == part.skeleton.joints.size());
  REQUIRE(count(group("balls"), "<circle") == part.skeleton.joints.size());
  REQUIRE(count(group("bones"), "<polygon") == part.skeleton.bones.size());
  REQUIRE(count(group("vertices"), "<circle") == part.outline.polygon.size());
  REQUIRE(count(svg, "nan") + count(svg, "inf\"") == 0);
}

TEST_CASE("export: a stroke's picture is the same at any size", "[part_export]") {
  const auto picture = [](double scale) {
    std::vector<Vec2> stroke = softStar(4, 100);
    for (Vec2& point : stroke) point = point * scale;
    auto part = buildPart(stroke);
    REQUIRE(part);
    return partToSvg("star", *part);
  };
  // Powers of two change no digit on the way.
  REQUIRE(picture(1024) == picture(1));
  REQUIRE(picture(1.0 / 1024) == picture(1));
}
