// A mesh for other programs: OBJ as text, STL and PLY in binary.
#pragma once

#include <string>

#include "character/character.h"

namespace marrow {

/// An object, with smooth normals; the paints are groups.
std::string toObj(const SkinnedMesh& mesh, const std::vector<Paint>& paints);
/// Little-endian, single precision, with z up and y to the back, as printers and most programs take
/// STL. Errors: meshFailed for what that cannot hold.
Result<std::string> toStl(const SkinnedMesh& mesh);
/// Little-endian, single precision, with y up, with normals and the colours of the triangles.
/// Errors: meshFailed.
Result<std::string> toPly(const SkinnedMesh& mesh, const std::vector<Paint>& paints);

}  // namespace marrow
