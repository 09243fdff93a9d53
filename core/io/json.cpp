#include "io/json.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "document/document.h"

namespace marrow {
namespace {

/// Walks through a text without keeping anything of it; stops at the first fault.
class Checker : public nlohmann::json_sax<Json> {
 public:
  explicit Checker(const std::string& text) : text_(text) {}

  const std::string& fault() const { return fault_; }

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(size_t) override { return open(); }
  bool end_array() override { return close(); }
  bool key(string_t&) override {
    return ++fields_.back() <= kMostFields || fail("An object in it has too many fields.");
  }
  bool parse_error(size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;
    return fail((error.id == kNumberOverflow ? "It holds a number that is too large"
                                             : "It is not valid JSON") +
                place(position) + ".");
  }

 private:
  bool value() { return ++values_ <= kMostValues || fail("It holds too many values."); }
  bool open() {
    fields_.push_back(0);
    return fields_.size() <= kDeepestNesting ? value() : fail("It is nested too deeply.");
  }
  bool close() {
    fields_.pop_back();
    return true;
  }
  bool fail(std::string sentence) {
    fault_ = std::move(sentence);
    return false;
  }
  std::string place(size_t position) const {
    size_t line = 1, column = 1;
    for (size_t i = 0; i + 1 < position && i < text_.size(); ++i) {
      ++column;
      if (text_[i] == '\n') {
        ++line;
        column = 1;
      }
    }
    return " (line " + std::to_string(line) + ", column " + std::to_string(column) + ")";
  }

  const std::string& text_;
  std::string fault_;
  std::vector<size_t> fields_;  // per open list or object
  size_t values_ = 0;
};

}  // namespace

Result<Json> parseJson(const std::string& text) {
  if (text.empty()) return {Status::unreadable, "It is empty."};
  if (text.size() > kLargestText) return {Status::unreadable, "It is larger than 64 MB."};
  Checker checker(text);
  if (!Json::sax_parse(text, &checker)) return {Status::unreadable, checker.fault()};
  Json tree = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (tree.is_discarded()) return {Status::unreadable, "It is not valid JSON."};
  return tree;
}

Json toJson(double value) {
  constexpr double kWhole = 9007199254740992;  // 2^53
  const bool whole = value > -kWhole && value < kWhole && value == std::floor(value);
  if (whole && !(value == 0 && std::signbit(value))) return static_cast<int64_t>(value);
  return value;
}

Json toJson(Vec2 point) { return Json::array({toJson(point.x), toJson(point.y)}); }

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
