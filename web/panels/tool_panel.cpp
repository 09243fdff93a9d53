// The tools, and how new strokes are placed.
#include <array>
#include <string>

#include "document/symmetry.h"
#include "icons.h"
#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {
namespace {

struct ToolButton {
  ToolKind tool;
  const char* icon;
  const char* tooltip;
};

const std::array<ToolButton, 6> kTools{{
    {ToolKind::draw, kIconPencil, "Draw a part  (B)"},
    {ToolKind::select, kIconMousePointer2,
     "Select, move, turn and scale  (V)\nDrag a part to move it, drag beside it for a box."},
    {ToolKind::redraw, kIconPenLine, "Draw over a stretch of an outline to replace it  (C)"},
    {ToolKind::reshape, kIconSpline, "Drag an outline to bend it  (C again)"},
    {ToolKind::line, kIconSquareCenterlineDashedHorizontal,
     "Draw the line of symmetry  (L)\nA half outline drawn along it becomes a whole one."},
    {ToolKind::pose, kIconPersonStanding, "Pose the character by its bones  (P)"},
}};

char keyOf(ToolKind tool) {
  switch (tool) {
    case ToolKind::draw:
      return 'b';
    case ToolKind::select:
      return 'v';
    case ToolKind::redraw:
      return 'c';
    case ToolKind::reshape:
      return 'C';
    case ToolKind::line:
      return 'l';
    case ToolKind::pose:
      return 'p';
  }
  return 0;
}

float height(const UiState& ui) {
  return (kTools.size() + 2) * (buttonSide(ui) + 2) + 7 + kBarPadding;
}

bool sheetReaches(float y) {
  for (const char* name : {"part", "parts", "refine", "pose"}) {
    const auto sheet = panelSpan(name);
    if (sheet && sheet->top < y) return true;
  }
  return false;
}

}  // namespace

const char* toString(ToolKind tool) {
  switch (tool) {
    case ToolKind::draw:
      return "draw";
    case ToolKind::select:
      return "select";
    case ToolKind::redraw:
      return "redraw";
    case ToolKind::reshape:
      return "reshape";
    case ToolKind::line:
      return "line";
    case ToolKind::pose:
      return "pose";
  }
  return "";
}

void drawToolPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  PanelBox box;
  box.position = {margin(ui), 2 * margin(ui) + barHeight(ui)};
  const bool sheets_below = ui.narrow() && !lowCanvas(ui);
  if (sheets_below && (ui.open.anySheet() || sheetReaches(box.position.y + height(ui)))) {
    return;  // it needs the room
  }
  box.bar = true;
  beginPanel("tools", box);
  const float side = buttonSide(ui);
  const bool two_columns = lowCanvas(ui);
  int count = 0;
  const auto next = [&] {
    if (two_columns && count % 2 == 1) ImGui::SameLine();
    ++count;
  };
  for (const ToolButton& button : kTools) {
    next();
    ButtonLook look{button.tooltip};
    look.on = ui.tool == button.tool;
    if (iconButton(toString(button.tool), button.icon, side, look)) {
      requests.key = keyOf(button.tool);
    }
  }
  if (!two_columns) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({at.x + 6, at.y + 3}, {at.x + side - 6, at.y + 3},
                                        Theme::kHairline);
    ImGui::Dummy({side, 7});
  }
  next();
  ButtonLook look{ui.symmetry ? "Symmetry is on: limbs get a twin on the other side  (M)"
                              : "Symmetry is off: every stroke is one part  (M)"};
  look.on = ui.symmetry;
  if (iconButton("symmetry", kIconFlipVertical2, side, look)) requests.key = 'm';
  next();
  look = {ui.through_selected ? "New parts lie as deep as the selected ones"
                              : "New parts begin on the surface they are drawn on.\nPress to draw "
                                "as deep as the selected part instead, or hold Shift."};
  look.on = ui.through_selected;
  look.enabled = ui.through_selected || !ui.selection.empty();
  if (iconButton("depth", kIconLayers, side, look)) {
    ui.through_selected = !ui.through_selected;
    requests.again = true;
  }
  (void)input;
  endPanel();
}

}  // namespace marrow
