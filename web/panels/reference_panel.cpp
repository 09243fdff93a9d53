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

struct Place {
  const char* id;
  const char* name;
  const char* tooltip;
  int column;
};

/// A slider with its name above it, half as wide as the panel; true while the value changes.
bool sliderAt(const Place& place, float& value, const UiState& ui, Requests& requests) {
  const float gap = 16, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  if (place.column == 1) ImGui::SameLine(0, gap);
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
  heading(place.name);
  const SliderEvent event = slider(place.id, value, 0.5f, ui.touch() ? 40.0f : 32.0f, width);
  ImGui::PopStyleVar();
  tooltipForLastItem(place.tooltip);
  ImGui::EndGroup();
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
  if (sliderAt({"opacity", "Opacity", "How clearly it is seen", 0}, t, ui, requests)) {
    reference.opacity = t;
    changed = true;
  }
  const double span = std::log(kLargest / kSmallest);
  t = static_cast<float>(
      std::clamp(std::log(reference.scale / fit.scale / kSmallest) / span, 0.0, 1.0));
  if (sliderAt({"size", "Size", "How large it is", 1}, t, ui, requests)) {
    reference.scale = fit.scale * kSmallest * std::exp(t * span);
    changed = true;
  }
  const auto slide = [&](const Place& place, double& value, double middle, double width) {
    auto at = static_cast<float>(std::clamp(0.5 + (value - middle) / width, 0.0, 1.0));
    if (!sliderAt(place, at, ui, requests)) return;
    value = middle + (at - 0.5) * width;
    changed = true;
  };
  slide({"across", "Left and right", "Moves it to the side", 0}, reference.position.x,
        fit.position.x, reach.x);
  slide({"upright", "Down and up", "Moves it down and up", 1}, reference.position.y, fit.position.y,
        reach.y);
  if (changed) ui.edit = PendingEdit{SetReference{reference}};
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
  const bool ready = picture && picture->pixels;
  if (picture && picture->broken) {
    softText("This picture cannot be shown: it is damaged, or of a kind that is not known here.");
  } else if (ready) {
    drawSliders(*reference, *picture->pixels, ui, requests);
  }
  const float width = (ImGui::GetContentRegionAvail().x - 16) / 3, height = rowHeight(ui);
  if (paleButton("fit", "Fit", width, height, "As large as the view, in its middle") && ready) {
    const Pixels& pixels = *picture->pixels;
    requests.commands.push_back(SetReference{
        fitted(*reference, pixels.natural_width, pixels.natural_height, ui.camera, ui.size)});
  }
  ImGui::SameLine();
  if (paleButton("choose", "Replace\xE2\x80\xA6", width, height, "Another picture in its place")) {
    requests.files.push_back({FileAction::Kind::picture, {}});
  }
  ImGui::SameLine();
  if (paleButton("remove", "Remove", width, height, "Takes the picture away", true)) {
    Reference none;
    none.view = view;
    requests.commands.push_back(SetReference{none});
  }
  endPanel();
}

}  // namespace marrow
