// Flat triangles → closed, inflated mesh  [RS §4.1; Dvorožňák et al. 2020]
#pragma once

#include "base/result.h"
#include "surface/mesh.h"
#include "surface/triangulation.h"

namespace marrow {

struct InflateOptions {
  enum class Profile : uint8_t {
    round,  // z = ±s√u with s so that the highest point is at the largest inscribed radius
    plain,  // z = ±√u: half circles on strips, discs come out flat
  };
  Profile profile = Profile::round;
  double thickness = 1.0;  // scales z
};

/// Solves −Δu = 2, u = 0 on the border, with the cotangent Laplacian and one sparse Cholesky;
/// z = ±s√u. Front and back share the border's vertices.
///
/// inscribed_radius: the largest inscribed radius of the outline, model units (the straight
/// skeleton's largest time); used by Profile::round only.
/// The mesh has the triangulation's points first (interior ones as the front, z > 0), then the
/// back's copies of the interior ones; it is closed, 2-manifold, outward, free of degenerate
/// triangles. Errors: meshFailed.
Result<Mesh> inflate(const Triangulation& flat, double inscribed_radius,
                     const InflateOptions& options = {});

}  // namespace marrow
