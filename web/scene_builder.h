// Document, what was derived from it and UiState → what the frame shows. Pure: called twice, it
// gives the same scene.
#pragma once

#include <memory>
#include <vector>

#include "document/evaluation.h"
#include "render/scene.h"
#include "tools/draw_tool.h"
#include "ui_state.h"

namespace marrow {

/// The part of the stroke under the hand.
struct LivePart {
  std::shared_ptr<const Part> part;  // null: nothing yet, or not now
  uint64_t mesh_id = 0;
  Color color;
};

Scene buildScene(const std::vector<EvaluatedPart>& parts, const LivePart& live,
                 const DrawTool& drawing, const UiState& ui);

}  // namespace marrow
