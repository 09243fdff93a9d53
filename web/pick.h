// Which part lies under a pixel.
#pragma once

#include <string>
#include <vector>

#include "camera.h"
#include "document/evaluation.h"

namespace marrow {

/// The id of the part seen nearest to the viewer there; empty where there is none.
std::string partAt(Vec2 pixel, const std::vector<EvaluatedPart>& parts, const Camera& camera,
                   ViewSize size);

}  // namespace marrow
