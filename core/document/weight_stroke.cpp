#include "document/weight_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "document/document.h"
#include "document/joint_id.h"
#include "document/placed_parts.h"

namespace marrow {
namespace {

constexpr double kCloser = 1. / 8;   // of the radius
constexpr double kSamePlace = 1e-9;  // of the axes' length
constexpr char kHangs[] = "a:";      // behind it another part's id
constexpr size_t kHangsLength = sizeof kHangs - 1;

}  // namespace

bool operator==(const WeightStroke& a, const WeightStroke& b) {
  return a.kind == b.kind && a.part == b.part && a.joint == b.joint && a.radius == b.radius &&
         a.strength == b.strength && a.points == b.points && a.extra == b.extra;
}

std::string renamedJoint(const std::string& joint, const RenamePlaced& rename) {
  const size_t end = lengthOfPart(joint);
  std::string renamed = quotedPart(rename(unquotedPart(joint.substr(0, end))));
  if (joint.compare(std::min(end + 1, joint.size()), kHangsLength, kHangs) != 0) {
    return renamed + joint.substr(end);
  }
  return renamed + '/' + kHangs +
         quotedPart(rename(unquotedPart(joint.substr(end + 1 + kHangsLength))));
}

std::string oppositePlaced(const Document& document, const std::string& placed_id) {
  const std::string source = sourceId(placed_id);
  const auto index = document.find(source);
  if (!index || !document.parts[*index]->mirror) return placed_id;
  return isTwinId(placed_id) ? source : source + kTwinSuffix;
}

std::string oppositeJoint(const Document& document, const std::string& joint) {
  return renamedJoint(
      joint, [&](const std::string& placed_id) { return oppositePlaced(document, placed_id); });
}

Result<WeightStroke> strokeOnPart(const Document& document, const WeightStroke& in_space) {
  WeightStroke stroke = in_space;
  stroke.part = sourceId(in_space.part);
  stroke.joint = toUtf8(in_space.joint);
  stroke.extra = "{}";
  const auto index = document.find(stroke.part);
  const bool twin = isTwinId(in_space.part);
  if (!index || (twin && !document.parts[*index]->mirror)) {
    return {Status::notFound, "There is no part \"" + onOneLine(in_space.part) + "\"."};
  }
  if (stroke.joint.empty() && stroke.kind != WeightStroke::Kind::smooth) {
    return {Status::notFound, "Choose a joint whose weights to paint."};
  }
  const PartSource& part = *document.parts[*index];
  if (twin) stroke.joint = oppositeJoint(document, stroke.joint);
  stroke.radius = in_space.radius / part.frame.scale();
  stroke.strength = in_space.strength > 0 ? std::min(in_space.strength, 1.0) : 0;
  if (!(stroke.radius >= WeightStroke::kMinRadius && stroke.radius <= WeightStroke::kMaxRadius)) {
    return {Status::noArea, "This brush has no size."};
  }
  stroke.points.clear();
  for (const Vec3 p : in_space.points) {
    if (!isDrawable(p)) continue;
    const Vec3 own = part.frame.toLocal(twin ? mirrored(p, *part.mirror) : p);
    if (!isDrawable(own)) continue;
    const double closer = kCloser * stroke.radius;
    if (!stroke.points.empty() && distance(own, stroke.points.back()) < closer) continue;
    stroke.points.push_back(own);
  }
  if (stroke.points.empty()) return {Status::noArea, "This is too far away to paint."};
  if (stroke.points.size() > WeightStroke::kMostPoints) return Status::tooMany;
  return stroke;
}

void dropLostStrokes(Document& document) {
  auto& strokes = document.weight_strokes;
  strokes.erase(std::remove_if(strokes.begin(), strokes.end(),
                               [&](const auto& one) { return !document.find(one->part); }),
                strokes.end());
}

void bringStrokes(const PartSource& before, const Affine& map, const PartSource& now,
                  Document& document) {
  // The way in the part's own coordinates: no map that leads far away costs a digit.
  const auto within = [&](Vec3 axis) {
    const Vec3 d = map.direction(axis);
    const Vec3 along{dot(now.frame.x, d), dot(now.frame.y, d), dot(now.frame.z(), d)};
    return along / dot(now.frame.x, now.frame.x);
  };
  // Depths are those of the surface, which no map shears.
  const double deeper = now.thickness / before.thickness;
  const bool turns_round = within(before.frame.z()).z < 0;
  const Vec3 own_z{0, 0, turns_round ? -deeper : deeper};
  const Affine own{within(before.frame.x), within(before.frame.y), own_z, {}};
  const bool same = distance(own.x, {1, 0, 0}) < kSamePlace &&
                    distance(own.y, {0, 1, 0}) < kSamePlace &&
                    distance(own.z, {0, 0, 1}) < kSamePlace;
  if (same) return;
  for (auto& shared : document.weight_strokes) {
    if (shared->part != now.id) continue;
    WeightStroke stroke = *shared;
    for (Vec3& p : stroke.points) {
      const Vec3 there = own(p);
      if (isDrawable(there)) p = there;
    }
    shared = std::make_shared<const WeightStroke>(std::move(stroke));
  }
}

void copyStrokes(const std::string& part, const std::string& copy, bool as_twin,
                 const RenamePlaced& rename, Document& document) {
  WeightStrokes strokes;
  for (const auto& one : document.weight_strokes) {
    strokes.push_back(one);
    if (one->part != part) continue;
    WeightStroke stroke = *one;
    stroke.part = copy;
    stroke.joint = renamedJoint(one->joint, rename);
    // A twin's frame looks at the part from behind.
    for (Vec3& p : stroke.points) p.z = as_twin ? -p.z : p.z;
    strokes.push_back(std::make_shared<const WeightStroke>(std::move(stroke)));
  }
  document.weight_strokes = std::move(strokes);
}

}  // namespace marrow
