#include "io/mesh_export.h"

#include <cmath>
#include <cstring>
#include <sstream>

#include "io/export_text.h"

namespace marrow {
namespace {

/// Bytes as both formats want them: little-endian, which WebAssembly and our other targets are.
class Bytes {
 public:
  template <typename T>
  void put(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    text_.append(raw, sizeof(T));
  }
  void put(Vec3 v) {
    for (const double number : {v.x, v.y, v.z}) {
      const auto single = static_cast<float>(number);
      finite_ = finite_ && std::isfinite(single);
      put(single);
    }
  }
  void text(const std::string& words) { text_ += words; }
  Result<std::string> take() {
    if (!finite_) return Status::meshFailed;
    return std::move(text_);
  }

 private:
  std::string text_;
  bool finite_ = true;
};

Vec3 upIsZ(Vec3 p) { return {p.x, -p.z, p.y}; }

}  // namespace

std::string toObj(const SkinnedMesh& mesh, const std::vector<Paint>& paints) {
  std::string text = "# Marrow\no " + obj::name(mesh.name) + '\n';
  for (const Vec3 p : mesh.mesh.positions) obj::appendVector(text, "v", p);
  for (const Vec3 n : mesh.normals) obj::appendVector(text, "vn", n);
  for (size_t paint = 0; paint < paints.size(); ++paint) {
    Mesh own;
    for (size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
      if (mesh.paint_of_triangle[t] == paint) own.triangles.push_back(mesh.mesh.triangles[t]);
    }
    if (own.triangles.empty()) continue;
    text += "g " + obj::name(paints[paint].name) + '\n';
    obj::appendFaces(text, own, 1);
  }
  return text;
}

Result<std::string> toStl(const SkinnedMesh& mesh) {
  constexpr size_t kHeader = 80;
  Bytes bytes;
  std::string header = "Marrow";
  header.resize(kHeader, ' ');
  bytes.text(header);
  bytes.put(static_cast<uint32_t>(mesh.mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.mesh.triangles) {
    const Vec3 p = upIsZ(mesh.mesh.positions[a]), q = upIsZ(mesh.mesh.positions[b]),
               r = upIsZ(mesh.mesh.positions[c]);
    const Vec3 normal = cross(q - p, r - p);
    const double size = length(normal);
    bytes.put(size > 0 ? normal / size : Vec3{});
    for (const Vec3 corner : {p, q, r}) bytes.put(corner);
    bytes.put(uint16_t{0});
  }
  return bytes.take();
}

Result<std::string> toPly(const SkinnedMesh& mesh, const std::vector<Paint>& paints) {
  Bytes bytes;
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\ncomment Marrow\nelement vertex "
         << mesh.mesh.positions.size() << '\n';
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    header << "property float " << name << '\n';
  header << "element face " << mesh.mesh.triangles.size()
         << "\nproperty list uchar uint vertex_indices\n";
  for (const char* name : {"red", "green", "blue"}) header << "property uchar " << name << '\n';
  header << "end_header\n";
  bytes.text(header.str());
  for (size_t i = 0; i < mesh.mesh.positions.size(); ++i) {
    bytes.put(mesh.mesh.positions[i]);
    bytes.put(mesh.normals[i]);
  }
  for (size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    bytes.put(uint8_t{3});
    for (const uint32_t corner : mesh.mesh.triangles[t]) bytes.put(corner);
    const Color color = paints[mesh.paint_of_triangle[t]].color;
    for (const uint8_t channel : {color.r, color.g, color.b}) bytes.put(channel);
  }
  return bytes.take();
}

}  // namespace marrow
