// Read by our own parser of JSON: tinygltf ends the program where a field is of another type than
// it expects, reads what nobody here needs, and would be a second parser with limits of its own.
#include "io/glb_file.h"

#include <algorithm>
#include <cmath>

#include "io/mesh_readers.h"

namespace marrow {
namespace {

constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

size_t sizeOf(int component) {
  switch (component) {
    case GlbFile::kByte:
    case GlbFile::kUnsignedByte:
      return 1;
    case GlbFile::kShort:
    case GlbFile::kUnsignedShort:
      return 2;
    case GlbFile::kUnsignedInt:
    case GlbFile::kFloat:
      return 4;
    default:
      return 0;
  }
}

}  // namespace

Error brokenGlb() { return {Status::unreadable, "It is a broken GLB file."}; }

const Json* inner(const Json* value, const char* key) {
  return value && value->is_object() ? field(*value, key) : nullptr;
}

const Json* item(const Json* list, std::optional<size_t> index) {
  return list && list->is_array() && index && *index < list->size() ? &(*list)[*index] : nullptr;
}

std::optional<size_t> whole(const Json* value) {
  constexpr double kLargest = 0xFFFFFFFE;  // what a size in WebAssembly holds
  if (!value || !value->is_number()) return std::nullopt;
  const double number = value->get<double>();
  if (!(number >= 0 && number <= kLargest) || number != std::floor(number)) return std::nullopt;
  return static_cast<size_t>(number);
}

std::optional<size_t> wholeOr(const Json* value, size_t missing) {
  return value ? whole(value) : missing;
}

Result<GlbFile> GlbFile::open(const std::string& bytes) {
  if (bytes.size() < kHeader || bytes.compare(0, 4, "glTF") != 0) {
    return {Status::unreadable, "It is no GLB file."};
  }
  size_t at = 4;
  if (take<uint32_t>(bytes, at) != 2) {
    return {Status::unreadable, "It is a GLB file of another version than 2."};
  }
  at = kHeader;
  GlbFile file(bytes);
  bool has_json = false;
  while (bytes.size() - at >= kChunkHeader) {
    const size_t size = take<uint32_t>(bytes, at);
    const auto kind = take<uint32_t>(bytes, at);
    if (size > bytes.size() - at) return brokenGlb();
    if (kind == kJsonChunk && !has_json) {
      auto tree = parseJson(bytes.substr(at, size));
      if (!tree || !tree->is_object()) return brokenGlb();
      file.tree_ = std::move(*tree);
      has_json = true;
    } else if (kind == kBinaryChunk && file.binary_.size == 0) {
      file.binary_ = {at, size};
    }
    at += size;
  }
  if (!has_json) return brokenGlb();
  return file;
}

std::optional<GlbFile::Bytes> GlbFile::view(std::optional<size_t> index) const {
  const Json* view = item(list("bufferViews"), index);
  const Json* buffer = item(list("buffers"), 0);
  const auto offset = view ? wholeOr(inner(view, "byteOffset"), 0) : std::nullopt;
  const auto size = whole(inner(view, "byteLength"));
  if (whole(inner(view, "buffer")) != size_t{0} || inner(buffer, "uri")) return std::nullopt;
  if (!offset || !size || *offset > binary_.size || *size > binary_.size - *offset) {
    return std::nullopt;
  }
  return Bytes{binary_.at + *offset, *size};
}

std::optional<GlbFile::Values> GlbFile::values(std::optional<size_t> index, const char* type,
                                               size_t width) const {
  const Json* accessor = item(list("accessors"), index);
  if (!accessor || inner(accessor, "sparse")) return std::nullopt;
  const Json* own_type = inner(accessor, "type");
  if (!own_type || *own_type != type) return std::nullopt;
  const auto view_index = whole(inner(accessor, "bufferView"));
  const auto place = view(view_index);
  const auto count = whole(inner(accessor, "count"));
  const auto component = whole(inner(accessor, "componentType"));
  const auto offset = wholeOr(inner(accessor, "byteOffset"), 0);
  if (!place || !count || !component || *component > kFloat || !offset) return std::nullopt;
  Values values;
  values.component = static_cast<int>(*component);
  const size_t size = width * sizeOf(values.component);
  if (size == 0) return std::nullopt;
  const auto step = wholeOr(inner(item(list("bufferViews"), view_index), "byteStride"), size);
  if (!step || *step < size || *step > 255) return std::nullopt;
  values.stride = *step;
  values.count = *count;
  const Json* normalised = inner(accessor, "normalized");
  values.normalised = normalised && normalised->is_boolean() && normalised->get<bool>();
  if (*offset > place->size) return std::nullopt;
  const size_t room = place->size - *offset;
  if (values.count > 0 && (room < size || values.count - 1 > (room - size) / values.stride)) {
    return std::nullopt;
  }
  values.at = place->at + *offset;
  return values;
}

double GlbFile::number(const Values& values, size_t index, size_t part) const {
  size_t at = values.at + index * values.stride + part * sizeOf(values.component);
  const auto scaled = [&](double value, double largest) {
    return values.normalised ? std::max(value / largest, -1.0) : value;
  };
  switch (values.component) {
    case kByte:
      return scaled(take<int8_t>(*bytes_, at), 127);
    case kUnsignedByte:
      return scaled(take<uint8_t>(*bytes_, at), 255);
    case kShort:
      return scaled(take<int16_t>(*bytes_, at), 32767);
    case kUnsignedShort:
      return scaled(take<uint16_t>(*bytes_, at), 65535);
    case kUnsignedInt:
      return take<uint32_t>(*bytes_, at);
    default:
      return take<float>(*bytes_, at);
  }
}

}  // namespace marrow
