// Whole characters: sub-skeletons, connection, refinement; dragging, sliders, opening.
#pragma once

#include <string>
#include <vector>

namespace marrow::bench {

/// Writes a JSON object a line, as `marrow_bench rig` does. paths: of documents to measure besides
/// our own.
void rigs(bool quick, const std::vector<std::string>& paths);

/// The document of 60 strokes.
std::string characterOfManyParts();

}  // namespace marrow::bench
