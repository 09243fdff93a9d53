// A part as text: JSON with everything, OBJ with the mesh, SVG to look at.
#pragma once

#include <string>

#include "part/part.h"

namespace marrow {

/// {"name", "outline", "polygon", "straightSkeleton", "skeleton", "mesh", "timings"}; the README
/// has the details.
std::string partToJson(const std::string& name, const Part& part);
std::string partToObj(const std::string& name, const Part& part);
/// Outline, polygon, straight skeleton, joints and radii.
std::string partToSvg(const std::string& name, const Part& part);

}  // namespace marrow
