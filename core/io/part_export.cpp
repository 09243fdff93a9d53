#include "io/part_export.h"

#include <array>

#include "io/json.h"

namespace marrow {
namespace {

std::string numberText(double value) { return toJson(value).dump(); }

Json straightSkeletonTree(const StraightSkeleton& skeleton) {
  Json nodes = Json::array(), edges = Json::array();
  for (size_t i = 0; i < skeleton.nodes.size(); ++i) {
    Json node = toJson(skeleton.nodes[i]);
    node.push_back(toJson(skeleton.times[i]));
    nodes.push_back(std::move(node));
  }
  for (const auto& edge : skeleton.edges) {
    edges.push_back(Json::array({edge.a, edge.b, toString(edge.kind)}));
  }
  Json tree = Json::object();
  tree["method"] = toString(skeleton.method);
  tree["nodes"] = std::move(nodes);
  tree["edges"] = std::move(edges);
  return tree;
}

Json skeletonTree(const PartSkeleton& skeleton) {
  Json joints = Json::array(), bones = Json::array();
  for (const auto& joint : skeleton.joints) {
    Json one = Json::object();
    one["kind"] = toString(joint.kind);
    one["position"] = Json::array({toJson(joint.position.x), toJson(joint.position.y), 0});
    one["radius"] = toJson(joint.radius);
    joints.push_back(std::move(one));
  }
  for (const auto& bone : skeleton.bones) bones.push_back(Json::array({bone[0], bone[1]}));
  Json tree = Json::object();
  tree["joints"] = std::move(joints);
  tree["bones"] = std::move(bones);
  return tree;
}

Json meshTree(const Mesh& mesh) {
  const MeshReport report = inspect(mesh);
  Json tree = Json::object();
  tree["vertices"] = mesh.positions.size();
  tree["triangles"] = mesh.triangles.size();
  tree["closed"] = report.closed;
  tree["manifold"] = report.manifold;
  tree["volume"] = toJson(report.volume);
  return tree;
}

Json timingsTree(const Timings& timings) {
  Json tree = Json::object();
  for (const auto& [stage, ms] : timings.stages_ms) tree[stage] = toJson(ms);
  tree["total"] = toJson(timings.total_ms);
  return tree;
}

/// A name for one line of an OBJ file: no control characters, no spaces, never empty.
std::string objName(const std::string& name) {
  std::string text;
  for (char c : name) text += static_cast<unsigned char>(c) <= ' ' || c == '\x7f' ? '_' : c;
  return text.empty() ? "part" : text;
}

void appendVector(std::string& text, const char* keyword, Vec3 v) {
  text += keyword;
  for (double value : {v.x, v.y, v.z}) text += ' ' + numberText(value);
  text += '\n';
}

}  // namespace

std::string partToJson(const std::string& name, const Part& part) {
  const std::array<std::pair<const char*, Json>, 7> fields = {{
      {"name", name},
      {"outline", toJson(part.outline.dense)},
      {"polygon", toJson(part.outline.polygon)},
      {"straightSkeleton", straightSkeletonTree(part.straight_skeleton)},
      {"skeleton", skeletonTree(part.skeleton)},
      {"mesh", meshTree(part.mesh)},
      {"timings", timingsTree(part.timings)},
  }};
  std::string text;
  for (const auto& [key, value] : fields) {
    text += text.empty() ? "{\n" : ",\n";
    text += "  \"" + std::string(key) + "\": " + toText(value);
  }
  return text + "\n}\n";
}

std::string partToObj(const std::string& name, const Part& part) {
  const std::string object = objName(name);
  std::string text = "# Marrow: a part's mesh, then its bones as lines between its joints\n";
  text += "o " + object + "\n";
  for (Vec3 position : part.mesh.positions) appendVector(text, "v", position);
  for (Vec3 normal : part.normals) appendVector(text, "vn", normal);
  text += "s 1\n";
  for (const auto& triangle : part.mesh.triangles) {
    text += 'f';
    for (uint32_t corner : triangle) {
      const std::string index = std::to_string(corner + 1);
      text += ' ' + index + "//" + index;
    }
    text += '\n';
  }

  text += "o " + object + "_bones\n";
  for (const auto& joint : part.skeleton.joints) {
    text +=
        "# " + std::string(toString(joint.kind)) + ", radius " + numberText(joint.radius) + '\n';
    appendVector(text, "v", {joint.position.x, joint.position.y, 0});
  }
  const size_t first = part.mesh.positions.size() + 1;
  for (const auto& bone : part.skeleton.bones) {
    text += "l " + std::to_string(first + bone[0]) + ' ' + std::to_string(first + bone[1]) + '\n';
  }
  return text;
}

}  // namespace marrow
