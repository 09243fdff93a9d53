// The drawing as a whole: its name, its file, samples and kept drawings; and the offer to go on
// with one of those.
#include <algorithm>
#include <array>
#include <string>

#include "icons.h"
#include "panels/menu_rows.h"
#include "panels/panel.h"

namespace marrow {
namespace {

using Kind = FileAction::Kind;

std::string inWords(const Recent& recent, const PanelInput& input, const UiState& ui) {
  const double since_s = (ui.now_ms - input.shelf.keeping.recentSince_ms()) / 1000;
  return ageInWords(recent.age_s + since_s);
}

const char* nameOf(const Recent& recent) {
  return recent.name.empty() ? Keeping::kNoName : recent.name.c_str();
}

/// Of a kept drawing; asked for where it is not there yet.
const Thumbnail* thumbnailOf(const Recent& recent, const PanelInput& input, UiState& ui,
                             Requests& requests) {
  const Thumbnail* thumbnail = input.shelf.thumbnails.find(recent.key());
  if (!thumbnail && ui.peeked.insert(recent.key()).second) {
    requests.files.push_back({Kind::peek, recent.slot});
  }
  return thumbnail;
}

void rename(const Keeping& keeping, const std::string& name, Requests& requests) {
  if (!name.empty() && name != keeping.name()) requests.files.push_back({Kind::rename, name});
}

void drawName(const Keeping& keeping, UiState& ui, Requests& requests) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(10, (rowHeight(ui) - ImGui::GetFontSize()) / 2));
  const auto typed = textField("name", "", keeping.name(), "Name of the drawing",
                               ImGui::GetContentRegionAvail().x);
  ImGui::PopStyleVar();
  if (typed) rename(keeping, *typed, requests);
}

// Where the platform has no dialogs of its own: the path is typed.
void drawPath(const Keeping& keeping, UiState& ui, Requests& requests) {
  if (!ui.file_path_edited) {
    ui.file_path = keeping.place().empty() ? fileName(keeping.name()) + ".json" : keeping.place();
  }
  const float height = rowHeight(ui), width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({0, 2});
  heading("File");
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(10, (height - ImGui::GetFontSize()) / 2));
  std::array<char, 512> path{};
  ui.file_path.copy(path.data(), path.size() - 1);
  ImGui::SetNextItemWidth(width);
  ui.file_path_edited |= ImGui::InputTextWithHint("##path", "Folder and name", path.data(),
                                                  path.size(), ImGuiInputTextFlags_AutoSelectAll);
  notePlace("path");
  ui.file_path = path.data();
  ImGui::PopStyleVar();
  const float half = (width - 8) / 2;
  if (paleButton("open", "Open", half, height, "Opens the file with this path  (Ctrl O)")) {
    requests.files.push_back({Kind::open, ui.file_path});
    ui.file_path_edited = false;
  }
  ImGui::SameLine();
  if (paleButton("save", "Save", half, height, "Writes the drawing to this path  (Ctrl S)")) {
    requests.files.push_back({Kind::save_as, ui.file_path});
    ui.file_path_edited = false;
  }
}

void drawRecent(const PanelInput& input, UiState& ui, Requests& requests) {
  const Keeping& keeping = input.shelf.keeping;
  ImGui::Dummy({0, 2});
  heading("Recent drawings");
  if (!keeping.has_storage) {
    softText("This browser keeps nothing here: save your drawing in a file.");
    return;
  }
  if (keeping.recent().empty()) {
    softText("Drawings are kept by themselves and wait here, the last ten.");
    return;
  }
  for (const Recent& recent : keeping.recent()) {
    ImGui::PushID(recent.slot.c_str());
    if (thumbnailRow("recent", thumbnailOf(recent, input, ui, requests), nameOf(recent),
                     inWords(recent, input, ui).c_str(), 56)) {
      requests.files.push_back({Kind::restore, recent.slot});
      ui.open.file = false;
      requests.again = true;
    }
    ImGui::PopID();
  }
}

}  // namespace

void drawFilePanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.file || input.drawing) {
    ui.file_listed = false;
    if (const auto typed = leftText("file")) rename(input.shelf.keeping, typed->text, requests);
    return;
  }
  if (!ui.file_listed) {
    ui.file_listed = true;
    requests.files.push_back({Kind::list, {}});
  }
  const Keeping& keeping = input.shelf.keeping;
  beginPanel("file", menuBox(ui, 320));
  if (titleRow("Drawing", ui)) {
    ui.open.file = false;
    requests.again = true;
  }
  const float height = rowHeight(ui);
  drawName(keeping, ui, requests);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
  const auto row = [&](const char* id, const char* icon, const char* text, const char* keys,
                       Kind kind, bool enabled = true) {
    if (!menuRow(id, icon, text, ui.touch() ? "" : keys, height, enabled)) return;
    requests.files.push_back({kind, {}});
    if (kind != Kind::save) ui.open.file = false;
    requests.again = true;
  };
  row("new", kIconFilePlus, "New", "", Kind::begin, !keeping.empty());
  if (keeping.dialogs) {
    row("open", kIconFolderOpen, "Open\xE2\x80\xA6", "Ctrl O", Kind::open);
    row("save", kIconSave, "Save", "Ctrl S", Kind::save);
    row("save as", kIconSaveAll, "Save as\xE2\x80\xA6", "Shift Ctrl S", Kind::save_as);
  }
  if (menuRow("export", kIconDownload, "Export\xE2\x80\xA6", "GLB, OBJ, STL", height)) {
    ui.openOnly(&PanelsOpen::exporting);
    requests.again = true;
  }
  if (menuRow("samples", kIconShapes, "Samples", "", height)) {
    ui.openOnly(&PanelsOpen::gallery);
    requests.again = true;
  }
  ImGui::PopStyleVar();
  if (!keeping.dialogs) drawPath(keeping, ui, requests);
  drawRecent(input, ui, requests);
  endPanel();
}

void drawOffer(const PanelInput& input, UiState& ui, Requests& requests) {
  const Recent* offer = input.shelf.keeping.offer();
  const PanelsOpen& open = ui.open;
  if (!offer || input.drawing || open.file || open.gallery || open.picture || open.exporting) {
    return;
  }
  const Recent recent = *offer;
  const float side = ui.touch() ? 44.0f : 34.0f;
  PanelBox box;
  box.anchor = {0.5f, 0};
  box.width = 360;
  box.position = {canvasWidth(ui) / 2, margin(ui)};
  if (ui.narrow()) {  // between the tools, the ball and the invitation
    box.anchor.x = 1;
    box.width = std::min(canvasWidth(ui) - 3 * margin(ui) - barHeight(ui), box.width);
    box.position = {canvasWidth(ui) - margin(ui), 2 * margin(ui) + gizmoSide(ui)};
  }
  beginPanel("offer", box);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  thumbnailAt(thumbnailOf(recent, input, ui, requests), at, {at.x + 56, at.y + 42}, 6);
  ImGui::Dummy({56, 42});
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 3));
  heading("Go on with your drawing?");
  const std::string words = std::string(nameOf(recent)) + ", " + inWords(recent, input, ui);
  softText(shortened(words, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  const float width = (ImGui::GetContentRegionAvail().x - 8) / 2;
  if (paleButton("not now", "Not now", width, side, "It stays among the recent drawings")) {
    requests.files.push_back({Kind::dismiss, recent.slot});
  }
  ImGui::SameLine();
  if (accentButton("open", "Open", width, side)) {
    requests.files.push_back({Kind::restore, recent.slot});
  }
  endPanel();
}

}  // namespace marrow
