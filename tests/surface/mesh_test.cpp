#include "surface/mesh.h"

#include <algorithm>

#include "support/catch.h"
#include "support/meshes.h"

using namespace marrow;

namespace {

Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};
}

/// Unit sphere of `rows` by 2 `rows` patches, poles on the z axis.
Mesh sphere(int rows) {
  Mesh mesh;
  const uint32_t columns = 2 * static_cast<uint32_t>(rows);
  mesh.positions.push_back({0, 0, 1});
  for (int r = 1; r < rows; ++r) {
    for (uint32_t c = 0; c < columns; ++c) {
      const double polar = kPi * r / rows, around = 2 * kPi * c / columns;
      mesh.positions.push_back({std::sin(polar) * std::cos(around),
                                std::sin(polar) * std::sin(around), std::cos(polar)});
    }
  }
  mesh.positions.push_back({0, 0, -1});
  const uint32_t south = static_cast<uint32_t>(mesh.positions.size()) - 1;
  for (uint32_t c = 0; c < columns; ++c) {
    const uint32_t d = (c + 1) % columns;
    mesh.triangles.push_back({0, 1 + c, 1 + d});
    for (uint32_t r = 0; r + 2 < static_cast<uint32_t>(rows); ++r) {
      const uint32_t row = 1 + r * columns, below = row + columns;
      mesh.triangles.push_back({row + c, below + c, below + d});
      mesh.triangles.push_back({row + c, below + d, row + d});
    }
    mesh.triangles.push_back({south - columns + c, south, south - columns + d});
  }
  return mesh;
}

/// True where one of the sentences has the words.
bool says(const std::vector<std::string>& sentences, const std::string& words) {
  return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
    return sentence.find(words) != std::string::npos;
  });
}

Mesh joined(Mesh a, const Mesh& b) {
  const uint32_t shift = static_cast<uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({i + shift, j + shift, k + shift});
  return a;
}

}  // namespace

TEST_CASE("mesh: nothing is wrong with a tetrahedron, and its measures are right", "[mesh]") {
  const Mesh mesh = tetrahedron();
  CHECK(validate(mesh).empty());
  const MeshReport report = inspect(mesh);
  CHECK(report.closed);
  CHECK(report.manifold);
  CHECK(report.volume == Approx(1.0 / 6));
  CHECK(report.area == Approx(1.5 + std::sqrt(3.0) / 2));
  CHECK(report.degenerate == 0);
}

TEST_CASE("mesh: volume and area of a sphere, wherever and however large it is", "[mesh]") {
  for (const double size : {1e-4, 1.0, 1e6}) {
    Mesh mesh = sphere(60);
    for (Vec3& p : mesh.positions) p = p * size + Vec3{5, -7, 3} * size;
    CHECK(validate(mesh).empty());
    const MeshReport report = inspect(mesh);
    CHECK(report.volume == Approx(4 * kPi / 3 * size * size * size).epsilon(0.01));
    CHECK(report.area == Approx(4 * kPi * size * size).epsilon(0.01));
  }
}

TEST_CASE("mesh: a missing triangle is reported as a hole with its edges", "[mesh]") {
  Mesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  const std::vector<std::string> faults = validate(mesh);
  CHECK(says(faults, "edge 0–2 has one triangle only"));
  CHECK(says(faults, "edge 0–3 has one triangle only"));
  CHECK(says(faults, "edge 2–3 has one triangle only"));
  CHECK_FALSE(says(faults, "flipped"));
  CHECK_FALSE(inspect(mesh).closed);
  CHECK(inspect(mesh).manifold);
}

TEST_CASE("mesh: a flipped triangle is reported by its edges", "[mesh]") {
  Mesh mesh = sphere(8);
  std::swap(mesh.triangles[20][0], mesh.triangles[20][1]);
  const std::vector<std::string> faults = validate(mesh);
  CHECK(faults.size() == 3);
  CHECK(says(faults, "a triangle is flipped"));
  CHECK(inspect(mesh).closed);
  CHECK_FALSE(inspect(mesh).manifold);
}

TEST_CASE("mesh: a repeated corner and a triangle without area are told apart", "[mesh]") {
  Mesh mesh = tetrahedron();
  mesh.triangles.push_back({1, 1, 2});
  CHECK(says(validate(mesh), "triangle 4 has the same corner twice"));
  CHECK(inspect(mesh).degenerate == 1);

  Mesh flat = tetrahedron();
  flat.positions[3] = {0.5, 0.5, 0};  // on edge 1–2
  CHECK(says(validate(flat), "triangle 2 has no area"));
  CHECK(says(validate(flat), "encloses no volume"));
  CHECK(inspect(flat).degenerate == 1);
}

TEST_CASE("mesh: two fans at a vertex are reported there", "[mesh]") {
  Mesh other = tetrahedron();
  for (Vec3& p : other.positions) p = -p;
  for (auto& t : other.triangles) std::swap(t[1], t[2]);
  Mesh mesh = joined(tetrahedron(), other);
  CHECK(validate(mesh).empty());
  for (auto& t : mesh.triangles) std::replace(t.begin(), t.end(), 4u, 0u);
  const std::vector<std::string> faults = validate(mesh);
  CHECK(faults == std::vector<std::string>{"vertex 0 joins more than one fan of triangles"});
  CHECK(inspect(mesh).closed);
  CHECK_FALSE(inspect(mesh).manifold);
}

TEST_CASE("mesh: an edge with four triangles is reported with their number", "[mesh]") {
  // Two tetrahedra hinged along edge 0–1.
  Mesh other = tetrahedron();
  for (Vec3& p : other.positions) p = {p.x, -p.y, -p.z};
  Mesh mesh = joined(tetrahedron(), other);
  for (auto& t : mesh.triangles) {
    std::replace(t.begin(), t.end(), 4u, 0u);
    std::replace(t.begin(), t.end(), 5u, 1u);
  }
  CHECK(says(validate(mesh), "edge 0–1 has 4 triangles"));
  CHECK_FALSE(inspect(mesh).manifold);
}

TEST_CASE("mesh: inward triangles are reported, and nothing else", "[mesh]") {
  Mesh mesh = sphere(6);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  CHECK(validate(mesh) ==
        std::vector<std::string>{"the volume is negative: the triangles face inward"});
  CHECK(inspect(mesh).volume < 0);
}

TEST_CASE("mesh: corners out of range, coordinates that are no number, and nothing at all are said",
          "[mesh]") {
  Mesh mesh = tetrahedron();
  mesh.triangles[1][2] = 9;
  CHECK(says(validate(mesh), "triangle 1 has a corner that is not among the vertices"));
  CHECK_FALSE(inspect(mesh).closed);

  Mesh broken = tetrahedron();
  broken.positions[2].y = std::nan("");
  CHECK(says(validate(broken), "vertex 2 has a coordinate that is no number"));

  CHECK(validate(Mesh{}) == std::vector<std::string>{"the mesh has no triangles"});
  CHECK_FALSE(inspect(Mesh{}).closed);
}

TEST_CASE("mesh: many faults of a kind are counted, not listed", "[mesh]") {
  Mesh mesh = sphere(20);
  mesh.triangles.resize(mesh.triangles.size() / 2);
  const std::vector<std::string> faults = validate(mesh);
  CHECK(faults.size() < 20);
  CHECK(says(faults, "more like it"));
}

TEST_CASE("mesh: normals of a sphere point from its centre, however uneven the triangles",
          "[mesh]") {
  for (const double size : {1e-4, 1.0, 1e6}) {
    Mesh mesh = sphere(12);
    for (Vec3& p : mesh.positions) p = p * size;
    const std::vector<Vec3> normals = vertexNormals(mesh);
    REQUIRE(normals.size() == mesh.positions.size());
    double worst = 1;
    for (size_t v = 0; v < normals.size(); ++v) {
      CHECK(length(normals[v]) == Approx(1));
      worst = std::min(worst, dot(normals[v], mesh.positions[v] / length(mesh.positions[v])));
    }
    CHECK(worst > 1 - 1e-9);
  }
}

TEST_CASE("mesh: a vertex without a triangle still has a unit normal", "[mesh]") {
  Mesh mesh = tetrahedron();
  mesh.positions.push_back({3, 3, 3});
  const Vec3 normal = vertexNormals(mesh).back();
  CHECK(length(normal) == 1);
}
