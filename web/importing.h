// How a mesh from elsewhere comes into a view.
#pragma once

#include "camera.h"
#include "document/command.h"
#include "surface/mesh.h"

namespace marrow {

/// As the view shows it, in its middle, as deep as the pivot; half as wide, high or deep as the
/// view is wide or high, whatever comes first: then it is in sight from all sides. size: of the
/// view, CSS pixels. mesh: about the origin, with a size in x, y or z.
ImportPart asSeen(const Mesh& mesh, const Camera& camera, ViewSize size, Vec3 pivot);

}  // namespace marrow
