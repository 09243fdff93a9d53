// Parts of panels that stand in more than one of them.
#pragma once

#include "panels/panel.h"

namespace marrow {

/// The thresholds of one scope, and which scope that is.
void drawThresholds(const PanelInput& input, UiState& ui, Requests& requests);

/// Whether the part's panel shows them: asked for there, or before it came.
inline bool showsBones(const UiState& ui) { return ui.open.bones || ui.open.skeleton; }
/// Whether the part's panel is there, so that the thresholds need none of their own.
bool partPanelShows(const PanelInput& input, const UiState& ui);

/// Where the only selected part hangs, and what overrules it.
void drawAttachment(const PanelInput& input, UiState& ui, Requests& requests);
/// What is asked for while UiState::attaching.
void drawAttachHint(const PanelInput& input, UiState& ui);

/// Ids of the selected parts, without twins, each once, in the order of the selection.
std::vector<std::string> selectedSources(const PanelInput& input, const UiState& ui);

/// "1 joint", "4 parts".
std::string counted(size_t n, const char* one);

}  // namespace marrow
