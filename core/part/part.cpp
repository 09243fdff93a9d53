#include "part/part.h"

#include <algorithm>

namespace marrow {

double Part::inscribedRadius() const {
  const auto& times = straight_skeleton.times;
  return times.empty() ? 0 : *std::max_element(times.begin(), times.end());
}

Result<Part> buildPart(const std::vector<Vec2>& stroke, const PartOptions& options, Clock clock) {
  Part part;
  Stopwatch watch(clock, part.timings);

  auto outline = makeOutline(stroke, options.outline);
  if (!outline) return outline.error();
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

  auto skeleton =
      placeJoints(part.outline.polygon, part.axis, part.outline.scale(), options.joints);
  if (!skeleton) return skeleton.error();
  part.skeleton = std::move(*skeleton);
  watch.lap("joints");

  auto flat = triangulate(part.outline.dense, options.triangulation);
  if (!flat) return flat.error();
  watch.lap("triangulation");

  auto mesh = inflate(*flat, part.inscribedRadius(), options.inflate);
  if (!mesh) return mesh.error();
  part.mesh = std::move(*mesh);
  watch.lap("inflation");

  part.normals = vertexNormals(part.mesh);
  watch.lap("normals");

  const std::vector<double> radii = proxyRadii(part.skeleton, part.mesh);
  for (size_t i = 0; i < radii.size(); ++i) part.skeleton.joints[i].radius = radii[i];
  watch.lap("proxy");
  return part;
}

}  // namespace marrow
