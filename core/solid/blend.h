// Soft seams: a limb grows out of the body instead of being stuck into it.
#pragma once

#include "solid/merge.h"

namespace marrow {

struct BlendOptions {
  /// How far from a seam, along the surface, points may move; model units. 0 or less: nothing does.
  /// Below the length of the mesh's edges only the seam itself moves.
  double radius = 0;
};

/// Fills the creases along the seams: points near them are drawn to the middle of their neighbours,
/// but never inward, so that nothing gets thinner. Triangles and parts stay the same; the normals
/// become those of the new surface towards the seams. Where that would make the surface cross
/// itself, points stay nearer to where they were; what was closed, manifold and without
/// self-intersections is so afterwards. O(n log n) for n points near seams, times the square of the
/// radius ÷ the edges' length (bounded).
MergedMesh blendSeams(MergedMesh merged, const BlendOptions& options, Clock clock = nullptr);

}  // namespace marrow
