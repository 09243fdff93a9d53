// A mesh for other programs: OBJ as text, STL and PLY in binary.
#pragma once

#include <string>

#include "character/character.h"

namespace marrow {

/// An object, with smooth normals; the paints are groups.
std::string toObj(const SkinnedMesh& mesh, const std::vector<Paint>& paints);
/// Little-endian, single precision. Errors: meshFailed for what that cannot hold.
Result<std::string> toStl(const SkinnedMesh& mesh);
/// The same, with normals and the colours of the triangles.
Result<std::string> toPly(const SkinnedMesh& mesh, const std::vector<Paint>& paints);

}  // namespace marrow
