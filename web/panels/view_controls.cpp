// How the model is looked at: the ball that turns it, the standard views, what is shown.
#include <array>
#include <cmath>

#include "icons.h"
#include "panels/layout.h"
#include "panels/sections.h"

namespace marrow {
namespace {

struct Switch {
  const char* id;
  const char* icon;
  const char* label;
  const char* tooltip;
  bool ViewSwitches::*shown;
};

const std::array<Switch, 5> kSwitches{{
    {"mesh", kIconBox, "Body", "Body: the inflated surface", &ViewSwitches::mesh},
    {"wireframe", kIconGrid3x3, "Wireframe", "Wireframe: the triangles of the surface",
     &ViewSwitches::wireframe},
    {"bones", kIconBone, "Bones", "Bones: what will move the body", &ViewSwitches::bones},
    {"straightSkeleton", kIconSplit, "Straight skeleton",
     "Straight skeleton: the lines the bones come from", &ViewSwitches::straight_skeleton},
    {"proxy", kIconCircleDot, "Balls and cones",
     "Balls and cones: the simple stand-in of the body around its bones", &ViewSwitches::proxy},
}};

struct ViewButton {
  StandardView view;
  const char* label;
  const char* tooltip;
};

const std::array<ViewButton, 3> kViews{{
    {StandardView::front, "Front", "Look from the front  (1)"},
    {StandardView::right, "Right", "Look from the right  (3)"},
    {StandardView::top, "Top", "Look from above  (7)"},
}};

void drawViewButtons(const UiState& ui, Requests& requests) {
  const Camera& camera = ui.glide.running() ? ui.glide.destination() : ui.camera;
  const auto current = standardView(camera);
  for (const ViewButton& button : kViews) {
    if (&button != kViews.data()) ImGui::SameLine();
    ButtonLook look{button.tooltip};
    look.on = current == button.view;
    look.width = ui.narrow() ? 48.0f : 56.0f;
    if (textButton(toString(button.view), button.label, buttonSide(ui), look)) {
      requests.view = button.view;
    }
  }
}

// The three directions as short arms around a ball; drag it to turn the view.
void drawGizmo(UiState& ui, Requests& requests) {
  const float side = gizmoSide(ui);
  ImGui::SetNextWindowPos({canvasWidth(ui) - margin(ui), margin(ui)}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowSize({side, side});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("gizmo", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::InvisibleButton("turn", {side, side});
  notePlace("turn");
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const ImVec2 drag = ImGui::GetIO().MouseDelta;
  if (held) requests.orbit_px = {drag.x, drag.y};
  if (!held) tooltipForLastItem("Drag to turn the view.\nOr drag with the right mouse button.");

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 at{low.x + side / 2, low.y + side / 2};
  const float radius = side / 2 - 1;
  list.AddCircleFilled(at, radius, held || hovered ? Theme::kPress : Theme::kHover, 48);

  struct Arm {
    Vec3 direction;
    const char* label;
    ImU32 color;
  };
  const auto [right, up, back] = ui.camera.axes();
  const auto toView = [&, r = right, u = up, b = back](Vec3 v) {
    return Vec3{dot(r, v), dot(u, v), dot(b, v)};
  };
  std::array<Arm, 3> arms{{{toView({1, 0, 0}), "R", IM_COL32(196, 84, 40, 255)},
                           {toView({0, 1, 0}), "T", IM_COL32(46, 132, 96, 255)},
                           {toView({0, 0, 1}), "F", IM_COL32(37, 99, 174, 255)}}};
  std::sort(arms.begin(), arms.end(),
            [](const Arm& a, const Arm& b) { return a.direction.z < b.direction.z; });
  const float reach = radius - 13;
  for (const Arm& arm : arms) {
    const ImVec2 tip{at.x + static_cast<float>(arm.direction.x) * reach,
                     at.y - static_cast<float>(arm.direction.y) * reach};
    list.AddLine(at, tip, arm.color, 2);
    list.AddCircleFilled(tip, 10, arm.color, 24);
    const ImVec2 extent = ImGui::CalcTextSize(arm.label);
    list.AddText({tip.x - extent.x / 2, tip.y - extent.y / 2}, IM_COL32_WHITE, arm.label);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void drawSwitches(UiState& ui, Requests& requests) {
  for (const Switch& item : kSwitches) {
    if (&item != kSwitches.data()) ImGui::SameLine();
    ButtonLook look{item.tooltip};
    look.on = ui.show.*item.shown;
    if (iconButton(item.id, item.icon, buttonSide(ui), look)) {
      ui.show.*item.shown = !(ui.show.*item.shown);
      requests.again = true;
    }
  }
}

// What opens and closes a panel where there is room for several.
void panelButton(const char* id, const char* icon, bool PanelsOpen::*which, ButtonLook look,
                 UiState& ui, Requests& requests) {
  look.on = ui.open.*which;
  if (!iconButton(id, icon, buttonSide(ui), look)) return;
  ui.open.*which = !(ui.open.*which);
  requests.again = true;
}

// The thresholds have a panel of their own, or stand in the selected part's as long as that is
// there.
void bonesButton(const PanelInput& input, UiState& ui, Requests& requests) {
  const bool in_part = partPanelShows(input, ui);
  ButtonLook look{"More bones or fewer"};
  look.on = ui.open.skeleton || (in_part && ui.open.bones);
  if (!iconButton("skeleton", kIconSlidersHorizontal, buttonSide(ui), look)) return;
  ui.open.skeleton = !look.on;
  if (in_part) ui.open.bones = false;
  requests.again = true;
}

void drawWide(const PanelInput& input, UiState& ui, Requests& requests) {
  PanelBox box;
  box.bar = true;
  box.anchor = {1, 0};
  box.position = {canvasWidth(ui) - margin(ui), 2 * margin(ui) + gizmoSide(ui)};
  beginPanel("views", box);
  drawViewButtons(ui, requests);
  endPanel();

  box.anchor = {0, 1};
  box.position = {margin(ui), canvasHeight(ui) - margin(ui)};
  beginPanel("switches", box);
  drawSwitches(ui, requests);
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine({at.x + 3, at.y + 6}, {at.x + 3, at.y + buttonSide(ui) - 6},
                                      Theme::kHairline);
  ImGui::Dummy({7, buttonSide(ui)});
  ImGui::SameLine();
  panelButton("parts", kIconListTree, &PanelsOpen::parts, {"All parts, and what hangs on what"}, ui,
              requests);
  ImGui::SameLine();
  panelButton("picture", kIconImage, &PanelsOpen::picture,
              {"Picture to draw after, behind this view"}, ui, requests);
  ImGui::SameLine();
  bonesButton(input, ui, requests);
  endPanel();

  box.anchor = {1, 1};
  box.position = {canvasWidth(ui) - margin(ui), canvasHeight(ui) - margin(ui)};
  beginPanel("performance button", box);
  panelButton("performance", kIconGauge, &PanelsOpen::performance,
              {"How long the last stroke took"}, ui, requests);
  endPanel();
}

PanelsOpen noPanels() {
  PanelsOpen open;
  open.part = false;
  return open;
}

// One sheet at a time.
void sheetButton(const char* id, const char* icon, bool PanelsOpen::*which, ButtonLook look,
                 UiState& ui, Requests& requests) {
  look.on = ui.open.*which && look.enabled;
  if (!iconButton(id, icon, buttonSide(ui), look)) return;
  const bool opens = !(ui.open.*which);
  ui.open = noPanels();
  ui.open.*which = opens;
  requests.again = true;
}

void drawNarrow(const PanelInput& input, UiState& ui, Requests& requests) {
  PanelBox box;
  box.bar = true;
  box.anchor = {0.5f, 1};
  box.position = {canvasWidth(ui) / 2, canvasHeight(ui) - margin(ui)};
  beginPanel("lower bar", box);
  drawViewButtons(ui, requests);
  ImGui::SameLine();
  sheetButton("view", kIconEye, &PanelsOpen::view, {"What is shown"}, ui, requests);
  ImGui::SameLine();
  if (ui.tool == ToolKind::pose) {
    sheetButton("poses", kIconPersonStanding, &PanelsOpen::pose, {"Poses"}, ui, requests);
  } else {
    ButtonLook look{"The selected part"};
    look.enabled = input.shown.find(sourceId(ui.selection.primary())).has_value();
    sheetButton("part", kIconSlidersHorizontal, &PanelsOpen::part, look, ui, requests);
  }
  ImGui::SameLine();
  sheetButton("parts", kIconListTree, &PanelsOpen::parts, {"All parts"}, ui, requests);
  ImGui::SameLine();
  sheetButton("help", kIconCircleQuestionMark, &PanelsOpen::help, {"How it works"}, ui, requests);
  endPanel();

  if (!ui.open.view) return;
  beginPanel("view sheet", sheetBox(ui));
  if (titleRow("Show", ui)) {
    ui.open.view = false;
    requests.again = true;
  }
  for (const Switch& item : kSwitches) {
    if (switchRow(item.id, item.icon, item.label, ui.show.*item.shown, 44)) {
      ui.show.*item.shown = !(ui.show.*item.shown);
      requests.again = true;
    }
  }
  const auto other = [&](const char* id, const char* icon, const char* text,
                         bool PanelsOpen::*which) {
    if (!disclosure(id, icon, text, "", false, 44)) return;
    ui.open = noPanels();
    ui.open.*which = true;
    requests.again = true;
  };
  ImGui::Separator();
  other("picture", kIconImage, "Picture to draw after", &PanelsOpen::picture);
  other("skeleton", kIconSlidersHorizontal, "More bones or fewer", &PanelsOpen::skeleton);
  other("performance", kIconGauge, "How long the last stroke took", &PanelsOpen::performance);
  endPanel();
}

}  // namespace

void drawViewControls(const PanelInput& input, UiState& ui, Requests& requests) {
  const PanelsOpen& open = ui.open;
  const bool covered =
      lowCanvas(ui) && (open.part || open.parts || open.skeleton || open.anySheet());
  if (!covered) drawGizmo(ui, requests);
  if (ui.narrow()) {
    drawNarrow(input, ui, requests);
  } else {
    drawWide(input, ui, requests);
  }
}

}  // namespace marrow
