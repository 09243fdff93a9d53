// The character as a file for other programs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "icons.h"
#include "panels/menu_rows.h"
#include "panels/panel.h"

namespace marrow {
namespace {

using Format = FileOptions::Format;

struct FormatChoice {
  Format format;
  const char *name, *what;
};
constexpr std::array<FormatChoice, 5> kFormats{{
    {Format::glb, "GLB", "For Blender, games and three.js."},
    {Format::gltf, "glTF", "The same as GLB, but as text."},
    {Format::obj, "OBJ", "The shape alone, for nearly every 3D program."},
    {Format::stl, "STL", "The shape alone, for 3D printers."},
    {Format::ply, "PLY", "The shape with its colours."},
}};

struct Height {
  const char *id, *label;
  double metres;
};
constexpr std::array<Height, 4> kHeights{
    {{"drawn", "As drawn", 0}, {"small", "20 cm", 0.2}, {"middle", "1 m", 1}, {"large", "2 m", 2}}};

constexpr ImU32 kDone = IM_COL32(37, 99, 174, 60);
constexpr double kSoftestSeam = 0.08;  // of the character's largest extent
constexpr float kMostPoses = 4;        // rows; the list scrolls beyond
constexpr double kDoubleClick_ms = 500;

/// "1.25 m", "20 cm".
std::string inWords(double metres) {
  std::array<char, 32> text{};
  if (metres < 0.995) {
    std::snprintf(text.data(), text.size(), metres < 0.0995 ? "%.1f cm" : "%.0f cm", 100 * metres);
  } else {
    std::snprintf(text.data(), text.size(), metres < 9.95 ? "%.1f m" : "%.0f m", metres);
  }
  return text.data();
}

class ExportPanel {
 public:
  ExportPanel(const PanelInput& input, UiState& ui, Requests& requests)
      : input_(input),
        ui_(ui),
        exporting_(ui.exporting),
        file_(ui.exporting.file),
        requests_(requests),
        height_(rowHeight(ui)),
        box_(shownBox(input.evaluation)) {}

  void draw() {
    beginPanel("export", menuBox(ui_, 340));
    if (titleRow("Export", ui_)) {
      ui_.open.exporting = false;
      requests_.again = true;
    }
    if (box_.isEmpty()) {
      softText("There is nothing to export yet: draw a shape first.");
      if (input_.file.busy()) making(ImGui::GetContentRegionAvail().x);
    } else {
      format();
      if (lowCanvas(ui_)) save();  // the options scroll
      if (file_.hasBones()) {
        model();
      } else {
        pose();
      }
      if (takesOneBody(file_)) seams();
      if (!input_.shelf.keeping.dialogs) path();
      if (!lowCanvas(ui_)) save();
    }
    endPanel();
  }

 private:
  void format() {
    std::vector<Choice> all;
    size_t now = 0;
    for (const FormatChoice& one : kFormats) {
      if (one.format == file_.format) now = all.size();
      all.push_back({toString(one.format), one.name});
    }
    const size_t next = choices(all, now, height_);
    if (next != now) {
      file_.format = kFormats[next].format;
      requests_.again = true;
    }
    softText(kFormats[next].what);
  }

  void model() {
    heading("Body");
    const size_t parts = file_.parts ? 1 : 0;
    choose({{"merged", "One piece"}, {"parts", "Part by part"}}, parts,
           [&](size_t next) { file_.parts = next == 1; });
    size();
    if (switchRow("weights", kIconBone, "Bones move the body", file_.weights, height_)) {
      file_.weights = !file_.weights;
      requests_.again = true;
    }
    const size_t poses = input_.shown.poses.size();
    const std::string several =
        "Its " + std::to_string(poses) + " poses go with it, as animations.";
    softText(!file_.weights ? "The shape alone: poses do not bend it."
             : poses == 0   ? "There are no poses yet to go with it."
             : poses == 1   ? "Its pose goes with it, as an animation."
                            : several.c_str());
  }

  void size() {
    const Vec3 extent = box_.size() * metresPerUnit(box_, exporting_.height_m);
    const std::string note = inWords(extent.y) + " high, " + inWords(extent.x) + " wide";
    headingWithNote("Size", note.c_str());
    ImGui::Dummy({0, 0});
    std::vector<Choice> all;
    size_t now = 0;
    for (const Height& one : kHeights) {
      if (one.metres == exporting_.height_m) now = all.size();
      all.push_back({one.id, one.label});
    }
    choose(all, now, [&](size_t next) { exporting_.height_m = kHeights[next].metres; });
  }

  void pose() {
    const auto& poses = input_.shown.poses;
    if (poses.empty()) {
      softText("At rest, as it was drawn: there are no poses yet.");
      return;
    }
    heading("Pose");
    const float rows = std::min(static_cast<float>(poses.size() + 1), kMostPoses);
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    beginScrolling("poses", rows * (height_ + gap) - gap, ui_.touch());
    const NamedPose* chosen = input_.shown.findPose(file_.pose);
    ButtonLook look;
    look.width = ImGui::GetContentRegionAvail().x;
    look.on = !chosen;
    if (textButton("rest", "At rest", height_, look)) take({});
    for (size_t i = 0; i < poses.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      look.on = chosen == poses[i].get();
      if (textButton("pose", poses[i]->name.c_str(), height_, look)) take(poses[i]->name);
      ImGui::PopID();
    }
    endScrolling();
  }

  void take(const std::string& pose) {
    file_.pose = pose;
    requests_.again = true;
  }

  // How far around seams the parts grow into each other.
  void seams() {
    const Vec3 size = box_.size();
    const double most = kSoftestSeam * std::max({size.x, size.y, size.z, 1e-9});
    headingWithNote("Seams", "sharp \xE2\x86\x92 soft");
    auto t = static_cast<float>(std::min(input_.shown.blend / most, 1.0));
    const SliderEvent event = slider("blend", t, 0, height_);
    tooltipForLastItem("Limbs grow out of the body.\nDouble click: sharp");
    if (event.changed) ui_.edit = PendingEdit{SetBlend{t * most}};
    if (event.released && !event.reset) requests_.commit_edit = true;
    if (event.reset) requests_.commands.push_back(SetBlend{0});
    requests_.reset |= event.reset;
    requests_.again |= event.changed || event.released || event.reset;
  }

  // Where the platform has no dialogs of its own: the path is typed.
  void path() {
    const Keeping& keeping = input_.shelf.keeping;
    const std::string ending = std::string(".") + toString(file_.format);
    if (!exporting_.path_edited) {
      const std::string& place = keeping.place();
      const size_t folder = place.find_last_of('/');
      exporting_.path = folder == std::string::npos ? "" : place.substr(0, folder + 1);
      exporting_.path += fileName(keeping.name()) + ending;
    }
    heading("File");
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(10, (height_ - ImGui::GetFontSize()) / 2));
    std::array<char, 512> typed{};
    exporting_.path.copy(typed.data(), typed.size() - 1);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    exporting_.path_edited |= ImGui::InputTextWithHint(
        "##path", "Folder and name", typed.data(), typed.size(), ImGuiInputTextFlags_AutoSelectAll);
    notePlace("path");
    ImGui::PopStyleVar();
    exporting_.path = typed.data();
  }

  /// "dog.glb", or the typed path with that ending.
  std::string target() const {
    const Keeping& keeping = input_.shelf.keeping;
    const std::string ending = std::string(".") + toString(file_.format);
    if (keeping.dialogs) return fileName(keeping.name()) + ending;
    std::string path = exporting_.path;
    for (const FormatChoice& other : kFormats) {
      const std::string old = std::string(".") + toString(other.format);
      const bool has =
          path.size() > old.size() && path.compare(path.size() - old.size(), old.size(), old) == 0;
      if (has) {
        path.resize(path.size() - old.size());
        break;
      }
    }
    return leaf(path).empty() ? std::string() : path + ending;
  }

  void save() {
    const FileMaker& maker = input_.file;
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({0, 2});
    // The button and what takes its place: a second click was meant for the first one.
    if (std::exchange(exporting_.making, maker.busy()) != maker.busy()) {
      exporting_.since_ms = ui_.now_ms;
    }
    if (maker.busy()) {
      making(width);
      return;
    }
    const std::string name = target();
    const std::string text = shortened("Save " + leaf(name), width - 24);
    if (!name.empty() && accentButton("save", text.c_str(), width, height_) && isMeant()) {
      requests_.files.push_back({FileAction::Kind::make, name});
      requests_.again = true;
    }
    if (!maker.failure().empty()) softText(maker.failure().c_str());
    for (const std::string& sentence : leftOut()) softText(sentence.c_str());
  }

  /// In the button's place: how far the file is, and a way out.
  void making(float width) {
    const FileMaker& maker = input_.file;
    constexpr float kCancel = 84;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = width - kCancel - 8;
    const float done = maker.working() ? static_cast<float>(std::clamp(maker.done(), 0.0, 1.0)) : 0;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + room, at.y + height_}, Theme::kHairline, 9);
    list.PushClipRect(at, {at.x + room * done, at.y + height_}, true);
    list.AddRectFilled(at, {at.x + room, at.y + height_}, kDone, 9);
    list.PopClipRect();
    const std::string text = "Making " + leaf(maker.name()) + "\xE2\x80\xA6";
    fittingText(text.c_str(), {at.x + 12, at.y + (height_ - ImGui::GetFontSize()) / 2}, room - 24,
                Theme::kText);
    ImGui::Dummy({room, height_});
    ImGui::SameLine(0, 8);
    if (paleButton("cancel", "Cancel", kCancel, height_, "No file is made") && isMeant()) {
      requests_.files.push_back({FileAction::Kind::give_up, {}});
      requests_.again = true;
    }
  }

  bool isMeant() const { return ui_.pressed_ms - exporting_.since_ms > kDoubleClick_ms; }

  static std::string leaf(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
  }

  /// Of the last file, or of the figure, which knows before there is any.
  const std::vector<std::string>& leftOut() const {
    const auto& figure = input_.figure.figure();
    if (figure && takesOneBody(file_)) return figure->left_out;
    return input_.file.leftOut();
  }

  template <typename Take>
  void choose(const std::vector<Choice>& all, size_t now, const Take& take) {
    ImGui::PushID(all.front().id);
    const size_t next = choices(all, now, height_);
    ImGui::PopID();
    if (next == now) return;
    take(next);
    requests_.again = true;
  }

  const PanelInput& input_;
  UiState& ui_;
  Exporting& exporting_;
  FileOptions& file_;
  Requests& requests_;
  float height_;
  Box3 box_;
};

}  // namespace

void drawExportPanel(const PanelInput& input, UiState& ui, Requests& requests) {
  Exporting& exporting = ui.exporting;
  if (!ui.open.exporting || input.drawing) {
    exporting.seen = ui.open.exporting;
    return;
  }
  if (!std::exchange(exporting.seen, true)) {
    exporting.path_edited = false;
    // What is seen is what one expects to get.
    exporting.file.pose = ui.tool == ToolKind::pose ? ui.posing.pose : std::string();
  }
  ExportPanel(input, ui, requests).draw();
}

}  // namespace marrow
