// GLB, read by our own parser of JSON: tinygltf ends the program where a field is of another type
// than it expects, reads what nobody here needs, and would be a second parser with limits of its
// own.
#include <algorithm>
#include <cmath>

#include "base/frame.h"
#include "base/quaternion.h"
#include "io/json.h"
#include "io/mesh_readers.h"

namespace marrow {
namespace {

constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;
constexpr size_t kMostNodes = 100'000;

enum Component { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };
enum Mode { kTriangles = 4, kStrip, kFan };

Error unreadable(const char* sentence) { return {Status::unreadable, sentence}; }
Error broken() { return unreadable("It is a broken GLB file."); }

/// A place in the file.
struct Bytes {
  size_t at = 0, size = 0;
};

struct Glb {
  Json tree;
  Bytes binary;
};

Result<Glb> openGlb(const std::string& bytes) {
  if (bytes.size() < kHeader || bytes.compare(0, 4, "glTF") != 0) {
    return unreadable("It is no GLB file.");
  }
  size_t at = 4;
  if (take<uint32_t>(bytes, at) != 2)
    return unreadable("It is a GLB file of another version than 2.");
  at = kHeader;
  Glb glb;
  bool has_json = false;
  while (bytes.size() - at >= kChunkHeader) {
    const size_t size = take<uint32_t>(bytes, at);
    const auto kind = take<uint32_t>(bytes, at);
    if (size > bytes.size() - at) return broken();
    if (kind == kJsonChunk && !has_json) {
      auto tree = parseJson(bytes.substr(at, size));
      if (!tree || !tree->is_object()) return broken();
      glb.tree = std::move(*tree);
      has_json = true;
    } else if (kind == kBinaryChunk && glb.binary.size == 0) {
      glb.binary = {at, size};
    }
    at += size;
  }
  if (!has_json) return broken();
  return glb;
}

/// The inner value, where there is one.
const Json* inner(const Json* value, const char* key) {
  return value && value->is_object() ? field(*value, key) : nullptr;
}
const Json* item(const Json* list, std::optional<size_t> index) {
  return list && list->is_array() && index && *index < list->size() ? &(*list)[*index] : nullptr;
}
std::optional<size_t> whole(const Json* value) {
  constexpr double kLargest = 9007199254740992;  // 2^53
  if (!value || !value->is_number()) return std::nullopt;
  const double number = value->get<double>();
  if (!(number >= 0 && number < kLargest) || number != std::floor(number)) return std::nullopt;
  return static_cast<size_t>(number);
}
std::optional<size_t> wholeOr(const Json* value, size_t missing) {
  return value ? whole(value) : missing;
}
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

/// The bytes that a buffer view means; only what is in the file.
std::optional<Bytes> viewIn(const Glb& glb, std::optional<size_t> index) {
  const Json* view = item(inner(&glb.tree, "bufferViews"), index);
  const Json* buffer = item(inner(&glb.tree, "buffers"), 0);
  const auto offset = view ? wholeOr(inner(view, "byteOffset"), 0) : std::nullopt;
  const auto size = whole(inner(view, "byteLength"));
  if (whole(inner(view, "buffer")) != size_t{0} || inner(buffer, "uri")) return std::nullopt;
  if (!offset || !size || *offset > glb.binary.size || *size > glb.binary.size - *offset) {
    return std::nullopt;
  }
  return Bytes{glb.binary.at + *offset, *size};
}

/// What an accessor tells of its values.
struct Values {
  size_t at = 0, count = 0, stride = 0;
  int component = 0;
  bool normalised = false;
};

class Reader {
 public:
  Reader(const std::string& bytes, const Glb& glb) : bytes_(bytes), glb_(glb) {}

  Result<Mesh> run() {
    if (const Json* required = inner(&glb_.tree, "extensionsRequired")) {
      for (const Json& one : *required) {
        if (one == "KHR_draco_mesh_compression" || one == "EXT_meshopt_compression") {
          return unreadable("Its mesh is compressed, so export it again without compression.");
        }
      }
    }
    if (!placeNodes()) return broken();
    const Json* nodes = inner(&glb_.tree, "nodes");
    for (const size_t node : order_) {
      const Json& one = (*nodes)[node];
      if (!inner(&one, "mesh")) continue;
      const Json* mesh = item(inner(&glb_.tree, "meshes"), whole(inner(&one, "mesh")));
      const Json* primitives = inner(mesh, "primitives");
      if (!primitives || !primitives->is_array()) return broken();
      const Affine place = inner(&one, "skin") ? bindPlace(one) : places_[node];
      for (const Json& primitive : *primitives) {
        if (auto error = addPrimitive(primitive, place)) return *error;
      }
    }
    return std::move(mesh_);
  }

 private:
  static Affine composed(const Affine& outer, const Affine& own) {
    return {outer.direction(own.x), outer.direction(own.y), outer.direction(own.z),
            outer(own.move)};
  }
  static Affine fromMatrix(const std::vector<double>& m) {
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
  }

  static Affine localPlace(const Json& node) {
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

  /// Finds the scene's nodes, each after its parent, and where they are; false where they are no
  /// trees.
  bool placeNodes() {
    const Json* nodes = inner(&glb_.tree, "nodes");
    if (!nodes) return true;
    if (!nodes->is_array() || nodes->size() > kMostNodes) return false;
    places_.resize(nodes->size());
    std::vector<char> seen(nodes->size(), 0);
    const auto add = [&](const Json& index, const Affine& parent) {
      const auto node = whole(&index);
      if (!node || *node >= nodes->size() || seen[*node]) return false;
      seen[*node] = 1;
      places_[*node] = composed(parent, localPlace((*nodes)[*node]));
      order_.push_back(*node);
      return true;
    };
    const auto addAll = [&](const Json* list, const Affine& parent) {
      if (!list) return true;
      if (!list->is_array()) return false;
      return std::all_of(list->begin(), list->end(),
                         [&](const Json& index) { return add(index, parent); });
    };
    const Json* scene = item(inner(&glb_.tree, "scenes"), wholeOr(inner(&glb_.tree, "scene"), 0));
    if (!addAll(inner(scene, "nodes"), {})) return false;
    for (size_t i = 0; i < order_.size(); ++i) {
      const size_t node = order_[i];
      if (!addAll(inner(&(*nodes)[node], "children"), Affine(places_[node]))) return false;
    }
    return true;
  }

  /// Where a skin puts its mesh at rest. All its joints agree there, so one says it.
  Affine bindPlace(const Json& node) {
    const Json* skin = item(inner(&glb_.tree, "skins"), whole(inner(&node, "skin")));
    const Json* first = item(inner(skin, "joints"), 0);
    const auto joint = whole(first);
    const Affine place = joint && *joint < places_.size() ? places_[*joint] : Affine{};
    const Json* inverse = inner(skin, "inverseBindMatrices");
    const auto values = inverse ? valuesOf(whole(inverse), "MAT4", 16) : std::nullopt;
    if (!values || values->component != kFloat || values->count == 0) return place;
    std::vector<double> matrix;
    for (size_t k = 0; k < 16; ++k) matrix.push_back(valueAt(*values, 0, k));
    return composed(place, fromMatrix(matrix));
  }

  static size_t sizeOf(int component) {
    switch (component) {
      case kByte:
      case kUnsignedByte:
        return 1;
      case kShort:
      case kUnsignedShort:
        return 2;
      case kUnsignedInt:
      case kFloat:
        return 4;
      default:
        return 0;
    }
  }

  /// Nothing where the accessor is of another type, or leaves its bytes.
  std::optional<Values> valuesOf(std::optional<size_t> index, const char* type, size_t width) {
    const Json* accessor = item(inner(&glb_.tree, "accessors"), index);
    if (!accessor || inner(accessor, "sparse")) return std::nullopt;
    const Json* own_type = inner(accessor, "type");
    if (!own_type || *own_type != type) return std::nullopt;
    const auto view_index = whole(inner(accessor, "bufferView"));
    const auto view = viewIn(glb_, view_index);
    const auto count = whole(inner(accessor, "count"));
    const auto component = whole(inner(accessor, "componentType"));
    const auto offset = wholeOr(inner(accessor, "byteOffset"), 0);
    if (!view || !count || !component || *component > kFloat || !offset) return std::nullopt;
    Values values;
    values.component = static_cast<int>(*component);
    const size_t size = width * sizeOf(values.component);
    if (size == 0) return std::nullopt;
    const Json* stride = inner(item(inner(&glb_.tree, "bufferViews"), view_index), "byteStride");
    const auto step = wholeOr(stride, size);
    if (!step || *step < size || *step > 255) return std::nullopt;
    values.stride = *step;
    values.count = *count;
    const Json* normalised_flag = inner(accessor, "normalized");
    values.normalised =
        normalised_flag && normalised_flag->is_boolean() && normalised_flag->get<bool>();
    if (*offset > view->size) return std::nullopt;
    const size_t room = view->size - *offset;
    if (values.count > 0 && (room < size || values.count - 1 > (room - size) / values.stride)) {
      return std::nullopt;
    }
    values.at = view->at + *offset;
    return values;
  }

  double valueAt(const Values& values, size_t index, size_t part) const {
    size_t at = values.at + index * values.stride + part * sizeOf(values.component);
    const auto scaled = [&](double value, double largest) {
      return values.normalised ? std::max(value / largest, -1.0) : value;
    };
    switch (values.component) {
      case kByte:
        return scaled(take<int8_t>(bytes_, at), 127);
      case kUnsignedByte:
        return scaled(take<uint8_t>(bytes_, at), 255);
      case kShort:
        return scaled(take<int16_t>(bytes_, at), 32767);
      case kUnsignedShort:
        return scaled(take<uint16_t>(bytes_, at), 65535);
      case kUnsignedInt:
        return take<uint32_t>(bytes_, at);
      default:
        return take<float>(bytes_, at);
    }
  }

  std::optional<Error> addPrimitive(const Json& primitive, const Affine& place) {
    const auto mode = wholeOr(inner(&primitive, "mode"), kTriangles);
    if (!primitive.is_object() || !mode) return broken();
    if (*mode < kTriangles || *mode > kFan) return std::nullopt;  // points and lines
    const Json* position = inner(inner(&primitive, "attributes"), "POSITION");
    const auto points = valuesOf(whole(position), "VEC3", 3);
    if (!points)
      return unreadable("It holds a mesh whose vertices are not in the file as numbers.");
    if (points->count > kMostReadVertices - mesh_.positions.size()) return tooManyVertices();
    std::optional<Values> indices;
    if (const Json* own = inner(&primitive, "indices")) {
      indices = valuesOf(whole(own), "SCALAR", 1);
      if (!indices || indices->component == kFloat) return broken();
    }
    const size_t corners = indices ? indices->count : points->count;
    if (corners > 3 * kMostReadTriangles) return tooManyTriangles();
    const size_t count = *mode == kTriangles ? corners / 3 : std::max<size_t>(corners, 2) - 2;
    if (count > kMostReadTriangles - mesh_.triangles.size()) return tooManyTriangles();

    const auto first = static_cast<uint32_t>(mesh_.positions.size());
    for (size_t i = 0; i < points->count; ++i) {
      const Vec3 p{valueAt(*points, i, 0), valueAt(*points, i, 1), valueAt(*points, i, 2)};
      mesh_.positions.push_back(place(p));
    }
    std::vector<uint32_t> names;
    for (size_t i = 0; i < corners; ++i) {
      const double name = indices ? valueAt(*indices, i, 0) : static_cast<double>(i);
      if (!(name >= 0 && name < static_cast<double>(points->count))) return broken();
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

  const std::string& bytes_;
  const Glb& glb_;
  std::vector<Affine> places_;  // of nodes
  std::vector<size_t> order_;   // nodes of the scene, each after its parent
  Mesh mesh_;
};

}  // namespace

Result<Mesh> readGlb(const std::string& bytes) {
  const auto glb = openGlb(bytes);
  if (!glb) return glb.error();
  return Reader(bytes, *glb).run();
}

std::optional<std::string> documentInGlb(const std::string& bytes) {
  const auto glb = openGlb(bytes);
  if (!glb) return std::nullopt;
  const Json* marrow = inner(inner(inner(&glb->tree, "asset"), "extras"), "marrow");
  const auto view = viewIn(*glb, whole(inner(marrow, "document")));
  if (!view) return std::nullopt;
  return bytes.substr(view->at, view->size);
}

}  // namespace marrow
