#include "surface/sharp.h"

#include <algorithm>

#include "solid/solids.h"
#include "support/catch.h"

namespace marrow {

TEST_CASE("sharp: the corners of a box have the normals of its faces", "[sharp]") {
  const Mesh box = gridBoxMesh({0, 0, 0}, {1, 2, 3}, 3);
  const auto corners = cornerNormals(box);
  REQUIRE(corners.size() == box.triangles.size());
  for (size_t t = 0; t < box.triangles.size(); ++t) {
    const auto [a, b, c] = box.triangles[t];
    const Vec3 p = box.positions[a];
    const Vec3 face = cross(box.positions[b] - p, box.positions[c] - p);
    for (const Vec3 normal : corners[t]) CHECK(length(normal - face / length(face)) < 1e-12);
  }
  const SplitVertices split = splitByNormals(box, corners);
  CHECK(split.vertices.size() == 6 * 16);
  REQUIRE(split.triangles.size() == box.triangles.size());
  for (size_t t = 0; t < box.triangles.size(); ++t) {
    for (size_t k = 0; k < 3; ++k) {
      CHECK(split.vertices[split.triangles[t][k]] == box.triangles[t][k]);
      CHECK(split.normals[split.triangles[t][k]] == corners[t][k]);
    }
  }
}

TEST_CASE("sharp: smooth surfaces have their smooth normals, and no vertex twice", "[sharp]") {
  for (const Mesh& mesh : {sphereMesh({1, 2, 3}, 5, 3), torusMesh({}, 3, 1, 40, 24)}) {
    const auto corners = cornerNormals(mesh);
    const std::vector<Vec3> smooth = vertexNormals(mesh);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (size_t k = 0; k < 3; ++k) CHECK(corners[t][k] == smooth[mesh.triangles[t][k]]);
    }
    CHECK(splitByNormals(mesh, corners).vertices.size() == mesh.positions.size());
  }
}

TEST_CASE("sharp: an edge is sharp from 40 degrees on, and ends where the surface is smooth",
          "[sharp]") {
  // A ring of as many flat sides, between two points.
  const auto spindle = [](int sides) {
    Mesh mesh;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * kPi * i / sides;
      for (const double z : {-1., 1.}) {
        mesh.positions.push_back({10 * std::cos(angle), 10 * std::sin(angle), 300 * z});
      }
    }
    const auto n = static_cast<uint32_t>(2 * sides);
    mesh.positions.push_back({0, 0, -301});
    mesh.positions.push_back({0, 0, 301});
    for (uint32_t a = 0; a < n; a += 2) {
      const uint32_t b = (a + 2) % n;
      mesh.triangles.insert(mesh.triangles.end(),
                            {{a, b, b + 1}, {a, b + 1, a + 1}, {b, a, n}, {a + 1, b + 1, n + 1}});
    }
    return mesh;
  };
  const auto copies = [](const Mesh& mesh) {
    return splitByNormals(mesh, cornerNormals(mesh)).vertices.size();
  };
  CHECK(copies(spindle(10)) == 10 * 2 * 2 + 2);  // 36° between sides; the ends are sharp
  CHECK(copies(spindle(8)) == 8 * 2 * 3 + 2);    // 45°
}

}  // namespace marrow
