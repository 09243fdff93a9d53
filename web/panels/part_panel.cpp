// The selected part: its name, thickness, bones and colour.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "icons.h"
#include "panels/layout.h"
#include "panels/panel.h"

namespace marrow {
namespace {

constexpr float kMark = 0.5f;  // where both sliders have their default
constexpr size_t kColors = 8;
// ε_s from the slider's left end, few bones, to its right one; the default lies in the middle.
constexpr double kFewBones = 60, kManyBones = 0.5;

// Two stretches of a logarithmic scale that meet at the default.
double fromSlider(float t, double low, double middle, double high) {
  return t < kMark ? low * std::pow(middle / low, t / kMark)
                   : middle * std::pow(high / middle, (t - kMark) / (1 - kMark));
}

float toSlider(double value, double low, double middle, double high) {
  const bool lower = (value - middle) * (high - low) < 0;
  const double t = lower ? kMark * std::log(value / low) / std::log(middle / low)
                         : kMark + (1 - kMark) * std::log(value / middle) / std::log(high / middle);
  return static_cast<float>(std::clamp(t, 0.0, 1.0));
}

// Left and right of a slider's name: what its ends mean.
void sliderTitle(const char* name, const char* ends) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
  heading(name);
  const float width = ImGui::CalcTextSize(ends).x;
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  softText(ends);
  ImGui::PopStyleVar();
}

// The part's name, which can be changed, and the buttons that delete the part and close the panel.
void drawTitle(const PartSource& part, UiState& ui, Requests& requests) {
  const float side = ui.touch() ? 44.0f : 34.0f;
  const ImVec2 at = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  std::array<char, 128> text{};
  part.name.copy(text.data(), text.size() - 1);
  ImGui::SetCursorPosY(at.y + (side - ImGui::GetFrameHeight()) / 2);
  ImGui::SetNextItemWidth(width - 2 * side - 8);
  ImGui::PushID(part.id.c_str());
  if (ImGui::InputText("##name", text.data(), text.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll) ||
      ImGui::IsItemDeactivatedAfterEdit()) {
    const std::string name = text.data();
    if (!name.empty() && name != part.name && requests.commands.empty()) {
      requests.commands.push_back(RenamePart{part.id, name});
    }
  }
  ImGui::PopID();
  notePlace("name");
  tooltipForLastItem("The part's name");

  ImGui::SetCursorPos({at.x + width - 2 * side, at.y});
  ButtonLook look{"Delete this part  (X or Delete)"};
  look.danger = true;
  if (iconButton("delete", kIconTrash2, side, look)) {
    requests.commands.push_back(DeleteParts{{part.id}});
  }
  ImGui::SetCursorPos({at.x + width - side, at.y});
  if (iconButton("close", kIconX, side, {"Close  (Esc)"})) {
    if (ui.narrow()) {
      ui.open.part = false;
    } else {
      ui.selection.clear();
    }
    requests.again = true;
  }
  ImGui::SetCursorPos({at.x, at.y + side + 8});
}

void drawSliders(const PartSource& part, UiState& ui, Requests& requests) {
  const float height = ui.touch() ? 44.0f : 32.0f;
  sliderTitle("Thickness", "flat \xE2\x86\x92 fat");
  float t = toSlider(part.thickness, kMinThickness, 1, kMaxThickness);
  SliderEvent event = slider("thickness", t, kMark, height);
  tooltipForLastItem("How thick the part is compared to its width");
  if (event.changed) {
    ui.edit = PendingEdit{SetThickness{{part.id}, fromSlider(t, kMinThickness, 1, kMaxThickness)}};
  }
  if (event.released) requests.commit_edit = true;
  requests.again |= event.changed || event.released;

  sliderTitle("Bones", "fewer \xE2\x86\x92 more");
  const double standard = JointOptions().epsilon_s;
  t = toSlider(part.refine.simplify.value_or(standard), kFewBones, standard, kManyBones);
  event = slider("bones", t, kMark, height);
  tooltipForLastItem(
      "More bones follow the drawing more closely, fewer are easier to pose "
      "(simplification \xCE\xB5)");
  if (event.changed) {
    SetRefinement simplify{{part.id}, {}, &Refinement::simplify, std::nullopt};
    if (t != kMark) simplify.value = fromSlider(t, kFewBones, standard, kManyBones);
    ui.edit = PendingEdit{simplify};
  }
  if (event.released) requests.commit_edit = true;
  requests.again |= event.changed || event.released;
}

void drawColors(const PartSource& part, const UiState& ui, Requests& requests) {
  heading("Colour");
  const float side = ui.touch() ? 44.0f : 32.0f;
  const float width = ImGui::GetContentRegionAvail().x;
  const auto per_row = std::max<size_t>(1, static_cast<size_t>(width / side));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (size_t i = 0; i < kColors; ++i) {
    const Color color = partColor(i);
    if (i > 0 && color == partColor(0)) break;  // they begin again
    if (i % per_row != 0) ImGui::SameLine();
    ImGui::PushID(static_cast<int>(i));
    const bool chosen = color == part.color;
    if (swatch("color", color, chosen, side) && !chosen) {
      requests.commands.push_back(SetColor{{part.id}, color});
    }
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
}

}  // namespace

void drawPartPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  const auto index = input.shown.find(sourceId(ui.selection.primary()));
  if (!index || !ui.open.part || input.drawing) return;
  const PartSource& part = *input.shown.parts[*index];
  beginPanel("part", ui.narrow() ? sheetBox(ui) : columnBox(ui));
  drawTitle(part, ui, requests);
  drawSliders(part, ui, requests);
  drawColors(part, ui, requests);
  endPanel();
}

}  // namespace marrow
