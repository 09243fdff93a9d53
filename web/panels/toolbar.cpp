// The drawing's sheet, undo, redo, new drawing, help.
#include <string>

#include "icons.h"
#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {

void drawToolbar(const PanelInput& input, UiState& ui, Requests& requests) {
  PanelBox box;
  box.position = {margin(ui), margin(ui)};
  box.bar = true;
  beginPanel("toolbar", box);
  const float side = buttonSide(ui);
  const History& history = input.history;

  ButtonLook look{ui.open.file ? "" : "Open, save, export, samples and recent drawings"};
  look.on = ui.open.file;
  if (iconButton("file", kIconMenu, side, look)) {
    if (ui.open.file) {
      ui.open.file = false;
    } else {
      ui.openOnly(&PanelsOpen::file);
    }
    requests.again = true;
  }

  ImGui::SameLine();
  const std::string undo = "Undo: " + history.undoName() + "  (Ctrl Z)";
  look = {history.canUndo() ? undo.c_str() : "Nothing to undo  (Ctrl Z)"};
  look.enabled = history.canUndo();
  if (iconButton("undo", kIconUndo2, side, look)) requests.undo = true;

  ImGui::SameLine();
  const std::string redo = "Redo: " + history.redoName() + "  (Shift Ctrl Z)";
  look = {history.canRedo() ? redo.c_str() : "Nothing to redo  (Shift Ctrl Z)"};
  look.enabled = history.canRedo();
  if (iconButton("redo", kIconRedo2, side, look)) requests.redo = true;

  ImGui::SameLine();
  look = {"New drawing. Undo brings this one back."};
  look.enabled = !input.shelf.keeping.empty();
  if (iconButton("new", kIconFilePlus, side, look)) {
    requests.files.push_back({FileAction::Kind::begin, {}});
  }

  ImGui::SameLine();
  look = {"Show everything  (F or Home)"};
  if (iconButton("frame", kIconScan, side, look)) requests.frame_all = true;

  if (!ui.narrow()) {
    ImGui::SameLine();
    look = {"How it works  (?)"};
    look.on = ui.open.help;
    if (iconButton("help", kIconCircleQuestionMark, side, look)) {
      ui.open.help = !ui.open.help;
      requests.again = true;
    }
  }
  endPanel();
}

}  // namespace marrow
