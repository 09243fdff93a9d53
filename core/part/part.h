// A stroke's whole way: outline, skeleton, mesh, proxy. And an imported mesh's, by its silhouette.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/timing.h"
#include "part/proxy.h"
#include "part/relief.h"
#include "part/silhouette.h"
#include "skeleton/axis.h"
#include "skeleton/hints.h"
#include "skeleton/joints.h"
#include "skeleton/straight_skeleton.h"
#include "sketch/outline.h"
#include "surface/inflate.h"
#include "surface/mesh.h"
#include "surface/sharp.h"
#include "surface/triangulation.h"

namespace marrow {

struct PartOptions {
  OutlineOptions outline;
  StraightSkeletonOptions straight_skeleton;
  AxisOptions axis;
  JointOptions joints;
  TriangulationOptions triangulation;
  InflateOptions inflate;
  std::optional<SkeletonHints> hints;  // of the stroke as it was before
};

/// Everything derived from one stroke, in its own plane z = 0; or from an imported mesh about it.
struct Part {
  Outline outline;
  StraightSkeleton straight_skeleton;
  Axis axis;
  PartSkeleton skeleton;  // joint radii are the proxy's; levels are complete
  Mesh mesh;
  std::vector<Vec3> normals;            // one per mesh vertex
  std::vector<double> depths;           // z of each mesh vertex at thickness 1
  Relief relief;                        // the mesh's sides, at thickness 1
  std::vector<double> inscribed_radii;  // one per joint
  SplitVertices shown;    // of an imported one, as it is to be shaded: sharp where its edges are
  bool imported = false;  // the mesh is not the same in front and behind
  std::vector<DepthSpan> spans;  // of an imported one: the body at the branches' samples, branch
                                 // by branch, at thickness 1
  Timings timings;               // stages: outline, straightSkeleton, axis, joints, triangulation,
                                 // inflation, normals, proxy

  double inscribedRadius() const;  // largest time of the straight skeleton
};

/// For a stroke that is still being drawn, every frame: the same skeleton, a coarser mesh.
PartOptions previewOptions();

/// Errors: those of the stages; noArea also for a perimeter below 1e-50 units.
Result<Part> buildPart(const std::vector<Vec2>& stroke, const PartOptions& options = {},
                       Clock clock = nullptr);

/// Its stages up to the joints alone.
Result<Part> buildSkeleton(const std::vector<Vec2>& stroke, const PartOptions& options = {},
                           Clock clock = nullptr);

/// The part of an imported mesh: its skeleton is that of the silhouette, at the middle of the
/// body's depth, with balls no larger than that depth. mesh: at thickness 1; closed and outward.
/// silhouette: a stroke, as of silhouetteOf. Errors: as above, but for those of making a mesh.
Result<Part> importPart(const Mesh& mesh, const std::vector<Vec2>& silhouette,
                        const PartOptions& options = {}, Clock clock = nullptr);

/// The part seen in the mirror z = 0.
Part flipped(const Part& part);

/// What buildPart or importPart gives with another thickness, bit for bit, by redoing only what
/// hangs on it; `timings` has the stages that ran.
Part withThickness(const Part& part, double thickness, Clock clock = nullptr);

}  // namespace marrow
