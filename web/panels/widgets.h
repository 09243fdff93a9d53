// The few controls that all panels are made of.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "panels/theme.h"

namespace marrow {

/// A floating panel that fits its contents. anchor: which of its points lies at `position`
/// (0, 0: top left; 1, 1: bottom right). width 0: as wide as the contents. Where its contents are
/// higher than it, fingers drag them.
struct PanelBox {
  ImVec2 position, anchor;
  float width = 0;
  float max_height = 0;        // 0: no limit; else it scrolls
  bool bar = false;            // a row of buttons, with less room around them
  bool touch = false;          // for fingers
  bool drawn_through = false;  // pointers go to the canvas below
};
void beginPanel(const char* name, const PanelBox& box);
void endPanel();
/// Where a panel lies, if it was there in the last frame.
struct PanelSpan {
  float left, top, right, bottom;
};
std::optional<PanelSpan> panelSpan(const char* name);
/// A stretch of a panel that scrolls by itself; both are called always.
void beginScrolling(const char* name, float height, bool touch);
void endScrolling();

struct ButtonLook {
  const char* tooltip = "";
  bool enabled = true;
  bool on = false;      // a switch that is on
  float width = 0;      // 0: square, or as wide as the text
  bool danger = false;  // takes something away
  bool raised = false;  // has a ground of its own
  bool quiet = false;   // pale until the pointer is there
};
bool iconButton(const char* id, const char* icon, float side, const ButtonLook& look);
bool textButton(const char* id, const char* text, float height, const ButtonLook& look);
/// A row: icon, words, and whether it is on.
bool switchRow(const char* id, const char* icon, const char* text, bool on, float height);

/// A row that opens and closes what is below it; true when it is pressed.
bool disclosure(const char* id, const char* icon, const char* text, const char* note, bool open,
                float height);

/// One of a few, side by side. Ids and labels, two at least. Gives the one that is pressed, else
/// `current`.
struct Choice {
  const char *id, *label;
};
size_t choices(const std::vector<Choice>& all, size_t current, float height);

struct SliderEvent {
  bool changed = false, released = false;
  bool reset = false;  // a double click: back to the mark
};
/// value: 0 … 1. mark: where the default lies. width 0: all that is there.
SliderEvent slider(const char* id, float& value, float mark, float height, float width = 0);

/// A field for one line of text that belongs to `owner`. Gives what was typed, once, when the user
/// is done with it: by Enter or by anything else that takes the field away from the keyboard. Esc
/// gives it up.
std::optional<std::string> textField(const char* id, const std::string& owner,
                                     const std::string& text, const char* hint, float width);
struct TypedText {
  std::string owner, text;
};
/// What was typed in a field of that panel that is gone since, with its panel or with its owner.
std::optional<TypedText> leftText(const char* panel);

/// One of the colours to choose from.
bool swatch(const char* id, Color color, bool chosen, float side);

/// An icon with its middle there.
void iconAt(const char* icon, ImVec2 at, ImU32 color);
/// Cut off with three dots where it is too wide.
void fittingText(const char* text, ImVec2 at, float width, ImU32 color);

void heading(const char* text);
/// A bold name with a quieter note right of it, at the end of the line.
void headingWithNote(const char* text, const char* note);
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
