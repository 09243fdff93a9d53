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

/// Brings the triangles about the origin; false where they have no size.
bool toSizeOne(Mesh& mesh) {
  Box3 box;
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) box.include(mesh.positions[corner]);
  }
  const Vec3 size = box.size(), middle = box.middle();
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0)) return false;
  for (Vec3& p : mesh.positions) p = (p - middle) / longest;
  return true;
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

std::optional<Error> unknownFile(const std::string& bytes, const std::string& file_name) {
  if (endsWith(file_name, ".gltf")) {
    return Error{Status::unreadable, "It is a glTF text, so export it again as GLB."};
  }
  const std::string_view start = Words(bytes, Lines::plain).anyWord().substr(0, 1);
  if (start.empty() || start == "{") return std::nullopt;
  return Error{Status::unreadable,
               "It is neither a Marrow drawing nor a GLB, OBJ, PLY or STL model."};
}

Error tooManyTriangles() {
  return {Status::tooMany,
          "It has more than 100,000 triangles, so reduce it in the program it comes from."};
}
Error tooManyVertices() { return {Status::tooMany, "It has more than 600,000 vertices."}; }

Words::Words(std::string_view text, Lines lines) : text_(text), lines_(lines) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") begin_ = 3;  // the mark of UTF-8
}

bool Words::nextLine() {
  if (begun_ && end_ >= text_.size()) return false;
  size_t from = begun_ ? end_ + 1 : begin_;
  at_ = from;
  begun_ = true;
  end_ = text_.find('\n', from);
  while (lines_ == Lines::continued && end_ != std::string_view::npos && continues(from)) {
    from = end_ + 1;
    end_ = text_.find('\n', from);
  }
  end_ = std::min(end_, text_.size());
  return at_ < text_.size();
}

/// Whether the line that begins there and has an end goes on behind it.
bool Words::continues(size_t from) const {
  size_t last = end_;
  if (last > from && text_[last - 1] == '\r') --last;
  if (last == from || text_[last - 1] != '\\') return false;
  for (size_t i = from; i < last; ++i) {
    if (text_[i] == '#' && (i == from || isSpace(text_[i - 1]))) return false;
  }
  return true;
}

std::string_view Words::word() {
  const auto separates = [&](size_t i) {
    return isSpace(text_[i]) || (lines_ == Lines::continued && text_[i] == '\\' && i + 1 < end_ &&
                                 (text_[i + 1] == '\n' || text_[i + 1] == '\r'));
  };
  while (at_ < end_ && separates(at_)) ++at_;
  if (lines_ == Lines::continued && at_ < end_ && text_[at_] == '#') at_ = end_;
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

Result<ImportedMesh> importModel(const std::string& bytes, MeshFormat format) {
  auto mesh = readMesh(bytes, format);
  if (!mesh) return mesh.error();
  if (mesh->triangles.empty()) return {Status::notSolid, "It holds no surface."};
  if (mesh->triangles.size() > kMostTriangles) return tooManyTriangles();
  for (const auto& triangle : mesh->triangles) {
    for (const uint32_t corner : triangle) {
      if (!isDrawable(mesh->positions[corner])) {
        return {Status::unreadable, "It holds a place that is too far away."};
      }
    }
  }
  if (!toSizeOne(*mesh)) return {Status::notSolid, "It encloses nothing."};
  auto closed = closeMost(*mesh);
  if (!closed) return closed.error();
  if (closed->mesh.triangles.size() > kMostTriangles) return tooManyTriangles();
  if (closed->left_out > 0) toSizeOne(closed->mesh);
  return ImportedMesh{std::move(closed->mesh), closed->left_out};
}

Result<Mesh> importMesh(const std::string& bytes, MeshFormat format) {
  auto model = importModel(bytes, format);
  if (!model) return model.error();
  return std::move(model->mesh);
}

}  // namespace marrow
