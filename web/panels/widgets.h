// The few controls that all panels are made of.
#pragma once

#include <functional>
#include <vector>

#include "document/document.h"
#include "panels/theme.h"

namespace marrow {

/// A floating panel that fits its contents. anchor: which of its points lies at `position`
/// (0, 0: top left; 1, 1: bottom right). width 0: as wide as the contents.
struct PanelBox {
  ImVec2 position, anchor;
  float width = 0;
  float max_height = 0;  // 0: no limit; else it scrolls
  bool bar = false;      // a row of buttons, with less room around them
};
void beginPanel(const char* name, const PanelBox& box);
void endPanel();

struct ButtonLook {
  const char* tooltip = "";
  bool enabled = true;
  bool on = false;      // a switch that is on
  float width = 0;      // 0: square, or as wide as the text
  bool danger = false;  // takes something away
};
bool iconButton(const char* id, const char* icon, float side, const ButtonLook& look);
bool textButton(const char* id, const char* text, float height, const ButtonLook& look);
/// A row: icon, words, and whether it is on.
bool switchRow(const char* id, const char* icon, const char* text, bool on, float height);

struct SliderEvent {
  bool changed = false, released = false;
};
/// value: 0 … 1. mark: where the default lies. width 0: all there is.
SliderEvent slider(const char* id, float& value, float mark, float height, float width = 0);

/// One of the colours to choose from.
bool swatch(const char* id, Color color, bool chosen, float side);

void heading(const char* text);
void softText(const char* text);  // wrapped, in a quieter colour

/// Where a widget of this frame lies, in CSS pixels: for who wants to point at it from outside.
struct WidgetPlace {
  const char *panel, *id;
  ImVec2 low, high;
};
const std::vector<WidgetPlace>& widgetPlaces();
/// Adds the last item.
void notePlace(const char* id);
void forgetPlaces();

/// The tooltip of the last item, beside it and not under the finger.
void tooltipForLastItem(const char* text);
/// A tooltip is waiting to be shown: frames are needed until then.
bool tooltipIsDue();

}  // namespace marrow
