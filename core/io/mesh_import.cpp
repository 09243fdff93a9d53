#include "io/mesh_import.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"
#include "document/document.h"
#include "io/decimal.h"
#include "io/json.h"
#include "io/mesh_readers.h"
#include "solid/close.h"

namespace marrow {
namespace {

constexpr size_t kMostCornersCut = 32;  // of a face; longer ones are cut like fans

bool endsWith(const std::string& name, const char* ending) {
  const size_t size = std::strlen(ending);
  if (name.size() < size) return false;
  return std::equal(name.end() - static_cast<std::ptrdiff_t>(size), name.end(), ending,
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether the word is [sign] digits [. digits] [e [sign] digits], one digit at least.
bool isNumber(std::string_view word) {
  size_t at = !word.empty() && (word[0] == '-' || word[0] == '+') ? 1 : 0;
  const auto digits = [&] {
    const size_t from = at;
    while (at < word.size() && isDigit(word[at])) ++at;
    return at - from;
  };
  size_t count = digits();
  if (at < word.size() && word[at] == '.') {
    ++at;
    count += digits();
  }
  if (count == 0) return false;
  if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
    ++at;
    if (at < word.size() && (word[at] == '-' || word[at] == '+')) ++at;
    if (digits() == 0) return false;
  }
  return at == word.size();
}

/// The ears of a flat polygon, by its projection along the largest coordinate of its normal.
void cutEars(Mesh& mesh, const std::vector<uint32_t>& corners, Vec3 normal) {
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  std::vector<Vec2> flat;
  for (const uint32_t corner : corners) {
    const Vec3 p = mesh.positions[corner];
    Vec2 q;
    if (z >= x && z >= y) {
      q = normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x};
    } else if (y >= x) {
      q = normal.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z};
    } else {
      q = normal.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y};
    }
    flat.push_back(q);
  }
  std::vector<uint32_t> left;
  for (uint32_t i = 0; i < corners.size(); ++i) left.push_back(i);
  const auto isEar = [&](size_t i) {
    const uint32_t a = left[(i + left.size() - 1) % left.size()], b = left[i],
                   c = left[(i + 1) % left.size()];
    if (!(cross(flat[b] - flat[a], flat[c] - flat[a]) > 0)) return false;
    return std::none_of(left.begin(), left.end(), [&](uint32_t other) {
      if (other == a || other == b || other == c) return false;
      const Vec2 p = flat[other];
      return cross(flat[b] - flat[a], p - flat[a]) >= 0 &&
             cross(flat[c] - flat[b], p - flat[b]) >= 0 &&
             cross(flat[a] - flat[c], p - flat[c]) >= 0;
    });
  };
  while (left.size() > 3) {
    size_t ear = 0;
    while (ear < left.size() && !isEar(ear)) ++ear;
    if (ear == left.size()) ear = 0;  // no simple polygon: any cut is as good as another
    const size_t n = left.size();
    mesh.triangles.push_back(
        {corners[left[(ear + n - 1) % n]], corners[left[ear]], corners[left[(ear + 1) % n]]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  mesh.triangles.push_back({corners[left[0]], corners[left[1]], corners[left[2]]});
}

}  // namespace

std::optional<MeshFormat> meshFormatOf(const std::string& bytes, const std::string& file_name) {
  if (bytes.compare(0, 4, "glTF") == 0) return MeshFormat::glb;
  if (bytes.compare(0, 4, "ply\n") == 0 || bytes.compare(0, 4, "ply\r") == 0) {
    return MeshFormat::ply;
  }
  if (endsWith(file_name, ".glb")) return MeshFormat::glb;
  if (endsWith(file_name, ".ply")) return MeshFormat::ply;
  if (endsWith(file_name, ".stl")) return MeshFormat::stl;
  if (endsWith(file_name, ".obj")) return MeshFormat::obj;
  return std::nullopt;
}

Error tooManyTriangles() {
  return {Status::tooMany,
          "It has more than 100,000 triangles, so reduce it in the program it comes from."};
}
Error tooManyVertices() { return {Status::tooMany, "It has more than 600,000 vertices."}; }

void addFace(Mesh& mesh, const std::vector<uint32_t>& corners) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const Vec3 first = mesh.positions[corners[0]];
  Vec3 normal;
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    normal =
        normal + cross(mesh.positions[corners[i]] - first, mesh.positions[corners[i + 1]] - first);
  }
  if (corners.size() <= kMostCornersCut) return cutEars(mesh, corners, normal);
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
}

bool Words::nextLine() {
  if (begun_ && end_ >= text_.size()) return false;
  at_ = begun_ ? end_ + 1 : 0;
  begun_ = true;
  end_ = text_.find('\n', at_);
  while (end_ != std::string_view::npos) {
    size_t last = end_;
    if (last > at_ && text_[last - 1] == '\r') --last;
    if (last == at_ || text_[last - 1] != '\\') break;
    end_ = text_.find('\n', end_ + 1);
  }
  end_ = std::min(end_, text_.size());
  return at_ < text_.size();
}

std::string_view Words::word() {
  const auto separates = [&](size_t i) {
    return isSpace(text_[i]) ||
           (text_[i] == '\\' && i + 1 < end_ && (text_[i + 1] == '\n' || text_[i + 1] == '\r'));
  };
  while (at_ < end_ && separates(at_)) ++at_;
  const size_t from = at_;
  while (at_ < end_ && !separates(at_)) ++at_;
  return text_.substr(from, at_ - from);
}

std::string_view Words::anyWord() {
  for (;;) {
    const std::string_view found = begun_ ? word() : std::string_view();
    if (!found.empty() || !nextLine()) return found;
  }
}

std::optional<double> toNumber(std::string_view word) {
  if (!isNumber(word)) return std::nullopt;
  if (word[0] == '+') word.remove_prefix(1);
  if (const auto quick = quickDouble(word)) return quick;
  // As JSON writes it: digits before the point, no needless zeros, digits behind it.
  std::string text;
  size_t at = word[0] == '-' ? 1 : 0;
  if (at > 0) text += '-';
  while (at + 1 < word.size() && word[at] == '0' && isDigit(word[at + 1])) ++at;
  if (!isDigit(word[at])) text += '0';
  while (at < word.size() && isDigit(word[at])) text += word[at++];
  if (at < word.size() && word[at] == '.') {
    ++at;
    if (at < word.size() && isDigit(word[at])) text += '.';
    while (at < word.size() && isDigit(word[at])) text += word[at++];
  }
  text += word.substr(at);
  const Json value = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::optional<int64_t> toWhole(std::string_view word) {
  constexpr size_t kMostDigits = 15;
  const bool negative = !word.empty() && word[0] == '-';
  if (negative) word.remove_prefix(1);
  if (word.empty() || word.size() > kMostDigits) return std::nullopt;
  int64_t value = 0;
  for (const char c : word) {
    if (!isDigit(c)) return std::nullopt;
    value = 10 * value + (c - '0');
  }
  return negative ? -value : value;
}

Result<Mesh> readMesh(const std::string& bytes, MeshFormat format) {
  if (bytes.size() > kLargestMeshFile) {
    return {Status::tooMany, "It is larger than 64 MB."};
  }
  switch (format) {
    case MeshFormat::obj:
      return readObj(bytes);
    case MeshFormat::stl:
      return readStl(bytes);
    case MeshFormat::ply:
      return readPly(bytes);
    case MeshFormat::glb:
      break;
  }
  return readGlb(bytes);
}

Result<Mesh> importMesh(const std::string& bytes, MeshFormat format) {
  auto mesh = readMesh(bytes, format);
  if (!mesh) return mesh.error();
  if (mesh->triangles.empty()) return {Status::notSolid, "It holds no surface."};
  if (mesh->triangles.size() > kMostTriangles) return tooManyTriangles();
  Box3 box;
  for (const auto& triangle : mesh->triangles) {
    for (const uint32_t corner : triangle) {
      if (!isDrawable(mesh->positions[corner])) {
        return {Status::unreadable, "It holds a place that is too far away."};
      }
      box.include(mesh->positions[corner]);
    }
  }
  const Vec3 size = box.size(), middle = box.middle();
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0)) return {Status::notSolid, "It encloses nothing."};
  // Vertices that no triangle uses may be anywhere.
  for (Vec3& p : mesh->positions) p = isDrawable(p) ? (p - middle) / longest : Vec3{};
  auto solid = closeSurface(*mesh);
  if (!solid) return solid.error();
  if (solid->triangles.size() > kMostTriangles) return tooManyTriangles();
  return solid;
}

}  // namespace marrow
