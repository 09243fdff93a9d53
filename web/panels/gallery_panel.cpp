// The samples, each with its picture.
#include <algorithm>
#include <string>

#include "icons.h"
#include "panels/menu_rows.h"
#include "panels/panel.h"
#include "samples.h"

namespace marrow {

void drawGalleryPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.gallery || input.drawing) return;
  beginPanel("gallery", menuBox(ui, 440));
  if (titleRow("Samples", ui)) {
    ui.open.gallery = false;
    requests.again = true;
  }
  softText("Open one and play with it. Undo brings your drawing back.");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(4, 4));
  const float available = ImGui::GetContentRegionAvail().x;
  const int columns = std::max(2, static_cast<int>(available / 130));
  const float width =
      (available - 4 * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  int index = 0;
  for (const Sample& sample : samples()) {
    if (index++ % columns != 0) ImGui::SameLine();
    const std::string file(sample.file), name(sample.name);
    const Thumbnail* thumbnail = input.shelf.thumbnails.find(file);
    if (!thumbnail) requests.files.push_back({FileAction::Kind::thumbnail, file});
    ImGui::PushID(index);
    if (thumbnailCard("sample", thumbnail, name.c_str(), width)) {
      requests.files.push_back({FileAction::Kind::sample, file});
      ui.open.gallery = false;
      requests.again = true;
    }
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  endPanel();
}

}  // namespace marrow
