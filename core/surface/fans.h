// Triangles around a vertex that belong together.
#pragma once

#include "base/sets.h"
#include "surface/mesh.h"

namespace marrow {

/// The same triangles with a vertex for each fan of theirs; those that none uses go.
/// fans: of corners, by the numbers of the sides that begin there (see nextSide); corners of one
/// fan have the same vertex.
Mesh splitByFans(const Mesh& mesh, Sets& fans);

}  // namespace marrow
