// Rigs for the tests, and what is true of every rig.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/evaluation.h"
#include "rig/connect.h"
#include "rig/refine.h"
#include "rig/rig.h"
#include "support/creatures.h"

namespace marrow {

/// Parts that are built once, however often they are moved, refined and joined.
class Workshop {
 public:
  const Part* partFor(const PartSource& source) {
    const auto key = std::make_pair(strokeKey(source.stroke), source.thickness);
    auto& part = parts_[key];
    if (!part) {
      // Coarse meshes: these tests look at bones.
      PartOptions options = previewOptions();
      options.triangulation.target_points = 80;
      options.inflate.thickness = source.thickness;
      auto built = buildPart(source.stroke, options);
      part = built ? std::make_unique<Part>(std::move(*built)) : std::make_unique<Part>();
    }
    return part->skeleton.bones.empty() ? nullptr : part.get();
  }

 private:
  static std::vector<std::pair<double, double>> strokeKey(const std::vector<Vec2>& stroke) {
    std::vector<std::pair<double, double>> key;
    for (const Vec2 p : stroke) key.emplace_back(p.x, p.y);
    return key;
  }
  std::map<std::pair<std::vector<std::pair<double, double>>, double>, std::unique_ptr<Part>> parts_;
};

/// A document's parts, ready to be joined. Keeps what RigPart refers to.
struct Assembly {
  Document document;
  std::vector<PlacedPart> placed;
  std::vector<RigPart> parts;

  Assembly(Document of, Workshop& workshop)
      : document(std::move(of)), placed(placedParts(document)) {
    for (const PlacedPart& part : placed) {
      const PartSource& source = *document.parts[part.source];
      parts.push_back({&part, &source, workshop.partFor(source)});
    }
  }
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  bool hasBones(size_t part) const { return parts[part].part && parts[part].source->skeleton; }
  std::vector<Connection> connections() const { return connectParts(parts); }
  Rig rig() const { return makeRig(parts, document.refine); }
  Rig rig(const Refinement& model) const { return makeRig(parts, model); }
  size_t indexOf(const std::string& id) const {
    size_t i = 0;
    while (i < placed.size() && placed[i].id != id) ++i;
    return i;
  }
};

inline std::vector<Vec2> ellipse(Vec2 centre, double half_width, double half_height) {
  std::vector<Vec2> stroke;
  for (const Vec2 p : unitCircle(60)) {
    stroke.push_back(centre + Vec2{p.x * half_width, p.y * half_height});
  }
  return stroke;
}

/// Adds a part, parallel to the front view, z in front of it; with a twin across `mirror`.
inline PartSource& addPart(Document& document, const std::string& name,
                           const std::vector<Vec2>& stroke, double z = 0,
                           std::optional<Plane> mirror = {}) {
  auto part = std::make_shared<PartSource>();
  part->id = partId(takePartNumber(document));
  part->name = name;
  part->stroke = stroke;
  part->frame.origin.z = z;
  part->mirror = mirror;
  document.parts.push_back(part);
  return *part;
}

/// Seen from its side: a body, two legs with their twins, a neck, a head, a tail.
inline Document quadruped() {
  const Plane middle{{0, 0, 1}, 0};
  Document document;
  addPart(document, "Body", ellipse({0, 0}, 180, 70));
  addPart(document, "Leg", ellipse({-120, -90}, 22, 80), 45, middle);
  addPart(document, "Leg", ellipse({110, -90}, 22, 80), 45, middle);
  addPart(document, "Neck", ellipse({185, 60}, 28, 70));
  addPart(document, "Head", ellipse({215, 150}, 75, 45));
  addPart(document, "Tail", ellipse({-230, 30}, 90, 12));
  return document;
}

/// The document seen after a similarity, or a mirror image where a mirror is given.
inline Document mapped(const Document& document, const Affine& map) {
  const double scale = length(map.x);
  const auto mappedPlane = [&](Plane plane) {
    const Vec3 normal = map.direction(plane.normal) / scale;
    const Vec3 on = map(plane.normal * -plane.offset);
    return Plane{normal / length(normal), -dot(normal / length(normal), on)};
  };
  Document result = document;
  for (auto& part : result.parts) {
    auto source = std::make_shared<PartSource>(*part);
    const Frame& frame = part->frame;
    source->frame = {map(frame.origin), map.direction(frame.x), map.direction(frame.y)};
    if (part->mirror) source->mirror = mappedPlane(*part->mirror);
    part = source;
  }
  return result;
}

inline Refinement thresholds(double simplify, double merge, double prune, double collapse) {
  Refinement refine;
  refine.simplify = simplify;
  refine.merge = merge;
  refine.prune = prune;
  refine.collapse = collapse;
  return refine;
}
inline Refinement unrefined() { return thresholds(Refinement::kSimplify, 0, 0, 0); }

/// What is wrong with a list of connections; nothing: "".
inline std::string faultOf(const std::vector<Connection>& connections, const Assembly& assembly) {
  std::map<uint32_t, uint32_t> parent_of;
  for (size_t i = 0; i < connections.size(); ++i) {
    const Connection& c = connections[i];
    if (i > 0 && connections[i - 1].child >= c.child) return "not by child, or a second parent";
    if (c.child == c.parent) return "hangs on itself";
    if (c.parent >= assembly.parts.size() || !assembly.hasBones(c.parent)) return "no such parent";
    if (c.child >= assembly.parts.size() || !assembly.parts[c.child].part) return "no such child";
    parent_of[c.child] = c.parent;
    const PartSkeleton& child = assembly.parts[c.child].part->skeleton;
    const PartSkeleton& parent = assembly.parts[c.parent].part->skeleton;
    const Frame &frame = assembly.placed[c.child].frame, &on = assembly.placed[c.parent].frame;
    Vec2 by = child.joints.at(c.child_joint).position;
    if (c.child_split) {
      const auto& bone = child.bones.at(c.child_bone);
      if (!(c.child_along > 0 && c.child_along < 1) || c.child_joint != bone[0]) {
        return "the child is split at an end";
      }
      by = lerp(by, child.joints[bone[1]].position, c.child_along);
    }
    if (!(distance(frame.toWorld(by), c.child_position) <= 1e-9 * frame.scale() * 1000)) {
      return "child's place";
    }
    Vec2 at = parent.joints.at(c.parent_joint).position;
    if (c.event == AttachEvent::split) {
      const auto& bone = parent.bones.at(c.parent_bone);
      if (!(c.along > 0 && c.along < 1) || c.parent_joint != bone[0]) return "split at an end";
      at = lerp(at, parent.joints[bone[1]].position, c.along);
    }
    if (!(distance(on.toWorld(at), c.parent_position) <= 1e-9 * on.scale() * 1000)) {
      return "parent's place";
    }
  }
  for (const auto& [child, parent] : parent_of) {
    uint32_t top = child;
    for (size_t steps = 0; parent_of.count(top); ++steps) {
      if (steps > parent_of.size()) return "a circle";
      top = parent_of[top];
    }
  }
  return "";
}

/// What is wrong with a rig; nothing: "".
inline std::string faultOf(const Rig& rig, const Assembly& assembly) {
  const std::string fault = faultOf(rig.connections, assembly);
  if (!fault.empty()) return fault;
  std::set<std::string> ids, names;
  std::vector<uint32_t> degrees(rig.joints.size()), roots;
  size_t bones = 0;
  for (uint32_t i = 0; i < rig.joints.size(); ++i) {
    const Rig::Joint& joint = rig.joints[i];
    if (!ids.insert(joint.id).second) return "id twice: " + joint.id;
    if (joint.name.empty() || !names.insert(joint.name).second) return "name twice: " + joint.name;
    if (joint.part >= assembly.parts.size() || !assembly.hasBones(joint.part)) return "part";
    if (joint.branch >= assembly.parts[joint.part].part->skeleton.branches.size()) return "branch";
    if (!std::isfinite(dot(joint.position, joint.position))) return "not finite";
    if (!(joint.radius > 0) || !std::isfinite(joint.radius)) return "radius";
    if (joint.parent < 0) {
      roots.push_back(i);
      continue;
    }
    if (joint.parent >= static_cast<int32_t>(i)) return "parent after its child";
    const std::array<uint32_t, 2> bone{static_cast<uint32_t>(joint.parent), i};
    if (bones >= rig.bones.size() || rig.bones[bones] != bone) return "bones and parents differ";
    ++bones;
    ++degrees[bone[0]];
    ++degrees[i];
  }
  if (bones != rig.bones.size()) return "a dangling bone";
  if (roots != rig.roots) return "roots";
  for (size_t i = 0; i < rig.joints.size(); ++i) {
    const JointKind kind = degrees[i] < 2    ? JointKind::terminal
                           : degrees[i] == 2 ? JointKind::sleeve
                                             : JointKind::junction;
    if (rig.joints[i].kind != kind) return "kind";
    if (degrees[i] == 0) return "a tree without a bone";
  }
  size_t trees = 0;
  for (size_t i = 0; i < assembly.parts.size(); ++i) trees += assembly.hasBones(i);
  if (rig.roots.size() + rig.connections.size() != trees) return "number of trees";
  size_t carried = 0;
  for (size_t i = 0; i < assembly.parts.size(); ++i) {
    carried += assembly.parts[i].part && !assembly.hasBones(i);
  }
  if (rig.carried.size() != carried) return "number carried";
  for (const auto& [part, joint] : rig.carried) {
    if (assembly.hasBones(part) || joint >= static_cast<int32_t>(rig.joints.size()))
      return "carried";
  }
  return "";
}

inline std::set<std::string> idsOf(const Rig& rig) {
  std::set<std::string> ids;
  for (const auto& joint : rig.joints) ids.insert(joint.id);
  return ids;
}

inline const Connection* connectionOf(const std::vector<Connection>& connections, size_t child) {
  for (const Connection& connection : connections) {
    if (connection.child == child) return &connection;
  }
  return nullptr;
}

}  // namespace marrow
