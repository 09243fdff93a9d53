#include "io/rig_export.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>
#include <utility>

#include "io/export_text.h"
#include "rig/names.h"
#include "solid/quality.h"

namespace marrow {
namespace {

Json jointsTree(const Rig& rig, const std::vector<PlacedPart>& placed) {
  Json joints = Json::array();
  for (const Rig::Joint& joint : rig.joints) {
    Json one = Json::object();
    one["id"] = joint.id;
    one["name"] = joint.name;
    one["part"] = placed[joint.part].id;
    one["parent"] = joint.parent < 0 ? Json() : Json(rig.joints[joint.parent].id);
    one["position"] = toJson(joint.position);
    one["radius"] = toJson(joint.radius);
    one["kind"] = toString(joint.kind);
    joints.push_back(std::move(one));
  }
  return joints;
}

Json connectionsTree(const Rig& rig, const std::vector<PlacedPart>& placed) {
  Json connections = Json::array();
  for (const Connection& connection : rig.connections) {
    Json one = Json::object();
    one["child"] = placed[connection.child].id;
    one["parent"] = placed[connection.parent].id;
    one["event"] = toString(connection.event);
    one["test"] = toString(connection.test);
    connections.push_back(std::move(one));
  }
  return connections;
}

Json carriedTree(const Rig& rig, const std::vector<PlacedPart>& placed) {
  Json carried = Json::array();
  for (const auto& [part, joint] : rig.carried) {
    Json one = Json::object();
    one["part"] = placed[part].id;
    one["joint"] = joint < 0 ? Json() : Json(rig.joints[joint].id);
    carried.push_back(std::move(one));
  }
  return carried;
}

Json errorsTree(const Evaluation& character) {
  Json errors = Json::array();
  for (const EvaluatedPart& part : character.parts()) {
    if (part.part) continue;
    Json one = Json::object();
    one["part"] = part.source->id;
    one["message"] = part.error.message();
    errors.push_back(std::move(one));
  }
  return errors;
}

Json rigTimings(const Timings& timings) {
  constexpr const char* kSubSkeletons[] = {"outline", "straightSkeleton", "axis", "joints"};
  Json tree = timingsToTree(timings);
  double sum_ms = 0;
  for (const char* stage : kSubSkeletons) {
    if (const Json* ms = field(tree, stage)) sum_ms += ms->get<double>();
  }
  const Json total = tree["total"];
  tree.erase("total");
  tree["subSkeletons"] = toJson(sum_ms);
  tree["total"] = total;
  return tree;
}

}  // namespace

std::vector<uint32_t> unattachedParts(const Evaluation& character) {
  const Rig& rig = character.rig();
  if (rig.roots.size() < 2) return {};
  std::vector<uint32_t> root_of(rig.joints.size());
  std::vector<std::set<uint32_t>> parts(rig.joints.size());  // of the tree, by its root
  for (uint32_t i = 0; i < rig.joints.size(); ++i) {
    const int32_t parent = rig.joints[i].parent;
    root_of[i] = parent < 0 ? i : root_of[static_cast<uint32_t>(parent)];
    parts[root_of[i]].insert(rig.joints[i].part);
  }
  const uint32_t largest =
      *std::max_element(rig.roots.begin(), rig.roots.end(),
                        [&](uint32_t a, uint32_t b) { return parts[a].size() < parts[b].size(); });
  std::vector<uint32_t> unattached;
  for (const uint32_t root : rig.roots) {
    if (root != largest) unattached.push_back(rig.joints[root].part);
  }
  return unattached;
}

Json rigToTree(const Evaluation& character) {
  const Rig& rig = character.rig();
  const std::vector<PlacedPart>& placed = character.placed();
  Json bones = Json::array(), roots = Json::array(), unattached = Json::array();
  for (const auto& bone : rig.bones) {
    bones.push_back(Json::array({rig.joints[bone[0]].id, rig.joints[bone[1]].id}));
  }
  for (const uint32_t root : rig.roots) roots.push_back(rig.joints[root].id);
  for (const uint32_t part : unattachedParts(character)) unattached.push_back(placed[part].id);

  Json tree = Json::object();
  tree["joints"] = jointsTree(rig, placed);
  tree["bones"] = std::move(bones);
  tree["connections"] = connectionsTree(rig, placed);
  tree["roots"] = std::move(roots);
  tree["carried"] = carriedTree(rig, placed);
  tree["unattached"] = std::move(unattached);
  tree["errors"] = errorsTree(character);
  tree["timings"] = rigTimings(character.timings());
  return tree;
}

void addCharacter(Json& tree, const Character& made) {
  const SolidReport report = inspectSolid(made.merged.mesh);
  Json& merged = tree["merged"] = Json::object();
  merged["vertices"] = made.merged.mesh.positions.size();
  merged["triangles"] = made.merged.mesh.triangles.size();
  merged["closed"] = report.closed;
  merged["manifold"] = report.manifold;
  merged["selfIntersections"] = report.self_intersections;
  merged["volume"] = toJson(report.volume);
  merged["components"] = report.components;
  merged["genus"] = report.genus;
  for (const Character::LeftOut& out : made.left_out) {
    Json one = Json::object();
    one["part"] = out.part;
    one["why"] = out.why;
    tree["leftOut"].push_back(std::move(one));
  }
  if (made.weights) {
    Json& weights = tree["weights"] = Json::object();
    weights["bones"] = made.weights->bones;
    weights["maxSumError"] = toJson(made.weights->max_sum_error);
    weights["min"] = toJson(made.weights->min);
    weights["max"] = toJson(made.weights->max);
  }
  if (!made.no_weights.empty()) tree["noWeights"] = made.no_weights;
  Json& timings = tree["timings"];
  const double before = timings["total"].get<double>();
  timings.erase("total");
  for (const auto& [stage, ms] : made.timings.stages_ms) timings[stage] = toJson(ms);
  timings["total"] = toJson(before + made.timings.total_ms);
}

std::string rigToJson(const Evaluation& character) { return toLines(rigToTree(character)); }

std::string rigToObj(const Evaluation& character) {
  const std::vector<RigPart> parts = character.rigParts();
  const std::vector<std::string> names = uniqueNames(parts);
  std::string text = "# Marrow: the parts' meshes, then the bones as lines between their joints\n";
  size_t vertices = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    const RigPart& part = parts[i];
    if (!part.part || !part.source->visible) continue;
    const Frame& frame = part.placed->frame;
    const Frame turn{{}, frame.x / frame.scale(), frame.y / frame.scale()};
    text += "o " + obj::name(names[i]) + '\n';
    for (Vec3 position : part.part->mesh.positions) {
      obj::appendVector(text, "v", frame.toWorld(position));
    }
    for (Vec3 normal : part.part->normals) obj::appendVector(text, "vn", turn.toWorld(normal));
    obj::appendFaces(text, part.part->mesh, vertices + 1);
    vertices += part.part->mesh.positions.size();
  }

  const Rig& rig = character.rig();
  if (rig.joints.empty()) return text;
  text += "o bones\n";
  for (const Rig::Joint& joint : rig.joints) {
    text += "# " + obj::name(joint.name) + ", " + toString(joint.kind) + ", radius " +
            obj::number(joint.radius) + '\n';
    obj::appendVector(text, "v", joint.position);
  }
  for (const auto& bone : rig.bones) {
    text += "l " + std::to_string(vertices + 1 + bone[0]) + ' ' +
            std::to_string(vertices + 1 + bone[1]) + '\n';
  }
  return text;
}

}  // namespace marrow
