// Poses by name, what can be done with the one that is shown, and how the skin follows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "document/symmetry.h"
#include "icons.h"
#include "panels/layout.h"
#include "panels/panel.h"
#include "pose/mirror.h"

namespace marrow {
namespace {

constexpr size_t kMostRows = 5;  // the list scrolls beyond
constexpr const char* kKeepFirst = "Keep the mix as a pose first";

void renamePose(const PanelInput& input, const TypedText& typed, Requests& requests) {
  const bool exists = input.shown.findPose(typed.owner) != nullptr;
  if (!exists || typed.text.empty() || typed.text == typed.owner) return;
  requests.commands.push_back(RenamePose{typed.owner, typed.text});
}

class PosePanel {
 public:
  PosePanel(const PanelInput& input, UiState& ui, Requests& requests)
      : input_(input),
        ui_(ui),
        posing_(ui.posing),
        requests_(requests),
        height_(rowHeight(ui)),
        current_(input.shown.findPose(ui.posing.pose)) {}

  void draw() {
    beginPanel("pose", ui_.narrow() ? sheetBox(ui_) : columnBox(ui_));
    title();
    progress();
    if (posing_.weights != Posing::Weights::hidden) {  // these need the room
      weights();
      ButtonLook look{"Hides the weights  (W)"};
      look.raised = true;
      look.width = ImGui::GetContentRegionAvail().x;
      ImGui::Dummy({0, 2});
      if (textButton("back", "Back to the poses", height_, look)) {
        posing_.weights = Posing::Weights::hidden;
        posing_.brush.reset();
        requests_.again = true;
      }
      endPanel();
      return;
    }
    list();
    thisPose();
    mix();
    heading("A drag");
    choose("drag", {{"pull", "Pulls the limb"}, {"turn", "Turns the bone"}}, posing_.turns);
    heading("Skin at the joints");
    bool dual = posing_.skinning == Skinning::dualQuaternions;
    choose("skin", {{"linear", "Simple"}, {"dual", "Keeps volume"}}, dual);
    posing_.skinning = dual ? Skinning::dualQuaternions : Skinning::linear;
    weights();
    endPanel();
  }

 private:
  void title() {
    const ImVec2 at = ImGui::GetCursorPos();
    const float side = ui_.touch() ? 44.0f : 32.0f;
    const float right = at.x + ImGui::GetContentRegionAvail().x + 6;
    if (titleRow("Poses", ui_)) close();
    const ImVec2 below = ImGui::GetCursorPos();
    ImGui::SetCursorPos({right - 2 * side - 4, at.y});
    if (iconButton("export", kIconDownload, side, {"Export: a file for Blender or games"})) {
      ui_.openOnly(&PanelsOpen::exporting);
      requests_.again = true;
    }
    ImGui::SetCursorPos(below);
  }

  void close() {
    if (ui_.narrow()) {
      ui_.open.pose = false;
      requests_.again = true;
    } else {
      requests_.key = 'p';
    }
  }

  void progress() {
    const FigureKeeper& figure = input_.figure;
    const FileMaker& file = input_.file;
    if (file.busy() && !figure.ready()) {
      bar("Making " + file.name().substr(file.name().find_last_of('/') + 1) + " first",
          file.working() ? file.done() : 0);
      return;
    }
    if (!figure.failure().empty()) {
      softText(figure.failure().c_str());
      return;
    }
    if (figure.ready()) return;
    bar("Fitting the skin", figure.done());
  }

  void bar(std::string text, double share) {
    text += "\xE2\x80\xA6";
    if (share > 0) text += " " + std::to_string(static_cast<int>(std::lround(100 * share))) + " %";
    softText(text.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float done = static_cast<float>(std::clamp(share, 0.03, 1.0));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + width, at.y + 4}, Theme::kHairline, 2);
    list.AddRectFilled(at, {at.x + width * done, at.y + 4}, Theme::kAccent, 2);
    ImGui::Dummy({width, 6});
  }

  void list() {
    const size_t rows = input_.shown.poses.size() + 1;
    const float room = height_ * static_cast<float>(std::min(rows, kMostRows));
    beginScrolling("poses", room, ui_.touch());
    ButtonLook look{"As it was drawn; always there"};
    look.on = !current_;
    look.width = ImGui::GetContentRegionAvail().x;
    if (nameButton("rest", "At rest", look)) show({});
    for (size_t i = 0; i < input_.shown.poses.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      row(*input_.shown.poses[i]);
      ImGui::PopID();
    }
    endScrolling();
    ImGui::Dummy({0, 2});
    look = {"Another pose, to begin with as this one"};
    look.raised = true;
    look.width = ImGui::GetContentRegionAvail().x;
    if (textButton("new", "New pose", height_, look)) {
      const std::string name = freshPoseName(input_.shown);
      ask(SetPose{name, withoutResting(input_.stance.wanted)});
      show(name);
    }
  }

  bool nameButton(const char* id, const char* name, const ButtonLook& look) {
    const bool pressed = textButton(id, "", height_, look);
    const ImVec2 low = ImGui::GetItemRectMin();
    fittingText(name, {low.x + 10, std::round(low.y + (height_ - ImGui::GetFontSize()) / 2)},
                look.width - 20, look.on ? Theme::kAccent : Theme::kText);
    return pressed;
  }

  void row(const NamedPose& pose) {
    const float width = ImGui::GetContentRegionAvail().x - height_;
    if (&pose == current_) {
      ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                          ImVec2(10, (height_ - ImGui::GetFontSize()) / 2));
      const auto typed = textField("name", pose.name, pose.name, "", width - 4);
      ImGui::PopStyleVar();
      tooltipForLastItem("The pose's name");
      if (typed) renamePose(input_, {pose.name, *typed}, requests_);
    } else {
      ButtonLook look;
      look.width = width - 4;
      if (nameButton("pose", pose.name.c_str(), look)) show(pose.name);
    }
    ImGui::SameLine(0, 4);
    ButtonLook look{"Delete this pose"};
    look.danger = look.quiet = true;
    if (iconButton("delete", kIconTrash2, height_, look)) ask(DeletePose{pose.name});
  }

  void thisPose() {
    const float half = (ImGui::GetContentRegionAvail().x - 8) / 2;
    const bool mixes = posing_.amount > 0;
    ButtonLook look{mixes ? kKeepFirst : "Left becomes right"};
    look.raised = true;
    look.width = half;
    look.enabled = !mixes && current_ && symmetryPlane(input_.shown);
    if (textButton("mirror", "Mirror", height_, look)) mirror();
    ImGui::SameLine();
    look.tooltip = mixes ? kKeepFirst : "All bones as they were drawn";
    look.enabled = !mixes && current_ && !current_->joints.empty();
    if (textButton("resetAll", "Reset all", height_, look)) ask(SetPose{current_->name, {}});
    const auto joint = chosen();
    if (joint) chosenBone(*joint);
    const Pose reset = joint && current_ ? withoutBone(*joint) : Pose{};
    look.tooltip = mixes ? kKeepFirst : "As it was drawn, and what else turns about the same joint";
    look.enabled = !mixes && joint && current_ && reset != current_->joints;
    if (textButton("resetBone", "Reset bone", height_, look)) {
      ask(SetPose{current_->name, reset});
    }
    ImGui::SameLine();
    const bool pinned = posing_.pins.count(posing_.joint) > 0;
    look.tooltip = "The chosen joint stays where it is while others are pulled  (N)";
    look.enabled = joint.has_value();
    look.on = pinned;
    if (textButton("pin", pinned ? "Unpin joint" : "Pin joint", height_, look)) requests_.key = 'n';
    if (!joint) softText("Drag a joint or a limb. Click a joint to choose it.");
  }

  /// The pose of now with the chosen bone as it was drawn; the whole stays where it is, unless its
  /// root itself is chosen.
  Pose withoutBone(size_t joint) const {
    const Rig& rig = input_.stance.rest;
    Pose pose = current_->joints;
    const auto found = pose.find(boneId(joint));
    if (found == pose.end()) return pose;
    const uint32_t head = boneOf(rig, static_cast<uint32_t>(joint));
    if (rig.joints[head].parent < 0 && head != joint) {
      found->second.rotation = {};
    } else {
      pose.erase(found);
    }
    return withoutResting(pose);
  }

  void chosenBone(size_t joint) {
    headingWithNote("Chosen bone", boneName(joint).c_str());
    ImGui::Dummy({0, 0});
  }

  void mirror() {
    const auto plane = symmetryPlane(input_.shown);
    const Pose mirrored = mirroredPose(input_.shown, input_.stance.rest, current_->joints, *plane);
    ask(SetPose{current_->name, withoutResting(mirrored)});
  }

  // Between the pose that is chosen and another one.
  void mix() {
    std::vector<std::string> others;
    if (current_) others.push_back({});
    for (const auto& pose : input_.shown.poses) {
      if (pose.get() != current_) others.push_back(pose->name);
    }
    if (others.empty()) {
      posing_.amount = 0;
      return;
    }
    const auto found = std::find(others.begin(), others.end(), posing_.mix);
    if (found == others.end()) posing_.mix = others.back();
    const size_t at =
        static_cast<size_t>(std::find(others.begin(), others.end(), posing_.mix) - others.begin());
    const std::string name = posing_.mix.empty() ? "At rest" : posing_.mix;
    headingWithNote("Mix with", name.c_str());
    const bool several = others.size() > 1;
    float t = static_cast<float>(posing_.amount);
    const float width = ImGui::GetContentRegionAvail().x - (several ? height_ + 4 : 0);
    const SliderEvent event = slider("mix", t, 0, height_, width);
    tooltipForLastItem("From this pose to the other one.\nDouble click: back");
    if (several) {
      ImGui::SameLine(0, 4);
      if (iconButton("other", kIconChevronRight, height_, {"Mix with the next one"})) {
        posing_.mix = others[(at + 1) % others.size()];
        requests_.again = true;
      }
    }
    if (event.changed) posing_.amount = t;
    if (event.reset) posing_.amount = 0;
    requests_.again |= event.changed || event.released || event.reset;
    if (!(posing_.amount > 0)) return;
    ButtonLook look{"A new pose as it is shown now"};
    look.raised = true;
    look.width = ImGui::GetContentRegionAvail().x;
    if (textButton("keepMix", "Keep as a new pose", height_, look)) {
      const std::string kept = freshPoseName(input_.shown);
      ask(SetPose{kept, withoutResting(input_.stance.wanted)});
      show(kept);
    }
  }

  void weights() {
    const bool hidden = posing_.weights == Posing::Weights::hidden;
    heading(hidden ? "Weights and brush" : "Weights");
    const std::vector<Choice> all{{"hidden", "Hidden"}, {"joint", "One bone"}, {"all", "All"}};
    const size_t now = static_cast<size_t>(posing_.weights);
    const size_t next = choices(all, now, height_);
    if (next != now) {
      posing_.weights = static_cast<Posing::Weights>(next);
      requests_.again = true;
    }
    if (posing_.weights == Posing::Weights::hidden) {
      posing_.brush.reset();
      return;
    }
    const auto joint = chosen();
    if (joint) chosenBone(*joint);
    if (posing_.weights == Posing::Weights::joint) {
      softText(joint ? "How much it holds: dark nothing, light all."
                     : "Click a joint to see what the bone that ends there holds.");
    }
    brush();
  }

  void brush() {
    heading("Brush");
    ImGui::PushID("brush");
    const std::vector<Choice> kinds{
        {"off", "Off"}, {"add", "More"}, {"take", "Less"}, {"smooth", "Smooth"}};
    const size_t now = posing_.brush ? static_cast<size_t>(*posing_.brush) + 1 : 0;
    const size_t next = choices(kinds, now, height_);
    ImGui::PopID();
    if (next != now) {
      posing_.brush.reset();
      if (next > 0) posing_.brush = static_cast<WeightStroke::Kind>(next - 1);
      requests_.again = true;
    }
    if (!posing_.brush) return;
    const bool smooths = posing_.brush == WeightStroke::Kind::smooth;
    if (!chosen() && !smooths) softText("Click the joint at the end of the bone to paint for.");
    headingWithNote("Size", "[  ]");
    const double least = std::log(Posing::kLeastBrush_px);
    const double most = std::log(Posing::kLargestBrush_px);
    const auto onSlider = [&](double px) {
      return static_cast<float>((std::log(px) - least) / (most - least));
    };
    const Posing usual;
    float size = onSlider(posing_.brush_px);
    const SliderEvent resized = slider("brushSize", size, onSlider(usual.brush_px), height_);
    if (resized.changed) posing_.brush_px = std::exp(least + size * (most - least));
    if (resized.reset) posing_.brush_px = usual.brush_px;
    heading("Strength");
    float strength = static_cast<float>(posing_.brush_strength);
    const SliderEvent changed =
        slider("brushStrength", strength, static_cast<float>(usual.brush_strength), height_);
    if (changed.changed) posing_.brush_strength = std::max(0.02, static_cast<double>(strength));
    if (changed.reset) posing_.brush_strength = usual.brush_strength;
    requests_.again |= resized.changed || resized.reset || changed.changed || changed.reset;
    const auto joint = chosen();
    const float half = (ImGui::GetContentRegionAvail().x - 8) / 2;
    clearing("clearPaint", "Clear bone", "What was painted for the chosen bone goes", half,
             joint ? std::optional<std::string>(boneId(*joint)) : std::nullopt);
    ImGui::SameLine();
    clearing("clearAll", "Clear all", "All that was painted and smoothed goes", half,
             std::string());
  }

  void clearing(const char* id, const char* text, const char* tooltip, float width,
                const std::optional<std::string>& joint) {
    ButtonLook look{tooltip};
    look.raised = true;
    look.width = width;
    look.enabled = false;
    if (joint) {
      const auto left = apply(input_.shown, ClearWeightStrokes{*joint});
      look.enabled = left && left->weight_strokes.size() < input_.shown.weight_strokes.size();
    }
    if (textButton(id, text, height_, look)) ask(ClearWeightStrokes{*joint});
  }

  void choose(const char* id, const std::vector<Choice>& two, bool& second) {
    ImGui::PushID(id);
    const size_t next = choices(two, second ? 1 : 0, height_);
    ImGui::PopID();
    if ((next == 1) == second) return;
    second = next == 1;
    requests_.again = true;
  }

  std::optional<size_t> chosen() const {
    const auto& joints = input_.stance.rest.joints;
    for (size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].id == posing_.joint) return i;
    }
    return std::nullopt;
  }

  /// As its file calls it.
  std::string boneName(size_t joint) const {
    const Rig& rig = input_.stance.rest;
    return rig.joints[boneOf(rig, static_cast<uint32_t>(joint))].name;
  }
  /// Id of the joint that turns the chosen bone.
  std::string boneId(size_t joint) const {
    const Rig& rig = input_.stance.rest;
    return rig.joints[boneOf(rig, static_cast<uint32_t>(joint))].id;
  }

  void show(const std::string& name) {
    posing_.pose = name;
    posing_.amount = 0;
    requests_.again = true;
  }
  void ask(Command command) { requests_.commands.push_back(std::move(command)); }

  const PanelInput& input_;
  UiState& ui_;
  Posing& posing_;
  Requests& requests_;
  float height_;
  const NamedPose* current_;
};

}  // namespace

void drawPosePanel(const PanelInput& input, UiState& ui, Requests& requests) {
  const bool shown = ui.tool == ToolKind::pose && (!ui.narrow() || ui.open.pose);
  if (shown) PosePanel(input, ui, requests).draw();
  if (const auto typed = leftText("pose")) renamePose(input, *typed, requests);
}

}  // namespace marrow
