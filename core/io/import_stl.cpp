#include <cmath>

#include "io/mesh_readers.h"

namespace marrow {
namespace {

constexpr size_t kHeader = 80, kCount = 4, kTriangle = 50;  // bytes

Error cutShort() { return {Status::unreadable, "It ends in the middle of a triangle."}; }

uint32_t countIn(const std::string& bytes) {
  size_t at = kHeader;
  return take<uint32_t>(bytes, at);
}

/// Many a binary file begins with "solid", too; but no text has a zero, and the highest byte of a
/// count is one.
bool isBinary(const std::string& bytes) {
  if (bytes.size() < kHeader + kCount) return false;
  if (bytes[kHeader + kCount - 1] == '\0') return true;
  return Words(bytes, Lines::plain).anyWord() != "solid";
}

Result<Mesh> readBinary(const std::string& bytes) {
  const size_t count = countIn(bytes);
  if (count > (bytes.size() - kHeader - kCount) / kTriangle) return cutShort();
  if (count > kMostReadTriangles) return tooManyTriangles();
  Mesh mesh;
  mesh.positions.reserve(3 * count);
  mesh.triangles.reserve(count);
  size_t at = kHeader + kCount;
  for (size_t t = 0; t < count; ++t) {
    at += 3 * sizeof(float);  // the normal
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 3; ++corner) {
      const auto x = take<float>(bytes, at), y = take<float>(bytes, at), z = take<float>(bytes, at);
      mesh.positions.push_back({x, y, z});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    at += sizeof(uint16_t);
  }
  return mesh;
}

Result<Mesh> readText(const std::string& bytes) {
  Mesh mesh;
  Words words(bytes, Lines::plain);
  if (words.anyWord() != "solid") return {Status::unreadable, "It is no STL file."};
  for (auto word = std::string_view("solid"); !word.empty(); word = words.anyWord()) {
    if (word == "solid" || word == "endsolid") words.skipLine();  // anything may be a name
    if (word != "vertex") continue;
    Vec3 p;
    for (double* into : {&p.x, &p.y, &p.z}) {
      const auto number = toNumber(words.word());
      if (!number) return {Status::unreadable, "It holds a vertex without three numbers."};
      *into = *number;
    }
    if (mesh.positions.size() == 3 * kMostReadTriangles) return tooManyTriangles();
    mesh.positions.push_back(p);
  }
  if (mesh.positions.size() % 3 != 0) return cutShort();
  for (uint32_t i = 0; i < mesh.positions.size(); i += 3) {
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  return mesh;
}

}  // namespace

Result<Mesh> readStl(const std::string& bytes) {
  auto mesh = isBinary(bytes) ? readBinary(bytes) : readText(bytes);
  if (!mesh) return mesh;
  for (Vec3& p : mesh->positions) p = {p.x, p.z, -p.y};
  return mesh;
}

}  // namespace marrow
