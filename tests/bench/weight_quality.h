// How well skin weights keep limbs apart, how far posed skin tears, and how alike twins are.
#pragma once

#include <vector>

#include "bench/quality.h"
#include "support/strokes.h"

namespace marrow::bench {

/// On bodies with narrow slits, on the gallery's creatures, and on drawings of one stroke each.
std::vector<QualityRow> weightQuality(const std::vector<strokes::NamedStroke>& drawings,
                                      bool verbose = false);

}  // namespace marrow::bench
