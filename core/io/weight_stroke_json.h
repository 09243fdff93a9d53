// One stroke of the weight brush ↔ JSON tree.
#pragma once

#include <string>

#include "document/weight_stroke.h"
#include "io/json.h"
#include "io/object_reader.h"

namespace marrow {

/// {"kind": "add", "take" or "smooth", "part", "joint", "radius", "strength",
///  "points": [[x, y, z], …]}; every field but "points" may be missing.
Json weightStrokeToTree(const WeightStroke& stroke);
WeightStroke readWeightStroke(const Json& tree, const std::string& where, Fault& fault);

}  // namespace marrow
