// What the app is showing, as JSON text: for embedding, for tests and for the desktop's --dump.
#pragma once

#include <string>

#include "app.h"

namespace marrow {

/// Array of {"id", "name", "joints": [{"kind", "position": [x, y, z], "radius"}], "bones": [[i,
/// j]], "mesh": {"vertices", "triangles"}, "timings": {stage: ms…, "total"}, "straightSkeleton":
/// {"method", "nodes", "edges"}}; of a part that could not be made: {"id", "name", "error"}.
std::string partsReport(const App& app);

/// {"frames", "dpr", "canvas", "camera", "selected", "evaluation", "preview", "warm", …}; the
/// README says more.
std::string statsReport(const App& app);

/// The vertices of the figure as it is shown while poses are made, else at rest; there must be a
/// figure.
SkinnedVertices posedFigure(const App& app);

}  // namespace marrow
