// Characters as solids with weights: merged, weighted, posed, written.
#pragma once

#include <string>
#include <vector>

namespace marrow::bench {

/// Writes a JSON object a line, as `marrow_bench model` does. paths: of documents to weigh besides
/// our own.
void models(bool quick, const std::vector<std::string>& paths);

}  // namespace marrow::bench
