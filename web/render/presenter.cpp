#include "render/presenter.h"

#include "imgui.h"

namespace marrow {

void Presenter::draw(const App& app) {
  renderer_.draw(app.scene());
  panels_.draw(*ImGui::GetDrawData(), app.fontsVersion());
}

}  // namespace marrow
