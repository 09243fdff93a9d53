// The picture to draw after that lies behind the view the camera is nearest to.
#include <algorithm>
#include <cmath>
#include <string>

#include "icons.h"
#include "keep/pictures.h"
#include "panels/menu_rows.h"
#include "panels/panel.h"

namespace marrow {
namespace {

constexpr double kSmallest = 1.0 / 8, kLargest = 8;  // of the size that fits

struct Row {
  const char* id;
  const char* name;
  const char* ends;
  const char* tooltip;
};

/// True while the value changes.
bool sliderRow(const Row& row, float& value, float mark, const UiState& ui, Requests& requests) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
  heading(row.name);
  const float width = ImGui::CalcTextSize(row.ends).x;
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  softText(row.ends);
  ImGui::PopStyleVar();
  const SliderEvent event = slider(row.id, value, mark, ui.touch() ? 40.0f : 32.0f);
  tooltipForLastItem(row.tooltip);
  if (event.released) requests.commit_edit = true;
  requests.again |= event.changed || event.released;
  return event.changed;
}

void drawSliders(const Reference& shown, const Pixels& pixels, UiState& ui, Requests& requests) {
  Reference reference = shown;
  const Reference fit =
      fitted(reference, pixels.natural_width, pixels.natural_height, ui.camera, ui.size);
  const Vec2 reach{ui.size.width / ui.camera.zoom, ui.size.height / ui.camera.zoom};
  bool changed = false;

  auto t = static_cast<float>(reference.opacity);
  if (sliderRow({"opacity", "Opacity", "faint \xE2\x86\x92 clear", "How clearly it is seen"}, t,
                0.5f, ui, requests)) {
    reference.opacity = t;
    changed = true;
  }
  const double span = std::log(kLargest / kSmallest);
  t = static_cast<float>(
      std::clamp(std::log(reference.scale / fit.scale / kSmallest) / span, 0.0, 1.0));
  if (sliderRow({"size", "Size", "small \xE2\x86\x92 large", "How large it is"}, t, 0.5f, ui,
                requests)) {
    reference.scale = fit.scale * kSmallest * std::exp(t * span);
    changed = true;
  }
  const auto place = [&](const Row& row, double& value, double middle, double width) {
    auto at = static_cast<float>(std::clamp(0.5 + (value - middle) / width, 0.0, 1.0));
    if (!sliderRow(row, at, 0.5f, ui, requests)) return;
    value = middle + (at - 0.5) * width;
    changed = true;
  };
  place({"across", "Across", "left \xE2\x86\x92 right", "Moves it to the side"},
        reference.position.x, fit.position.x, reach.x);
  place({"upright", "Upright", "down \xE2\x86\x92 up", "Moves it up and down"},
        reference.position.y, fit.position.y, reach.y);
  if (changed) ui.edit = PendingEdit{SetReference{reference}};

  ButtonLook look{"As large as the view, in its middle"};
  look.width = ImGui::GetContentRegionAvail().x;
  if (textButton("fit", "Fit into the view", rowHeight(ui), look)) {
    requests.commands.push_back(SetReference{fit});
  }
}

}  // namespace

void drawReferencePanel(const PanelInput& input, UiState& ui, Requests& requests) {
  if (!ui.open.picture || input.drawing) return;
  const Camera& camera = ui.glide.running() ? ui.glide.destination() : ui.camera;
  const Reference::View view = nearestView(camera);
  const Reference* reference = referenceIn(input.shown, view);
  beginPanel("picture", menuBox(ui, 300));
  if (titleRow("Picture to draw after", ui)) {
    ui.open.picture = false;
    requests.again = true;
  }
  const std::string where = std::string("Behind the ") + toString(view) + " view";
  if (!reference) {
    softText((where + ": none yet. Each view can have one.").c_str());
    if (accentButton("choose", "Choose a picture\xE2\x80\xA6", ImGui::GetContentRegionAvail().x,
                     rowHeight(ui))) {
      requests.files.push_back({FileAction::Kind::picture, {}});
    }
    softText(input.shelf.keeping.dialogs ? "Or drop it here, or paste it: PNG, JPEG or WebP."
                                         : "Or drop it here: PNG or JPEG.");
    endPanel();
    return;
  }
  softText((where + ", and seen from there alone.").c_str());
  const Picture* picture = input.shelf.pictures.find(*reference);
  if (picture && picture->broken) {
    softText("This picture cannot be shown: it is damaged, or of a kind that is not known here.");
  } else if (picture && picture->pixels) {
    drawSliders(*reference, *picture->pixels, ui, requests);
  }
  ButtonLook look{"Another picture in its place"};
  look.width = (ImGui::GetContentRegionAvail().x - 8) / 2;
  if (textButton("choose", "Replace\xE2\x80\xA6", rowHeight(ui), look)) {
    requests.files.push_back({FileAction::Kind::picture, {}});
  }
  ImGui::SameLine();
  look.tooltip = "Takes the picture away";
  look.danger = true;
  if (textButton("remove", "Remove", rowHeight(ui), look)) {
    Reference none;
    none.view = view;
    requests.commands.push_back(SetReference{none});
  }
  endPanel();
}

}  // namespace marrow
