// What panels are given and what they may ask for. A panel draws itself and nothing else: what it
// wants waits in Requests until the next frame applies it.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "document/evaluation.h"
#include "document/history.h"
#include "figure/figure_keeper.h"
#include "figure/file_maker.h"
#include "keep/shelf.h"
#include "meter.h"
#include "scene_builder.h"
#include "ui_state.h"

namespace marrow {

struct PanelInput {
  const History& history;
  const Document& shown;         // the current document with the edit under the hand
  const Evaluation& evaluation;  // of `shown`
  const Rig& rig;                // of the evaluation's placed parts and, after them, the live ones
  const LivePart& live;
  const Hand& hand;
  const Meter& meter;
  const Shelf& shelf;
  const Stance& stance;  // while poses are made
  const FigureKeeper& figure;
  const FileMaker& file;  // being made
  bool drawing = false;   // a stroke is under way
};

struct Requests {
  std::vector<Command> commands;
  std::vector<FileAction> files;
  bool commit_edit = false;  // UiState::edit becomes a command
  bool reset = false;        // the commands come from a double click, its first click before them
  bool undo = false, redo = false;
  char key = 0;  // as if this key had been pressed
  bool frame_all = false;
  std::optional<StandardView> view;
  Vec2 orbit_px;
  bool again = false;  // this frame changed UiState or moves: draw another one
  double wake_after_ms = std::numeric_limits<double>::infinity();  // nothing changes until then
};

void drawToolbar(const PanelInput& input, UiState& ui, Requests& requests);
void drawViewControls(const PanelInput& input, UiState& ui, Requests& requests);
/// On the canvas, below all panels: handles, the box, where a part will hang.
void drawCanvasMarks(const PanelInput& input, UiState& ui, Requests& requests);
void drawToolPanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawPartPanel(const PanelInput& input, UiState& ui, Requests& requests);
/// The list of all parts.
void drawPartsPanel(const PanelInput& input, UiState& ui, Requests& requests);
/// The thresholds, while no part's panel shows them.
void drawRefinePanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawPerformancePanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawHelpPanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawFilePanel(const PanelInput& input, UiState& ui, Requests& requests);
/// The offer to go on with a kept drawing.
void drawOffer(const PanelInput& input, UiState& ui, Requests& requests);
/// Poses, while they are made.
void drawPosePanel(const PanelInput& input, UiState& ui, Requests& requests);
/// The character as a file.
void drawExportPanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawGalleryPanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawReferencePanel(const PanelInput& input, UiState& ui, Requests& requests);
void drawHint(const PanelInput& input, UiState& ui, Requests& requests);
void drawToast(const PanelInput& input, UiState& ui, Requests& requests);

}  // namespace marrow
