#include "part/part.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "skeleton/inside.h"

namespace marrow {
namespace {

// Products of lengths below it would underflow; kLargestCoordinate guards the other end.
constexpr double kSmallestPerimeter = 1e-50;

constexpr int kOutlineAttempts = 6;

void setNormals(Part& part) {
  part.normals = vertexNormals(part.mesh);
  if (part.imported) part.shown = splitByNormals(part.mesh, cornerNormals(part.mesh));
}

/// Scales the mesh's depth. Normals and proxy have to be redone then.
void setThickness(Part& part, double thickness) {
  for (size_t i = 0; i < part.depths.size(); ++i) {
    part.mesh.positions[i].z = part.depths[i] * thickness;
  }
}

/// Joints of an imported part and the samples they are chosen from.
void setDepths(Part& part, double thickness) {
  auto span = part.spans.begin();
  for (auto& branch : part.skeleton.branches) {
    const auto first = span;
    for (BranchSample& sample : branch.samples) sample.depth = (span++)->middle() * thickness;
    for (size_t k = 0; k < branch.joints.size(); ++k) {
      const DepthSpan& own = *(first + static_cast<std::ptrdiff_t>(branch.at[k]));
      auto& joint = part.skeleton.joints[branch.joints[k]];
      joint.depth = own.middle() * thickness;
      joint.radius = std::min(part.inscribed_radii[branch.joints[k]], own.half() * thickness);
    }
  }
}

void setProxy(Part& part, double thickness) {
  if (part.imported) return setDepths(part, thickness);
  for (size_t i = 0; i < part.inscribed_radii.size(); ++i) {
    part.skeleton.joints[i].radius = part.inscribed_radii[i];
  }
  const std::vector<double> radii = proxyRadii(part.skeleton, part.mesh);
  for (size_t i = 0; i < radii.size(); ++i) part.skeleton.joints[i].radius = radii[i];
}

/// The body at all samples of the branches; where a ray misses it, as at the sample before.
std::vector<DepthSpan> spansOf(const PartSkeleton& skeleton, const Mesh& mesh) {
  const DepthRays rays(mesh);
  std::vector<DepthSpan> spans;
  for (const auto& branch : skeleton.branches) {
    const size_t first = spans.size();
    std::vector<char> known;
    for (const BranchSample& sample : branch.samples) {
      const auto span = rays.at(sample.point);
      known.push_back(span.has_value());
      spans.push_back(span ? *span : spans.size() > first ? spans.back() : DepthSpan{});
    }
    const auto found = std::find(known.begin(), known.end(), 1);
    if (found == known.end()) continue;
    const auto count = found - known.begin();
    const auto begin = spans.begin() + static_cast<std::ptrdiff_t>(first);
    std::fill(begin, begin + count, *(begin + count));
  }
  return spans;
}

/// Outline, straight skeleton, axis and joints. Nothing where all is well.
std::optional<Error> makeSkeleton(const std::vector<Vec2>& stroke, const PartOptions& options,
                                  Part& part, Stopwatch& watch) {
  OutlineOptions outlining = options.outline;
  if (options.hints) outlining.was_symmetric = options.hints->mirrored;
  JointOptions joining = options.joints;
  joining.hints = options.hints;
  for (int attempt = 1;; ++attempt) {
    auto outline = makeOutline(stroke, outlining);
    if (!outline) return outline.error();
    if (outline->perimeter < kSmallestPerimeter) return Error{Status::noArea, {}};
    part.outline = std::move(*outline);
    watch.lap("outline");

    auto straight = straightSkeleton(part.outline.polygon, options.straight_skeleton);
    if (!straight) return straight.error();
    part.straight_skeleton = std::move(*straight);
    watch.lap("straightSkeleton");

    AxisOptions axial = options.axis;
    axial.mirror = part.outline.mirror;
    axial.hints = options.hints;
    auto axis = extractAxis(part.outline.polygon, part.straight_skeleton, axial);
    if (!axis) return axis.error();
    part.axis = std::move(*axis);
    watch.lap("axis");

    // The smooth polygon may bulge out of thin places of what was drawn, and the axis with it.
    if (attempt < kOutlineAttempts &&
        !segmentsInside(part.outline.dense, part.axis.points, part.axis.edges)) {
      outlining.steadiness = attempt + 1 < kOutlineAttempts ? outlining.steadiness / 2 : 0;
      if (attempt + 1 == kOutlineAttempts) outlining.symmetric = false;
      continue;
    }
    const MirrorLine* mirror = part.outline.mirror ? &*part.outline.mirror : nullptr;
    auto skeleton = placeJoints(part.outline.polygon, part.axis, part.outline.scale(), joining,
                                &part.outline.dense, mirror);
    if (!skeleton && mirror) {
      outlining.symmetric = false;
      continue;
    }
    if (!skeleton) return skeleton.error();
    part.skeleton = std::move(*skeleton);
    break;
  }
  for (const auto& joint : part.skeleton.joints) part.inscribed_radii.push_back(joint.radius);
  watch.lap("joints");
  return std::nullopt;
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
  if (auto error = makeSkeleton(stroke, options, part, watch)) return *error;

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

  setNormals(part);
  watch.lap("normals");

  setProxy(part, options.inflate.thickness);
  watch.lap("proxy");

  return part;
}

Result<Part> buildSkeleton(const std::vector<Vec2>& stroke, const PartOptions& options,
                           Clock clock) {
  Part part;
  Stopwatch watch(clock, part.timings);
  if (auto error = makeSkeleton(stroke, options, part, watch)) return *error;
  return part;
}

Result<Part> importPart(const Mesh& mesh, const std::vector<Vec2>& silhouette,
                        const PartOptions& options, Clock clock) {
  Part part;
  Stopwatch watch(clock, part.timings);
  if (auto error = makeSkeleton(silhouette, options, part, watch)) return *error;
  part.imported = true;
  part.mesh = mesh;
  for (Vec3 position : mesh.positions) part.depths.push_back(position.z);
  part.relief = Relief(mesh, part.depths, /*even=*/false);
  setThickness(part, options.inflate.thickness);
  watch.lap("inflation");

  setNormals(part);
  watch.lap("normals");

  part.spans = spansOf(part.skeleton, mesh);
  setProxy(part, options.inflate.thickness);
  watch.lap("proxy");
  return part;
}

Part flipped(const Part& part) {
  Part other = part;
  for (Vec3& position : other.mesh.positions) position.z = -position.z;
  for (auto& triangle : other.mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (Vec3& normal : other.normals) normal.z = -normal.z;
  for (Vec3& normal : other.shown.normals) normal.z = -normal.z;
  for (auto& triangle : other.shown.triangles) std::swap(triangle[1], triangle[2]);
  for (double& depth : other.depths) depth = -depth;
  for (DepthSpan& span : other.spans) span = {-span.high, -span.low};
  for (auto& joint : other.skeleton.joints) joint.depth = -joint.depth;
  for (auto& branch : other.skeleton.branches) {
    for (BranchSample& sample : branch.samples) sample.depth = -sample.depth;
  }
  other.relief = part.relief.flipped();
  return other;
}

Part withThickness(const Part& part, double thickness, Clock clock) {
  Timings timings;
  Stopwatch watch(clock, timings);
  Part next = part;
  setThickness(next, thickness);
  watch.lap("inflation");
  setNormals(next);
  watch.lap("normals");
  setProxy(next, thickness);
  watch.lap("proxy");
  next.timings = std::move(timings);
  return next;
}

}  // namespace marrow
