// Document, what was derived from it and UiState → what the frame shows. Pure: called twice, it
// gives the same scene.
#pragma once

#include <memory>
#include <vector>

#include "document/evaluation.h"
#include "figure/figure_keeper.h"
#include "render/scene.h"
#include "tools/hand.h"
#include "ui_state.h"

namespace marrow {

/// The part of the stroke under the hand, and its twin.
struct LivePart {
  std::shared_ptr<const Part> part;  // null: nothing yet, or not now
  uint64_t mesh_id = 0;
  PartSource source;               // as it would be in the document
  std::vector<PlacedPart> placed;  // itself and its twin, if it gets one
};

/// stance, figure: shown while poses are made, the figure also before it is exported. rig: of the
/// evaluation's placed parts and, after them, the live ones. symmetry: the plane to show, if any.
Scene buildScene(const Evaluation& evaluation, const Rig& rig, const LivePart& live,
                 const DrawTool& gesture, const Hand& hand, const std::optional<Plane>& symmetry,
                 const Stance& stance, const FigureKeeper& figure, const UiState& ui);

}  // namespace marrow
