#include "io/mesh_readers.h"

namespace marrow {
namespace {

Error wrongLine(size_t line, const char* what) {
  return {Status::unreadable, "Line " + std::to_string(line) + ' ' + what};
}

/// The vertex that "7", "7/1/3" or "-1" means, of `count` so far; counted from 0.
std::optional<uint32_t> vertexOf(std::string_view word, size_t count) {
  const auto number = toWhole(word.substr(0, word.find('/')));
  if (!number || *number == 0) return std::nullopt;
  const int64_t index = *number > 0 ? *number - 1 : static_cast<int64_t>(count) + *number;
  if (index < 0 || index >= static_cast<int64_t>(count)) return std::nullopt;
  return static_cast<uint32_t>(index);
}

}  // namespace

Result<Mesh> readObj(const std::string& bytes) {
  Mesh mesh;
  Words words(bytes, Lines::continued);
  std::vector<uint32_t> corners;
  size_t line = 0;
  while (words.nextLine()) {
    ++line;
    const std::string_view kind = words.word();
    if (kind == "v") {
      Vec3 p;
      for (double* into : {&p.x, &p.y, &p.z}) {
        const auto number = toNumber(words.word());
        if (!number) return wrongLine(line, "is a vertex without three numbers.");
        *into = *number;
      }
      if (mesh.positions.size() == kMostReadVertices) return tooManyVertices();
      mesh.positions.push_back(p);
    } else if (kind == "f") {
      corners.clear();
      for (auto word = words.word(); !word.empty(); word = words.word()) {
        const auto vertex = vertexOf(word, mesh.positions.size());
        if (!vertex) return wrongLine(line, "is a face with a corner that is no vertex before it.");
        if (corners.size() == kMostReadTriangles) return tooManyTriangles();
        corners.push_back(*vertex);
      }
      if (corners.size() < 3) return wrongLine(line, "is a face with fewer than three corners.");
      if (mesh.triangles.size() + corners.size() > kMostReadTriangles) return tooManyTriangles();
      addFace(mesh, corners);
    }
  }
  return mesh;
}

}  // namespace marrow
