#include "part/part.h"

#include <algorithm>
#include <utility>

#include "skeleton/inside.h"

namespace marrow {
namespace {

// Products of lengths below it would underflow; kLargestCoordinate guards the other end.
constexpr double kSmallestPerimeter = 1e-50;

constexpr int kOutlineAttempts = 6;

/// Scales the mesh's depth. Normals and proxy have to be redone then.
void setThickness(Part& part, double thickness) {
  for (size_t i = 0; i < part.depths.size(); ++i) {
    part.mesh.positions[i].z = part.depths[i] * thickness;
  }
}

void setProxy(Part& part) {
  for (size_t i = 0; i < part.inscribed_radii.size(); ++i) {
    part.skeleton.joints[i].radius = part.inscribed_radii[i];
  }
  const std::vector<double> radii = proxyRadii(part.skeleton, part.mesh);
  for (size_t i = 0; i < radii.size(); ++i) part.skeleton.joints[i].radius = radii[i];
}

}  // namespace

PartOptions previewOptions() {
  PartOptions options;
  options.triangulation.target_points = 300;
  return options;
}

double Part::inscribedRadius() const {
  const auto& times = straight_skeleton.times;
  return times.empty() ? 0 : *std::max_element(times.begin(), times.end());
}

Result<Part> buildPart(const std::vector<Vec2>& stroke, const PartOptions& options, Clock clock) {
  Part part;
  Stopwatch watch(clock, part.timings);

  OutlineOptions outlining = options.outline;
  for (int attempt = 1;; ++attempt) {
    auto outline = makeOutline(stroke, outlining);
    if (!outline) return outline.error();
    if (outline->perimeter < kSmallestPerimeter) return Status::noArea;
    part.outline = std::move(*outline);
    watch.lap("outline");

    auto straight = straightSkeleton(part.outline.polygon, options.straight_skeleton);
    if (!straight) return straight.error();
    part.straight_skeleton = std::move(*straight);
    watch.lap("straightSkeleton");

    auto axis = extractAxis(part.outline.polygon, part.straight_skeleton, options.axis);
    if (!axis) return axis.error();
    part.axis = std::move(*axis);
    watch.lap("axis");

    // The simplified polygon may bulge out of thin places of what was drawn, and the axis with it.
    if (attempt == kOutlineAttempts ||
        segmentsInside(part.outline.dense, part.axis.points, part.axis.edges)) {
      break;
    }
    outlining.tolerance /= 4;
  }

  auto skeleton = placeJoints(part.outline.polygon, part.axis, part.outline.scale(), options.joints,
                              &part.outline.dense);
  if (!skeleton) return skeleton.error();
  part.skeleton = std::move(*skeleton);
  for (const auto& joint : part.skeleton.joints) part.inscribed_radii.push_back(joint.radius);
  watch.lap("joints");

  auto flat = triangulate(part.outline.dense, options.triangulation);
  if (!flat) return flat.error();
  watch.lap("triangulation");

  InflateOptions unscaled = options.inflate;
  unscaled.thickness = 1;
  auto mesh = inflate(*flat, part.inscribedRadius(), unscaled);
  if (!mesh) return mesh.error();
  part.mesh = std::move(*mesh);
  for (Vec3 position : part.mesh.positions) part.depths.push_back(position.z);
  part.relief = Relief(part.mesh, part.depths);
  setThickness(part, options.inflate.thickness);
  watch.lap("inflation");

  part.normals = vertexNormals(part.mesh);
  watch.lap("normals");

  setProxy(part);
  watch.lap("proxy");

  for (auto& branch : part.skeleton.branches) {
    completeLevels(branch, part.outline.polygon, part.outline.scale(), options.joints,
                   &part.outline.dense);
  }
  watch.lap("levels");
  return part;
}

Part withThickness(const Part& part, double thickness, Clock clock) {
  Timings timings;
  Stopwatch watch(clock, timings);
  Part next = part;
  setThickness(next, thickness);
  watch.lap("inflation");
  next.normals = vertexNormals(next.mesh);
  watch.lap("normals");
  setProxy(next);
  watch.lap("proxy");
  next.timings = std::move(timings);
  return next;
}

}  // namespace marrow
