#include "document/placed_parts.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"

namespace marrow {
namespace {

constexpr size_t kSuffixLength = sizeof kTwinSuffix - 1;

Vec2 middle(const std::vector<Vec2>& stroke) {
  return stroke.empty() ? Vec2{} : boxOf(stroke).middle();
}

/// Whether the side that the normal points to is the character's left.
bool pointsLeft(Vec3 normal) {
  double largest = normal.x;
  if (std::fabs(normal.y) > std::fabs(largest)) largest = normal.y;
  if (std::fabs(normal.z) > std::fabs(largest)) largest = normal.z;
  return largest > 0;
}

bool isLeft(const PartSource& part) {
  const double side = distance(*part.mirror, part.frame.toWorld(middle(part.stroke)));
  return pointsLeft(part.mirror->normal) ? side >= 0 : side < 0;
}

}  // namespace

std::vector<PlacedPart> placedParts(const Document& document) {
  std::vector<PlacedPart> placed;
  placed.reserve(document.parts.size());
  for (size_t i = 0; i < document.parts.size(); ++i) {
    const PartSource& part = *document.parts[i];
    placed.push_back({part.id, i, false, part.frame, 0});
    if (!part.mirror) continue;
    const bool left = isLeft(part);
    placed.back().side = left ? 'L' : 'R';
    placed.push_back(
        {part.id + kTwinSuffix, i, true, mirrored(part.frame, *part.mirror), left ? 'R' : 'L'});
  }
  return placed;
}

bool isTwinId(const std::string& placed_id) {
  return placed_id.size() >= kSuffixLength &&
         placed_id.compare(placed_id.size() - kSuffixLength, kSuffixLength, kTwinSuffix) == 0;
}

const PlacedPart* findPlaced(const std::vector<PlacedPart>& placed, const std::string& id) {
  const auto found = std::find_if(placed.begin(), placed.end(),
                                  [&](const PlacedPart& one) { return one.id == id; });
  return found == placed.end() ? nullptr : &*found;
}

std::string sourceId(const std::string& placed_id) {
  return isTwinId(placed_id) ? placed_id.substr(0, placed_id.size() - kSuffixLength) : placed_id;
}

}  // namespace marrow
