#include "document/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/box.h"

namespace marrow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRoom = 0.5;    // before and behind the others, of their extent
constexpr double kEqual = 1e-6;  // of the part's size: nearer than this is level

// What lies along a direction; distances from the origin.
struct Span {
  double low = 0, high = 0;

  double middle() const { return (low + high) / 2; }
  double extent() const { return high - low; }
};

Span spanOf(const Box3& box, const Frame& frame, Vec3 direction) {
  const Vec3 half = box.size() / 2;
  const double middle = dot(direction, frame.toWorld(box.middle()));
  const double reach = std::abs(dot(direction, frame.x)) * half.x +
                       std::abs(dot(direction, frame.y)) * half.y +
                       std::abs(dot(direction, frame.z())) * half.z;
  return {middle - reach, middle + reach};
}

// The part that moves and, as seen from it, the others.
class Layers {
 public:
  struct Other {
    Span span;
    bool covers;  // their boxes overlap on the part's plane
  };

  static std::optional<Layers> of(const Evaluation& evaluation, const Ids& ids, Vec3 viewer) {
    if (ids.empty()) return std::nullopt;
    const auto& placed = evaluation.placed();
    const PlacedPart* found = findPlaced(placed, ids.back());
    if (!found || !evaluation.parts()[found->source].part) return std::nullopt;
    std::vector<char> named(evaluation.parts().size(), 0);
    for (size_t i = 0; i < named.size(); ++i) {
      const std::string& id = evaluation.parts()[i].source->id;
      named[i] = std::any_of(ids.begin(), ids.end(),
                             [&](const std::string& one) { return sourceId(one) == id; });
    }
    Layers layers;
    const Frame& frame = found->frame;
    layers.box_ = boxOf(evaluation.parts()[found->source].shapeOf(*found)->mesh.positions);
    const Vec3 normal = frame.z() / frame.scale();
    layers.direction = dot(normal, viewer) < 0 ? -normal : normal;
    layers.own = spanOf(layers.box_, frame, layers.direction);
    const Vec3 extent = layers.box_.size();
    layers.size = std::max(extent.x, extent.y) * frame.scale();
    for (const PlacedPart& other : placed) {
      const EvaluatedPart& evaluated = evaluation.parts()[other.source];
      if (named[other.source] || !evaluated.part || !evaluated.source->visible) continue;
      const Box3 box = boxOf(evaluated.shapeOf(other)->mesh.positions);
      layers.others.push_back(
          {spanOf(box, other.frame, layers.direction), layers.overlaps(frame, box, other.frame)});
    }
    return layers;
  }

  Vec3 direction;
  Span own;
  double size = 0;
  std::vector<Other> others;  // in modelling order

 private:
  bool overlaps(const Frame& frame, const Box3& box, const Frame& box_frame) const {
    Box3 seen;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p{corner & 1 ? box.low.x : box.high.x, corner & 2 ? box.low.y : box.high.y,
                   corner & 4 ? box.low.z : box.high.z};
      seen.include(frame.toLocal(box_frame.toWorld(p)));
    }
    return seen.low.x < box_.high.x && seen.high.x > box_.low.x && seen.low.y < box_.high.y &&
           seen.high.y > box_.low.y;
  }

  Box3 box_;  // of the part, in its frame
};

}  // namespace

std::optional<DepthScale> depthScale(const Evaluation& evaluation, const Ids& ids,
                                     Vec3 towards_viewer) {
  const auto layers = Layers::of(evaluation, ids, towards_viewer);
  if (!layers) return std::nullopt;
  DepthScale scale;
  scale.direction = layers->direction;
  scale.now = layers->own.middle();
  Span all{kInfinity, -kInfinity};
  std::optional<double> covered;
  for (const Layers::Other& other : layers->others) {
    all = {std::min(all.low, other.span.low), std::max(all.high, other.span.high)};
    if (other.covers && !covered) covered = other.span.middle();
  }
  if (layers->others.empty()) {
    scale.low = -layers->size;
    scale.high = layers->size;
    return scale;
  }
  const double room = std::max(all.extent() * kRoom, layers->own.extent());
  scale.low = all.low - room;
  scale.high = all.high + room;
  scale.level = covered.value_or(all.middle());
  return scale;
}

std::optional<Vec3> layerMove(const Evaluation& evaluation, const Ids& ids, Vec3 towards_viewer,
                              bool nearer) {
  const auto layers = Layers::of(evaluation, ids, towards_viewer);
  if (!layers) return std::nullopt;
  const double now = layers->own.middle(), equal = kEqual * layers->size;
  double next = nearer ? kInfinity : -kInfinity;
  for (const Layers::Other& other : layers->others) {
    if (!other.covers) continue;
    if (nearer && other.span.high > now + equal) next = std::min(next, other.span.high);
    if (!nearer && other.span.low < now - equal) next = std::max(next, other.span.low);
  }
  if (std::isinf(next)) return std::nullopt;
  return layers->direction * (next - now);
}

}  // namespace marrow
