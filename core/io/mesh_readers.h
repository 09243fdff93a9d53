// The readers behind mesh_import.h, and what they share.
#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_import.h"

namespace marrow {

Result<Mesh> readObj(const std::string& bytes);
Result<Mesh> readStl(const std::string& bytes);
Result<Mesh> readPly(const std::string& bytes);
Result<Mesh> readGlb(const std::string& bytes);

Error tooManyTriangles();
Error tooManyVertices();

/// Cuts a face into triangles: a flat one well, whatever its shape, as long as it does not cross
/// itself; holes may be cut out by a bridge, where it has few corners. corners: indices of
/// vertices.
void addFace(Mesh& mesh, const std::vector<uint32_t>& corners);

/// How a text's lines are meant: as they are; or one that ends with a backslash goes on, and a word
/// that begins with # begins a comment, which goes to the end of its own line.
enum class Lines { plain, continued };

/// The words of one line after another.
class Words {
 public:
  Words(std::string_view text, Lines lines);

  /// Goes to the next line; false behind the last.
  bool nextLine();
  /// Leaves out what is left of the line.
  void skipLine() { at_ = end_; }
  /// The next word of the line; empty behind its last.
  std::string_view word();
  /// The next word, of any line.
  std::string_view anyWord();
  /// Where the next line begins.
  size_t lineEnd() const { return end_ < text_.size() ? end_ + 1 : end_; }

 private:
  bool continues(size_t from) const;

  std::string_view text_;
  Lines lines_;
  size_t begin_ = 0, at_ = 0, end_ = 0;
  bool begun_ = false;
};

/// The double nearest to a decimal number, which may have a plus and begin or end with its point;
/// nothing for anything else.
std::optional<double> toNumber(std::string_view word);
/// A whole number.
std::optional<int64_t> toWhole(std::string_view word);

/// A value of little-endian bytes; `at` is moved behind it. There must be as many.
template <typename T>
T take(const std::string& bytes, size_t& at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

}  // namespace marrow
