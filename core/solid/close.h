// Any surface → a closed solid, or why not.
#pragma once

#include "base/result.h"
#include "surface/mesh.h"

namespace marrow {

/// What can be closed, and how:
/// - corners in the same place become one vertex (or in nearly the same, within 10⁻⁵ of the size,
///   where that is what it takes); triangles with a repeated corner and doubles go, and so do two
///   on each other's backs, unless all are;
/// - faces are turned so that neighbours agree, and each piece outward;
/// - where more than two faces meet at an edge, those with the solid between them belong together,
///   if the surface faces one way there;
/// - a hole gets a cap where it is flat (no corner further from its mean plane than a tenth of the
///   hole's size; or all on one line, as where a corner lies on an edge) or small (a twentieth of
///   the model's): anything else would be a guess at a shape;
/// - triangles without area are flipped away (see flipSlivers);
/// - pieces that enclose nothing go; vertices where a surface touches itself are doubled.
/// The result is closed, 2-manifold and outward, with positive volume; it may have several pieces
/// and cross itself. Errors: notSolid, with the reason. About O(n log n).
///
/// surface: indices in range, coordinates finite, of ordinary size (see importMesh), but for
/// vertices that no triangle uses.
Result<Mesh> closeSurface(const Mesh& surface);

struct ClosedSurface {
  Mesh mesh;
  size_t left_out = 0;  // pieces that cannot be closed
};
/// The same, but pieces that cannot be closed go where the others span a quarter of the model at
/// least. Errors: those of closeSurface for the whole.
Result<ClosedSurface> closeMost(const Mesh& surface);

/// Whether one of its pieces passes through itself, which keeps it out of merged bodies.
bool crossesItself(const Mesh& mesh);

/// The connected pieces of a mesh, each with the vertices it uses, in the order of their first
/// triangles. O(n).
std::vector<Mesh> piecesOf(const Mesh& mesh);

}  // namespace marrow
