#include <algorithm>

#include "base/frame.h"
#include "base/quaternion.h"
#include "io/glb_file.h"
#include "io/mesh_readers.h"

namespace marrow {
namespace {

constexpr size_t kMostNodes = 100'000;
constexpr size_t kMostPieces = 100'000;  // primitives, as often as nodes show them
constexpr size_t kMostJoints = 100'000;  // of all skins
constexpr size_t kMostSets = 4;          // of four joints that move a vertex

enum Mode { kTriangles = 4, kStrip, kFan };

Error unreadable(const char* sentence) { return {Status::unreadable, sentence}; }

/// The numbers of a list of that length; else none.
std::vector<double> numbers(const Json* list, size_t count) {
  std::vector<double> found;
  if (!list || !list->is_array() || list->size() != count) return found;
  for (const Json& one : *list) {
    if (!one.is_number()) return {};
    found.push_back(one.get<double>());
  }
  return found;
}

Affine composed(const Affine& outer, const Affine& own) {
  return {outer.direction(own.x), outer.direction(own.y), outer.direction(own.z), outer(own.move)};
}

Affine fromMatrix(const std::vector<double>& m) {
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

Affine localPlace(const Json& node) {
  const auto matrix = numbers(inner(&node, "matrix"), 16);
  if (!matrix.empty()) return fromMatrix(matrix);
  const auto move = numbers(inner(&node, "translation"), 3);
  const auto turn = numbers(inner(&node, "rotation"), 4);
  const auto scale = numbers(inner(&node, "scale"), 3);
  const Quaternion q =
      turn.empty() ? Quaternion{} : normalised(Quaternion{turn[0], turn[1], turn[2], turn[3]});
  Affine place;
  const std::vector<double> s = scale.empty() ? std::vector<double>{1, 1, 1} : scale;
  place.x = rotated(q, {s[0], 0, 0});
  place.y = rotated(q, {0, s[1], 0});
  place.z = rotated(q, {0, 0, s[2]});
  if (!move.empty()) place.move = {move[0], move[1], move[2]};
  return place;
}

class Reader {
 public:
  explicit Reader(const GlbFile& file) : file_(file), nodes_(file.list("nodes")) {}

  Result<Mesh> run() {
    if (const Json* required = file_.list("extensionsRequired")) {
      for (const Json& one : *required) {
        if (one == "KHR_draco_mesh_compression" || one == "EXT_meshopt_compression") {
          return unreadable("Its mesh is compressed, so export it again without compression.");
        }
      }
    }
    if (!placeNodes()) return brokenGlb();
    if (const Json* skins = file_.list("skins")) skins_.resize(skins->size());
    for (const size_t node : order_) {
      const Json& one = (*nodes_)[node];
      if (!inner(&one, "mesh")) continue;
      const Json* mesh = item(file_.list("meshes"), whole(inner(&one, "mesh")));
      const Json* primitives = inner(mesh, "primitives");
      if (!primitives || !primitives->is_array()) return brokenGlb();
      const std::vector<Affine>* motions = nullptr;
      if (const Json* skin = inner(&one, "skin")) {
        motions = motionsOf(whole(skin));
        if (!motions) return brokenGlb();
      }
      for (const Json& primitive : *primitives) {
        if (++pieces_ > kMostPieces) {
          return {Status::tooMany, "It holds more than 100,000 pieces."};
        }
        if (auto error = addPrimitive(primitive, places_[node], motions)) return *error;
      }
    }
    return std::move(mesh_);
  }

 private:
  /// Finds the scene's nodes, each after its parent, and where they are; false where they are no
  /// trees. Without scenes it is all nodes.
  bool placeNodes() {
    if (!nodes_) return true;
    if (!nodes_->is_array() || nodes_->size() > kMostNodes) return false;
    places_.resize(nodes_->size());
    std::vector<char> seen(nodes_->size(), 0);
    const auto add = [&](std::optional<size_t> node, const Affine& parent) {
      if (!node || *node >= nodes_->size() || seen[*node]) return false;
      seen[*node] = 1;
      places_[*node] = composed(parent, localPlace((*nodes_)[*node]));
      order_.push_back(*node);
      return true;
    };
    const auto addAll = [&](const Json* list, const Affine& parent) {
      if (!list) return true;
      if (!list->is_array()) return false;
      return std::all_of(list->begin(), list->end(),
                         [&](const Json& index) { return add(whole(&index), parent); });
    };
    if (const Json* scenes = file_.list("scenes")) {
      const Json* scene = item(scenes, wholeOr(file_.list("scene"), 0));
      if (!addAll(inner(scene, "nodes"), {})) return false;
    } else {
      const std::vector<char> is_child = children();
      for (size_t node = 0; node < is_child.size(); ++node) {
        if (!is_child[node]) add(node, {});
      }
    }
    for (size_t i = 0; i < order_.size(); ++i) {
      const size_t node = order_[i];
      if (!addAll(inner(&(*nodes_)[node], "children"), Affine(places_[node]))) return false;
    }
    return true;
  }

  /// For each node whether it is another's child.
  std::vector<char> children() const {
    std::vector<char> is_child(nodes_->size(), 0);
    for (const Json& node : *nodes_) {
      const Json* list = inner(&node, "children");
      if (!list || !list->is_array()) continue;
      for (const Json& index : *list) {
        const auto child = whole(&index);
        if (child && *child < is_child.size()) is_child[*child] = 1;
      }
    }
    return is_child;
  }

  /// What each joint of a skin does to a vertex at rest: not the same for all of them, in files
  /// whose rest is not the pose in which the skin was bound. Null where the skin is broken.
  const std::vector<Affine>* motionsOf(std::optional<size_t> index) {
    const Json* joints = inner(item(file_.list("skins"), index), "joints");
    if (!joints || !joints->is_array() || joints->empty()) return nullptr;
    std::vector<Affine>& motions = skins_[*index];
    if (!motions.empty()) return &motions;
    joints_ += joints->size();
    if (joints_ > kMostJoints) return nullptr;
    const Json* inverse = inner(item(file_.list("skins"), index), "inverseBindMatrices");
    const auto binds = inverse ? file_.values(whole(inverse), "MAT4", 16) : std::nullopt;
    if (inverse && (!binds || binds->component != GlbFile::kFloat)) return nullptr;
    for (size_t i = 0; i < joints->size(); ++i) {
      const auto joint = whole(&(*joints)[i]);
      if (!joint || *joint >= places_.size() || (binds && i >= binds->count)) return nullptr;
      Affine bind;
      if (binds) {
        std::vector<double> matrix;
        for (size_t k = 0; k < 16; ++k) matrix.push_back(file_.number(*binds, i, k));
        bind = fromMatrix(matrix);
      }
      motions.push_back(composed(places_[*joint], bind));
    }
    return &motions;
  }

  /// What a vertex is weighted by, in one set of four.
  struct Influences {
    GlbFile::Values joints, weights;
  };

  /// Nothing where they are broken; none where the primitive has none.
  std::optional<std::vector<Influences>> influencesOf(const Json* attributes, size_t points) {
    std::vector<Influences> found;
    for (size_t set = 0; set < kMostSets; ++set) {
      const std::string number = std::to_string(set);
      const Json* joints = inner(attributes, ("JOINTS_" + number).c_str());
      const Json* weights = inner(attributes, ("WEIGHTS_" + number).c_str());
      if (!joints || !weights) break;
      const auto names = file_.values(whole(joints), "VEC4", 4);
      const auto shares = file_.values(whole(weights), "VEC4", 4);
      if (!names || !shares || names->count != points || shares->count != points) {
        return std::nullopt;
      }
      found.push_back({*names, *shares});
    }
    return found;
  }

  /// A vertex at rest, moved by its joints in linear blending; as the first joint has it where it
  /// has no weights. Nothing where it names a joint that is none.
  std::optional<Vec3> atRest(Vec3 p, size_t vertex, const std::vector<Influences>& influences,
                             const std::vector<Affine>& motions) const {
    Vec3 sum;
    double all = 0;
    for (const auto& [joints, weights] : influences) {
      for (size_t k = 0; k < 4; ++k) {
        const double weight = file_.number(weights, vertex, k);
        if (!(weight > 0)) continue;
        const double joint = file_.number(joints, vertex, k);
        if (!(joint >= 0 && joint < static_cast<double>(motions.size()))) return std::nullopt;
        sum = sum + motions[static_cast<size_t>(joint)](p) * weight;
        all += weight;
      }
    }
    return all > 0 ? sum / all : motions.front()(p);
  }

  /// motions: of the skin's joints; null without a skin.
  std::optional<Error> addPrimitive(const Json& primitive, const Affine& place,
                                    const std::vector<Affine>* motions) {
    const auto mode = wholeOr(inner(&primitive, "mode"), kTriangles);
    if (!primitive.is_object() || !mode) return brokenGlb();
    if (*mode < kTriangles || *mode > kFan) return std::nullopt;  // points and lines
    const Json* attributes = inner(&primitive, "attributes");
    const auto points = file_.values(whole(inner(attributes, "POSITION")), "VEC3", 3);
    if (!points)
      return unreadable("It holds a mesh whose vertices are not in the file as numbers.");
    if (points->count > kMostReadVertices - mesh_.positions.size()) return tooManyVertices();
    std::optional<GlbFile::Values> indices;
    if (const Json* own = inner(&primitive, "indices")) {
      indices = file_.values(whole(own), "SCALAR", 1);
      if (!indices || indices->component == GlbFile::kFloat) return brokenGlb();
    }
    const size_t corners = indices ? indices->count : points->count;
    if (corners > 3 * kMostReadTriangles) return tooManyTriangles();
    const size_t count = *mode == kTriangles ? corners / 3 : std::max<size_t>(corners, 2) - 2;
    if (count > kMostReadTriangles - mesh_.triangles.size()) return tooManyTriangles();

    const auto first = static_cast<uint32_t>(mesh_.positions.size());
    const auto influences = influencesOf(motions ? attributes : nullptr, points->count);
    if (!influences) return brokenGlb();
    for (size_t i = 0; i < points->count; ++i) {
      const Vec3 p{file_.number(*points, i, 0), file_.number(*points, i, 1),
                   file_.number(*points, i, 2)};
      const auto placed = motions ? atRest(p, i, *influences, *motions) : place(p);
      if (!placed) return brokenGlb();
      mesh_.positions.push_back(*placed);
    }
    std::vector<uint32_t> names;
    for (size_t i = 0; i < corners; ++i) {
      const double name = indices ? file_.number(*indices, i, 0) : static_cast<double>(i);
      if (!(name >= 0 && name < static_cast<double>(points->count))) return brokenGlb();
      names.push_back(first + static_cast<uint32_t>(name));
    }
    for (size_t t = 0; t < count; ++t) {
      if (*mode == kTriangles) {
        mesh_.triangles.push_back({names[3 * t], names[3 * t + 1], names[3 * t + 2]});
      } else if (*mode == kFan) {
        mesh_.triangles.push_back({names[0], names[t + 1], names[t + 2]});
      } else {
        mesh_.triangles.push_back({names[t], names[t + 1 + t % 2], names[t + 2 - t % 2]});
      }
    }
    return std::nullopt;
  }

  const GlbFile& file_;
  const Json* nodes_;
  std::vector<Affine> places_;              // of nodes
  std::vector<size_t> order_;               // nodes of the scene, each after its parent
  std::vector<std::vector<Affine>> skins_;  // what their joints do; empty until asked for
  size_t joints_ = 0;                       // of those skins
  size_t pieces_ = 0;                       // primitives seen
  Mesh mesh_;
};

}  // namespace

Result<Mesh> readGlb(const std::string& bytes) {
  const auto file = GlbFile::open(bytes);
  if (!file) return file.error();
  return Reader(*file).run();
}

std::optional<std::string> documentInGlb(const std::string& bytes) {
  const auto file = GlbFile::open(bytes);
  if (!file) return std::nullopt;
  const Json* marrow = inner(inner(file->list("asset"), "extras"), "marrow");
  const auto view = file->view(whole(inner(marrow, "document")));
  if (!view) return std::nullopt;
  std::string text = bytes.substr(view->at, view->size);
  // A program that wrote the file again may have put its own bytes there.
  if (text.empty() || text[0] != '{') return std::nullopt;
  const auto tree = parseJson(text);
  const Json* format = tree ? inner(&*tree, "format") : nullptr;
  if (!format || *format != "marrow") return std::nullopt;
  return text;
}

}  // namespace marrow
