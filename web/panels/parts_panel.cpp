// All parts: what hangs on what, and a way to the hidden and locked ones.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "icons.h"
#include "panels/layout.h"
#include "panels/sections.h"

namespace marrow {
namespace {

struct Row {
  size_t part = 0;  // of the document
  int depth = 0;    // how far down its tree
  bool loose = false;
};

// Tree after tree, children below what they hang on, in modelling order. Twins stand for their
// parts, which could close a circle: whoever is left begins a tree.
std::vector<Row> rowsOf(const PanelInput& input) {
  const auto& placed = input.evaluation.placed();
  const size_t count = input.evaluation.parts().size();
  std::vector<size_t> parent(count, count);
  std::vector<char> held(count, 0);
  const auto hang = [&](size_t child, size_t on) {
    if (child >= placed.size() || on >= placed.size()) return;
    held[placed[child].source] = held[placed[on].source] = 1;
    if (placed[child].twin || placed[child].source == placed[on].source) return;
    parent[placed[child].source] = placed[on].source;
  };
  for (const Connection& connection : input.rig.connections) {
    hang(connection.child, connection.parent);
  }
  for (const auto& [part, joint] : input.rig.carried) {
    if (joint >= 0) hang(part, input.rig.joints[static_cast<size_t>(joint)].part);
  }
  std::vector<std::vector<size_t>> children(count);
  for (size_t i = 0; i < count; ++i) {
    if (parent[i] < count) children[parent[i]].push_back(i);
  }
  std::vector<Row> rows;
  std::vector<char> listed(count, 0);
  const auto list = [&](size_t first) {
    std::vector<Row> open{{first, 0, false}};
    while (!open.empty()) {
      Row row = open.back();
      open.pop_back();
      if (listed[row.part]) continue;
      listed[row.part] = 1;
      row.loose = count > 1 && !held[row.part];
      rows.push_back(row);
      const auto& below = children[row.part];
      for (auto child = below.rbegin(); child != below.rend(); ++child) {
        open.push_back({*child, row.depth + 1, false});
      }
    }
  };
  for (size_t i = 0; i < count; ++i) {
    if (parent[i] == count) list(i);
  }
  for (size_t i = 0; i < count; ++i) list(i);
  return rows;
}

class PartsPanel {
 public:
  PartsPanel(const PanelInput& input, UiState& ui, Requests& requests)
      : input_(input), ui_(ui), requests_(requests), side_(rowHeight(ui)) {}

  void draw() {
    const std::vector<Row> rows = rowsOf(input_);
    const PanelBox box = ui_.narrow() ? sheetBox(ui_) : leftColumnBox(ui_, 284);
    beginPanel("parts", box);
    const std::string title = rows.empty() ? "Parts" : counted(rows.size(), "part");
    if (titleRow(title.c_str(), ui_)) {
      ui_.open.parts = false;
      requests_.again = true;
    }
    if (rows.empty()) softText("Every shape you draw is listed here.");
    const float room = box.max_height - 2 * 14 - side_ - 12;
    const float wanted = static_cast<float>(rows.size()) * side_;
    if (!rows.empty()) {
      beginScrolling("rows", std::max(side_, std::min(wanted, room)), ui_.touch());
      ImGuiListClipper clipper;
      clipper.Begin(static_cast<int>(rows.size()), side_);
      while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
          row(rows[static_cast<size_t>(i)]);
        }
      }
      endScrolling();
    }
    endPanel();
  }

 private:
  bool selected(const PartSource& part) const {
    return std::any_of(ui_.selection.ids.begin(), ui_.selection.ids.end(),
                       [&](const std::string& id) { return sourceId(id) == part.id; });
  }

  void row(const Row& row) {
    const PartSource& part = *input_.shown.parts[row.part];
    ImGui::PushID(part.id.c_str());
    const float buttons = 2 * side_;
    const float width = ImGui::GetContentRegionAvail().x - buttons;
    ButtonLook look{row.loose ? "Hangs on nothing: move it until it touches another part" : ""};
    look.on = selected(part);
    look.width = width;
    if (textButton("row", "", side_, look)) choose(part);
    label(row, part, ImGui::GetItemRectMin(), width);
    ImGui::SameLine();
    look = {part.visible ? "Hide" : "Show"};
    if (toggle("visible", part.visible ? kIconEye : kIconEyeOff, !part.visible, look)) {
      requests_.commands.push_back(SetVisible{{part.id}, !part.visible});
    }
    ImGui::SameLine();
    look = {part.locked ? "Unlock" : "Lock"};
    if (toggle("locked", part.locked ? kIconLock : kIconLockOpen, part.locked, look)) {
      requests_.commands.push_back(SetLocked{{part.id}, !part.locked});
    }
    ImGui::PopID();
  }

  // Quiet while it is as with most parts.
  bool toggle(const char* id, const char* icon, bool set, ButtonLook look) {
    look.quiet = !set;
    return iconButton(id, icon, side_, look);
  }

  void label(const Row& row, const PartSource& part, ImVec2 low, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float x = low.x + 12 + 11 * static_cast<float>(std::min(row.depth, 5));
    const float y = low.y + side_ / 2, text_y = std::round(y - ImGui::GetFontSize() / 2);
    list.AddCircleFilled({x, y}, 6, IM_COL32(part.color.r, part.color.g, part.color.b, 255), 24);
    list.AddCircle({x, y}, 6, IM_COL32(41, 46, 60, 60), 24, 1);
    float end = low.x + width - 4;
    if (row.loose) {
      iconAt(kIconUnlink, {end - 10, y}, Theme::kDanger);
      end -= 24;
    }
    if (part.mirror) {
      const char* twins = "L R";
      const float extent = ImGui::CalcTextSize(twins).x;
      list.AddText({end - extent - 2, text_y}, Theme::kSoftText, twins);
      end -= extent + 8;
    }
    fittingText(part.name.c_str(), {x + 14, text_y}, end - x - 14,
                part.visible ? Theme::kText : Theme::kSoftText);
  }

  void choose(const PartSource& part) {
    if (ImGui::GetIO().KeyShift) {
      const bool was = selected(part);
      auto& ids = ui_.selection.ids;
      ids.erase(std::remove_if(ids.begin(), ids.end(),
                               [&](const std::string& id) { return sourceId(id) == part.id; }),
                ids.end());
      if (!was) ids.push_back(part.id);
      ui_.selection.branch.clear();
    } else {
      ui_.selection.set(part.id);
    }
    requests_.again = true;
  }

  const PanelInput& input_;
  UiState& ui_;
  Requests& requests_;
  float side_;
};

}  // namespace

void drawPartsPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.parts || input.drawing) return;
  if (!ui.narrow() && ui.open.help) return;  // in its place
  PartsPanel(input, ui, requests).draw();
}

}  // namespace marrow
