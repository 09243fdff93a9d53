// What the readers and writers of this room share: JSON text ↔ tree, without exceptions.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace marrow {

/// Keeps the order of an object's fields.
using Json = nlohmann::ordered_json;

/// Limits that no drawing meets, so that no text can exhaust the stack, the memory or the patience.
constexpr size_t kLargestText = 64u << 20;  // bytes
constexpr size_t kMostValues = 8'000'000;   // numbers, texts, lists and objects in all
constexpr size_t kMostFields = 1000;        // of one object
constexpr size_t kDeepestNesting = 64;      // of lists and objects

/// Errors: unreadable, with a sentence that says what and where.
Result<Json> parseJson(const std::string& text);

/// Whole numbers are written without a fraction; reading gives the same bits.
Json toJson(double value);
Json toJson(Vec2 point);
Json toJson(Vec3 v);
Json toJson(const std::vector<Vec2>& points);

/// Compact text; bytes that are not UTF-8 are replaced.
std::string toText(const Json& value);

/// The field of an object, or null.
const Json* field(const Json& object, const char* key);

/// A list of pairs of numbers, none beyond kLargestCoordinate. `where` names it in the error.
Result<std::vector<Vec2>> readPoints(const Json& value, const std::string& where);

}  // namespace marrow
