#include "io/glb.h"
#include "io/mesh_import.h"
#include "pose/rigs.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/mesh_files.h"

namespace marrow {
TEST_CASE("import glb: nodes of a GLB place its meshes, and every way to draw triangles counts",
          "[import_glb]") {
  const Mesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  const auto flat = importMesh(glbOf(box, "\"scale\": [1, 0.5, -2], "), MeshFormat::glb);
  REQUIRE(flat);
  CHECK(inspect(*flat).volume == Approx(1. / 8));
  const auto moved = readMesh(
      glbOf(box, "\"rotation\": [0, 0, 1, 1], \"translation\": [10, 0, 0], "), MeshFormat::glb);
  REQUIRE(moved);
  CHECK(length(boxOf(moved->positions).middle() - Vec3{9.5, 0.5, 0.5}) < 1e-12);
  const auto by_matrix =
      readMesh(glbOf(box, "\"matrix\": [2,0,0,0, 0,2,0,0, 0,0,2,0, 1,2,3,1], "), MeshFormat::glb);
  REQUIRE(by_matrix);
  CHECK(length(boxOf(by_matrix->positions).middle() - Vec3{2, 3, 4}) < 1e-12);

  // A tetrahedron as a strip, its vertices as bytes from −1 to 1.
  std::string binary;
  for (const int number :
       {127, 127, 127, 0, -127, -127, 127, 0, -127, 127, -127, 0, 127, -127, -127, 0}) {
    append(binary, static_cast<int8_t>(number));
  }
  for (const int name : {0, 1, 2, 3, 0, 1}) append(binary, static_cast<uint8_t>(name));
  const auto strip =
      readMesh(glbOf(
                   R"({"scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"mesh":0}],
"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{}],
"bufferViews":[{"buffer":0,"byteLength":16,"byteStride":4},
{"buffer":0,"byteOffset":16,"byteLength":6}],
"accessors":[{"bufferView":0,"type":"VEC3","componentType":5120,"normalized":true,"count":4},
{"bufferView":1,"type":"SCALAR","componentType":5121,"count":6}]})",
                   binary),
               MeshFormat::glb);
  REQUIRE(strip);
  const MeshReport report = inspect(*strip);
  CHECK(report.closed);
  CHECK(report.manifold);
  CHECK(std::abs(report.volume) == Approx(8. / 3));
}

TEST_CASE("import glb: a character that was exported comes back as one solid at rest",
          "[import_glb]") {
  Random random(5);
  const Rig rig = randomRig(random, 9);
  SkinnedMesh body = skinnedMesh(sphereMesh({50, 20, 10}, 30, 3));
  body.skin.resize(body.mesh.positions.size());
  for (VertexSkin& skin : body.skin) skin.weights = {1, 0, 0, 0};
  const auto bytes =
      toGlb({"Ball", rig, {body}, {{"Paint", {}, {}}}, {}, "{\"format\": \"marrow\"}"});
  REQUIRE(bytes);
  const auto mesh = readMesh(*bytes, MeshFormat::glb);
  REQUIRE(mesh);
  CHECK(length(boxOf(mesh->positions).middle() - Vec3{0.5, 0.2, 0.1}) < 1e-6);
  CHECK(importMesh(*bytes, MeshFormat::glb));
  CHECK(documentInGlb(*bytes) == "{\"format\": \"marrow\"}");
  CHECK(!documentInGlb(glbOf(boxMesh({}, {1, 1, 1}))));
  CHECK(!documentInGlb("glTF"));
}

TEST_CASE("import glb: a skin is seen as its joints hold it at rest, whatever it was bound in",
          "[import_glb]") {
  // Two meshes on the same joints, the second of which moved 5 to the right since. Each skin
  // begins with another one.
  const Mesh box = boxMesh({}, {1, 1, 1});
  std::string binary;
  for (const Vec3 p : box.positions) {
    for (const double number : {p.x, p.y, p.z}) append(binary, static_cast<float>(number));
  }
  for (const auto& triangle : box.triangles) {
    for (const uint32_t corner : triangle) append(binary, static_cast<uint8_t>(corner));
  }
  const auto glb = [&](int one, int other, float share) {
    std::string all = binary;
    for (int i = 0; i < 8; ++i) {
      for (const int joint : {one, other, 0, 0}) append(all, static_cast<uint8_t>(joint));
    }
    for (int i = 0; i < 8; ++i) {
      for (const float weight : {share, 1 - share, 0.f, 0.f}) append(all, weight);
    }
    return glbOf(R"({"scenes":[{"nodes":[0,2,3]}],
"nodes":[{"children":[1]},{"translation":[5,0,0]},{"mesh":0,"skin":0},
{"mesh":1,"skin":1,"translation":[0,70,0]}],"skins":[{"joints":[0,1]},{"joints":[1,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]},
{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]}],
"buffers":[{}],"bufferViews":[{"buffer":0,"byteLength":96},
{"buffer":0,"byteOffset":96,"byteLength":36},{"buffer":0,"byteOffset":132,"byteLength":32},
{"buffer":0,"byteOffset":164,"byteLength":128}],
"accessors":[{"bufferView":0,"type":"VEC3","componentType":5126,"count":8},
{"bufferView":1,"type":"SCALAR","componentType":5121,"count":36},
{"bufferView":2,"type":"VEC4","componentType":5121,"count":8},
{"bufferView":3,"type":"VEC4","componentType":5126,"count":8}]})",
                 all);
  };
  const auto mesh = readMesh(glb(0, 1, 0.75f), MeshFormat::glb);
  REQUIRE(mesh);
  REQUIRE(mesh->positions.size() == 16);
  for (size_t i = 0; i < 8; ++i) {
    CHECK(mesh->positions[i] == box.positions[i] + Vec3{1.25, 0, 0});
    CHECK(mesh->positions[8 + i] == box.positions[i] + Vec3{3.75, 0, 0});
  }
  CHECK(readMesh(glb(0, 9, 0.5f), MeshFormat::glb).status() == Status::unreadable);
}

TEST_CASE("import glb: a GLB without scenes shows all its nodes", "[import_glb]") {
  std::string bytes = glbOf(boxMesh({}, {1, 1, 1}), "\"scale\": [1, 2, 4], ");
  const std::string scenes = R"("scene":0,"scenes":[{"nodes":[0]}],)";
  const size_t at = bytes.find(scenes);
  REQUIRE(at != std::string::npos);
  bytes.replace(at, scenes.size(), std::string(scenes.size(), ' '));
  const auto mesh = readMesh(bytes, MeshFormat::glb);
  REQUIRE(mesh);
  CHECK(boxOf(mesh->positions).size() == Vec3{1, 2, 4});
}

TEST_CASE("import glb: bytes that another program put in a drawing's place are no drawing",
          "[import_glb]") {
  const auto glb = [](const std::string& inside) {
    return glbOf(R"({"asset":{"extras":{"marrow":{"document":0}}},"buffers":[{}],
"bufferViews":[{"buffer":0,"byteLength":)" +
                     std::to_string(inside.size()) + "}]}",
                 inside);
  };
  const std::string drawing = R"({"format":"marrow","version":1})";
  CHECK(documentInGlb(glb(drawing)) == drawing);
  for (const char* other :
       {"", "\x01\x02\x03\x04", "[1, 2]", "{", "{}", R"({"format":7})", R"({"format":"other"})"}) {
    CHECK(!documentInGlb(glb(other)));
  }
}

TEST_CASE("import glb: pieces that add nothing are counted, too", "[import_glb]") {
  constexpr int kMany = 400;
  std::string text = R"({"scenes":[{"nodes":[0)";
  for (int i = 1; i < kMany; ++i) text += ',' + std::to_string(i);
  text += R"(]}],"nodes":[{"mesh":0})";
  for (int i = 1; i < kMany; ++i) text += R"(,{"mesh":0})";
  text += R"(],"meshes":[{"primitives":[{"mode":0})";
  for (int i = 1; i < kMany; ++i) text += R"(,{"mode":0})";
  const auto mesh = importMesh(glbOf(text + "]}]}", ""), MeshFormat::glb);
  REQUIRE(!mesh);
  CHECK(mesh.status() == Status::tooMany);
}

}  // namespace marrow
