#include "io/part_export.h"

#include "io/export_text.h"

namespace marrow {
namespace {

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

}  // namespace

std::string partToJson(const std::string& name, const Part& part) {
  Json tree = Json::object();
  tree["name"] = name;
  tree["outline"] = toJson(part.outline.dense);
  tree["polygon"] = toJson(part.outline.polygon);
  tree["straightSkeleton"] = straightSkeletonTree(part.straight_skeleton);
  tree["skeleton"] = skeletonTree(part.skeleton);
  tree["mesh"] = meshTree(part.mesh);
  tree["timings"] = timingsToTree(part.timings);
  return toLines(tree);
}

std::string partToObj(const std::string& name, const Part& part) {
  const std::string object = obj::name(name);
  std::string text = "# Marrow: a part's mesh, then its bones as lines between its joints\n";
  text += "o " + object + "\n";
  for (Vec3 position : part.mesh.positions) obj::appendVector(text, "v", position);
  for (Vec3 normal : part.normals) obj::appendVector(text, "vn", normal);
  obj::appendFaces(text, part.mesh, 1);

  text += "o " + object + "_bones\n";
  for (const auto& joint : part.skeleton.joints) {
    text +=
        "# " + std::string(toString(joint.kind)) + ", radius " + obj::number(joint.radius) + '\n';
    obj::appendVector(text, "v", {joint.position.x, joint.position.y, 0});
  }
  const size_t first = part.mesh.positions.size() + 1;
  for (const auto& bone : part.skeleton.bones) {
    text += "l " + std::to_string(first + bone[0]) + ' ' + std::to_string(first + bone[1]) + '\n';
  }
  return text;
}

}  // namespace marrow
