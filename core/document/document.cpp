#include "document/document.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marrow {
namespace {

constexpr char kIdPrefix[] = "part-";
constexpr size_t kPrefixLength = sizeof kIdPrefix - 1;
constexpr size_t kMostDigits = 15;  // of kLargestPartNumber

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Color> parseColor(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::array<uint8_t, 3> channels;
  for (size_t i = 0; i < 3; ++i) {
    const int high = hexDigit(text[1 + 2 * i]), low = hexDigit(text[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    channels[i] = static_cast<uint8_t>(16 * high + low);
  }
  return Color{channels[0], channels[1], channels[2]};
}

std::string toString(Color color) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (uint8_t channel : {color.r, color.g, color.b}) {
    text += kDigits[channel / 16];
    text += kDigits[channel % 16];
  }
  return text;
}

Color partColor(size_t index) {
  static constexpr Color kColors[] = {
      {0x8c, 0xcb, 0xf0},  // sky blue
      {0xef, 0xbe, 0x5a},  // orange
      {0x5f, 0xc3, 0xa6},  // bluish green
      {0xdf, 0xa6, 0xc6},  // reddish purple
      {0xf4, 0xeb, 0x85},  // yellow
      {0xe3, 0x92, 0x5c},  // vermilion
      {0x6a, 0xa6, 0xd6},  // blue
  };
  return kColors[index % (sizeof kColors / sizeof kColors[0])];
}

bool isDrawable(Vec2 point) {
  return std::fabs(point.x) <= kLargestCoordinate && std::fabs(point.y) <= kLargestCoordinate;
}

bool isDrawable(Vec3 point) {
  return isDrawable(Vec2{point.x, point.y}) && isDrawable(Vec2{point.z, 0});
}

std::string faultIn(const Mesh& mesh) {
  if (mesh.triangles.empty()) return "has no triangles";
  if (mesh.triangles.size() > PartSource::kMostTriangles) return "has more than 100,000 triangles";
  std::vector<char> used(mesh.positions.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (corner >= used.size()) return "has a corner that is no vertex";
      used[corner] = 1;
    }
  }
  if (std::find(used.begin(), used.end(), 0) != used.end()) return "has a vertex without triangles";
  for (const Vec3 p : mesh.positions) {
    for (const double number : {p.x, p.y, p.z}) {
      if (!isDrawable(Vec2{number, 0}) || static_cast<float>(number) != number) {
        return "has a coordinate out of range";
      }
    }
  }
  const MeshReport report = inspect(mesh);
  if (!report.closed) return "has a hole";
  if (!report.manifold) return "is no surface of a solid";
  if (!(report.volume > 0)) return "encloses nothing";
  return {};
}

Mesh inSinglePrecision(Mesh mesh) {
  // By way of memory: there and back in one expression, GCC 12 leaves some numbers as they are
  // (its -ftree-slp-vectorize).
  std::vector<std::array<float, 3>> numbers;
  numbers.reserve(mesh.positions.size());
  for (const Vec3 p : mesh.positions) {
    numbers.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  for (size_t i = 0; i < numbers.size(); ++i) {
    mesh.positions[i] = {numbers[i][0], numbers[i][1], numbers[i][2]};
  }
  return mesh;
}

std::optional<size_t> Document::find(const std::string& id) const {
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i]->id == id) return i;
  }
  return std::nullopt;
}

const NamedPose* Document::findPose(const std::string& name) const {
  for (const auto& pose : poses) {
    if (pose->name == name) return pose.get();
  }
  return nullptr;
}

std::optional<JointMotion> withUnitRotation(const JointMotion& motion) {
  const double squared = dot(motion.rotation, motion.rotation);
  if (!isDrawable(motion.move) || !(squared > 0) || !std::isfinite(squared)) return std::nullopt;
  constexpr double kRounding = 1e-14;
  if (std::fabs(squared - 1) <= kRounding) return motion;
  const JointMotion unit{normalised(motion.rotation), motion.move};
  const bool is_unit = std::fabs(dot(unit.rotation, unit.rotation) - 1) <= kRounding;
  return is_unit ? std::optional<JointMotion>(unit) : std::nullopt;
}

uint64_t partNumber(const std::string& id) {
  if (id.compare(0, kPrefixLength, kIdPrefix) != 0) return 0;
  if (id.size() == kPrefixLength || id.size() > kPrefixLength + kMostDigits) return 0;
  if (id[kPrefixLength] == '0') return 0;
  uint64_t number = 0;
  for (size_t i = kPrefixLength; i < id.size(); ++i) {
    if (id[i] < '0' || id[i] > '9') return 0;
    number = 10 * number + static_cast<uint64_t>(id[i] - '0');
  }
  return number;
}

uint64_t takePartNumber(Document& document) {
  do {
    document.last_part = document.last_part < kLargestPartNumber ? document.last_part + 1 : 1;
  } while (document.find(partId(document.last_part)));
  return document.last_part;
}

std::string partId(uint64_t number) { return kIdPrefix + std::to_string(number); }

std::string defaultPartName(uint64_t number) { return "Part " + std::to_string(number); }

std::string freshPoseName(const Document& document) {
  for (size_t number = document.poses.size() + 1;; ++number) {
    std::string name = "Pose " + std::to_string(number);
    if (!document.findPose(name)) return name;
  }
}

}  // namespace marrow
