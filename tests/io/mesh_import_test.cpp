#include "io/mesh_import.h"

#include <algorithm>

#include "io/document_json.h"
#include "solid/close.h"
#include "solid/solids.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/mesh_files.h"

namespace marrow {
namespace {

struct MeshFile {
  std::string name, bytes;
};

std::vector<MeshFile> filesOf(const Mesh& mesh) {
  return {{"thing.obj", objOf(mesh)},     {"thing.stl", stlOf(mesh)},
          {"thing.STL", textStlOf(mesh)}, {"thing.ply", plyOf(mesh)},
          {"thing.PLY", textPlyOf(mesh)}, {"thing.glb", glbOf(mesh)}};
}

Result<Mesh> imported(const MeshFile& file) {
  const auto format = meshFormatOf(file.bytes, file.name);
  REQUIRE(format);
  return importMesh(file.bytes, *format);
}

std::string refusal(const MeshFile& file) {
  CAPTURE(file.name);
  const auto mesh = imported(file);
  REQUIRE(!mesh);
  const std::string sentence = mesh.message();
  CHECK(sentence.back() == '.');
  CHECK(sentence.find('\n') == std::string::npos);
  return sentence;
}

/// What must hold whatever the bytes are.
void checkAny(const MeshFile& file) {
  const auto format = meshFormatOf(file.bytes, file.name);
  if (!format) return;
  const auto mesh = importMesh(file.bytes, *format);
  if (!mesh) {
    if (mesh.message().empty() || mesh.message().back() != '.') FAIL(mesh.message());
    return;
  }
  const MeshReport report = inspect(*mesh);
  if (!report.closed || !report.manifold || !(report.volume > 0)) FAIL(file.name);
}

}  // namespace

TEST_CASE("mesh import: the same solid comes from every format, about the origin and of size one",
          "[mesh_import]") {
  const Mesh torus = torusMesh({100, -30, 7}, 40, 13, 24, 12);
  const Vec3 size = boxOf(torus.positions).size();
  const double longest = std::max({size.x, size.y, size.z});
  const double volume = inspect(torus).volume / (longest * longest * longest);
  for (const MeshFile& file : filesOf(torus)) {
    CAPTURE(file.name);
    const auto mesh = imported(file);
    REQUIRE(mesh);
    CHECK(mesh->triangles.size() == torus.triangles.size());
    CHECK(mesh->positions.size() == torus.positions.size());
    CHECK(inspect(*mesh).volume == Approx(volume).epsilon(1e-5));
    const Box3 box = boxOf(mesh->positions);
    CHECK(length(box.middle()) < 1e-6);
    CHECK(std::max({box.size().x, box.size().y, box.size().z}) == Approx(1));
    CHECK(box.size().z == Approx(size.z / longest).epsilon(1e-5));
  }
}

TEST_CASE("mesh import: a file is known by what it begins with, or by its name", "[mesh_import]") {
  CHECK(meshFormatOf("glTF....", "any.txt") == MeshFormat::glb);
  CHECK(meshFormatOf("ply\nformat", "any") == MeshFormat::ply);
  CHECK(meshFormatOf("v 0 0 0", "a.Obj") == MeshFormat::obj);
  CHECK(meshFormatOf("solid", "a.stl") == MeshFormat::stl);
  CHECK(!meshFormatOf("{\"format\": \"marrow\"}", "drawing.json"));
  CHECK(!meshFormatOf("", ""));
}

TEST_CASE("mesh import: what is neither a mesh nor a drawing is told which files are",
          "[mesh_import]") {
  for (const char* text : {"{}", "", " \n{\"format\"", "\xEF\xBB\xBF{}"}) {
    CHECK(!unknownFile(text, "drawing.json"));
  }
  for (const char* bytes : {"Kaydara FBX Binary  ", "\x89PNG", "v 0 0 0"}) {
    const auto error = unknownFile(bytes, "thing.fbx");
    REQUIRE(error);
    CHECK(error->message().find("GLB, OBJ, PLY or STL") != std::string::npos);
  }
  const auto error = unknownFile("{\"asset\": {}}", "thing.glTF");
  REQUIRE(error);
  CHECK(error->message().find("as GLB") != std::string::npos);
}

TEST_CASE("mesh import: OBJ faces of any number of corners, with all ways to name them",
          "[mesh_import]") {
  const std::string box =
      "# a box\r\nmtllib none.mtl\r\no Box\r\nv 0 0 0\r\nv 1. 0 0 0.5 0.5 0.5\r\nv 1 1e0 0\r\n"
      "v 0 1 0\r\nv +0 -0 .1e+1\r\nv 1 0 1\r\nv 1 1 1\r\nv 0 1 1\r\nvn 0 0 1\r\ns off\r\n"
      "f 4//1 3//1 2//1 1//1\r\nf 5/1 6/2 7/3 8/4\r\nf 1 2 \\\r\n 6 5\r\n"
      "f 2/1/1 3/1/1 7/1/1 6/1/1\r\nf -6 -5 -1 -2\r\nf 4 1 5 8";
  const auto mesh = imported({"box.obj", box});
  REQUIRE(mesh);
  CHECK(mesh->triangles.size() == 12);
  CHECK(inspect(*mesh).volume == Approx(1));

  // A face like an arrow, which a fan would cut outside itself; and its extrusion.
  std::string arrow;
  const std::vector<Vec2> outline{{0, 0}, {4, 0}, {4, 4}, {3, 1}};
  for (const char* z : {"0", "1"}) {
    for (const Vec2 p : outline) {
      arrow += "v " + toText(toJson(p.x)) + ' ' + toText(toJson(p.y)) + ' ' + z + '\n';
    }
  }
  arrow += "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const auto pointed = imported({"arrow.obj", arrow});
  REQUIRE(pointed);
  const double area = 0.5 * std::abs(cross(outline[1] - outline[0], outline[2] - outline[0]) +
                                     cross(outline[2] - outline[0], outline[3] - outline[0]));
  CHECK(inspect(*pointed).volume == Approx(area / 64));
}

TEST_CASE(
    "mesh import: comments end where their line ends, and a mark of UTF-8 is no part of a word",
    "[mesh_import]") {
  const std::string body =
      "v 0 0 0 # one \\\nv 1 0 0#1\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 4 3 2 1 # bottom\nf 5 6 7 8 #\nf 1 2 \\\n6 5 # front \\\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 "
      "8\n";
  const std::string known = std::string(body).replace(body.find("#1"), 2, "  ");
  for (const char* start : {"\xEF\xBB\xBF", "# C:\\models\\\n", "#\\\r\n"}) {
    const auto mesh = imported({"box.obj", start + known});
    REQUIRE(mesh);
    CHECK(mesh->triangles.size() == 12);
    CHECK(inspect(*mesh).volume == Approx(1));
  }
  CHECK(refusal({"box.obj", body}).find("three numbers") != std::string::npos);

  std::string ply = textPlyOf(boxMesh({}, {1, 1, 1}));
  ply.insert(ply.find("element"), "comment C:\\models\\\n");
  const auto mesh = imported({"box.ply", ply});
  REQUIRE(mesh);
  CHECK(mesh->triangles.size() == 12);
}

TEST_CASE("mesh import: faces of many corners and faces with holes are cut within themselves",
          "[mesh_import]") {
  // The prism over a polygon whose first corner is a reflex one.
  const auto prism = [](const std::vector<Vec2>& outline) {
    std::string text;
    const size_t n = outline.size();
    for (const double z : {0., 1.}) {
      for (const Vec2 p : outline) text += "v " + numbersOf({p.x, p.y, z}) + '\n';
    }
    text += 'f';
    for (size_t i = n; i > 0; --i) text += ' ' + std::to_string(i);
    text += "\nf";
    for (size_t i = 1; i <= n; ++i) text += ' ' + std::to_string(n + i);
    text += '\n';
    for (size_t i = 0; i < n; ++i) {
      text += 'f';
      for (const size_t corner : {i, (i + 1) % n, n + (i + 1) % n, n + i}) {
        text += ' ' + std::to_string(corner + 1);
      }
      text += '\n';
    }
    return text;
  };
  for (const int points : {8, 20, 60, 600}) {
    CAPTURE(points);
    std::vector<Vec2> star = unitCircle(2 * points);
    double area = 0;
    for (size_t i = 0; i < star.size(); ++i) star[i] = star[i] * (i % 2 ? 3. : 1.);
    for (size_t i = 0; i < star.size(); ++i) {
      area += 0.5 * cross(star[i], star[(i + 1) % star.size()]);
    }
    const auto mesh = importMesh(prism(star), MeshFormat::obj);
    REQUIRE(mesh);
    const double height = boxOf(mesh->positions).size().z;
    CHECK(inspect(*mesh).volume == Approx(area * height * height * height));
    CHECK_FALSE(crossesItself(*mesh));
  }

  std::string ring;
  for (const char* z : {" 0\n", " 1\n"}) {
    for (const char* xy : {"0 0", "4 0", "4 4", "0 4", "1 1", "3 1", "3 3", "1 3"}) {
      ring += std::string("v ") + xy + z;
    }
  }
  ring += "f 9 10 11 12 9 13 16 15 14 13\nf 1 5 6 7 8 5 1 4 3 2\n";
  for (const auto& [from, turn] : {std::pair<int, int>{1, 1}, {5, 3}}) {
    for (int i = 0; i < 4; ++i) {
      const int a = from + turn * i % 4, b = from + turn * (i + 1) % 4;
      ring += 'f';
      for (const int corner : {a, b, b + 8, a + 8}) ring += ' ' + std::to_string(corner);
      ring += '\n';
    }
  }
  const auto mesh = importMesh(ring, MeshFormat::obj);
  REQUIRE(mesh);
  CHECK(inspect(*mesh).volume == Approx(12. / 64));
  CHECK_FALSE(crossesItself(*mesh));
}

TEST_CASE(
    "mesh import: STL has z up; whatever its name is, text is read as text and bytes as bytes",
    "[mesh_import]") {
  const Mesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 "
      "3\nendloop\nendfacet\n";
  for (const char* name : {"", " my vertex thing", " vertex 1 2", " # 1"}) {
    const auto mesh =
        readMesh(std::string("solid") + name + "\n" + facet + "endsolid" + name, MeshFormat::stl);
    REQUIRE(mesh);
    REQUIRE(mesh->positions.size() == 3);
    CHECK(mesh->positions[2] == Vec3{0, 3, -2});
  }
  std::string padded = stlOf(box);
  padded.replace(0, 6, "solid ");
  for (int i = 0; i < 3; ++i) {
    const auto mesh = readMesh(padded, MeshFormat::stl);
    REQUIRE(mesh);
    CHECK(mesh->triangles.size() == 12);
    CHECK(boxOf(mesh->positions).high == Vec3{1, 2, 3});  // as it was before it was written
    padded += '\n';
  }
}

TEST_CASE("mesh import: numbers of text are the nearest doubles", "[mesh_import]") {
  const std::vector<std::pair<std::string, double>> known{
      {"0.1", 0.1},
      {".5", 0.5},
      {"5.", 5},
      {"-.5e1", -5},
      {"+007.250", 7.25},
      {"1.e2", 100},
      {"123456789012345678901234567890", 123456789012345678901234567890.0},
      {"0.1000000000000000055511151231257827", 0.1},
      {"-00.00000000000000000000000000000000001", -1e-35},
      {"1E-40", 1e-40}};
  for (const auto& [text, value] : known) {
    CAPTURE(text);
    const auto mesh = readMesh("v " + text + " 0 0\n", MeshFormat::obj);
    REQUIRE(mesh);
    CHECK(mesh->positions[0].x == value);
  }
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "nan", "inf", "0x10", "1,5", "1e999"}) {
    CAPTURE(text);
    CHECK(!readMesh(std::string("v 0 0 ") + text + "\n", MeshFormat::obj));
  }
}

TEST_CASE("mesh import: what is no such file is refused in one sentence", "[mesh_import]") {
  const std::string header = "ply\nformat ascii 1.0\n";
  const MeshFile files[] = {
      {"a.obj", "v 1 2\n"},
      {"b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
      {"c.obj", "f 1 2 3\n"},
      {"d.obj", "v 0 0 0\nf 0 1 1\n"},
      {"e.obj", "v 0 0 0\nf 1 1\n"},
      {"f.obj", ""},
      {"g.obj", "v 1e60 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"a.stl", ""},
      {"b.stl", "solid\nvertex 1 2\n"},
      {"c.stl", "solid\nvertex 1 2 3\n"},
      {"d.stl", std::string(84, 'x')},
      {"a.ply", "ply\n"},
      {"b.ply", header + "element vertex 3\nproperty float x\nend_header\n1 2"},
      {"c.ply", header + "element vertex -3\nproperty float x\nend_header\n1 2"},
      {"d.ply", header + "property float x\nend_header\n"},
      {"e.ply", header + "element vertex 1\nproperty quad x\nend_header\n"},
      {"f.ply", "ply\nformat binary_big_endian 1.0\nend_header\n"},
      {"g.ply", header + "element face 1\nproperty list char int vertex_indices\nend_header\n-1\n"},
      {"h.ply",
       header + "element face 1\nproperty list int int vertex_index\nend_header\n3 0 1 2\n"},
      {"a.glb", "glTF"},
      {"b.glb", glbOf("[]", "")},
      {"c.glb", glbOf("{\"nodes\": [{\"children\": [0]}], \"scenes\": [{\"nodes\": [0]}]}", "")},
      {"d.glb", glbOf("{\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]}", "")},
      {"e.glb", glbOf("{\"nodes\": 7, \"scenes\": [{\"nodes\": 3}]}", "")},
      {"f.glb", glbOf(boxMesh({}, {1, 1, 1}), "\"matrix\": [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1], ")}};
  for (const MeshFile& file : files) CHECK_FALSE(refusal(file).empty());
  CHECK(refusal({"x.glb", glbOf("{\"extensionsRequired\":[\"EXT_meshopt_compression\"]}", "")})
            .find("compressed") != std::string::npos);
}

TEST_CASE("mesh import: counts that the bytes do not bear cost nothing", "[mesh_import]") {
  std::string stl(80, ' ');
  append<uint32_t>(stl, 0xFFFFFFFF);
  CHECK_FALSE(refusal({"a.stl", stl}).empty());
  for (const char* count : {"4294967295", "99999999999999", "600001"}) {
    CHECK_FALSE(refusal({"a.ply", std::string("ply\nformat binary_little_endian 1.0\nelement "
                                              "vertex ") +
                                      count + "\nproperty float x\nend_header\n"})
                    .empty());
  }
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint float "
      "vertex_indices\nend_header\n";
  append<uint32_t>(ply, 0xFFFFFFF0);
  CHECK_FALSE(refusal({"b.ply", ply}).empty());
  CHECK_FALSE(refusal({"c.ply",
                       "ply\nformat ascii 1.0\nelement thing 4000000000\nproperty float "
                       "x\nend_header\n"})
                  .empty());
  std::string often = "ply\nformat binary_little_endian 1.0\n";
  for (int i = 0; i < 3; ++i) often += "element vertex 250000\nproperty uchar x\n";
  often += "end_header\n" + std::string(750'000, '\0');
  CHECK(readMesh(often, MeshFormat::ply).status() == Status::tooMany);
  CHECK(importMesh("ply\nformat ascii 1.0\nelement vertex 600000\nend_header\n", MeshFormat::ply)
            .status() == Status::notSolid);
  for (const char* count : {"9007199254740991", "1e300", "-1", "0.5", "4294967296"}) {
    const std::string glb = glbOf(std::string(
                                      R"({"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{}],
"bufferViews":[{"buffer":0,"byteLength":16}],
"accessors":[{"bufferView":0,"type":"VEC3","componentType":5126,"count":)") +
                                      count + "}]}",
                                  std::string(16, '\0'));
    CHECK_FALSE(refusal({"a.glb", glb}).empty());
  }
}

TEST_CASE("mesh import: more triangles than a part holds are refused by their number",
          "[mesh_import]") {
  const Mesh fine = sphereMesh({}, 1, 7);
  REQUIRE(fine.triangles.size() > kMostTriangles);
  const auto mesh = importMesh(stlOf(fine), MeshFormat::stl);
  REQUIRE(!mesh);
  CHECK(mesh.status() == Status::tooMany);
  CHECK(mesh.message().find("100,000") != std::string::npos);
}

TEST_CASE("mesh import: files cut short or changed in any byte are a solid or a sentence",
          "[mesh_import]") {
  Random random(6);
  for (const MeshFile& file : filesOf(sphereMesh({3, 2, 1}, 2, 1))) {
    for (size_t size = 0; size < file.bytes.size(); size += 1 + file.bytes.size() / 150) {
      checkAny({file.name, file.bytes.substr(0, size)});
    }
    for (int run = 0; run < 300; ++run) {
      MeshFile other = file;
      for (int i = 1 + random.below(4); i > 0; --i) {
        const auto at = static_cast<size_t>(random.below(static_cast<int>(other.bytes.size())));
        if (random.below(3) == 0) {
          other.bytes.erase(at, static_cast<size_t>(1 + random.below(8)));
        } else {
          other.bytes[at] = random.below(2) ? static_cast<char>(random.below(256))
                                            : "0129-. \n{}[]\"e"[random.below(14)];
        }
        if (other.bytes.empty()) break;
      }
      checkAny(other);
    }
  }
}

}  // namespace marrow
