#include <algorithm>
#include <cmath>

#include "io/mesh_readers.h"

namespace marrow {
namespace {

enum class Type : uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr struct {
  const char *name, *other_name;
  Type type;
  size_t size;
} kTypes[] = {{"char", "int8", Type::int8, 1},        {"uchar", "uint8", Type::uint8, 1},
              {"short", "int16", Type::int16, 2},     {"ushort", "uint16", Type::uint16, 2},
              {"int", "int32", Type::int32, 4},       {"uint", "uint32", Type::uint32, 4},
              {"float", "float32", Type::float32, 4}, {"double", "float64", Type::float64, 8}};

constexpr size_t kMostProperties = 100;    // of an element
constexpr size_t kMostElements = 20;       // kinds of them
constexpr size_t kMostCount = 0xFFFFFFFF;  // of one kind

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> list;  // of its count
};

struct Element {
  std::string name;
  size_t count = 0;
  std::vector<Property> properties;
};

Error unreadable(const char* sentence) { return {Status::unreadable, sentence}; }

std::optional<Type> typeOf(std::string_view name) {
  for (const auto& type : kTypes) {
    if (name == type.name || name == type.other_name) return type.type;
  }
  return std::nullopt;
}

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes), words_(bytes, Lines::plain) {}

  Result<Mesh> run() {
    if (auto error = readHeader()) return *error;
    for (const Element& element : elements_) {
      if (auto error = readElement(element)) return *error;
    }
    const auto count = static_cast<double>(mesh_.positions.size());
    for (const auto& face : faces_) {
      corners_.clear();
      for (size_t i = face.first; i < face.first + face.second; ++i) {
        if (!(indices_[i] >= 0 && indices_[i] < count)) {
          return unreadable("It holds a face with a corner that is no vertex.");
        }
        corners_.push_back(static_cast<uint32_t>(indices_[i]));
      }
      addFace(mesh_, corners_);
    }
    return std::move(mesh_);
  }

 private:
  std::optional<Error> readHeader() {
    if (!words_.nextLine() || words_.word() != "ply") return unreadable("It is no PLY file.");
    bool has_format = false;
    while (words_.nextLine()) {
      const std::string_view kind = words_.word();
      if (kind == "format") {
        const std::string_view format = words_.word();
        has_format = true;
        binary_ = format == "binary_little_endian";
        if (!binary_ && format != "ascii") {
          return unreadable("It is neither ASCII nor little-endian binary.");
        }
      } else if (kind == "element") {
        Element element;
        element.name = words_.word();
        const auto count = toWhole(words_.word());
        if (!count || *count < 0 || *count > static_cast<int64_t>(kMostCount) ||
            elements_.size() == kMostElements) {
          return unreadable("Its header is broken.");
        }
        element.count = static_cast<size_t>(*count);
        elements_.push_back(std::move(element));
      } else if (kind == "property") {
        if (auto error = readProperty()) return error;
      } else if (kind == "end_header") {
        at_ = words_.lineEnd();
        if (!has_format) break;
        return std::nullopt;
      }
    }
    return unreadable("Its header is broken.");
  }

  std::optional<Error> readProperty() {
    Property property;
    std::string_view word = words_.word();
    if (word == "list") {
      property.list = typeOf(words_.word());
      if (!property.list || *property.list >= Type::float32) {
        return unreadable("Its header is broken.");
      }
      word = words_.word();
    }
    const auto type = typeOf(word);
    property.name = words_.word();
    if (!type || property.name.empty() || elements_.empty() ||
        elements_.back().properties.size() == kMostProperties) {
      return unreadable("Its header is broken.");
    }
    property.type = *type;
    elements_.back().properties.push_back(std::move(property));
    return std::nullopt;
  }

  std::optional<Error> readElement(const Element& element) {
    // Without properties an element takes no bytes, and says nothing.
    if (element.properties.empty()) return std::nullopt;
    const bool vertices = element.name == "vertex", faces = element.name == "face";
    if (vertices && element.count > kMostReadVertices - mesh_.positions.size()) {
      return tooManyVertices();
    }
    if (faces && element.count > kMostReadTriangles) return tooManyTriangles();
    for (size_t i = 0; i < element.count; ++i) {
      Vec3 p;
      for (const Property& property : element.properties) {
        size_t length = 1;
        if (property.list) {
          const auto count = number(*property.list);
          if (!count || !(*count >= 0)) return cutShort();
          if (!(*count <= static_cast<double>(bytes_.size()))) return cutShort();
          length = static_cast<size_t>(*count);
        }
        const bool corners = faces && property.list &&
                             (property.name == "vertex_indices" || property.name == "vertex_index");
        if (corners) {
          corner_count_ += length;
          if (corner_count_ > 3 * kMostReadTriangles) return tooManyTriangles();
          if (length >= 3) faces_.push_back({indices_.size(), length});
        }
        for (size_t k = 0; k < length; ++k) {
          const auto value = number(property.type);
          if (!value) return cutShort();
          if (corners) indices_.push_back(*value);
          if (!vertices || property.list) continue;
          if (property.name == "x") p.x = *value;
          if (property.name == "y") p.y = *value;
          if (property.name == "z") p.z = *value;
        }
      }
      if (vertices) mesh_.positions.push_back(p);
    }
    return std::nullopt;
  }

  static Error cutShort() { return unreadable("It ends too early, or holds what is no number."); }

  /// The next number of the body.
  std::optional<double> number(Type type) {
    if (!binary_) return toNumber(words_.anyWord());
    const size_t size = kTypes[static_cast<size_t>(type)].size;
    if (bytes_.size() - at_ < size) return std::nullopt;
    switch (type) {
      case Type::int8:
        return take<int8_t>(bytes_, at_);
      case Type::uint8:
        return take<uint8_t>(bytes_, at_);
      case Type::int16:
        return take<int16_t>(bytes_, at_);
      case Type::uint16:
        return take<uint16_t>(bytes_, at_);
      case Type::int32:
        return take<int32_t>(bytes_, at_);
      case Type::uint32:
        return take<uint32_t>(bytes_, at_);
      case Type::float32:
        return take<float>(bytes_, at_);
      case Type::float64:
        break;
    }
    return take<double>(bytes_, at_);
  }

  const std::string& bytes_;
  Words words_;
  size_t at_ = 0;  // of the next byte of a binary body
  bool binary_ = false;
  std::vector<Element> elements_;
  Mesh mesh_;
  std::vector<double> indices_;                   // of all faces
  std::vector<std::pair<size_t, size_t>> faces_;  // first of the indices, and how many
  size_t corner_count_ = 0;
  std::vector<uint32_t> corners_;
};

}  // namespace

Result<Mesh> readPly(const std::string& bytes) { return Reader(bytes).run(); }

}  // namespace marrow
