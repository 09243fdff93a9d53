// Reading the fields of JSON objects one by one; the first fault is kept, and what nobody asked
// for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/frame.h"
#include "base/quaternion.h"
#include "base/text.h"
#include "io/json.h"

namespace marrow {

/// The first fault of a text. Everything read after it is a default.
class Fault {
 public:
  void say(const std::string& sentence) {
    if (!error_) error_ = Error{Status::unreadable, onOneLine(sentence)};
  }
  const std::optional<Error>& error() const { return error_; }

 private:
  std::optional<Error> error_;
};

/// Every field may be missing, which gives its default; one of another kind is a fault.
class ObjectReader {
 public:
  /// `object` must outlive the reader. where: what faults call it; empty for the whole text.
  ObjectReader(const Json& object, std::string where, Fault& fault);

  /// Says that the field is known.
  void asked(const std::string& key) { asked_.push_back(key); }
  bool has(const std::string& key) const { return field(object_, key.c_str()) != nullptr; }
  std::string text(const std::string& key);
  bool flag(const std::string& key, bool missing);
  /// Brought into the range.
  std::optional<double> number(const std::string& key, double low, double high);
  /// Coordinates, none beyond the largest.
  Vec2 point(const std::string& key);
  Vec3 vector(const std::string& key, Vec3 missing);
  /// Four numbers as they are.
  Quaternion rotation(const std::string& key);
  /// The value as it is, or null.
  const Json* value(const std::string& key);
  /// An object; null where it is missing, or JSON's null and that is allowed.
  const Json* object(const std::string& key, bool may_be_null = false);
  /// {"plane": [nx, ny, nz, d]}, or null.
  std::optional<Plane> plane(const std::string& key);

  /// The fields that nobody asked for, and under the inner objects' keys the same of these.
  Json rest() const;
  void keepInner(const std::string& key, const ObjectReader& inner);

  /// What faults call an inner object.
  std::string where(const std::string& key) const;
  /// fault: "is no plane."
  void say(const std::string& key, const std::string& fault);

 private:
  std::vector<double> numbers(const std::string& key, size_t count);

  const Json& object_;
  std::string where_;
  Fault& fault_;
  std::vector<std::string> asked_;
  Json inner_ = Json::object();
};

}  // namespace marrow
