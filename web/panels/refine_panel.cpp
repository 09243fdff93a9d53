// Fewer joints or more: the four thresholds of a branch, a part or the whole model.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "icons.h"
#include "panels/layout.h"
#include "panels/sections.h"
#include "rig/refine.h"

namespace marrow {
namespace {

using Threshold = std::optional<double> Refinement::*;

struct Slider {
  Threshold threshold;
  const char *id, *name, *symbol, *what;
  double standard, largest;
};

// In the order in which they are applied.
const std::array<Slider, 4> kSliders{
    {{&Refinement::simplify, "simplify", "Detail", "\xCE\xB5s",
      "How closely the bones follow the drawing (simplification)", Refinement::kSimplify, 100},
     {&Refinement::merge, "merge", "Forks", "\xCE\xB5m",
      "Forks nearer to each other than this become one (merging)", Refinement::kMerge, 400},
     {&Refinement::prune, "prune", "Twigs", "\xCE\xB5t",
      "Side branches shorter than this get no bones (pruning)", Refinement::kPrune, 400},
     {&Refinement::collapse, "collapse", "Short bones",
      "\xCE\xB5"
      "c",
      "Bones shorter than this become one joint (collapsing)", Refinement::kCollapse, 200}}};

// More joints to the right: 0 is at the right end, the largest threshold at the left one, the
// standard in the middle, on largest · (kᵘ − 1) / (k − 1) with u from the right.
double base(const Slider& slider) {
  const double root = slider.largest / slider.standard - 1;
  return root * root;
}
double fromSlider(const Slider& slider, float t) {
  const double k = base(slider);
  return slider.largest * (std::pow(k, 1.0 - static_cast<double>(t)) - 1) / (k - 1);
}
float toSlider(const Slider& slider, double value) {
  const double k = base(slider);
  const double u = std::log(1 + value * (k - 1) / slider.largest) / std::log(k);
  return static_cast<float>(std::clamp(1 - u, 0.0, 1.0));
}

bool any(const Refinement& refine) {
  return std::any_of(kSliders.begin(), kSliders.end(),
                     [&](const Slider& slider) { return (refine.*slider.threshold).has_value(); });
}

// What is left after each step, when those behind it did nothing. Costs some rigs, so they are kept
// until a setting changes.
class Steps {
 public:
  static constexpr size_t kCount = 4;

  const Rig& after(size_t step, const PanelInput& input) {
    if (step + 1 == kCount) return input.rig;
    update(input);
    return rigs_[step];
  }

 private:
  void update(const PanelInput& input) {
    if (input.shown.parts == parts_ && input.shown.refine == refine_) return;
    parts_ = input.shown.parts;
    refine_ = input.shown.refine;
    std::vector<RigPart> rig_parts = input.evaluation.rigParts();
    std::vector<PartSource> sources;
    for (const auto& part : parts_) {
      sources.push_back(*part);
      sources.back().stroke.clear();
    }
    for (RigPart& part : rig_parts) {
      if (part.source) part.source = &sources[part.placed->source];
    }
    Refinement model = refine_;
    for (size_t step = kCount - 1; step-- > 0;) {
      const Threshold off = kSliders[step + 1].threshold;
      model.*off = 0;
      for (PartSource& source : sources) source.refine.*off = 0;
      rigs_[step] = refineRig(rig_parts, input.rig.connections, model);
    }
  }

  std::vector<std::shared_ptr<const PartSource>> parts_;
  Refinement refine_;
  std::array<Rig, kCount - 1> rigs_;
};

Steps steps;  // belongs to the one set of panels, as ImGui's own state does

class Thresholds {
 public:
  Thresholds(const PanelInput& input, UiState& ui, Requests& requests)
      : input_(input), ui_(ui), requests_(requests), ids_(selectedSources(input, ui)) {
    scope_ = ui.refine_scope;
    if (scope_ == RefineScope::branch && !hasBranch()) scope_ = RefineScope::part;
    if (ids_.empty()) scope_ = RefineScope::model;
    if (!ids_.empty()) part_ = input.shown.parts[*input.shown.find(ids_.back())].get();
  }

  void draw() {
    scopes();
    if (input_.shown.parts.empty()) {
      softText("Draw something first.");
      return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 6));
    softText("fewer joints");
    const char* more = "more";
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(more).x -
                    resetSide());
    softText(more);
    ImGui::PopStyleVar();
    for (size_t i = 0; i < kSliders.size(); ++i) {
      if (scope_ != RefineScope::branch || i == 0) sliderRow(i);
    }
    if (scope_ == RefineScope::part && !hasBranch()) {
      softText(ui_.touch() ? "Tap a bone to change its branch alone."
                           : "Click a bone to change its branch alone.");
    }
    resets();
  }

 private:
  bool hasBranch() const { return ids_.size() == 1 && !ui_.selection.branch.empty(); }
  float resetSide() const { return ui_.touch() ? 44.0f : 32.0f; }
  Ids targets() const { return scope_ == RefineScope::model ? Ids{} : Ids(ids_); }
  std::string branch() const {
    return scope_ == RefineScope::branch ? ui_.selection.branch : std::string();
  }

  void scopes() {
    if (ids_.empty()) return;
    std::vector<Choice> all;
    std::vector<RefineScope> scopes;
    if (hasBranch()) {
      all.push_back({"scopeBranch", "Branch"});
      scopes.push_back(RefineScope::branch);
    }
    all.push_back({"scopePart", ids_.size() == 1 ? "This part" : "These parts"});
    scopes.push_back(RefineScope::part);
    all.push_back({"scopeModel", "Whole model"});
    scopes.push_back(RefineScope::model);
    const auto at =
        static_cast<size_t>(std::find(scopes.begin(), scopes.end(), scope_) - scopes.begin());
    const size_t chosen = choices(all, at, rowHeight(ui_));
    if (chosen == at) return;
    ui_.refine_scope = scopes[chosen];
    requests_.again = true;
  }

  // What is set at this scope, and what would hold if it were not.
  std::optional<double> own(const Slider& slider) const {
    if (scope_ == RefineScope::model) return input_.shown.refine.*slider.threshold;
    if (scope_ == RefineScope::part) return part_->refine.*slider.threshold;
    const auto found = part_->branches.find(ui_.selection.branch);
    if (found == part_->branches.end()) return std::nullopt;
    return found->second;
  }
  double inherited(const Slider& slider) const {
    if (scope_ == RefineScope::model) return slider.standard;
    const double model = (input_.shown.refine.*slider.threshold).value_or(slider.standard);
    if (scope_ == RefineScope::part) return model;
    return (part_->refine.*slider.threshold).value_or(model);
  }

  size_t jointsIn(const Rig& rig) const {
    const auto& placed = input_.evaluation.placed();
    return static_cast<size_t>(
        std::count_if(rig.joints.begin(), rig.joints.end(), [&](const Rig::Joint& joint) {
          if (scope_ == RefineScope::model) return true;
          if (joint.part >= placed.size() || placed[joint.part].twin) return false;
          if (std::find(ids_.begin(), ids_.end(), placed[joint.part].id) == ids_.end())
            return false;
          return scope_ != RefineScope::branch || branchKey(joint.branch) == ui_.selection.branch;
        }));
  }

  void sliderRow(size_t i) {
    const Slider& row = kSliders[i];
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
    heading(row.name);
    ImGui::SameLine(0, 6);
    softText(row.symbol);
    const size_t last = scope_ == RefineScope::branch ? Steps::kCount - 1 : i;
    const std::string count = counted(jointsIn(steps.after(last, input_)), "joint");
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x);
    softText(count.c_str());
    ImGui::PopStyleVar();

    const auto set = own(row);
    const double otherwise = inherited(row);
    const float mark = toSlider(row, otherwise), side = resetSide();
    float t = toSlider(row, set.value_or(otherwise));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 6));
    const SliderEvent event =
        slider(row.id, t, mark, side, ImGui::GetContentRegionAvail().x - side);
    char tooltip[200];
    std::snprintf(tooltip, sizeof tooltip, "%s\n%s = %.3g.  The dot: %s", row.what, row.symbol,
                  set.value_or(otherwise), dotMeans());
    tooltipForLastItem(tooltip);
    SetRefinement change{targets(), branch(), row.threshold, std::nullopt};
    if (event.changed) {
      if (t != mark) change.value = fromSlider(row, t);
      ui_.edit = PendingEdit{change};
    }
    if (event.released && !event.reset) requests_.commit_edit = true;
    requests_.reset |= event.reset;
    ImGui::SameLine();
    ImGui::PushID(row.id);
    bool reset = event.reset;
    if (set) {
      reset |= iconButton("reset", kIconRotateCcw, side, {"Back to the dot"});
    } else {
      ImGui::Dummy({side, side});
    }
    ImGui::PopID();
    ImGui::PopStyleVar();
    if (reset) {
      change.value.reset();
      requests_.commands.push_back(change);
    }
    requests_.again |= event.changed || event.released || reset;
  }

  const char* dotMeans() const {
    if (scope_ == RefineScope::model) return "the usual value";
    return scope_ == RefineScope::part ? "the whole model's value" : "the part's value";
  }

  void textReset(const char* id, const char* text, const char* tooltip, bool within) {
    ButtonLook look{tooltip};
    look.raised = true;
    look.width = ImGui::GetContentRegionAvail().x;
    if (textButton(id, text, rowHeight(ui_), look)) {
      requests_.commands.push_back(ResetRefinement{targets(), branch(), within});
    }
  }

  // How to take everything back, and what narrower scopes keep to themselves.
  void resets() {
    bool set = false;
    size_t within = 0;
    if (scope_ == RefineScope::model) {
      set = any(input_.shown.refine);
      within = static_cast<size_t>(std::count_if(
          input_.shown.parts.begin(), input_.shown.parts.end(),
          [](const auto& part) { return any(part->refine) || !part->branches.empty(); }));
    } else if (scope_ == RefineScope::part) {
      for (const std::string& id : ids_) {
        const PartSource& part = *input_.shown.parts[*input_.shown.find(id)];
        set |= any(part.refine);
        within += part.branches.size();
      }
    } else {
      set = own(kSliders[0]).has_value();
    }
    if (set) textReset("resetAll", "Reset", "All of these back to the dots", false);
    if (within == 0) return;
    const bool model = scope_ == RefineScope::model;
    const std::string note = counted(within, model ? "part" : "branch") +
                             (within == 1 ? " has its own settings" : " have their own settings");
    softText(
        (within > 1 && !model ? std::to_string(within) + " branches have their own settings" : note)
            .c_str());
    textReset("resetWithin", "Reset those too", "Everything in here follows this scope again",
              true);
  }

  const PanelInput& input_;
  UiState& ui_;
  Requests& requests_;
  std::vector<std::string> ids_;
  RefineScope scope_;
  const PartSource* part_ = nullptr;  // the last one chosen
};

}  // namespace

void drawThresholds(const PanelInput& input, UiState& ui, Requests& requests) {
  Thresholds(input, ui, requests).draw();
}

void drawRefinePanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.skeleton || ui.tool == ToolKind::pose || partPanelShows(input, ui) || input.drawing)
    return;
  beginPanel("refine", ui.narrow() ? sheetBox(ui) : columnBox(ui));
  if (titleRow("Bones", ui)) {
    ui.open.skeleton = false;
    requests.again = true;
  }
  drawThresholds(input, ui, requests);
  endPanel();
}

}  // namespace marrow
