#include <algorithm>
#include <set>

#include "base/text.h"
#include "document/command.h"
#include "document/placed_parts.h"

namespace marrow {
namespace {

std::string named(const Document& document, const std::string& placed_id) {
  const auto index = document.find(sourceId(placed_id));
  if (!index) return "a part";
  const PartSource& part = *document.parts[*index];
  const uint64_t number = partNumber(part.id);
  if (number > 0 && part.name == defaultPartName(number)) return "part " + std::to_string(number);
  return onOneLine(part.name);
}

std::string named(const Document& document, const Ids& ids) {
  std::set<std::string> sources;
  for (const std::string& id : ids) sources.insert(sourceId(id));
  if (sources.empty()) return "nothing";
  if (sources.size() == 1) return named(document, *sources.begin());
  return std::to_string(sources.size()) + " parts";
}

const char* nameOf(std::optional<double> Refinement::*threshold) {
  if (threshold == &Refinement::merge) return "Merge joints";
  if (threshold == &Refinement::prune) return "Prune";
  if (threshold == &Refinement::collapse) return "Collapse";
  return "Simplify";
}

std::string describeIn(const Document& before, const AddPart&) {
  Document next = before;
  return "Draw part " + std::to_string(takePartNumber(next));
}
std::string describeIn(const Document& before, const ImportPart& command) {
  Document next = before;
  const std::string name = onOneLine(toUtf8(command.name));
  return "Import " + (name.empty() ? "part " + std::to_string(takePartNumber(next)) : name);
}
std::string describeIn(const Document& before, const DeleteParts& command) {
  return "Delete " + named(before, command.ids);
}
std::string describeIn(const Document& before, const DuplicateParts& command) {
  return "Duplicate " + named(before, command.ids);
}
std::string describeIn(const Document& before, const TransformParts& command) {
  return command.verb + " " + named(before, command.ids);
}
std::string describeIn(const Document& before, const SetThickness& command) {
  return "Thickness of " + named(before, command.ids);
}
std::string describeIn(const Document& before, const SetColor& command) {
  return "Colour of " + named(before, command.ids);
}
std::string describeIn(const Document& before, const SetVisible& command) {
  return (command.visible ? "Show " : "Hide ") + named(before, command.ids);
}
std::string describeIn(const Document& before, const SetLocked& command) {
  return (command.locked ? "Lock " : "Unlock ") + named(before, command.ids);
}
std::string describeIn(const Document& before, const SetSkeleton& command) {
  return (command.skeleton ? "Skeleton for " : "No skeleton for ") + named(before, command.ids);
}
std::string describeIn(const Document& before, const RenamePart& command) {
  return "Rename " + named(before, command.id);
}
std::string describeIn(const Document& before, const SetStroke& command) {
  return "Reshape " + named(before, command.id);
}
std::string describeIn(const Document& before, const SetMirror& command) {
  return (command.plane ? "Mirror " : "No mirror for ") + named(before, command.ids);
}
std::string describeIn(const Document& before, const SeparateTwins& command) {
  return "Separate twins of " + named(before, command.ids);
}
std::string describeIn(const Document&, const SetSymmetry& command) {
  return command.plane ? "Set symmetry plane" : "Remove symmetry plane";
}
std::string describeIn(const Document& before, const SetRefinement& command) {
  const std::string what = nameOf(command.threshold);
  if (command.ids.empty()) return what + " everywhere";
  const std::string where = named(before, command.ids);
  if (!command.branch.empty()) return what + " a branch of " + where;
  return what + (command.threshold == &Refinement::merge ? " of " : " ") + where;
}
std::string describeIn(const Document& before, const ResetRefinement& command) {
  if (command.ids.empty()) return "Reset refinement";
  const std::string where = named(before, command.ids);
  return "Reset refinement of " + (command.branch.empty() ? where : "a branch of " + where);
}
std::string describeIn(const Document& before, const SetAttachment& command) {
  const std::string what = named(before, command.id);
  if (!command.attachment) return "Attach " + what + " by itself";
  if (command.attachment->part.empty()) return "Detach " + what;
  return "Attach " + what + " to " + named(before, command.attachment->part);
}
std::string describeIn(const Document& before, const SetRoot& command) {
  return "Begin at " + named(before, command.id);
}
std::string describeIn(const Document& before, const SetReference& command) {
  if (!command.reference.image) return "Remove picture";
  const auto same_view = [&](const auto& one) { return one->view == command.reference.view; };
  const bool there = std::any_of(before.references.begin(), before.references.end(), same_view);
  return there ? "Change picture" : "Add picture";
}
std::string describeIn(const Document& before, const SetPose& command) {
  return (before.findPose(command.name) ? "Change pose " : "Add pose ") + onOneLine(command.name);
}
std::string describeIn(const Document&, const RenamePose& command) {
  return "Rename pose " + onOneLine(command.name);
}
std::string describeIn(const Document&, const DeletePose& command) {
  return "Delete pose " + onOneLine(command.name);
}
std::string describeIn(const Document&, const SetBlend&) { return "Soft seams"; }
std::string describeIn(const Document& before, const AddWeightStroke& command) {
  const char* verbs[] = {"Add weight on ", "Take weight on ", "Smooth weights on "};
  return verbs[static_cast<size_t>(command.stroke.kind)] + named(before, command.stroke.part);
}
std::string describeIn(const Document&, const ClearWeightStrokes& command) {
  return command.joint.empty() ? "Clear painted weights" : "Clear a joint's painted weights";
}
std::string describeIn(const Document&, const ReplaceDocument& command) { return command.name; }

}  // namespace

std::string describe(const Document& before, const Command& command) {
  return std::visit([&](const auto& one) { return describeIn(before, one); }, command.step);
}

}  // namespace marrow
