#include "render/presenter.h"

#include "imgui.h"

namespace marrow {

void Presenter::draw(const App& app) {
  textures_.update(app.shelf(), app.ui().dpr, renderer_);
  renderer_.draw(app.scene(), textures_);
  panels_.draw(*ImGui::GetDrawData(), app.fontsVersion(), textures_);
}

}  // namespace marrow
