#include "tools/transform_tool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace marrow {
namespace {

constexpr double kDegree_rad = 3.14159265358979323846 / 180;
// An axis that points so much at the viewer cannot be followed on the screen.
constexpr double kShortAxis = 0.12;
constexpr double kRadiansPerPixel = 0.01;
constexpr double kSmallestFactor = 0.01, kLargestFactor = 100;

/// Cosine and sine, exact for whole quarters.
std::pair<double, double> turn(double degrees) {
  const double quarters = degrees / 90;
  if (quarters == std::floor(quarters) && std::abs(quarters) < 1e6) {
    static constexpr double kCosines[] = {1, 0, -1, 0}, kSines[] = {0, 1, 0, -1};
    const long k = ((std::lround(quarters) % 4) + 4) % 4;
    return {kCosines[k], kSines[k]};
  }
  return {std::cos(degrees * kDegree_rad), std::sin(degrees * kDegree_rad)};
}

Vec3 turned(Vec3 v, Vec3 axis, double c, double s) {
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

const char* letter(TransformAxis axis) {
  return axis == TransformAxis::x   ? " X"
         : axis == TransformAxis::y ? " Y"
         : axis == TransformAxis::z ? " Z"
                                    : "";
}

}  // namespace

Vec3 axisDirection(TransformAxis axis, const Camera& camera) {
  switch (axis) {
    case TransformAxis::x:
      return {1, 0, 0};
    case TransformAxis::y:
      return {0, 1, 0};
    case TransformAxis::z:
      return {0, 0, 1};
    case TransformAxis::none:
      break;
  }
  return camera.axes()[2];
}

void TransformTool::begin(TransformKind kind, TransformAxis axis, std::vector<std::string> ids,
                          Vec3 pivot, Vec2 pointer_px, const Camera& camera, ViewSize size,
                          bool by_key) {
  kind_ = kind;
  axis_ = axis;
  ids_ = std::move(ids);
  pivot_ = pivot;
  camera_ = camera;
  pivot_px_ = camera.toScreen(pivot, size);
  start_px_ = now_px_ = pointer_px;
  by_key_ = by_key;
  active_ = true;
  changed_ = false;
  turned_rad_ = 0;
  typed_.clear();
}

void TransformTool::move(Vec2 pointer_px) {
  const Vec2 before = now_px_ - pivot_px_, after = pointer_px - pivot_px_;
  if (length(before) > 1 && length(after) > 1) {
    turned_rad_ -= std::atan2(cross(before, after), dot(before, after));  // pixels point down
  }
  changed_ |= pointer_px != now_px_;
  now_px_ = pointer_px;
}

bool TransformTool::key(char character) {
  const auto toggled = [&](TransformAxis axis) {
    axis_ = axis_ == axis ? TransformAxis::none : axis;
    return true;
  };
  switch (character) {
    case 'x':
    case 'X':
      return toggled(TransformAxis::x);
    case 'y':
    case 'Y':
      return toggled(TransformAxis::y);
    case 'z':
    case 'Z':
      return toggled(TransformAxis::z);
    case '-':
      typed_ = !typed_.empty() && typed_[0] == '-' ? typed_.substr(1) : "-" + typed_;
      break;
    case '\b':
      if (!typed_.empty()) typed_.pop_back();
      break;
    case '.':
      if (typed_.find('.') == std::string::npos) typed_ += '.';
      break;
    default:
      if (character < '0' || character > '9') return false;
      if (typed_.size() < 12) typed_ += character;
  }
  changed_ = true;
  return true;
}

double TransformTool::amount() const {
  if (std::any_of(typed_.begin(), typed_.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return std::strtod(typed_.c_str(), nullptr);
  }
  const auto [right, up, back] = camera_.axes();
  const Vec3 axis = axisDirection(axis_, camera_);
  const Vec2 drag{now_px_.x - start_px_.x, start_px_.y - now_px_.y};
  const Vec2 on_screen{dot(right, axis), dot(up, axis)};
  switch (kind_) {
    case TransformKind::move: {
      const double squared = dot(on_screen, on_screen);
      // Towards the viewer: pulling down brings it nearer.
      if (squared < kShortAxis * kShortAxis) return -drag.y / camera_.zoom;
      return dot(drag, on_screen) / squared / camera_.zoom;
    }
    case TransformKind::rotate: {
      const double towards = dot(back, axis);
      if (std::abs(towards) > 0.3) return turned_rad_ / kDegree_rad * (towards > 0 ? 1 : -1);
      const Vec2 across = perpendicular(on_screen) / length(on_screen);
      return -dot(drag, across) * kRadiansPerPixel / kDegree_rad;
    }
    case TransformKind::scale:
      break;
  }
  const double from = std::max(distance(start_px_, pivot_px_), 10.0);
  return std::clamp(distance(now_px_, pivot_px_) / from, kSmallestFactor, kLargestFactor);
}

Affine TransformTool::map() const {
  Affine map;
  if (!changed_) return map;
  const double by = amount();
  const Vec3 axis = axisDirection(axis_, camera_);
  switch (kind_) {
    case TransformKind::move: {
      const auto [right, up, back] = camera_.axes();
      if (axis_ != TransformAxis::none) {
        map.move = axis * by;
      } else if (!typed_.empty()) {
        map.move = right * by;
      } else {
        map.move = right * ((now_px_.x - start_px_.x) / camera_.zoom) +
                   up * ((start_px_.y - now_px_.y) / camera_.zoom);
      }
      return map;
    }
    case TransformKind::rotate: {
      const auto [c, s] = turn(by);
      map.x = turned(map.x, axis, c, s);
      map.y = turned(map.y, axis, c, s);
      map.z = turned(map.z, axis, c, s);
      break;
    }
    case TransformKind::scale: {
      const bool all = axis_ == TransformAxis::none;
      const double factor = std::abs(by) < kSmallestFactor ? kSmallestFactor : by;
      const auto scaled = [&](Vec3 v) {
        return all ? v * factor : v + axis * (dot(axis, v) * (factor - 1));
      };
      map.x = scaled(map.x);
      map.y = scaled(map.y);
      map.z = scaled(map.z);
      break;
    }
  }
  map.move = pivot_ - map.direction(pivot_);
  return map;
}

TransformParts TransformTool::command() const {
  static constexpr const char* kVerbs[] = {"Move", "Turn", "Scale"};
  return {ids_, map(), kVerbs[static_cast<size_t>(kind_)]};
}

std::string TransformTool::label() const {
  static constexpr const char* kVerbs[] = {"Move", "Turn", "Scale"};
  static constexpr const char* kUnits[] = {"", "\xC2\xB0", "\xC3\x97"};
  const auto k = static_cast<size_t>(kind_);
  std::string text = std::string(kVerbs[k]) + letter(axis_);
  if (kind_ == TransformKind::move && axis_ == TransformAxis::none && typed_.empty()) return text;
  char number[32];
  std::snprintf(number, sizeof number, kind_ == TransformKind::scale ? ": %.2f" : ": %.1f",
                changed_ ? amount() : (kind_ == TransformKind::scale ? 1.0 : 0.0));
  return text + (typed_.empty() ? number : ": " + typed_) + kUnits[k];
}

}  // namespace marrow
