// Every change to a document is one of these; applying gives a new document.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "document/document.h"

namespace marrow {

struct AddPart {
  std::vector<Vec2> stroke;
};
struct DeletePart {
  std::string id;
};
struct SetThickness {
  std::string id;
  double thickness;
};
struct SetSimplify {
  std::string id;
  std::optional<double> epsilon_s;  // nothing: back to the default
};
struct SetColor {
  std::string id;
  Color color;
};
struct RenamePart {
  std::string id, name;
};
struct ReplaceDocument {  // open, new
  Document document;
  std::string name;  // of the step: "Open", "New drawing"
};

/// Any one of the above. A type of its own rather than a variant, so that `apply` never means
/// std::apply.
struct Command {
  using Step = std::variant<AddPart, DeletePart, SetThickness, SetSimplify, SetColor, RenamePart,
                            ReplaceDocument>;
  template <typename One, typename = std::enable_if_t<std::is_constructible_v<Step, One>>>
  Command(One one) : step(std::move(one)) {}

  Step step;
};

/// The document after the command; the given one is untouched. New parts get the next free id
/// ("part-1", …), a name and a colour. Values out of range are clamped.
/// Errors: notFound; tooFewPoints and noArea for a stroke that encloses nothing.
Result<Document> apply(const Document& document, const Command& command);

/// For the menu: "Draw part 3", "Delete part 3", "Thickness of part 3".
std::string describe(const Document& before, const Command& command);

}  // namespace marrow
