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

/// By its size: many a binary file begins with "solid", too.
bool isBinary(const std::string& bytes) {
  if (bytes.size() < kHeader + kCount) return false;
  if (bytes.size() == kHeader + kCount + kTriangle * size_t{countIn(bytes)}) return true;
  Words words(bytes);
  return words.anyWord() != "solid";
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
  Words words(bytes);
  for (auto word = words.anyWord(); !word.empty(); word = words.anyWord()) {
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
  if (isBinary(bytes)) return readBinary(bytes);
  Words words(bytes);
  if (words.anyWord() != "solid") return {Status::unreadable, "It is no STL file."};
  return readText(bytes);
}

}  // namespace marrow
