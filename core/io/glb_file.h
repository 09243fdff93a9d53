// The chunks, lists and numbers of a GLB file of any program, none of which can be trusted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.h"
#include "io/json.h"

namespace marrow {

Error brokenGlb();

/// The field, where the value is an object that has it; else null.
const Json* inner(const Json* value, const char* key);
/// The item, where the value is a list that has it; else null.
const Json* item(const Json* list, std::optional<size_t> index);
/// A whole number below 2³² − 1; else nothing.
std::optional<size_t> whole(const Json* value);
std::optional<size_t> wholeOr(const Json* value, size_t missing);

/// Refers to the bytes it was read from, which must outlive it.
class GlbFile {
 public:
  enum Component {
    kByte = 5120,
    kUnsignedByte,
    kShort,
    kUnsignedShort,
    kUnsignedInt = 5125,
    kFloat
  };

  /// A place in the file.
  struct Bytes {
    size_t at = 0, size = 0;
  };

  /// What an accessor tells of its values, all of which are in the file.
  struct Values {
    size_t at = 0, count = 0, stride = 0;
    int component = 0;
    bool normalised = false;
  };

  /// Errors: unreadable.
  static Result<GlbFile> open(const std::string& bytes);

  /// A field of the whole, or null.
  const Json* list(const char* key) const { return inner(&tree_, key); }
  /// The bytes that a buffer view means; only what is in the file.
  std::optional<Bytes> view(std::optional<size_t> index) const;
  /// Nothing where the accessor is of another type, or leaves its bytes. width: numbers of a value.
  std::optional<Values> values(std::optional<size_t> index, const char* type, size_t width) const;
  double number(const Values& values, size_t index, size_t part) const;

 private:
  explicit GlbFile(const std::string& bytes) : bytes_(&bytes) {}

  const std::string* bytes_;
  Json tree_;
  Bytes binary_;
};

}  // namespace marrow
