// Meshes as files of other programs, for tests of the readers.
#pragma once

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "io/json.h"
#include "io/mesh_export.h"

namespace marrow {

inline SkinnedMesh skinnedMesh(const Mesh& mesh) {
  SkinnedMesh made;
  made.name = "Thing";
  made.mesh = mesh;
  made.normals = vertexNormals(mesh);
  made.paint_of_triangle.assign(mesh.triangles.size(), 0);
  return made;
}

inline std::string objOf(const Mesh& mesh) { return toObj(skinnedMesh(mesh), {{"Paint", {}, {}}}); }
inline std::string stlOf(const Mesh& mesh) { return *toStl(skinnedMesh(mesh)); }
inline std::string plyOf(const Mesh& mesh) {
  return *toPly(skinnedMesh(mesh), {{"Paint", {}, {}}});
}

inline std::string numbersOf(Vec3 p) {
  return toText(toJson(p.x)) + ' ' + toText(toJson(p.y)) + ' ' + toText(toJson(p.z));
}

inline std::string textStlOf(const Mesh& mesh) {
  std::string text = "solid thing\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const uint32_t corner : triangle) {
      const Vec3 p = mesh.positions[corner];
      text += "  vertex " + numbersOf({p.x, -p.z, p.y}) + '\n';  // z is up in STL
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid thing\n";
}

inline std::string textPlyOf(const Mesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                     std::to_string(mesh.positions.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3 p : mesh.positions) text += numbersOf(p) + '\n';
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  }
  return text;
}

template <typename T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

inline std::string glbOf(const std::string& json, std::string binary) {
  std::string text = json, bytes = "glTF";
  while (text.size() % 4 != 0) text += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  append<uint32_t>(bytes, 2);
  append(bytes, static_cast<uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
  append(bytes, static_cast<uint32_t>(text.size()));
  append<uint32_t>(bytes, 0x4E4F534A);
  bytes += text;
  append(bytes, static_cast<uint32_t>(binary.size()));
  append<uint32_t>(bytes, 0x004E4942);
  return bytes + binary;
}

/// node: its fields but the mesh, such as "\"scale\": [2, 2, 2], ".
inline std::string glbOf(const Mesh& mesh, const std::string& node = {}) {
  std::string binary;
  for (const Vec3 p : mesh.positions) {
    for (const double number : {p.x, p.y, p.z}) append(binary, static_cast<float>(number));
  }
  const size_t points = binary.size();
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) append(binary, corner);
  }
  const auto number = [](size_t value) { return std::to_string(value); };
  return glbOf(
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node +
          R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)" +
          R"("buffers":[{"byteLength":)" + number(binary.size()) +
          R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + number(points) +
          R"(},{"buffer":0,"byteOffset":)" + number(points) + R"(,"byteLength":)" +
          number(binary.size() - points) +
          R"(}],"accessors":[{"bufferView":0,"type":"VEC3","componentType":5126,"count":)" +
          number(mesh.positions.size()) +
          R"(},{"bufferView":1,"type":"SCALAR","componentType":5125,"count":)" +
          number(3 * mesh.triangles.size()) + "}]}",
      binary);
}

}  // namespace marrow
