// On which side of a plane a point lies, without rounding.
#pragma once

#include "base/vec.h"

namespace marrow {

/// Sign of det(b − a, c − a, d − a): 1 where d is in front of the triangle a, b, c, which is
/// counter-clockwise there. Any finite coordinates whose products neither overflow nor vanish.
int exactOrientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

}  // namespace marrow
