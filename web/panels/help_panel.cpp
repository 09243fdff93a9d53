// What hands and keys do.
#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {
namespace {

void entry(const char* what, const char* how) {
  ImGui::TextUnformatted(what);
  ImGui::SameLine(104);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 4));
  softText(how);
  ImGui::PopStyleVar();
}

}  // namespace

void drawHelpPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.help || input.drawing) return;
  PanelBox box = sheetBox(ui);
  if (!ui.narrow()) {
    box.position = {margin(ui), 2 * margin(ui) + barHeight(ui)};
    box.anchor = {0, 0};
    box.width = 360;
    box.max_height = canvasHeight(ui) - 4 * margin(ui) - 2 * barHeight(ui);
  }
  beginPanel("help panel", box);
  if (titleRow("How it works", ui)) {
    ui.open.help = false;
    requests.again = true;
  }
  softText("Draw a closed shape: it becomes a body with bones. Draw more to add parts.");
  entry("Draw",
        "drag with the left button, one finger or a pen; from another view, drawing turns "
        "back to the front");
  entry("Select", "click or tap a part");
  entry("Turn",
        "right button or Alt and drag; twist two fingers; drag three fingers; or drag the "
        "ball in the corner");
  entry("Move", "middle button, or drag two fingers");
  entry("Zoom", "wheel, or pinch");
  entry("Views", "1 front, 3 right, 7 top, F everything");
  entry("Undo", "Ctrl Z, redo: Shift Ctrl Z or Ctrl Y");
  entry("Delete", "X or Delete");
  entry("Cancel", "Esc gives up the stroke under your hand");
  endPanel();
}

}  // namespace marrow
