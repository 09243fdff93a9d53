// Where panels lie. Wide: around the edges. Narrow: a bar above, a bar below, and one sheet at a
// time between them and the drawing.
#pragma once

#include <algorithm>

#include "panels/widgets.h"

namespace marrow {

constexpr float kBarPadding = 10;  // of a bar's two sides together

inline float barHeight(const UiState& ui) { return buttonSide(ui) + kBarPadding; }
inline float canvasWidth(const UiState& ui) { return static_cast<float>(ui.size.width); }
inline float canvasHeight(const UiState& ui) { return static_cast<float>(ui.size.height); }
inline float margin(const UiState& ui) { return ui.narrow() ? 8 : Theme::kMargin; }
/// The ball that turns the view, in the top right corner.
inline float gizmoSide(const UiState& ui) { return ui.narrow() ? 76.0f : 96.0f; }

/// A canvas so low that sheets stand at its side.
inline bool lowCanvas(const UiState& ui) { return ui.narrow() && ui.size.height < 480; }

/// A sheet above the lower bar; at the right where the canvas is low.
inline PanelBox sheetBox(const UiState& ui) {
  PanelBox box;
  const float gap = margin(ui);
  box.position = {canvasWidth(ui) / 2, canvasHeight(ui) - 2 * gap - barHeight(ui)};
  box.anchor = {0.5f, 1};
  box.width = std::min(canvasWidth(ui) - 2 * gap, 420.0f);
  box.max_height = canvasHeight(ui) * 0.55f;
  box.touch = ui.touch();
  if (lowCanvas(ui)) {
    box.position.x = canvasWidth(ui) - gap;
    box.anchor.x = 1;
    box.width = std::min(box.width, std::max(canvasWidth(ui) / 2, 344.0f));
    box.max_height = canvasHeight(ui) - barHeight(ui) - 3 * gap;
  }
  return box;
}

/// A column at the right, below the view buttons.
inline PanelBox columnBox(const UiState& ui) {
  PanelBox box;
  const float top = 3 * margin(ui) + gizmoSide(ui) + barHeight(ui);
  box.position = {canvasWidth(ui) - margin(ui), top};
  box.anchor = {1, 0};
  box.width = ui.touch() ? 316.0f : 284.0f;
  box.max_height = std::max(canvasHeight(ui) - top - 2 * margin(ui) - barHeight(ui), 120.0f);
  box.touch = ui.touch();
  return box;
}

/// A column at the left, beside the tools.
inline PanelBox leftColumnBox(const UiState& ui, float width) {
  PanelBox box;
  box.position = {2 * margin(ui) + barHeight(ui), 2 * margin(ui) + barHeight(ui)};
  box.width = width;
  box.max_height = std::max(canvasHeight(ui) - 4 * margin(ui) - 2 * barHeight(ui), 120.0f);
  box.touch = ui.touch();
  return box;
}

/// Height of a row that can be pressed.
inline float rowHeight(const UiState& ui) { return ui.touch() ? 44.0f : 34.0f; }

/// The title of a panel and the button that closes it; true when it is pressed.
bool titleRow(const char* title, const UiState& ui);

}  // namespace marrow
