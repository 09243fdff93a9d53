#include "io/object_reader.h"

#include <algorithm>
#include <utility>

#include "document/document.h"
#include "document/placement.h"

namespace marrow {

// So that with the fields that we write no object has too many.
constexpr size_t kMostUnknown = kMostFields - 50;

ObjectReader::ObjectReader(const Json& object, std::string where, Fault& fault)
    : object_(object), where_(std::move(where)), fault_(fault) {}

std::string ObjectReader::where(const std::string& key) const {
  return where_.empty() ? key : where_ + "." + key;
}

void ObjectReader::say(const std::string& key, const std::string& fault) {
  fault_.say(where(key) + " " + fault);
}

const Json* ObjectReader::value(const std::string& key) {
  asked_.push_back(key);
  return field(object_, key.c_str());
}

std::string ObjectReader::text(const std::string& key) {
  const Json* found = value(key);
  if (!found) return {};
  if (found->is_string()) return found->get<std::string>();
  say(key, "is not a text.");
  return {};
}

bool ObjectReader::flag(const std::string& key, bool missing) {
  const Json* found = value(key);
  if (!found) return missing;
  if (found->is_boolean()) return found->get<bool>();
  say(key, "is neither true nor false.");
  return missing;
}

std::optional<double> ObjectReader::number(const std::string& key, double low, double high) {
  const Json* found = value(key);
  if (!found) return std::nullopt;
  if (found->is_number()) return std::clamp(found->get<double>(), low, high);
  say(key, "is not a number.");
  return std::nullopt;
}

std::vector<double> ObjectReader::numbers(const std::string& key, size_t count) {
  const Json* found = value(key);
  if (!found) return {};
  std::vector<double> list;
  if (found->is_array() && found->size() == count) {
    for (const Json& one : *found) {
      if (one.is_number()) list.push_back(one.get<double>());
    }
  }
  if (list.size() != count) {
    say(key, "is not a list of " + std::to_string(count) + " numbers.");
    return {};
  }
  const bool near = std::all_of(list.begin(), list.end(), [](double one) {
    return isDrawable(Vec2{one, 0});
  });
  if (near) return list;
  say(key, "is too far away.");
  return {};
}

Vec2 ObjectReader::point(const std::string& key) {
  const auto list = numbers(key, 2);
  return list.empty() ? Vec2{} : Vec2{list[0], list[1]};
}

Vec3 ObjectReader::vector(const std::string& key, Vec3 missing) {
  const auto list = numbers(key, 3);
  return list.empty() ? missing : Vec3{list[0], list[1], list[2]};
}

Quaternion ObjectReader::rotation(const std::string& key) {
  const auto list = numbers(key, 4);
  return list.empty() ? Quaternion{} : Quaternion{list[0], list[1], list[2], list[3]};
}

const Json* ObjectReader::object(const std::string& key, bool may_be_null) {
  const Json* found = value(key);
  if (!found || (may_be_null && found->is_null())) return nullptr;
  if (found->is_object()) return found;
  say(key, "is not an object.");
  return nullptr;
}

std::optional<Plane> ObjectReader::plane(const std::string& key) {
  const Json* found = object(key, /*may_be_null=*/true);
  if (!found) return std::nullopt;
  ObjectReader reader(*found, where(key), fault_);
  const auto list = reader.numbers("plane", 4);
  keepInner(key, reader);
  if (!reader.has("plane")) reader.say("plane", "is missing.");
  if (list.empty()) return std::nullopt;
  const auto plane = normalised({{list[0], list[1], list[2]}, list[3]});
  if (!plane) reader.say("plane", "is no plane.");
  return plane;
}

Json ObjectReader::rest() const {
  Json rest = Json::object();
  for (const auto& item : object_.items()) {
    const bool asked = std::find(asked_.begin(), asked_.end(), item.key()) != asked_.end();
    if (!asked) rest[item.key()] = item.value();
  }
  for (const auto& item : inner_.items()) rest[item.key()] = item.value();
  if (rest.size() > kMostUnknown) {
    fault_.say((where_.empty() ? "It" : where_) + " has too many fields.");
  }
  return rest;
}

void ObjectReader::keepInner(const std::string& key, const ObjectReader& inner) {
  Json fields = inner.rest();
  if (!fields.empty()) inner_[key] = std::move(fields);
}

}  // namespace marrow
