#include "io/glb.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

#include "io/document_json.h"
#include "io/tiny_gltf.h"

namespace marrow {
namespace {

constexpr char kSkeleton[] = "Skeleton";
constexpr int kDocumentVersion = 1;

/// Of a colour as screens show it, what light makes it; four decimals.
double linear(uint8_t channel) {
  const double c = channel / 255.0;
  const double light = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return std::round(light * 1e4) / 1e4;
}

std::vector<double> numbers(Vec3 v) { return {v.x, v.y, v.z}; }
std::vector<double> numbers(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }

/// Numbers are written as single precision; a sum of weights must stay one.
std::array<float, VertexSkin::kMost> singleWeights(const VertexSkin& own) {
  std::array<float, VertexSkin::kMost> weights{};
  float others = 0;
  for (size_t k = 1; k < weights.size(); ++k) {
    weights[k] = static_cast<float>(own.weights[k]);
    others += weights[k];
  }
  weights[0] = 1 - others;
  return weights;
}

class Writer {
 public:
  Writer(const GlbCharacter& character, const GlbOptions& options)
      : character_(character), rig_(character.rig), scale_(options.metres_per_unit) {
    model_.asset.generator = "Marrow";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back();
    model_.scenes[0].name = character.name;
    model_.defaultScene = 0;
  }

  Result<std::string> write(bool binary) {
    addJoints();
    addPaints();
    for (const SkinnedMesh& mesh : character_.meshes) addMesh(mesh);
    for (const auto& [name, pose] : character_.poses) addAnimation(name, pose);
    addDocument();
    if (!finite_) return Status::meshFailed;
    if (bytes().empty()) model_.buffers.clear();
    std::ostringstream out;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, out, false, binary)) {
      return Status::meshFailed;
    }
    return out.str();
  }

 private:
  // ---- Bytes

  std::vector<unsigned char>& bytes() { return model_.buffers[0].data; }

  template <typename T>
  void put(T value) {
    const size_t at = bytes().size();
    bytes().resize(at + sizeof(T));
    std::memcpy(bytes().data() + at, &value, sizeof(T));
  }
  float put(double value) {
    const auto single = static_cast<float>(value);
    finite_ = finite_ && std::isfinite(single);
    put<float>(single);
    return single;
  }

  /// Begins a view at a multiple of four bytes.
  int beginView(int target) {
    while (bytes().size() % 4 != 0) bytes().push_back(0);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes().size();
    view.target = target;
    model_.bufferViews.push_back(std::move(view));
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }
  /// What was put since beginView.
  int endAccessor(int type, int component, size_t count) {
    tinygltf::BufferView& view = model_.bufferViews.back();
    view.byteLength = bytes().size() - view.byteOffset;
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.type = type;
    accessor.componentType = component;
    accessor.count = count;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int putVectors(const std::vector<Vec3>& vectors, double scale, bool with_bounds) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    beginView(TINYGLTF_TARGET_ARRAY_BUFFER);
    std::array<float, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
    for (const Vec3 v : vectors) {
      const std::array<float, 3> put_there{put(v.x * scale), put(v.y * scale), put(v.z * scale)};
      for (size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], put_there[k]);
        high[k] = std::max(high[k], put_there[k]);
      }
    }
    const int accessor =
        endAccessor(TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, vectors.size());
    if (with_bounds) {
      model_.accessors.back().minValues.assign(low.begin(), low.end());
      model_.accessors.back().maxValues.assign(high.begin(), high.end());
    }
    return accessor;
  }

  int putWeights(const std::vector<VertexSkin>& skin) {
    beginView(TINYGLTF_TARGET_ARRAY_BUFFER);
    for (const VertexSkin& own : skin) {
      for (const float weight : singleWeights(own)) put<float>(weight);
    }
    return endAccessor(TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT, skin.size());
  }

  int putJoints(const std::vector<VertexSkin>& skin) {
    beginView(TINYGLTF_TARGET_ARRAY_BUFFER);
    for (const VertexSkin& own : skin) {
      const auto weights = singleWeights(own);
      for (size_t k = 0; k < weights.size(); ++k) {
        put<uint16_t>(weights[k] > 0 ? static_cast<uint16_t>(own.joints[k]) : uint16_t{0});
      }
    }
    return endAccessor(TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, skin.size());
  }

  int putTriangles(const SkinnedMesh& mesh, uint32_t paint, size_t count) {
    const bool few = mesh.mesh.positions.size() < 0xffff;
    beginView(TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    for (size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
      if (mesh.paint_of_triangle[t] != paint) continue;
      for (const uint32_t corner : mesh.mesh.triangles[t]) {
        if (few) {
          put<uint16_t>(static_cast<uint16_t>(corner));
        } else {
          put<uint32_t>(corner);
        }
      }
    }
    return endAccessor(
        TINYGLTF_TYPE_SCALAR,
        few ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
        3 * count);
  }

  // ---- The skeleton

  int addNode(tinygltf::Node node) {
    model_.nodes.push_back(std::move(node));
    return static_cast<int>(model_.nodes.size()) - 1;
  }

  /// Where each joint is and how it is turned, in space.
  std::vector<Rigid> places(const Pose& pose) const {
    const std::vector<Rigid> motions = posed(rig_, pose);
    std::vector<Rigid> all(rig_.joints.size());
    for (size_t i = 0; i < all.size(); ++i) {
      all[i] = {normalised(motions[i].rotation * axes_[i]),
                motions[i](rig_.joints[i].position) * scale_};
    }
    return all;
  }
  Rigid withinParent(const std::vector<Rigid>& places, size_t joint) const {
    const int32_t parent = rig_.joints[joint].parent;
    return parent < 0 ? places[joint]
                      : inverse(places[static_cast<size_t>(parent)]) * places[joint];
  }

  void addJoints() {
    if (rig_.joints.empty()) return;
    axes_ = restAxes(rig_);
    rest_ = places({});
    tinygltf::Node skeleton;
    skeleton.name = kSkeleton;
    skeleton_ = addNode(std::move(skeleton));
    model_.scenes[0].nodes.push_back(skeleton_);
    for (size_t i = 0; i < rig_.joints.size(); ++i) {
      const Rig::Joint& joint = rig_.joints[i];
      const Rigid local = withinParent(rest_, i);
      tinygltf::Node node;
      node.name = joint.name;
      node.rotation = numbers(local.rotation);
      node.translation = numbers(local.move);
      finite_ = finite_ && std::isfinite(dot(local.move, local.move));
      const int parent = joint.parent < 0 ? skeleton_ : nodeOf(static_cast<size_t>(joint.parent));
      const int self = addNode(std::move(node));
      model_.nodes[static_cast<size_t>(parent)].children.push_back(self);
    }
  }
  int nodeOf(size_t joint) const { return skeleton_ + 1 + static_cast<int>(joint); }

  /// The one skin, of all joints.
  int skin() {
    if (!model_.skins.empty()) return 0;
    beginView(0);
    for (const Rigid& place : rest_) {
      const Rigid back = inverse(place);
      for (const Vec3 column : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Vec3 turned = back.direction(column);
        for (const double number : {turned.x, turned.y, turned.z, 0.0}) put(number);
      }
      for (const double number : {back.move.x, back.move.y, back.move.z, 1.0}) put(number);
    }
    tinygltf::Skin skin;
    skin.name = kSkeleton;
    skin.inverseBindMatrices =
        endAccessor(TINYGLTF_TYPE_MAT4, TINYGLTF_COMPONENT_TYPE_FLOAT, rest_.size());
    skin.skeleton = skeleton_;
    for (size_t i = 0; i < rest_.size(); ++i) skin.joints.push_back(nodeOf(i));
    model_.skins.push_back(std::move(skin));
    return 0;
  }

  // ---- The body

  void addPaints() {
    for (const Paint& paint : character_.paints) {
      tinygltf::Material material;
      material.name = paint.name;
      material.pbrMetallicRoughness.baseColorFactor = {linear(paint.color.r), linear(paint.color.g),
                                                       linear(paint.color.b), 1};
      material.pbrMetallicRoughness.metallicFactor = 0;
      material.pbrMetallicRoughness.roughnessFactor = 0.8;
      model_.materials.push_back(std::move(material));
    }
  }

  void addMesh(const SkinnedMesh& mesh) {
    std::map<uint32_t, size_t> triangles;  // by paint
    for (const uint32_t paint : mesh.paint_of_triangle) ++triangles[paint];
    if (triangles.empty()) return;
    tinygltf::Primitive shared;
    shared.mode = TINYGLTF_MODE_TRIANGLES;
    shared.attributes["POSITION"] = putVectors(mesh.mesh.positions, scale_, true);
    shared.attributes["NORMAL"] = putVectors(mesh.normals, 1, false);
    tinygltf::Node node;
    node.name = mesh.name;
    if (!mesh.skin.empty()) {
      shared.attributes["JOINTS_0"] = putJoints(mesh.skin);
      shared.attributes["WEIGHTS_0"] = putWeights(mesh.skin);
      node.skin = skin();
    }
    tinygltf::Mesh added;
    added.name = mesh.name;
    for (const auto& [paint, count] : triangles) {
      tinygltf::Primitive primitive = shared;
      primitive.material = static_cast<int>(paint);
      primitive.indices = putTriangles(mesh, paint, count);
      added.primitives.push_back(std::move(primitive));
    }
    node.mesh = static_cast<int>(model_.meshes.size());
    model_.meshes.push_back(std::move(added));
    model_.scenes[0].nodes.push_back(addNode(std::move(node)));
  }

  // ---- Poses

  int addChannel(tinygltf::Animation& animation, int input, int output, size_t joint,
                 const char* path) {
    tinygltf::AnimationSampler sampler;
    sampler.input = input;
    sampler.output = output;
    animation.samplers.push_back(std::move(sampler));
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
    channel.target_node = nodeOf(joint);
    channel.target_path = path;
    animation.channels.push_back(std::move(channel));
    return channel.sampler;
  }

  void addAnimation(const std::string& name, const Pose& pose) {
    if (rig_.joints.empty()) return;
    const std::vector<Rigid> there = places(pose);
    tinygltf::Animation animation;
    animation.name = name;
    beginView(0);
    put(0.0);
    const int time = endAccessor(TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, 1);
    model_.accessors.back().minValues = model_.accessors.back().maxValues = {0};
    for (size_t i = 0; i < there.size(); ++i) {
      const Rigid local = withinParent(there, i), rest = withinParent(rest_, i);
      beginView(0);
      for (const double number : numbers(local.rotation)) put(number);
      addChannel(animation, time, endAccessor(TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT, 1),
                 i, "rotation");
      if (local.move == rest.move) continue;
      beginView(0);
      for (const double number : numbers(local.move)) put(number);
      addChannel(animation, time, endAccessor(TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, 1),
                 i, "translation");
    }
    model_.animations.push_back(std::move(animation));
  }

  // ---- The drawing it was made from

  void addDocument() {
    if (character_.document.empty()) return;
    const int view = beginView(0);
    bytes().insert(bytes().end(), character_.document.begin(), character_.document.end());
    model_.bufferViews.back().byteLength = character_.document.size();
    using tinygltf::Value;
    model_.asset.extras =
        Value(Value::Object{{"marrow", Value(Value::Object{{"version", Value(kDocumentVersion)},
                                                           {"document", Value(view)}})}});
  }

  const GlbCharacter& character_;
  const Rig& rig_;
  double scale_;
  tinygltf::Model model_;
  std::vector<Quaternion> axes_;  // of the joints, at rest
  std::vector<Rigid> rest_;       // of the joints, in metres
  int skeleton_ = -1;             // the node above all joints, which follow it
  bool finite_ = true;
};

}  // namespace

GlbCharacter glbOf(const Character& made, const Rig& rig, const Document& document,
                   const std::string& name) {
  GlbCharacter character{name, rig, made.meshes, made.paints, {}, writeDocument(document)};
  for (const auto& pose : document.poses) character.poses.push_back({pose->name, pose->joints});
  return character;
}

namespace {

Result<std::string> written(const GlbCharacter& character, const GlbOptions& options, bool binary) {
  constexpr size_t kMostJoints = 0x10000;  // their indices have 16 bits
  if (character.rig.joints.size() > kMostJoints) return Status::tooMany;
  return Writer(character, options).write(binary);
}

}  // namespace

Result<std::string> toGlb(const GlbCharacter& character, const GlbOptions& options) {
  return written(character, options, /*binary=*/true);
}

Result<std::string> toGltf(const GlbCharacter& character, const GlbOptions& options) {
  return written(character, options, /*binary=*/false);
}

}  // namespace marrow
