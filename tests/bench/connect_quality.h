// Do drawn parts become the character that an animator would put together? Measured on
// partedCreatures, against the meshes of the bodies themselves.
#pragma once

#include <vector>

#include "bench/quality.h"

namespace marrow::bench {

/// Rows of the table of rig quality. verbose: each fault on the standard error.
std::vector<QualityRow> connectQuality(bool verbose = false);

}  // namespace marrow::bench
