// The selected parts: name, thickness, depth, colour, twins, bones and where they hang.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "document/depth.h"
#include "document/symmetry.h"
#include "icons.h"
#include "panels/layout.h"
#include "panels/sections.h"

namespace marrow {
namespace {

void rename(const PanelInput& input, const TypedText& typed, Requests& requests) {
  const auto part = input.shown.find(typed.owner);
  if (!part || typed.text.empty() || typed.text == input.shown.parts[*part]->name) return;
  requests.commands.push_back(RenamePart{typed.owner, typed.text});
}

constexpr float kMark = 0.5f;  // where the thickness has its default
constexpr size_t kColors = 8;

// Two stretches of a logarithmic scale that meet at the default.
double thicknessAt(float t) {
  return t < kMark ? kMinThickness * std::pow(1 / kMinThickness, t / kMark)
                   : std::pow(kMaxThickness, (t - kMark) / (1 - kMark));
}

float thicknessToSlider(double thickness) {
  const double t = thickness < 1
                       ? kMark * std::log(thickness / kMinThickness) / std::log(1 / kMinThickness)
                       : kMark + (1 - kMark) * std::log(thickness) / std::log(kMaxThickness);
  return static_cast<float>(std::clamp(t, 0.0, 1.0));
}

class PartPanel {
 public:
  PartPanel(const PanelInput& input, UiState& ui, Requests& requests)
      : input_(input), ui_(ui), requests_(requests), ids_(selectedSources(input, ui)) {
    for (const std::string& id : ids_) {
      parts_.push_back(input.shown.parts[*input.shown.find(id)].get());
    }
  }

  void draw() {
    if (parts_.empty()) return;
    beginPanel("part", ui_.narrow() ? sheetBox(ui_) : columnBox(ui_));
    title();
    buttons();
    if (all([](const PartSource& part) { return part.locked; })) {
      softText("Locked: the lock above lets it be changed again.");
    } else {
      thickness();
      depth();
      colors();
      twins();
      skeleton();
      if (parts_.size() == 1) attachment();
    }
    endPanel();
  }

 private:
  // The last one chosen speaks for all.
  const PartSource& primary() const { return *parts_.back(); }
  template <typename Test>
  bool all(Test test) const {
    return std::all_of(parts_.begin(), parts_.end(),
                       [&](const PartSource* part) { return test(*part); });
  }
  void ask(Command command) { requests_.commands.push_back(std::move(command)); }

  // The part's name, which can be changed, and the button that closes the panel.
  void title() {
    const float side = rowHeight(ui_);
    const ImVec2 at = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (parts_.size() == 1) {
      name(at, width - side - 8, side);
    } else {
      ImGui::PushFont(fonts().title);
      ImGui::SetCursorPosY(at.y + (side - ImGui::GetFontSize()) / 2);
      ImGui::TextUnformatted(counted(parts_.size(), "part").c_str());
      ImGui::PopFont();
    }
    ImGui::SetCursorPos({at.x + width - side + 4, at.y});
    if (iconButton("close", kIconX, side, {"Close  (Esc)"})) {
      if (ui_.narrow()) {
        ui_.open.part = ui_.open.bones = false;
      } else {
        ui_.selection.clear();
      }
      requests_.again = true;
    }
    ImGui::SetCursorPos({at.x, at.y + side + 6});
  }

  void name(ImVec2 at, float width, float side) {
    const PartSource& part = primary();
    ImGui::SetCursorPosY(at.y + (side - ImGui::GetFrameHeight()) / 2);
    const auto typed = textField("name", part.id, part.name, "", width);
    if (typed) rename(input_, {part.id, *typed}, requests_);
    tooltipForLastItem("The part's name");
  }

  void buttons() {
    const float side = ui_.touch() ? 44.0f : 38.0f;
    const float gap = (ImGui::GetContentRegionAvail().x - 4 * side) / 3;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, 8));
    if (iconButton("duplicate", kIconCopy, side, {"Duplicate  (Shift D)"})) requests_.key = 'D';
    ImGui::SameLine();
    const bool hidden = all([](const PartSource& part) { return !part.visible; });
    ButtonLook look{hidden ? "Show  (Shift H shows everything)" : "Hide  (H)"};
    look.on = hidden;
    if (iconButton("hide", hidden ? kIconEyeOff : kIconEye, side, look)) {
      ask(SetVisible{ids_, hidden});
    }
    ImGui::SameLine();
    const bool locked = all([](const PartSource& part) { return part.locked; });
    look = {locked ? "Unlock" : "Lock: clicks on the canvas go past it, and nothing changes it"};
    look.on = locked;
    if (iconButton("lock", locked ? kIconLock : kIconLockOpen, side, look)) {
      ask(SetLocked{ids_, !locked});
    }
    ImGui::SameLine();
    look = {"Delete  (X or Delete)"};
    look.danger = true;
    if (iconButton("delete", kIconTrash2, side, look)) ask(DeleteParts{ui_.selection.ids});
    ImGui::PopStyleVar();
  }

  void follow(const SliderEvent& event) {
    if (event.released && !event.reset) requests_.commit_edit = true;
    requests_.reset |= event.reset;
    requests_.again |= event.changed || event.released || event.reset;
  }

  void thickness() {
    const double now = primary().thickness;
    const bool same = all([&](const PartSource& part) { return part.thickness == now; });
    headingWithNote("Thickness", same ? "flat \xE2\x86\x92 fat" : "not all the same");
    float t = thicknessToSlider(now);
    const SliderEvent event = slider("thickness", t, kMark, rowHeight(ui_));
    tooltipForLastItem(
        "How thick the part is compared to its width.\nDouble click: as it was drawn");
    if (event.changed) ui_.edit = PendingEdit{SetThickness{ids_, thicknessAt(t)}};
    if (event.reset) ask(SetThickness{ids_, 1});
    follow(event);
  }

  // Along the part's own normal, within what the whole model spans.
  void depth() {
    const auto scale = depthScale(input_.evaluation, ui_.selection.ids, towardsViewer());
    const auto before = committedOrigin();
    if (!scale || !before) return;
    headingWithNote("Depth", "further \xE2\x86\x92 nearer");
    const float side = rowHeight(ui_);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(4, 8));
    if (iconButton("layerDown", kIconChevronsDown, side, {"Behind the next part  ( [ )"})) {
      requests_.key = '[';
    }
    ImGui::SameLine();
    const double length = scale->high - scale->low;
    const auto onSlider = [&](double depth) {
      return static_cast<float>(std::clamp((depth - scale->low) / length, 0.0, 1.0));
    };
    const double was = scale->now + dot(scale->direction, *before - shownOrigin());
    const float mark = onSlider(scale->level);
    float t = onSlider(scale->now);
    const SliderEvent event =
        slider("depth", t, mark, side, ImGui::GetContentRegionAvail().x - side - 4);
    tooltipForLastItem("Moves the part towards you or away.\nThe dot: level with what it covers");
    ImGui::SameLine();
    if (iconButton("layerUp", kIconChevronsUp, side, {"In front of the next part  ( ] )"})) {
      requests_.key = ']';
    }
    ImGui::PopStyleVar();
    const double wanted = t == mark ? scale->level : scale->low + length * t;
    TransformParts move{ui_.selection.ids, {}, "Move"};
    if (event.changed || event.reset) {
      move.map.move = scale->direction * ((event.reset ? scale->level : wanted) - was);
    }
    if (event.changed) ui_.edit = PendingEdit{move};
    if (event.reset) ask(move);
    follow(event);
  }

  Vec3 towardsViewer() const { return ui_.camera.axes()[2]; }

  Vec3 shownOrigin() const {
    return findPlaced(input_.evaluation.placed(), ui_.selection.primary())->frame.origin;
  }
  std::optional<Vec3> committedOrigin() const {
    if (!findPlaced(input_.evaluation.placed(), ui_.selection.primary())) return std::nullopt;
    const auto all = placedParts(input_.history.current());
    const PlacedPart* one = findPlaced(all, ui_.selection.primary());
    if (!one) return std::nullopt;
    return one->frame.origin;
  }

  void colors() {
    heading("Colour");
    const float width = ImGui::GetContentRegionAvail().x;
    size_t count = 1;
    while (count < kColors && !(partColor(count) == partColor(0))) ++count;  // they begin again
    // A colour that came with a file has a place of its own behind them.
    std::vector<Color> colors;
    for (size_t i = 0; i < count; ++i) colors.push_back(partColor(i));
    const Color own = primary().color;
    if (std::find(colors.begin(), colors.end(), own) == colors.end()) colors.push_back(own);
    count = colors.size();
    const float least = ui_.touch() ? 44.0f : 32.0f;
    const auto fits = std::max<size_t>(1, static_cast<size_t>(width / least));
    const size_t rows = (count + fits - 1) / fits, per_row = (count + rows - 1) / rows;
    const float side = std::min(width / static_cast<float>(per_row), least + 4);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    for (size_t i = 0; i < count; ++i) {
      const Color color = colors[i];
      if (i % per_row != 0) ImGui::SameLine();
      ImGui::PushID(static_cast<int>(i));
      const bool chosen = all([&](const PartSource& part) { return part.color == color; });
      if (swatch("color", color, chosen, side) && !chosen) ask(SetColor{ids_, color});
      ImGui::PopID();
    }
    ImGui::PopStyleVar();
    ImGui::Dummy({0, 0});
  }

  void twins() {
    const bool on = all([](const PartSource& part) { return part.mirror.has_value(); });
    if (switchRow("twin", kIconSquareCenterlineDashedHorizontal, "Twin on the other side", on,
                  rowHeight(ui_))) {
      const auto plane = symmetryPlane(input_.shown);
      ask(SetMirror{ids_, on ? std::nullopt : plane});
    }
    tooltipForLastItem("A mirror image that follows every change");
    if (!on) return;
    ButtonLook look{"Makes parts of their own of the twins, each to be changed by itself"};
    look.raised = true;
    look.width = ImGui::GetContentRegionAvail().x;
    if (textButton("separate", "Part the twins", rowHeight(ui_), look)) ask(SeparateTwins{ids_});
  }

  void skeleton() {
    const bool on = all([](const PartSource& part) { return part.skeleton; });
    const bool open = showsBones(ui_);
    if (disclosure("skeleton", kIconBone, "Bones", on ? joints().c_str() : "none", open,
                   rowHeight(ui_))) {
      ui_.open.skeleton = false;
      ui_.open.bones = !open;
      requests_.again = true;
    }
    if (!open) return;
    if (switchRow("bones", kIconBone, "Bones of its own", on, rowHeight(ui_))) {
      ask(SetSkeleton{ids_, !on});
    }
    tooltipForLastItem("Ears and spikes need none: they move with what they sit on");
    if (on) {
      drawThresholds(input_, ui_, requests_);
    } else {
      softText("It moves with what it sits on: right for ears and spikes.");
    }
  }

  std::string joints() const {
    const auto& placed = input_.evaluation.placed();
    const auto count = std::count_if(
        input_.rig.joints.begin(), input_.rig.joints.end(), [&](const Rig::Joint& joint) {
          if (joint.part >= placed.size() || placed[joint.part].twin) return false;
          return std::find(ids_.begin(), ids_.end(), placed[joint.part].id) != ids_.end();
        });
    return counted(static_cast<size_t>(count), "joint");
  }

  void attachment() { drawAttachment(input_, ui_, requests_); }

  const PanelInput& input_;
  UiState& ui_;
  Requests& requests_;
  std::vector<std::string> ids_;
  std::vector<const PartSource*> parts_;
};

}  // namespace

std::vector<std::string> selectedSources(const PanelInput& input, const UiState& ui) {
  std::vector<std::string> ids;
  for (const std::string& placed_id : ui.selection.ids) {
    const std::string id = sourceId(placed_id);
    const auto found = std::find(ids.begin(), ids.end(), id);
    if (found != ids.end()) ids.erase(found);
    if (input.shown.find(id)) ids.push_back(id);
  }
  return ids;
}

std::string counted(size_t n, const char* one) {
  return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

bool partPanelShows(const PanelInput& input, const UiState& ui) {
  if (ui.tool == ToolKind::pose) return false;
  return ui.open.part && (ui.narrow() || !selectedSources(input, ui).empty());
}

void drawPartPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (input.drawing) return;
  if (ui.attaching) drawAttachHint(input, ui);
  if (ui.open.part && ui.tool != ToolKind::pose) PartPanel(input, ui, requests).draw();
  if (const auto typed = leftText("part")) rename(input, *typed, requests);
}

}  // namespace marrow
