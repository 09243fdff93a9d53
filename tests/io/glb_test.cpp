#include "io/glb.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

#include "io/tiny_gltf.h"
#include "pose/rigs.h"
#include "support/catch.h"

namespace marrow {
namespace {

/// A rig with a few triangles about each joint.
struct Model {
  Rig rig;
  SkinnedMesh mesh;
};

Model model(Random& random, int joints) {
  Model made{randomRig(random, joints), {}};
  made.mesh.name = "Body";
  for (uint32_t joint = 0; joint < made.rig.joints.size(); ++joint) {
    const auto first = static_cast<uint32_t>(made.mesh.mesh.positions.size());
    for (int i = 0; i < 3; ++i) {
      made.mesh.mesh.positions.push_back(made.rig.joints[joint].position +
                                         randomRotation(random).x * 5);
      made.mesh.normals.push_back(randomRotation(random).y);
      VertexSkin own;
      const double weight = random.between(0.5, 1);
      const int32_t parent = made.rig.joints[joint].parent;
      own.joints = {joint, parent < 0 ? 0 : static_cast<uint32_t>(parent), 0, 0};
      own.weights = {weight, 1 - weight, 0, 0};
      if (parent < 0) {
        own.joints[1] = 0;
        own.weights = {1, 0, 0, 0};
      }
      made.mesh.skin.push_back(own);
    }
    made.mesh.mesh.triangles.push_back({first, first + 1, first + 2});
    made.mesh.paint_of_triangle.push_back(joint % 2);
  }
  return made;
}

GlbCharacter characterOf(const Model& model) {
  const std::vector<Paint> paints{{"Red", {200, 30, 30}, "part-1"},
                                  {"Sky", {30, 120, 200}, "part-2"}};
  return {"Creature", model.rig, {model.mesh}, paints, {}, {}};
}

tinygltf::Model read(const std::string& bytes) {
  tinygltf::Model model;
  std::string error, warning;
  const bool fine = tinygltf::TinyGLTF().LoadBinaryFromMemory(
      &model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
      static_cast<unsigned int>(bytes.size()));
  CAPTURE(error, warning);
  REQUIRE(fine);
  CHECK(error.empty());
  CHECK(warning.empty());
  return model;
}

tinygltf::Model written(const GlbCharacter& character, const GlbOptions& options = {}) {
  const auto glb = toGlb(character, options);
  REQUIRE(glb);
  return read(*glb);
}

template <typename T>
std::vector<T> values(const tinygltf::Model& model, int accessor, size_t per_item) {
  const tinygltf::Accessor& of = model.accessors[static_cast<size_t>(accessor)];
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(of.bufferView)];
  std::vector<T> result(of.count * per_item);
  REQUIRE(view.byteLength == result.size() * sizeof(T));
  std::memcpy(result.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
  return result;
}

Rigid localOf(const tinygltf::Node& node) {
  const auto& q = node.rotation;
  const auto& t = node.translation;
  return {q.empty() ? Quaternion{} : Quaternion{q[0], q[1], q[2], q[3]},
          t.empty() ? Vec3{} : Vec3{t[0], t[1], t[2]}};
}

/// Where each node lies in space.
std::vector<Rigid> globals(const tinygltf::Model& model) {
  std::vector<Rigid> all(model.nodes.size());
  std::vector<int> todo = model.scenes[0].nodes;
  for (const int root : todo) {
    all[static_cast<size_t>(root)] = localOf(model.nodes[static_cast<size_t>(root)]);
  }
  while (!todo.empty()) {
    const auto node = static_cast<size_t>(todo.back());
    todo.pop_back();
    for (const int child : model.nodes[node].children) {
      const auto c = static_cast<size_t>(child);
      all[c] = all[node] * localOf(model.nodes[c]);
      todo.push_back(child);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("glb: the joints are nodes of their names, each below its parent, where they are",
          "[glb]") {
  Random random(1);
  for (int run = 0; run < 20; ++run) {
    const Model made = model(random, 1 + random.below(60));
    const tinygltf::Model gltf = written(characterOf(made), {0.5});
    REQUIRE(gltf.skins.size() == 1);
    const tinygltf::Skin& skin = gltf.skins[0];
    REQUIRE(skin.joints.size() == made.rig.joints.size());
    const std::vector<Rigid> places = globals(gltf);
    std::map<int, int> parents;
    for (size_t node = 0; node < gltf.nodes.size(); ++node) {
      for (const int child : gltf.nodes[node].children) parents[child] = static_cast<int>(node);
    }
    for (size_t i = 0; i < skin.joints.size(); ++i) {
      const Rig::Joint& joint = made.rig.joints[i];
      const auto node = static_cast<size_t>(skin.joints[i]);
      CHECK(gltf.nodes[node].name == joint.name);
      CHECK(distance(places[node].move, joint.position * 0.5) < 1e-6);
      const int parent =
          joint.parent < 0 ? skin.skeleton : skin.joints[static_cast<size_t>(joint.parent)];
      CHECK(parents[skin.joints[i]] == parent);
    }
  }
}

TEST_CASE("glb: inverse bind matrices take every joint's place back to the origin", "[glb]") {
  Random random(2);
  const Model made = model(random, 40);
  const tinygltf::Model gltf = written(characterOf(made));
  const tinygltf::Skin& skin = gltf.skins[0];
  const std::vector<float> matrices = values<float>(gltf, skin.inverseBindMatrices, 16);
  const std::vector<Rigid> places = globals(gltf);
  for (size_t i = 0; i < skin.joints.size(); ++i) {
    const float* m = &matrices[16 * i];
    const Rigid& place = places[static_cast<size_t>(skin.joints[i])];
    const auto mapped = [&](Vec3 p) {
      return Vec3{m[0] * p.x + m[4] * p.y + m[8] * p.z + m[12],
                  m[1] * p.x + m[5] * p.y + m[9] * p.z + m[13],
                  m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14]};
    };
    for (const Vec3 p : {Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      CHECK(distance(mapped(place(p)), p) < 1e-5);
    }
    CHECK((m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1));
  }
}

TEST_CASE("glb: weights are single numbers that sum up to one, unused joints are 0", "[glb]") {
  Random random(3);
  Model made = model(random, 30);
  for (VertexSkin& own : made.mesh.skin) {
    double rest = 1;
    for (size_t k = 3; k > 0; --k) {
      own.joints[k] = static_cast<uint32_t>((own.joints[0] + k) % 30);
      own.weights[k] = k == 3 ? 1e-60 : rest * random.between(0, 0.3);
      rest -= own.weights[k];
    }
    own.weights[0] = rest;
  }
  const tinygltf::Model gltf = written(characterOf(made));
  const auto& attributes = gltf.meshes[0].primitives[0].attributes;
  const std::vector<float> weights = values<float>(gltf, attributes.at("WEIGHTS_0"), 4);
  const std::vector<uint16_t> joints = values<uint16_t>(gltf, attributes.at("JOINTS_0"), 4);
  for (size_t i = 0; i < made.mesh.skin.size(); ++i) {
    float sum = 0;
    for (size_t k = 0; k < 4; ++k) {
      sum += weights[4 * i + k];
      CHECK(weights[4 * i + k] >= 0);
      CHECK(std::abs(weights[4 * i + k] - made.mesh.skin[i].weights[k]) < 1e-6);
      CHECK(joints[4 * i + k] == (weights[4 * i + k] > 0 ? made.mesh.skin[i].joints[k] : 0));
    }
    CHECK(std::abs(sum - 1) <= 2e-7f);
  }
}

TEST_CASE("glb: each paint has its triangles, all of one set of vertices", "[glb]") {
  Random random(4);
  for (const int joints : {5, 25000}) {  // indices of two bytes, and of four
    const Model made = model(random, joints);
    const tinygltf::Model gltf = written(characterOf(made));
    REQUIRE(gltf.meshes.size() == 1);
    REQUIRE(gltf.meshes[0].primitives.size() == 2);
    REQUIRE(gltf.materials.size() == 2);
    CHECK(gltf.materials[1].name == "Sky");
    size_t triangles = 0;
    for (const tinygltf::Primitive& primitive : gltf.meshes[0].primitives) {
      CHECK(primitive.attributes == gltf.meshes[0].primitives[0].attributes);
      std::vector<uint32_t> corners;
      const bool few = made.mesh.mesh.positions.size() < 0xffff;
      if (few) {
        const auto read_there = values<uint16_t>(gltf, primitive.indices, 1);
        corners.assign(read_there.begin(), read_there.end());
      } else {
        corners = values<uint32_t>(gltf, primitive.indices, 1);
      }
      size_t next = 0;
      for (size_t t = 0; t < made.mesh.mesh.triangles.size(); ++t) {
        if (static_cast<int>(made.mesh.paint_of_triangle[t]) != primitive.material) continue;
        bool same = true;
        for (const uint32_t corner : made.mesh.mesh.triangles[t]) {
          same = same && next < corners.size() && corners[next] == corner;
          ++next;
        }
        if (!same) FAIL("triangle " << t);
        ++triangles;
      }
      CHECK(next == corners.size());
    }
    CHECK(triangles == made.mesh.mesh.triangles.size());
  }
}

TEST_CASE("glb: a pose is an animation of one key that puts the joints where the pose has them",
          "[glb]") {
  Random random(5);
  const Model made = model(random, 30);
  GlbCharacter character = characterOf(made);
  const Pose pose = randomPose(random, made.rig);
  character.poses = {{"Rest", {}}, {"Wave", pose}};
  const GlbOptions options;
  tinygltf::Model gltf = written(character, options);
  REQUIRE(gltf.animations.size() == 2);
  CHECK(gltf.animations[1].name == "Wave");
  const std::vector<Rigid> rest = globals(gltf), motions = posed(made.rig, pose);
  for (const tinygltf::Animation& animation : gltf.animations) {
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      const tinygltf::AnimationSampler& sampler =
          animation.samplers[static_cast<size_t>(channel.sampler)];
      CHECK(values<float>(gltf, sampler.input, 1) == std::vector<float>{0});
      const bool turns = channel.target_path == "rotation";
      const std::vector<float> key = values<float>(gltf, sampler.output, turns ? 4 : 3);
      tinygltf::Node& node = gltf.nodes[static_cast<size_t>(channel.target_node)];
      (turns ? node.rotation : node.translation).assign(key.begin(), key.end());
    }
    const std::vector<Rigid> places = globals(gltf);
    for (size_t i = 0; i < made.rig.joints.size(); ++i) {
      const auto node = static_cast<size_t>(gltf.skins[0].joints[i]);
      const Vec3 at_rest = made.rig.joints[i].position;
      const Vec3 wanted = animation.name == "Rest" ? at_rest : motions[i](at_rest);
      CHECK(distance(places[node].move, wanted * options.metres_per_unit) < 1e-5);
      const Quaternion turned = animation.name == "Rest"
                                    ? rest[node].rotation
                                    : motions[i].rotation * rest[node].rotation;
      CHECK(std::abs(std::abs(dot(turned, places[node].rotation)) - 1) < 1e-5);
    }
  }
}

TEST_CASE("glb: the document lies in it byte for byte", "[glb]") {
  Random random(6);
  const Model made = model(random, 3);
  GlbCharacter character = characterOf(made);
  character.document = "{\"format\": \"marrow\", \"name\": \"\xC3\xA9\"}";
  const tinygltf::Model gltf = written(character);
  const auto& marrow = gltf.asset.extras.Get("marrow");
  const auto& view = gltf.bufferViews[static_cast<size_t>(marrow.Get("document").GetNumberAsInt())];
  const auto* begin = gltf.buffers[0].data.data() + view.byteOffset;
  CHECK(std::string(begin, begin + view.byteLength) == character.document);
}

TEST_CASE("glb: as a text it is the same model, its bytes in base64", "[glb]") {
  Random random(9);
  const Model made = model(random, 12);
  GlbCharacter character = characterOf(made);
  character.document = "{}";
  const GlbOptions options{0.25};
  const auto text = toGltf(character, options);
  REQUIRE(text);
  REQUIRE((*text)[0] == '{');
  tinygltf::Model gltf;
  std::string error, warning;
  REQUIRE(tinygltf::TinyGLTF().LoadASCIIFromString(&gltf, &error, &warning, text->data(),
                                                   static_cast<unsigned int>(text->size()), ""));
  CHECK(error + warning == "");
  const tinygltf::Model glb = written(character, options);
  CHECK(gltf.buffers[0].data == glb.buffers[0].data);
  CHECK(gltf.nodes == glb.nodes);
  CHECK(gltf.accessors == glb.accessors);
  CHECK(gltf.asset == glb.asset);
}

TEST_CASE("glb: without skin, without joints, without anything there is still a file", "[glb]") {
  Random random(7);
  Model made = model(random, 4);
  made.mesh.skin.clear();
  const tinygltf::Model bare = written(characterOf(made));
  CHECK(bare.skins.empty());
  CHECK(bare.meshes[0].primitives[0].attributes.count("JOINTS_0") == 0);
  Model empty{{}, {}};
  GlbCharacter nothing = characterOf(empty);
  nothing.poses = {{"Rest", {}}};
  const tinygltf::Model gltf = written(nothing);
  CHECK(gltf.meshes.empty());
  CHECK(gltf.animations.empty());
}

TEST_CASE("glb: numbers that single precision cannot hold are refused", "[glb]") {
  Random random(8);
  for (const double bad :
       {1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Model made = model(random, 4);
    made.mesh.mesh.positions[2].y = bad;
    CHECK(toGlb(characterOf(made)).status() == Status::meshFailed);
    Model far = model(random, 4);
    far.rig.joints[1].position.x = bad;
    CHECK(toGlb(characterOf(far)).status() == Status::meshFailed);
  }
}

}  // namespace marrow
