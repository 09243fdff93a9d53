// Errors are values: a code that tests compare and a sentence that people read.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>

namespace marrow {

enum class Status {
  ok,
  tooFewPoints,    // under three distinct points
  noArea,          // the points enclose nothing
  notAPolygon,     // a stage was given something else than a simple counter-clockwise polygon
  skeletonFailed,  // neither our wavefront nor CGAL could make a consistent straight skeleton
  meshFailed,      // triangulation or inflation found no solution
  unreadable,      // a file or text that is not what it should be
  newerVersion,    // a document written by a later version
  notFound,        // a part, a step or a file that is not there
  locked,          // a part that the user locked
  tooMany,         // more than a document holds
  notSolid,        // a surface that encloses nothing and cannot be made to
  notDrawn,        // a part that is no stroke: it has no outline to change
};

/// The sentence shown to the user for a code, always compiled in.
const char* toSentence(Status status);

struct Error {
  Status status = Status::ok;
  std::string detail;  // what exactly, where the code alone does not say; may be empty

  /// One sentence on one line, for people.
  std::string message() const { return detail.empty() ? std::string(toSentence(status)) : detail; }
};

/// A value, or why there is none.
template <typename T>
class Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Status status, std::string detail = {}) : error_{status, std::move(detail)} {
    assert(status != Status::ok);
  }
  Result(Error error) : error_(std::move(error)) { assert(error_.status != Status::ok); }

  explicit operator bool() const { return value_.has_value(); }
  Status status() const { return error_.status; }
  const Error& error() const { return error_; }
  std::string message() const { return error_.message(); }

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

 private:
  std::optional<T> value_;
  Error error_;
};

}  // namespace marrow
