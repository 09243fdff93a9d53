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
/// - a hole gets a cap where it is flat (no corner further from its mean plane than a tenth of the
///   hole's size) or small (a twentieth of the model's): anything else would be a guess at a shape;
/// - triangles without area are flipped away (see flipSlivers);
/// - pieces that enclose nothing go; vertices where a surface touches itself are doubled.
/// The result is closed, 2-manifold and outward, with positive volume; it may have several pieces
/// and cross itself. Errors: notSolid, with the reason. About O(n log n).
///
/// surface: indices in range, coordinates finite, of ordinary size (see importMesh).
Result<Mesh> closeSurface(const Mesh& surface);

/// Whether one of its pieces passes through itself, which keeps it out of merged bodies.
bool crossesItself(const Mesh& mesh);

/// The connected pieces of a mesh, each with the vertices it uses, in the order of their first
/// triangles. O(n).
std::vector<Mesh> piecesOf(const Mesh& mesh);

}  // namespace marrow
