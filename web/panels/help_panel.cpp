// What hands and keys do.
#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {
namespace {

struct Entry {
  const char *what, *how;
};

constexpr Entry kFingers[] = {
    {"Draw", "one finger or a pen, with the pencil"},
    {"Select", "tap a part or a bone"},
    {"Look around", "twist two fingers, drag three, or drag the ball in the corner"},
    {"Zoom", "pinch; drag two fingers to move the view"},
    {"Move a part", "the arrow tool: drag the part, or its handles to turn and scale it"},
    {"Outline", "the third tool: draw over a stretch of the selected part; the fourth: drag it"},
    {"Symmetry", "the mirror below the tools: limbs get a twin on the other side"},
    {"Line", "the fifth tool: the line of symmetry; half a shape along it is completed"},
    {"Pose", "the figure below the tools: drag a limb or a joint; drag beside it to look around"},
    {"Export", "the menu at the top left: a file for Blender, games or 3D printing"},
    {"Undo", "the arrow at the top left; every step comes back"},
};
constexpr Entry kDrawing[] = {
    {"Draw  B", "drag a closed shape, from any side"},
    {"Shift", "held at the start of a stroke: as deep as the selected part"},
    {"Outline  C", "draw over a stretch of the selected part; C again: drag its points"},
    {"Symmetry  M", "limbs get a twin on the other side"},
    {"Line  L", "draw the line of symmetry; half a shape along it is completed"},
    {"Esc", "gives up what is under your hand, then lets go of the selection"},
    {"Undo  Ctrl Z", "redo: Shift Ctrl Z or Ctrl Y"},
};
constexpr Entry kParts[] = {
    {"Select  V", "click; Shift click adds; drag beside the parts for a box; Ctrl A: all"},
    {"Move  G", "then X, Y or Z for an axis, a number, Enter; Esc or right click: never mind"},
    {"Turn  R", "the same"},
    {"Scale  S", "the same"},
    {"Copy", "Shift D"},
    {"Layer  [  ]", "behind or in front of the next part"},
    {"Hide  H", "Shift H shows everything"},
    {"Delete  X", "or the Delete key"},
};
constexpr Entry kPosing[] = {
    {"Pose  P", "drag a joint or a limb; drag beside the character to look around"},
    {"Turn  T", "drags turn the bone instead of pulling the limb; R, G: the chosen joint"},
    {"Pin  N", "the chosen joint stays where it is"},
    {"Weights  W", "what each bone holds"},
};
constexpr Entry kFiles[] = {
    {"Open", "Ctrl O, or drop a file on the canvas: a drawing or a 3D model"},
    {"Save", "Ctrl S; Shift Ctrl S: in another file"},
    {"Export", "in the menu at the top left: a file for Blender, games or 3D printing"},
};
constexpr Entry kLooking[] = {
    {"Turn", "right button, or Alt and drag, or the ball in the corner"},
    {"Move", "middle button"},
    {"Zoom", "wheel"},
    {"Views", "1 front, 3 right, 7 top"},
    {"Everything", "F or Home"},
};

template <size_t n>
void section(const char* title, const Entry (&entries)[n], float indent) {
  ImGui::Dummy({0, 2});
  heading(title);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 5));
  for (const Entry& entry : entries) {
    const float left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(entry.what);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + indent);
    softText(entry.how);
  }
  ImGui::PopStyleVar();
}

}  // namespace

void drawHelpPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.help || input.drawing) return;
  const bool two_columns = canvasWidth(ui) >= 1180 && !ui.touch();
  const bool fingers_only = ui.narrow() && ui.last_pointer == PointerKind::touch;  // a phone
  const float indent = 104;
  const PanelBox box =
      ui.narrow() ? sheetBox(ui) : leftColumnBox(ui, two_columns ? 760.0f : 400.0f);
  beginPanel("help panel", box);
  if (titleRow("How it works", ui)) {
    ui.open.help = false;
    requests.again = true;
  }
  softText(
      "Draw a closed shape: it becomes a body with bones. Draw more: parts that touch become "
      "one creature.");
  if (ui.touch()) section("With fingers", kFingers, indent);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(12, 2));
  if (two_columns && ImGui::BeginTable("columns", 2, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    section("Drawing", kDrawing, indent);
    section("Posing", kPosing, indent);
    section("Files", kFiles, indent);
    ImGui::TableNextColumn();
    section("Parts", kParts, indent);
    section("Looking", kLooking, indent);
    ImGui::EndTable();
  } else if (!two_columns && !fingers_only) {
    section("Drawing", kDrawing, indent);
    section("Parts", kParts, indent);
    section("Posing", kPosing, indent);
    section("Looking", kLooking, indent);
    section("Files", kFiles, indent);
  }
  ImGui::PopStyleVar();
  endPanel();
}

}  // namespace marrow
