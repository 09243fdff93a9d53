#include "io/json.h"

#include <cmath>

#include "document/document.h"

namespace marrow {

Json toJson(double value) {
  constexpr double kWhole = 9007199254740992;  // 2^53
  const bool whole = value > -kWhole && value < kWhole && value == std::floor(value);
  if (whole && !(value == 0 && std::signbit(value))) return static_cast<int64_t>(value);
  return value;
}

Json toJson(Vec2 point) { return Json::array({toJson(point.x), toJson(point.y)}); }
Json toJson(Vec3 v) { return Json::array({toJson(v.x), toJson(v.y), toJson(v.z)}); }

Json toJson(const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (Vec2 point : points) list.push_back(toJson(point));
  return list;
}

std::string toText(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const Json* field(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

Result<std::vector<Vec2>> readPoints(const Json& value, const std::string& where) {
  if (!value.is_array()) return {Status::unreadable, where + " is not a list of points."};
  std::vector<Vec2> points;
  points.reserve(value.size());
  for (const Json& pair : value) {
    const auto here = [&] { return where + "[" + std::to_string(points.size()) + "]"; };
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number()) {
      return {Status::unreadable, here() + " is not a pair of numbers."};
    }
    const Vec2 point{pair[0].get<double>(), pair[1].get<double>()};
    if (!isDrawable(point)) return {Status::unreadable, here() + " is too far away."};
    points.push_back(point);
  }
  return points;
}

}  // namespace marrow
