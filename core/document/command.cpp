#include "document/command.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/text.h"
#include "document/placed_parts.h"
#include "document/placement.h"
#include "document/posed_parts.h"
#include "document/reference_image.h"
#include "part/silhouette.h"
#include "sketch/outline.h"

namespace marrow {
namespace {

using PartPointer = std::shared_ptr<const PartSource>;

PartPointer share(PartSource part) { return std::make_shared<const PartSource>(std::move(part)); }

Error notFound(const std::string& id) {
  return {Status::notFound, "There is no part \"" + onOneLine(id) + "\"."};
}
Error noPlane() { return {Status::noArea, "This is no plane to mirror across."}; }

/// Indices of the parts, each once, in modelling order.
Result<std::vector<size_t>> findParts(const Document& document, const Ids& ids) {
  std::vector<size_t> found;
  for (const std::string& id : ids) {
    const auto index = document.find(sourceId(id));
    if (!index) return notFound(id);
    found.push_back(*index);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The same without the locked ones. Errors: locked, where all are.
Result<std::vector<size_t>> findUnlocked(const Document& document, const Ids& ids) {
  auto found = findParts(document, ids);
  if (!found || found->empty()) return found;
  std::vector<size_t> unlocked;
  for (size_t i : *found) {
    if (!document.parts[i]->locked) unlocked.push_back(i);
  }
  if (!unlocked.empty()) return unlocked;
  if (found->size() > 1) {
    return {Status::locked, "These parts are locked. Unlock them to change them."};
  }
  return {Status::locked,
          onOneLine(document.parts[found->front()]->name) + " is locked. Unlock it to change it."};
}

/// The document with some parts changed; the same parts where the change changes nothing.
template <typename Change>
Result<Document> changeParts(const Document& document, const Result<std::vector<size_t>>& parts,
                             Change change) {
  if (!parts) return parts.error();
  Document next = document;
  for (size_t i : *parts) {
    PartSource part = *document.parts[i];
    if (change(part)) next.parts[i] = share(std::move(part));
  }
  return next;
}

template <typename Change>
Result<Document> changeUnlocked(const Document& document, const Ids& ids, Change change) {
  return changeParts(document, findUnlocked(document, ids), change);
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

std::vector<Vec2> drawable(const std::vector<Vec2>& stroke) {
  std::vector<Vec2> kept;
  std::copy_if(stroke.begin(), stroke.end(), std::back_inserter(kept),
               [](Vec2 p) { return isDrawable(p); });
  return kept;
}

Error tooFarAway() { return {Status::noArea, "This is too far away to draw."}; }

Error edgeOn() {
  return {Status::noArea, "It is seen edge-on from here, so turn the view and import it again."};
}

size_t meshTriangles(const Document& document) {
  size_t count = 0;
  for (const auto& part : document.parts) count += part->mesh ? part->mesh->triangles.size() : 0;
  return count;
}

/// Errors: tooMany, where there are now more triangles than the document may hold.
Result<Document> withinTriangles(const Document& before, Document next) {
  const size_t count = meshTriangles(next);
  if (count <= Document::kMostTriangles || count <= meshTriangles(before)) return next;
  return {Status::tooMany,
          "The imported models of a drawing have at most 500,000 triangles together."};
}

/// With the next number, its name and its colour.
Document withPart(const Document& document, PartSource part) {
  Document next = document;
  const uint64_t number = takePartNumber(next);
  part.id = partId(number);
  if (part.name.empty()) part.name = defaultPartName(number);
  part.color = partColor(static_cast<size_t>(number - 1));
  next.parts.push_back(share(std::move(part)));
  return next;
}

Result<Document> applyTo(const Document& document, const AddPart& command) {
  if (document.parts.size() >= Document::kMostParts) return Status::tooMany;
  PartSource part;
  part.stroke = drawable(command.stroke);
  part.frame = command.frame;
  if (!fitInFrame(part)) return tooFarAway();
  auto outline = makeOutline(part.stroke);
  if (!outline) return outline.error();
  if (!isDrawable(part.stroke, part.frame)) return tooFarAway();
  if (command.mirror) {
    part.mirror = normalised(*command.mirror);
    if (!part.mirror) return noPlane();
  }
  return withPart(document, std::move(part));
}

Result<Document> applyTo(const Document& document, const ImportPart& command) {
  if (document.parts.size() >= Document::kMostParts) return Status::tooMany;
  if (!command.mesh) return Status::notSolid;
  PartSource part;
  part.frame = command.frame;
  part.mesh = std::make_shared<const Mesh>(inSinglePrecision(*command.mesh));
  if (!fitInFrame(part)) return tooFarAway();
  const std::string fault = faultIn(*part.mesh);
  if (!fault.empty()) return {Status::notSolid, "The mesh " + fault + "."};
  auto silhouette = silhouetteOf(*part.mesh);
  if (!silhouette) return edgeOn();
  part.stroke = std::move(*silhouette);
  if (!makeOutline(part.stroke)) return edgeOn();
  if (!isDrawable(part)) return tooFarAway();
  part.name = toUtf8(command.name);
  return withinTriangles(document, withPart(document, std::move(part)));
}

Result<Document> applyTo(const Document& document, const DeleteParts& command) {
  const auto gone = findUnlocked(document, command.ids);
  if (!gone) return gone.error();
  Document next = document;
  next.parts.clear();
  for (size_t i = 0; i < document.parts.size(); ++i) {
    if (!std::binary_search(gone->begin(), gone->end(), i)) next.parts.push_back(document.parts[i]);
  }
  if (!gone->empty()) dropLostStrokes(next);
  return next;
}

/// The name with the next number that no part's name has: "Leg", "Leg 2", "Leg 3".
std::string numbered(const std::string& name, const std::set<std::string>& taken) {
  size_t end = name.find_last_not_of("0123456789");
  const bool has_number = end != std::string::npos && end > 0 && end + 1 < name.size() &&
                          name.size() - end <= 7 && name[end] == ' ' && name[end + 1] != '0';
  const std::string stem = has_number ? name.substr(0, end) : name;
  uint64_t number = has_number ? std::stoul(name.substr(end + 1)) : 1;
  std::string next;
  do {
    next = stem + " " + std::to_string(++number);
  } while (taken.count(next) > 0);
  return next;
}

std::set<std::string> namesOf(const Document& document) {
  std::set<std::string> names;
  for (const auto& part : document.parts) names.insert(part->name);
  return names;
}

Result<Document> applyTo(const Document& document, const DuplicateParts& command) {
  const auto originals = findParts(document, command.ids);
  if (!originals) return originals.error();
  if (document.parts.size() + originals->size() > Document::kMostParts) return Status::tooMany;
  Affine move;
  move.move = command.move;

  Document next = document;
  std::set<std::string> names = namesOf(document);
  std::map<std::string, std::string> copy_of;
  std::map<size_t, PartSource> copies;
  for (size_t i : *originals) {
    const PartSource& original = *document.parts[i];
    auto copy = mapped(original, move);
    if (!copy) return copy.error();
    const uint64_t number = takePartNumber(next), own = partNumber(original.id);
    copy->id = partId(number);
    const bool unnamed = own > 0 && original.name == defaultPartName(own);
    copy->name = unnamed ? defaultPartName(number) : numbered(original.name, names);
    copy->locked = false;
    names.insert(copy->name);
    copy_of[original.id] = copy->id;
    copies[i] = std::move(*copy);
  }
  next.parts.clear();
  for (size_t i = 0; i < document.parts.size(); ++i) {
    next.parts.push_back(document.parts[i]);
    const auto found = copies.find(i);
    if (found == copies.end()) continue;
    PartSource& copy = found->second;
    if (copy.attachment) {
      std::string& part = copy.attachment->part;
      const auto other = copy_of.find(sourceId(part));
      if (other != copy_of.end()) part = other->second + (isTwinId(part) ? kTwinSuffix : "");
    }
    next.parts.push_back(share(std::move(copy)));
  }
  const auto rename = [&](const std::string& placed_id) {
    const auto other = copy_of.find(sourceId(placed_id));
    if (other == copy_of.end()) return placed_id;
    return other->second + (isTwinId(placed_id) ? kTwinSuffix : "");
  };
  for (const auto& [original, copy] : copy_of) copyStrokes(original, copy, false, rename, next);
  if (next.weight_strokes.size() > Document::kMostWeightStrokes) return Status::tooMany;
  return withinTriangles(document, std::move(next));
}

/// What a map did to a part.
struct Stretch {
  Frame before;
  Affine map;
  Frame now;

  Vec2 operator()(Vec2 p) const {
    const Vec3 way = map.direction(before.x * p.x + before.y * p.y);
    return Vec2{dot(now.x, way), dot(now.y, way)} / dot(now.x, now.x);
  }
};

/// What hangs by the user's word on parts whose strokes were stretched hangs at the same places of
/// them.
void bringAttachments(const std::map<std::string, Stretch>& stretched, Document& document) {
  if (stretched.empty()) return;
  for (auto& shared : document.parts) {
    if (!shared->attachment || shared->locked) continue;
    const auto parent = stretched.find(sourceId(shared->attachment->part));
    if (parent == stretched.end()) continue;
    const Vec2 at = parent->second(shared->attachment->at);
    if (!isDrawable(at)) continue;
    PartSource part = *shared;
    part.attachment->at = at;
    shared = share(std::move(part));
  }
}

Result<Document> applyTo(const Document& document, const TransformParts& command) {
  const auto parts = findUnlocked(document, command.ids);
  if (!parts) return parts.error();
  std::set<std::string> named(command.ids.begin(), command.ids.end());
  Document next = document;
  std::map<std::string, PartTurn> turns;
  std::map<std::string, Stretch> stretched;
  bool all = !parts->empty() && parts->size() == document.parts.size();
  for (size_t i : *parts) {
    const PartSource& part = *document.parts[i];
    const bool twin = part.mirror && named.count(part.id + kTwinSuffix) > 0;
    const bool itself = !twin || named.count(part.id) > 0;
    all = all && itself && (twin || !part.mirror);
    const Affine map = itself ? command.map : mirrored(command.map, *part.mirror);
    auto moved = mapped(part, map);
    if (!moved) return moved.error();
    if (itself && twin) {
      moved->mirror = mapped(*part.mirror, command.map);
      if (!moved->mirror) return noPlane();
    }
    // A drawn part that is mirrored across its own plane is the same; what is on it is not.
    bringStrokes(part, map, *moved, next);
    turns[part.id] = turnOf(part.frame, map, moved->frame);
    if (part.mirror) {
      const Affine of_twin = itself && twin ? command.map : mirrored(map, *part.mirror);
      turns[part.id + kTwinSuffix] = turnOf(mirrored(part.frame, *part.mirror), of_twin,
                                            mirrored(moved->frame, *moved->mirror));
    }
    const bool same = moved->frame == part.frame && moved->mirror == part.mirror &&
                      moved->thickness == part.thickness && moved->stroke == part.stroke &&
                      moved->mesh == part.mesh;
    if (same) continue;
    if (moved->stroke != part.stroke) stretched[part.id] = {part.frame, map, moved->frame};
    next.parts[i] = share(std::move(*moved));
  }
  turnPosed(turns, next);
  bringAttachments(stretched, next);
  if (all && document.symmetry) {
    next.symmetry = mapped(*document.symmetry, command.map);
    if (!next.symmetry) return noPlane();
  }
  return next;
}

Result<Document> applyTo(const Document& document, const SetThickness& command) {
  const double thickness = clamp(command.thickness, kMinThickness, kMaxThickness);
  const auto parts = findUnlocked(document, command.ids);
  auto next = changeParts(document, parts,
                          [=](PartSource& part) { return assign(part.thickness, thickness); });
  if (!next) return next;
  for (size_t i : *parts) bringStrokes(*document.parts[i], {}, *next->parts[i], *next);
  return next;
}

Result<Document> applyTo(const Document& document, const SetColor& command) {
  return changeUnlocked(document, command.ids,
                        [&](PartSource& part) { return assign(part.color, command.color); });
}

Result<Document> applyTo(const Document& document, const SetVisible& command) {
  return changeParts(document, findParts(document, command.ids),
                     [&](PartSource& part) { return assign(part.visible, command.visible); });
}

Result<Document> applyTo(const Document& document, const SetLocked& command) {
  return changeParts(document, findParts(document, command.ids),
                     [&](PartSource& part) { return assign(part.locked, command.locked); });
}

Result<Document> applyTo(const Document& document, const SetSkeleton& command) {
  return changeUnlocked(document, command.ids,
                        [&](PartSource& part) { return assign(part.skeleton, command.skeleton); });
}

Result<Document> applyTo(const Document& document, const RenamePart& command) {
  return changeParts(document, findParts(document, {command.id}), [&](PartSource& part) {
    return !command.name.empty() && assign(part.name, toUtf8(command.name));
  });
}

Result<Document> applyTo(const Document& document, const SetStroke& command) {
  const auto parts = findUnlocked(document, {command.id});
  if (!parts) return parts.error();
  const PartSource& changed = *document.parts[parts->front()];
  if (changed.mesh) {
    return {Status::notDrawn,
            onOneLine(changed.name) + " was imported, so it has no outline to change."};
  }
  const std::vector<Vec2> stroke = drawable(command.stroke);
  auto outline = makeOutline(stroke);
  if (!outline) return outline.error();
  if (!isDrawable(stroke, changed.frame)) return tooFarAway();
  return changeParts(document, parts,
                     [&](PartSource& part) { return assign(part.stroke, stroke); });
}

/// What becomes of the part's twin where it is mirrored across another plane.
PartTurn turnOfTwin(const PartSource& part, const Plane& plane) {
  const auto direction = [&](Vec3 axis) {
    return mirroredDirection(mirroredDirection(axis, *part.mirror), plane);
  };
  const Affine map{direction({1, 0, 0}), direction({0, 1, 0}), direction({0, 0, 1}), {}};
  return turnOf(mirrored(part.frame, *part.mirror), map, mirrored(part.frame, plane));
}

Result<Document> applyTo(const Document& document, const SetMirror& command) {
  std::optional<Plane> plane;
  if (command.plane) {
    plane = normalised(*command.plane);
    if (!plane) return noPlane();
  }
  std::map<std::string, PartTurn> turns;
  auto next = changeUnlocked(document, command.ids, [&](PartSource& part) {
    if (part.mirror && plane) turns[part.id + kTwinSuffix] = turnOfTwin(part, *plane);
    return assign(part.mirror, plane);
  });
  if (next) turnPosed(turns, *next);
  return next;
}

/// Where the twin of a part hangs, if the part's attachment is this one.
Attachment attachmentOfTwin(const Document& document, const Attachment& attachment,
                            const Plane& plane) {
  const auto index = document.find(sourceId(attachment.part));
  if (!index) return attachment;
  const PartSource& parent = *document.parts[*index];
  if (parent.mirror) {
    return {isTwinId(attachment.part) ? parent.id : parent.id + kTwinSuffix, attachment.at};
  }
  const Vec3 at = parent.frame.toLocal(mirrored(parent.frame.toWorld(attachment.at), plane));
  return {attachment.part, {at.x, at.y}};
}

/// What was painted on twins and how they were posed is that of the parts that they became. new_id:
/// of what was a twin.
void separateStrokesAndPoses(const Document& before,
                             const std::map<std::string, std::string>& new_id, Document& document) {
  const auto renamed = [&](const std::string& placed_id) {
    const auto found = new_id.find(placed_id);
    return found == new_id.end() ? placed_id : found->second;
  };
  for (const auto& [twin, id] : new_id) {
    const auto opposite = [&](const std::string& placed_id) {
      return renamed(oppositePlaced(before, placed_id));
    };
    copyStrokes(sourceId(twin), id, true, opposite, document);
  }
  for (auto& shared : document.weight_strokes) {
    std::string joint = renamedJoint(shared->joint, renamed);
    if (joint == shared->joint) continue;
    WeightStroke stroke = *shared;
    stroke.joint = std::move(joint);
    shared = std::make_shared<const WeightStroke>(std::move(stroke));
  }
  const auto jointRenamed = [&](const std::string& joint) { return renamedJoint(joint, renamed); };
  renamePosed(jointRenamed, document);
}

Result<Document> applyTo(const Document& document, const SeparateTwins& command) {
  const auto found = findUnlocked(document, command.ids);
  if (!found) return found.error();
  Document next = document;
  std::map<size_t, PartSource> twins;
  std::map<std::string, std::string> new_id;  // of what was a twin
  for (const PlacedPart& placed : placedParts(document)) {
    if (!placed.twin || !std::binary_search(found->begin(), found->end(), placed.source)) continue;
    const PartSource& part = *document.parts[placed.source];
    PartSource twin = part;
    twin.id = partId(takePartNumber(next));
    twin.name = part.name + '.' + placed.side;
    twin.frame = placed.frame;
    twin.mirror.reset();
    twin.root = false;
    if (part.attachment) {
      twin.attachment = attachmentOfTwin(document, *part.attachment, *part.mirror);
    }
    if (twin.mesh) twin.mesh = std::make_shared<const Mesh>(flipped(*twin.mesh));
    if (!isDrawable(twin)) return tooFarAway();
    new_id[placed.id] = twin.id;
    twins[placed.source] = std::move(twin);
  }
  if (document.parts.size() + twins.size() > Document::kMostParts) return Status::tooMany;

  const auto retarget = [&](PartSource& part) {
    if (!part.attachment) return false;
    const auto id = new_id.find(part.attachment->part);
    return id != new_id.end() && assign(part.attachment->part, id->second);
  };
  next.parts.clear();
  for (size_t i = 0; i < document.parts.size(); ++i) {
    PartSource part = *document.parts[i];
    const auto twin = twins.find(i);
    bool changed = retarget(part);
    if (twin != twins.end()) {
      part.name += twin->second.name.back() == 'L' ? ".R" : ".L";
      part.mirror.reset();
      changed = true;
    }
    next.parts.push_back(changed ? share(std::move(part)) : document.parts[i]);
    if (twin == twins.end()) continue;
    retarget(twin->second);
    next.parts.push_back(share(std::move(twin->second)));
  }
  separateStrokesAndPoses(document, new_id, next);
  if (next.weight_strokes.size() > Document::kMostWeightStrokes) return Status::tooMany;
  return withinTriangles(document, std::move(next));
}

Result<Document> applyTo(const Document& document, const SetSymmetry& command) {
  Document next = document;
  next.symmetry.reset();
  if (!command.plane) return next;
  next.symmetry = normalised(*command.plane);
  if (!next.symmetry) return noPlane();
  return next;
}

Result<Document> applyTo(const Document& document, const SetRefinement& command) {
  if (!command.threshold) return document;
  auto value = command.value;
  if (value) value = clamp(*value, 0, Refinement::kLargest);
  if (command.ids.empty()) {
    Document next = document;
    next.refine.*command.threshold = value;
    return next;
  }
  if (command.branch.empty()) {
    return changeUnlocked(document, command.ids, [&](PartSource& part) {
      return assign(part.refine.*command.threshold, value);
    });
  }
  const auto parts = findUnlocked(document, command.ids);
  if (!parts) return parts.error();
  for (size_t i : *parts) {
    const auto& branches = document.parts[i]->branches;
    if (branches.size() >= PartSource::kMostBranches && !branches.count(command.branch)) {
      return Status::tooMany;
    }
  }
  if (command.threshold != &Refinement::simplify) return document;
  return changeParts(document, parts, [&](PartSource& part) {
    if (!value) return part.branches.erase(command.branch) > 0;
    const auto [place, added] = part.branches.emplace(command.branch, *value);
    return added || assign(place->second, *value);
  });
}

Result<Document> applyTo(const Document& document, const ResetRefinement& command) {
  const auto reset = [&](PartSource& part) {
    bool changed = assign(part.refine, Refinement{});
    if (command.within) changed |= assign(part.branches, {});
    return changed;
  };
  if (command.ids.empty()) {
    Document next = document;
    next.refine = {};
    if (!command.within) return next;
    std::vector<size_t> unlocked;
    for (size_t i = 0; i < document.parts.size(); ++i) {
      if (!document.parts[i]->locked) unlocked.push_back(i);
    }
    return changeParts(next, unlocked, reset);
  }
  return changeUnlocked(document, command.ids, [&](PartSource& part) {
    return command.branch.empty() ? reset(part) : part.branches.erase(command.branch) > 0;
  });
}

Result<Document> applyTo(const Document& document, const SetAttachment& command) {
  const auto parts = findUnlocked(document, {command.id});
  if (!parts) return parts.error();
  if (command.attachment && !command.attachment->part.empty()) {
    const std::string& on = command.attachment->part;
    const auto parent = document.find(sourceId(on));
    if (!parent || (isTwinId(on) && !document.parts[*parent]->mirror)) return notFound(on);
    if (*parent == parts->front()) {
      return {Status::notFound, "A part cannot hang on itself."};
    }
  }
  if (command.attachment && !isDrawable(command.attachment->at)) return tooFarAway();
  return changeParts(document, parts,
                     [&](PartSource& part) { return assign(part.attachment, command.attachment); });
}

Result<Document> applyTo(const Document& document, const SetRoot& command) {
  const auto root = findParts(document, {command.id});
  if (!root) return root.error();
  const auto others = findParts(document, command.others);
  if (!others) return others.error();
  auto next =
      changeParts(document, others, [](PartSource& part) { return assign(part.root, false); });
  return changeParts(*next, root, [](PartSource& part) { return assign(part.root, true); });
}

Result<Document> applyTo(const Document& document, const SetReference& command) {
  Document next = document;
  auto& references = next.references;
  const auto place = std::find_if(references.begin(), references.end(), [&](const auto& one) {
    return one->view == command.reference.view;
  });
  if (!command.reference.image) {
    if (place != references.end()) references.erase(place);
    return next;
  }
  if (!isReferenceImage(*command.reference.image)) {
    return {Status::unreadable, "The picture is neither PNG, JPEG nor WebP, or larger than 16 MB."};
  }
  Reference reference = command.reference;
  if (!isDrawable(reference.position)) return tooFarAway();
  reference.opacity = clamp(reference.opacity, 0, 1);
  reference.scale = clamp(reference.scale, Reference::kMinScale, Reference::kMaxScale);
  if (place != references.end()) {
    *place = std::make_shared<const Reference>(std::move(reference));
  } else {
    references.push_back(std::make_shared<const Reference>(std::move(reference)));
  }
  return next;
}

std::vector<std::shared_ptr<const NamedPose>>::iterator findPose(Document& document,
                                                                 const std::string& name) {
  return std::find_if(document.poses.begin(), document.poses.end(),
                      [&](const auto& pose) { return pose->name == name; });
}

Error noPose(const std::string& name) {
  return {Status::notFound, "There is no pose \"" + onOneLine(name) + "\"."};
}

Result<Document> applyTo(const Document& document, const SetPose& command) {
  if (command.name.empty()) return {Status::notFound, "A pose needs a name."};
  NamedPose pose;
  pose.name = toUtf8(command.name);
  if (command.joints.size() > NamedPose::kMostJoints) return Status::tooMany;
  for (const auto& [joint, motion] : command.joints) {
    const auto unit = withUnitRotation(motion);
    if (!unit) return {Status::noArea, "This is no pose: a joint's motion is out of range."};
    pose.joints[toUtf8(joint)] = *unit;
  }
  Document next = document;
  const auto place = findPose(next, pose.name);
  if (place == next.poses.end()) {
    if (next.poses.size() >= Document::kMostPoses) return Status::tooMany;
    next.poses.push_back(std::make_shared<const NamedPose>(std::move(pose)));
  } else if ((*place)->joints != pose.joints) {
    pose.extra = (*place)->extra;
    *place = std::make_shared<const NamedPose>(std::move(pose));
  }
  return next;
}

Result<Document> applyTo(const Document& document, const RenamePose& command) {
  Document next = document;
  const auto place = findPose(next, command.name);
  if (place == next.poses.end()) return noPose(command.name);
  const std::string to = toUtf8(command.to);
  if (to.empty() || to == command.name) return next;
  if (next.findPose(to)) {
    return {Status::notFound, "There is a pose \"" + onOneLine(to) + "\" already."};
  }
  NamedPose pose = **place;
  pose.name = to;
  *place = std::make_shared<const NamedPose>(std::move(pose));
  return next;
}

Result<Document> applyTo(const Document& document, const DeletePose& command) {
  Document next = document;
  const auto place = findPose(next, command.name);
  if (place == next.poses.end()) return noPose(command.name);
  next.poses.erase(place);
  return next;
}

Result<Document> applyTo(const Document& document, const SetBlend& command) {
  Document next = document;
  next.blend = clamp(command.radius, 0, Document::kLargestBlend);
  return next;
}

Result<Document> applyTo(const Document& document, const AddWeightStroke& command) {
  auto stroke = strokeOnPart(document, command.stroke);
  if (!stroke) return stroke.error();
  const auto part = findUnlocked(document, {stroke->part});
  if (!part) return part.error();
  if (document.weight_strokes.size() >= Document::kMostWeightStrokes) return Status::tooMany;
  Document next = document;
  next.weight_strokes.push_back(std::make_shared<const WeightStroke>(std::move(*stroke)));
  return next;
}

Result<Document> applyTo(const Document& document, const ClearWeightStrokes& command) {
  const auto isMeant = [&](const WeightStroke& stroke) {
    const auto index = document.find(stroke.part);
    if (index && document.parts[*index]->locked) return false;
    if (command.joint.empty()) return true;
    if (stroke.kind == WeightStroke::Kind::smooth) return false;  // it is of no joint
    if (stroke.joint == command.joint) return true;
    const bool twins = index && document.parts[*index]->mirror;
    return twins && oppositeJoint(document, stroke.joint) == command.joint;
  };
  Document next = document;
  auto& strokes = next.weight_strokes;
  strokes.erase(std::remove_if(strokes.begin(), strokes.end(),
                               [&](const auto& one) { return isMeant(*one); }),
                strokes.end());
  return next;
}

Result<Document> applyTo(const Document&, const ReplaceDocument& command) {
  return command.document;
}

}  // namespace

Result<Document> apply(const Document& document, const Command& command) {
  return std::visit([&](const auto& one) { return applyTo(document, one); }, command.step);
}

}  // namespace marrow
