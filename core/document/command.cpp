#include "document/command.h"

#include <algorithm>
#include <utility>

#include "sketch/outline.h"

namespace marrow {
namespace {

Result<Document> notFound(const std::string& id) {
  return {Status::notFound, "There is no part \"" + id + "\"."};
}

/// The document with one part changed; the same part where the change changes nothing.
template <typename Change>
Result<Document> changePart(const Document& document, const std::string& id, Change change) {
  const auto index = document.find(id);
  if (!index) return notFound(id);
  PartSource part = *document.parts[*index];
  Document next = document;
  if (change(part)) next.parts[*index] = std::make_shared<const PartSource>(std::move(part));
  return next;
}

/// Sets `target`; true when that changed it.
template <typename T>
bool assign(T& target, const T& value) {
  if (target == value) return false;
  target = value;
  return true;
}

/// NaN becomes `low`.
double clamp(double value, double low, double high) {
  return value > low ? std::min(value, high) : low;
}

Result<Document> applyTo(const Document& document, const AddPart& command) {
  PartSource part;
  std::copy_if(command.stroke.begin(), command.stroke.end(), std::back_inserter(part.stroke),
               isDrawable);
  auto outline = makeOutline(part.stroke);
  if (!outline) return outline.error();

  Document next = document;
  const uint64_t number = takePartNumber(next);
  part.id = partId(number);
  part.name = defaultPartName(number);
  part.color = partColor(static_cast<size_t>(number - 1));
  next.parts.push_back(std::make_shared<const PartSource>(std::move(part)));
  return next;
}

Result<Document> applyTo(const Document& document, const DeletePart& command) {
  const auto index = document.find(command.id);
  if (!index) return notFound(command.id);
  Document next = document;
  next.parts.erase(next.parts.begin() + static_cast<std::ptrdiff_t>(*index));
  return next;
}

Result<Document> applyTo(const Document& document, const SetThickness& command) {
  const double thickness = clamp(command.thickness, kMinThickness, kMaxThickness);
  return changePart(document, command.id,
                    [=](PartSource& part) { return assign(part.thickness, thickness); });
}

Result<Document> applyTo(const Document& document, const SetSimplify& command) {
  auto epsilon_s = command.epsilon_s;
  if (epsilon_s) epsilon_s = clamp(*epsilon_s, kMinEpsilonS, kMaxEpsilonS);
  return changePart(document, command.id,
                    [=](PartSource& part) { return assign(part.epsilon_s, epsilon_s); });
}

Result<Document> applyTo(const Document& document, const SetColor& command) {
  return changePart(document, command.id,
                    [&](PartSource& part) { return assign(part.color, command.color); });
}

Result<Document> applyTo(const Document& document, const RenamePart& command) {
  return changePart(document, command.id, [&](PartSource& part) {
    return !command.name.empty() && assign(part.name, command.name);
  });
}

Result<Document> applyTo(const Document&, const ReplaceDocument& command) {
  return command.document;
}

std::string named(const Document& document, const std::string& id) {
  const auto index = document.find(id);
  if (!index) return "a part";
  const PartSource& part = *document.parts[*index];
  const uint64_t number = partNumber(id);
  if (number > 0 && part.name == defaultPartName(number)) return "part " + std::to_string(number);
  return part.name;
}

std::string describeIn(const Document& before, const AddPart&) {
  Document next = before;
  return "Draw part " + std::to_string(takePartNumber(next));
}
std::string describeIn(const Document& before, const DeletePart& command) {
  return "Delete " + named(before, command.id);
}
std::string describeIn(const Document& before, const SetThickness& command) {
  return "Thickness of " + named(before, command.id);
}
std::string describeIn(const Document& before, const SetSimplify& command) {
  return "Simplify " + named(before, command.id);
}
std::string describeIn(const Document& before, const SetColor& command) {
  return "Colour of " + named(before, command.id);
}
std::string describeIn(const Document& before, const RenamePart& command) {
  return "Rename " + named(before, command.id);
}
std::string describeIn(const Document&, const ReplaceDocument& command) { return command.name; }

}  // namespace

Result<Document> apply(const Document& document, const Command& command) {
  return std::visit([&](const auto& one) { return applyTo(document, one); }, command.step);
}

std::string describe(const Document& before, const Command& command) {
  return std::visit([&](const auto& one) { return describeIn(before, one); }, command.step);
}

}  // namespace marrow
