#include "io/stroke_json.h"

#include <utility>

#include "io/json.h"

namespace marrow {

Result<StrokeFile> readStroke(const std::string& text) {
  auto parsed = parseJson(text);
  if (!parsed) return parsed.error();
  const Json& tree = *parsed;
  if (!tree.is_object()) return {Status::unreadable, "It is not a stroke: not an object."};

  StrokeFile stroke;
  if (const Json* name = field(tree, "name")) {
    if (!name->is_string()) return {Status::unreadable, "name is not a text."};
    stroke.name = name->get<std::string>();
  }
  const Json* closed = field(tree, "closed");
  if (closed && !closed->is_boolean()) {
    return {Status::unreadable, "closed is neither true nor false."};
  }
  const Json* points = field(tree, "points");
  if (!points) return {Status::unreadable, "points is missing."};
  auto read = readPoints(*points, "points");
  if (!read) return read.error();
  stroke.points = std::move(*read);
  return stroke;
}

}  // namespace marrow
