#include "tools/stroke_place.h"

#include <algorithm>
#include <cmath>

#include "document/symmetry.h"
#include "sketch/polygon.h"

namespace marrow {
namespace {

constexpr double kFaces = 0.985;  // cosine: two directions count as one
// A half outline ends so near to the line of symmetry, on the screen.
constexpr double kReach_px = 24;
// How much a surface faces the viewer where it counts as the side of a body, and where as its rim.
constexpr double kSideFacing = 0.75, kRimFacing = 0.3;
constexpr size_t kSamples = 24;  // of a stroke, to see what it lies on

Vec2 centroid(const std::vector<Vec2>& points) {
  Vec2 sum;
  for (const Vec2 p : points) sum = sum + p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

void StrokePlace::begin(Vec2 pixel, const Camera& camera, const Document& document,
                        const Evaluation& evaluation, const UiState& ui, Vec3 ground,
                        bool through_selected) {
  const auto axes = camera.axes();
  right_ = axes[0];
  up_ = axes[1];
  back_ = axes[2];
  evaluation_ = &evaluation;
  camera_ = camera;
  size_ = ui.size;
  chosen_ = through_selected;
  hit_ = through_selected ? std::nullopt : surfaceAt(pixel, evaluation, camera, ui.size);
  through_ = hit_ ? hit_->position : ground;
  symmetry_ = ui.symmetry ? symmetryPlane(document) : std::nullopt;
  side_view_ = symmetry_ && std::abs(dot(symmetry_->normal, back_)) > kFaces;
  line_ = symmetry_ && document.symmetry.has_value();
  reach_ = kReach_px / camera.zoom;
  outlines_.clear();
  for (size_t i = 0; i < evaluation.placed().size(); ++i) outlines_.push_back(outlineInView(i));
}

std::vector<Vec2> StrokePlace::outlineInView(size_t placed) const {
  const PlacedPart& one = evaluation_->placed()[placed];
  const EvaluatedPart& evaluated = evaluation_->parts()[one.source];
  std::vector<Vec2> outline;
  if (!evaluated.part || !evaluated.source->visible) return outline;
  for (const Vec2 p : evaluated.part->outline.dense) {
    outline.push_back(inView(one.frame.toWorld(p)));
  }
  return outline;
}

Frame StrokePlace::frameThrough(Vec3 world) const {
  return {back_ * dot(back_, world), right_, up_};
}

// Where the stroke began, or else where it reaches deepest into an outline.
std::optional<StrokePlace::Anchor> StrokePlace::anchorOf(const std::vector<Vec2>& stroke) const {
  if (hit_) return Anchor{*hit_, stroke.front()};
  double deepest = 0;
  Vec2 at;
  for (size_t k = 0; k < kSamples; ++k) {
    const Vec2 p = stroke[k * (stroke.size() - 1) / (kSamples - 1)];
    for (const auto& outline : outlines_) {
      if (outline.empty() || !contains(outline, p)) continue;
      const double depth = distanceToBorder(outline, p);
      if (depth <= deepest) continue;
      deepest = depth;
      at = p;
    }
  }
  if (deepest <= 0) return std::nullopt;
  const Vec2 pixel = camera_.toScreen(right_ * at.x + up_ * at.y, size_);
  const auto hit = surfaceAt(pixel, *evaluation_, camera_, size_);
  if (!hit) return std::nullopt;
  return Anchor{*hit, at};
}

bool StrokePlace::looksLikeLimb(const std::vector<Vec2>& stroke, const Anchor& anchor) const {
  if (anchor.hit.facing < kRimFacing) return false;
  const PlacedPart& placed = evaluation_->placed()[anchor.hit.placed];
  const PartSkeleton& skeleton = evaluation_->parts()[placed.source].shapeOf(placed)->skeleton;
  const Vec2 middle = centroid(stroke), way = middle - anchor.at;
  for (const auto& bone : skeleton.bones) {
    for (const bool second : {false, true}) {
      const PartSkeleton::Joint& joint = skeleton.joints[bone[second ? 1 : 0]];
      if (joint.kind != JointKind::terminal) continue;
      const Vec2 end = inView(placed.frame.toWorld(joint.place()));
      const Vec2 bone_way =
          end - inView(placed.frame.toWorld(skeleton.joints[bone[second ? 0 : 1]].place()));
      if (length(bone_way) <= 0) continue;
      const Vec2 outward = bone_way / length(bone_way), beyond = middle - end;
      const double radius = joint.radius * placed.frame.scale();
      const double ahead = dot(beyond, outward), aside = std::abs(cross(outward, beyond));
      if (ahead > 0.5 * radius && ahead > 0.6 * aside) return false;  // goes on where it ends
      const bool near = distance(anchor.at, end) < 1.3 * radius;
      if (near && way.y > 0.3 * length(way)) return false;  // a neck
    }
  }
  return way.y < -0.4 * length(way) || anchor.hit.facing > kSideFacing;
}

Vec3 StrokePlace::throughFor(const std::vector<Vec2>& stroke) const {
  if (!symmetry_ || chosen_ || stroke.size() < 3) return through_;
  const auto anchor = anchorOf(stroke);
  const auto ontoSymmetry = [&](Vec3 p) { return p - symmetry_->normal * distance(*symmetry_, p); };
  if (!anchor) return side_view_ ? ontoSymmetry(through_) : through_;
  const bool within = contains(outlines_[anchor->hit.placed], centroid(stroke));
  if (within) return anchor->hit.position;
  if (side_view_) {
    const Vec3 surface = anchor->hit.position;
    return looksLikeLimb(stroke, *anchor) ? surface : ontoSymmetry(surface);
  }
  const PlacedPart& placed = evaluation_->placed()[anchor->hit.placed];
  return middleOf(evaluation_->parts()[placed.source], placed.frame);
}

StrokePlace::Place StrokePlace::at(const std::vector<Vec2>& stroke) const {
  Place place;
  place.frame = frameThrough(throughFor(stroke));
  if (!symmetry_ || stroke.size() < 3) return place;
  if (line_) {
    if (auto whole = completedByMirror(stroke, place.frame, *symmetry_, reach_)) {
      place.completed = true;
      place.stroke = std::move(*whole);
      return place;
    }
  }
  const bool belongs = line_ || anchorOf(stroke).has_value();
  if (belongs && isOffPlane(stroke, place.frame, *symmetry_)) place.mirror = symmetry_;
  return place;
}

}  // namespace marrow
