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
// What is begun nearer to the rim of a body than this goes on in the body's plane.
constexpr double kRimFacing = 0.3, kSideFacing = 0.75;

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
  hit_ = through_selected ? std::nullopt : surfaceAt(pixel, evaluation, camera, ui.size);
  chosen_ = through_selected;
  through_ = hit_ ? hit_->position : ground;
  symmetry_ = ui.symmetry ? symmetryPlane(document) : std::nullopt;
  side_view_ = symmetry_ && std::abs(dot(symmetry_->normal, back_)) > kFaces;
  line_ = symmetry_ && document.symmetry.has_value();
  reach_ = kReach_px / camera.zoom;
  ends_.clear();
  outlines_.clear();
  for (const PlacedPart& placed : evaluation.placed()) {
    const EvaluatedPart& evaluated = evaluation.parts()[placed.source];
    if (!evaluated.part || !evaluated.source->visible) continue;
    std::vector<Vec2> outline;
    for (const Vec2 p : evaluated.part->outline.dense) {
      const Vec3 world = placed.frame.toWorld(p);
      outline.push_back({dot(right_, world), dot(up_, world)});
    }
    outlines_.push_back(std::move(outline));
  }
  if (!hit_) return;
  const PlacedPart& placed = evaluation.placed()[hit_->placed];
  const PartSkeleton& skeleton = evaluation.parts()[placed.source].part->skeleton;
  const auto inView = [&](Vec2 p) {
    const Vec3 world = placed.frame.toWorld(p);
    return Vec2{dot(right_, world), dot(up_, world)};
  };
  for (const auto& bone : skeleton.bones) {
    for (const bool second : {false, true}) {
      const PartSkeleton::Joint& joint = skeleton.joints[bone[second ? 1 : 0]];
      if (joint.kind != JointKind::terminal) continue;
      const Vec2 from = inView(skeleton.joints[bone[second ? 0 : 1]].position);
      const Vec2 to = inView(joint.position);
      const double span = distance(from, to);
      if (span <= 0) continue;
      ends_.push_back({to, (to - from) / span, joint.radius * placed.frame.scale()});
    }
  }
}

Frame StrokePlace::frameThrough(Vec3 world) const {
  return {back_ * dot(back_, world), right_, up_};
}

bool StrokePlace::looksLikeLimb(const std::vector<Vec2>& stroke) const {
  if (!hit_ || hit_->facing < kRimFacing) return false;
  const Vec2 start = stroke.front(), middle = centroid(stroke);
  const Vec2 way = middle - start;
  for (const End& end : ends_) {
    const Vec2 beyond = middle - end.position;
    const double ahead = dot(beyond, end.outward), aside = std::abs(cross(end.outward, beyond));
    if (ahead > 0.5 * end.radius && ahead > 0.6 * aside) return false;  // goes on where it ends
    const bool near = distance(start, end.position) < 1.3 * end.radius;
    if (near && way.y > 0.3 * length(way)) return false;  // a neck
  }
  return way.y < -0.4 * length(way) || hit_->facing > kSideFacing;
}

bool StrokePlace::touchesCharacter(const std::vector<Vec2>& stroke) const {
  constexpr size_t kSamples = 24;
  for (size_t k = 0; k < kSamples; ++k) {
    const Vec2 p = stroke[k * (stroke.size() - 1) / (kSamples - 1)];
    for (const auto& outline : outlines_) {
      if (contains(outline, p)) return true;
    }
  }
  return false;
}

StrokePlace::Place StrokePlace::at(const std::vector<Vec2>& stroke) const {
  Place place;
  place.frame = frameThrough(through_);
  if (!symmetry_ || stroke.size() < 3) return place;
  if (side_view_ && !chosen_ && !looksLikeLimb(stroke)) {
    const Vec3 normal = symmetry_->normal;
    place.frame = frameThrough(through_ - normal * distance(*symmetry_, through_));
    return place;
  }
  if (line_) {
    if (auto whole = completedByMirror(stroke, place.frame, *symmetry_, reach_)) {
      place.completed = true;
      place.stroke = std::move(*whole);
      return place;
    }
  }
  const bool belongs = line_ || touchesCharacter(stroke);
  if (belongs && isOffPlane(stroke, place.frame, *symmetry_)) place.mirror = symmetry_;
  return place;
}

}  // namespace marrow
