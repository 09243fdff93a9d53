#include "figure/figure.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace marrow {
namespace {

class Writer {
 public:
  template <typename T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const std::string& text) {
    put(static_cast<uint32_t>(text.size()));
    bytes_ += text;
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    put(static_cast<uint32_t>(values.size()));
    if constexpr (std::is_trivially_copyable_v<T>) {
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  void put(const Figure::Joint& joint) {
    put(joint.id);
    put(joint.parent);
  }
  void put(const Figure::Stretch& stretch) {
    put(stretch.part);
    put(stretch.first);
    put(stretch.count);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  void get(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (const char* from = take(sizeof value)) std::memcpy(&value, from, sizeof value);
  }
  void get(std::string& text) {
    uint32_t size = 0;
    get(size);
    if (const char* from = take(size)) text.assign(from, size);
  }
  template <typename T>
  void get(std::vector<T>& values) {
    uint32_t count = 0;
    get(count);
    if constexpr (std::is_trivially_copyable_v<T>) {
      const char* from = take(uint64_t{count} * sizeof(T));
      if (!from) return;
      values.resize(count);
      if (count > 0) std::memcpy(values.data(), from, count * sizeof(T));
    } else {
      for (uint32_t i = 0; i < count && fine_; ++i) get(values.emplace_back());
    }
  }
  void get(Figure::Joint& joint) {
    get(joint.id);
    get(joint.parent);
  }
  void get(Figure::Stretch& stretch) {
    get(stretch.part);
    get(stretch.first);
    get(stretch.count);
  }
  bool atEnd() const { return fine_ && at_ == bytes_.size(); }

 private:
  const char* take(uint64_t count) {
    fine_ &= count <= bytes_.size() - at_;
    if (!fine_) return nullptr;
    at_ += static_cast<size_t>(count);
    return bytes_.data() + at_ - static_cast<size_t>(count);
  }

  const std::string& bytes_;
  size_t at_ = 0;
  bool fine_ = true;
};

std::array<float, 3> toFloats(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Vec3 toVec(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Result<Figure> figureOf(const Character& character, const Evaluation& evaluation) {
  if (character.meshes.size() != 1) {
    const auto left_out = leftOutOf(character);
    return {Status::meshFailed, left_out.empty() ? "There is no figure." : left_out.front()};
  }
  const Rig& rig = evaluation.rig();
  if (rig.joints.size() > std::numeric_limits<uint16_t>::max()) {
    return {Status::tooMany, "The skeleton has too many joints to be posed."};
  }
  const SkinnedMesh& mesh = character.meshes.front();
  Figure figure;
  figure.origin = mesh.mesh.positions.empty() ? Vec3{} : mesh.mesh.positions.front();
  figure.vertices.resize(mesh.mesh.positions.size());
  const std::vector<Vec3> hull = vertexNormals(character.merged.mesh);
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    Figure::Vertex& vertex = figure.vertices[i];
    vertex = {toFloats(mesh.mesh.positions[i] - figure.origin),
              toFloats(mesh.normals[i]),
              {},
              {},
              toFloats(hull[mesh.merged_vertex[i]])};
    if (mesh.skin.empty()) continue;
    for (size_t k = 0; k < VertexSkin::kMost; ++k) {
      vertex.weights[k] = static_cast<float>(mesh.skin[i].weights[k]);
      vertex.joints[k] = static_cast<uint16_t>(mesh.skin[i].joints[k]);
    }
  }
  for (const Paint& paint : character.paints) figure.stretches.push_back({paint.part, 0, 0});
  for (const uint32_t paint : mesh.paint_of_triangle) ++figure.stretches[paint].count;
  uint32_t first = 0;
  for (Figure::Stretch& stretch : figure.stretches) {
    stretch.first = std::exchange(first, first + stretch.count);
  }
  std::vector<uint32_t> next;
  for (const Figure::Stretch& stretch : figure.stretches) next.push_back(stretch.first);
  figure.triangles.resize(mesh.mesh.triangles.size());
  for (size_t t = 0; t < figure.triangles.size(); ++t) {
    figure.triangles[next[mesh.paint_of_triangle[t]]++] = mesh.mesh.triangles[t];
  }
  for (const Rig::Joint& joint : rig.joints) figure.joints.push_back({joint.id, joint.parent});
  figure.left_out = leftOutOf(character);
  return figure;
}

namespace {

/// Calls `visit` with every field, in the order in which they travel.
template <typename AnyFigure, typename Visit>
void visitFields(AnyFigure& figure, const Visit& visit) {
  visit(figure.origin);
  visit(figure.vertices);
  visit(figure.triangles);
  visit(figure.stretches);
  visit(figure.joints);
  visit(figure.left_out);
  visit(figure.guessed);
  visit(figure.made_ms);
}

}  // namespace

std::string toBytes(const Figure& figure) {
  Writer writer;
  visitFields(figure, [&](const auto& field) { writer.put(field); });
  return writer.take();
}

Result<Figure> figureFromBytes(const std::string& bytes) {
  Figure figure;
  Reader reader(bytes);
  visitFields(figure, [&](auto& field) { reader.get(field); });
  if (!reader.atEnd()) return {Status::unreadable, "The figure did not arrive whole."};
  return figure;
}

Figure outermost(const Figure& figure) {
  constexpr size_t kDirections = 26;
  std::array<Vec3, kDirections> directions;
  size_t next = 0;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x != 0 || y != 0 || z != 0) directions[next++] = {x, y, z};
      }
    }
  }
  constexpr uint32_t kNone = UINT32_MAX;
  const size_t groups = figure.joints.size() + 1;  // the last: of what follows none
  std::vector<std::array<uint32_t, kDirections>> farthest(groups);
  for (auto& group : farthest) group.fill(kNone);
  for (uint32_t i = 0; i < figure.vertices.size(); ++i) {
    const Figure::Vertex& vertex = figure.vertices[i];
    const bool follows = vertex.weights[0] > 0 && vertex.joints[0] < figure.joints.size();
    auto& group = farthest[follows ? vertex.joints[0] : groups - 1];
    for (size_t d = 0; d < kDirections; ++d) {
      const auto reach = [&](uint32_t v) {
        return dot(directions[d], toVec(figure.vertices[v].position));
      };
      if (group[d] == kNone || reach(i) > reach(group[d])) group[d] = i;
    }
  }
  std::set<uint32_t> chosen;
  for (const auto& group : farthest) chosen.insert(group.begin(), group.end());
  chosen.erase(kNone);
  Figure few;
  few.origin = figure.origin;
  few.joints = figure.joints;
  for (const uint32_t v : chosen) few.vertices.push_back(figure.vertices[v]);
  return few;
}

std::vector<Rigid> motionsOf(const Figure& figure, const Rig& rig,
                             const std::vector<Rigid>& posed) {
  std::unordered_map<std::string, size_t> joint_of_id;
  for (size_t i = 0; i < rig.joints.size(); ++i) joint_of_id.emplace(rig.joints[i].id, i);
  std::vector<Rigid> motions(figure.joints.size());
  for (size_t i = 0; i < figure.joints.size(); ++i) {
    const auto found = joint_of_id.find(figure.joints[i].id);
    if (found != joint_of_id.end()) {
      motions[i] = posed[found->second];
    } else if (figure.joints[i].parent >= 0) {
      motions[i] = motions[static_cast<size_t>(figure.joints[i].parent)];
    }
  }
  return motions;
}

SkinnedVertices posedVertices(const Figure& figure, const std::vector<Rigid>& motions,
                              Skinning how) {
  std::vector<Vec3> positions, normals;
  std::vector<VertexSkin> skins(figure.vertices.size());
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    const Figure::Vertex& vertex = figure.vertices[i];
    positions.push_back(figure.origin + toVec(vertex.position));
    normals.push_back(toVec(vertex.normal));
    for (size_t k = 0; k < VertexSkin::kMost; ++k) {
      skins[i].joints[k] = vertex.joints[k];
      skins[i].weights[k] = vertex.weights[k];
    }
  }
  if (motions.empty()) return {std::move(positions), std::move(normals)};
  SkinnedVertices result;
  skin(positions, normals, skins, motions, how, result);
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    if (figure.vertices[i].weights[0] > 0) continue;  // the largest comes first
    result.positions[i] = positions[i];
    result.normals[i] = normals[i];
  }
  return result;
}

}  // namespace marrow
