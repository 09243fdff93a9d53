// Where a part hangs, in plain words, and what overrules it.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "icons.h"
#include "panels/layout.h"
#include "panels/sections.h"

namespace marrow {
namespace {

struct Hanging {
  enum class Kind { alone, root, single, joint, overlap, user, carried, loose };
  Kind kind = Kind::alone;
  std::string title, sentence;
  bool is_root = false;  // the bones of its tree begin here
  Ids others;            // the other parts of its tree
};

// Placed parts that hang together, each with the first one of its tree.
std::vector<uint32_t> trees(const PanelInput& input) {
  std::vector<uint32_t> first(input.evaluation.placed().size());
  std::iota(first.begin(), first.end(), 0u);
  const auto top = [&](uint32_t i) {
    while (first[i] != i) i = first[i];
    return i;
  };
  for (const Connection& connection : input.rig.connections) {
    if (std::max(connection.child, connection.parent) >= first.size()) continue;
    const uint32_t a = top(connection.child), b = top(connection.parent);
    first[std::max(a, b)] = std::min(a, b);
  }
  for (uint32_t i = 0; i < first.size(); ++i) first[i] = top(i);
  return first;
}

class Finder {
 public:
  Finder(const PanelInput& input, const std::string& id)
      : input_(input), placed_(input.evaluation.placed()) {
    while (own_ < placed_.size() && placed_[own_].id != id) ++own_;
  }

  bool found() const { return own_ < placed_.size(); }
  const PartSource& source() const { return sourceOf(own_); }

  Hanging find() const {
    Hanging hanging;
    tree(hanging);
    using Kind = Hanging::Kind;
    const auto& connections = input_.rig.connections;
    const auto on = std::find_if(connections.begin(), connections.end(),
                                 [&](const Connection& one) { return one.child == own_; });
    if (!source().skeleton) {
      carried(hanging);
    } else if (on != connections.end() && on->parent < placed_.size()) {
      const std::string name = nameOf(on->parent);
      hanging.title = "Hangs on " + name;
      if (on->test == AttachTest::user) {
        hanging.kind = Kind::user;
        hanging.sentence = "It hangs on " + name + " because you chose so.";
      } else if (on->test == AttachTest::overlap) {
        hanging.kind = Kind::overlap;
        hanging.sentence = "It found " + name + " by itself: the two overlap.";
      } else {
        hanging.kind = Kind::joint;
        hanging.sentence = "It found " + name + " by itself: its bones begin inside.";
      }
    } else if (placed_.size() == 1) {
      hanging.kind = Kind::single;
      hanging.title = "The skeleton begins here";
      hanging.sentence = "Parts drawn on this one will hang on it.";
    } else if (!hanging.others.empty()) {
      hanging.kind = Kind::root;
      hanging.title = hanging.is_root ? "The skeleton begins here" : "Holds other parts";
      hanging.sentence = "Other parts hang on this one.";
    } else {
      hanging.kind = Kind::alone;
      hanging.title = "Hangs on nothing";
      hanging.sentence =
          "It would stay behind when the others move. Move it until it touches another part, or "
          "press \xE2\x80\x9C"
          "Attach to\xE2\x80\x9D and then a bone.";
    }
    return hanging;
  }

 private:
  const PartSource& sourceOf(size_t placed) const {
    return *input_.evaluation.parts()[placed_[placed].source].source;
  }
  std::string nameOf(size_t placed) const {
    std::string name = sourceOf(placed).name;
    if (placed_[placed].side) name += std::string(".") + placed_[placed].side;
    return name;
  }

  void tree(Hanging& hanging) const {
    const std::vector<uint32_t> first = trees(input_);
    for (size_t i = 0; i < placed_.size(); ++i) {
      const std::string& id = sourceOf(i).id;
      if (first[i] != first[own_] || id == source().id) continue;
      if (std::find(hanging.others.begin(), hanging.others.end(), id) == hanging.others.end()) {
        hanging.others.push_back(id);
      }
    }
    for (const uint32_t root : input_.rig.roots) {
      const uint32_t part = input_.rig.joints[root].part;
      hanging.is_root |= part < placed_.size() && placed_[part].source == placed_[own_].source;
    }
  }

  void carried(Hanging& hanging) const {
    hanging.kind = Hanging::Kind::loose;
    hanging.title = "Moves with nothing";
    hanging.sentence = "Move it until it touches a part with bones.";
    for (const auto& [part, joint] : input_.rig.carried) {
      if (part != own_ || joint < 0) continue;
      const uint32_t on = input_.rig.joints[static_cast<size_t>(joint)].part;
      if (on >= placed_.size()) continue;
      hanging.kind = Hanging::Kind::carried;
      hanging.title = "Moves with " + nameOf(on);
      hanging.sentence = "It has no bones and moves with what it sits on.";
    }
  }

  const PanelInput& input_;
  const std::vector<PlacedPart>& placed_;
  size_t own_ = 0;
};

// Buttons in rows that are filled one after the other.
class ButtonFlow {
 public:
  explicit ButtonFlow(float height) : height_(height), left_(ImGui::GetContentRegionAvail().x) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(kGap, kGap));
  }
  ~ButtonFlow() { ImGui::PopStyleVar(); }
  ButtonFlow(const ButtonFlow&) = delete;
  ButtonFlow& operator=(const ButtonFlow&) = delete;

  bool button(const char* id, const char* text, const char* tooltip, bool on = false) {
    ButtonLook look{tooltip};
    look.raised = true;
    look.on = on;
    look.width = ImGui::CalcTextSize(text).x + 22;
    const float whole = ImGui::GetContentRegionAvail().x;
    if (count_++ > 0 && look.width + kGap <= left_) {
      ImGui::SameLine();
      left_ -= look.width + kGap;
    } else {
      left_ = whole - look.width;
    }
    return textButton(id, text, height_, look);
  }

 private:
  static constexpr float kGap = 6;
  float height_, left_;
  int count_ = 0;
};

}  // namespace

void drawAttachment(const PanelInput& input, UiState& ui, Requests& requests) {
  const Finder finder(input, ui.selection.primary());
  if (!finder.found()) return;
  using Kind = Hanging::Kind;
  const Hanging hanging = finder.find();
  const bool loose = hanging.kind == Kind::alone || hanging.kind == Kind::loose;
  if (disclosure("attachment", loose ? kIconUnlink : kIconLink, hanging.title.c_str(), "",
                 ui.open.attachment, rowHeight(ui))) {
    ui.open.attachment = !ui.open.attachment;
    requests.again = true;
  }
  if (!ui.open.attachment) return;
  softText(hanging.sentence.c_str());
  if (input.shown.parts.size() < 2) return;

  const PartSource& part = finder.source();
  ButtonFlow flow(rowHeight(ui));
  if (flow.button("attach", "Attach to\xE2\x80\xA6",
                  "Then click the bone or the part it shall hang on", ui.attaching)) {
    ui.attaching = !ui.attaching;
    if (ui.narrow()) ui.open.part = ui.open.bones = false;  // the model has to be seen
    requests.again = true;
  }
  const bool hangs = hanging.kind == Kind::joint || hanging.kind == Kind::overlap ||
                     hanging.kind == Kind::user || hanging.kind == Kind::carried;
  if (hangs && flow.button("detach", "Detach", "It shall hang on nothing")) {
    requests.commands.push_back(SetAttachment{part.id, Attachment{}});
  }
  if (part.attachment && flow.button("byItself", "By itself",
                                     "Forget what was chosen: it finds its place by itself")) {
    requests.commands.push_back(SetAttachment{part.id, std::nullopt});
  }
  if (part.skeleton && !hanging.is_root && !hanging.others.empty() &&
      flow.button("root", "Begin here", "The bones of the whole creature begin in this part")) {
    requests.commands.push_back(SetRoot{part.id, hanging.others});
  }
}

void drawAttachHint(const PanelInput&, UiState& ui) {
  const char* text = ui.touch() ? "Tap the bone or the part it shall hang on."
                                : "Click the bone or the part it shall hang on. Esc: never mind.";
  const float wrap = std::min(canvasWidth(ui) - 4 * margin(ui) - 32, 420.0f);
  const ImVec2 extent = ImGui::CalcTextSize(text, nullptr, false, wrap);
  const float top =
      ui.narrow() ? 2 * margin(ui) + std::max(barHeight(ui), gizmoSide(ui)) : margin(ui) + 4;
  const ImVec2 low{std::round(canvasWidth(ui) / 2 - extent.x / 2 - 16), top};
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(low, {low.x + extent.x + 32, low.y + extent.y + 20}, Theme::kAccent, 12);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + 16, low.y + 10},
               Theme::kTooltipText, text, nullptr, wrap);
}

}  // namespace marrow
