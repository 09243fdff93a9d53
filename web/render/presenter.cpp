#include "render/presenter.h"

#include "backends/imgui_impl_opengl3.h"
#include "imgui.h"

namespace marrow {

Presenter::Presenter() {
#if defined(MARROW_GLES)
  ImGui_ImplOpenGL3_Init("#version 300 es");
#else
  ImGui_ImplOpenGL3_Init("#version 330 core");
#endif
}

Presenter::~Presenter() { ImGui_ImplOpenGL3_Shutdown(); }

void Presenter::draw(const App& app) {
  if (fonts_version_ != app.fontsVersion()) {
    if (fonts_version_ != 0) {
      ImGui_ImplOpenGL3_DestroyFontsTexture();
      ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    fonts_version_ = app.fontsVersion();
  }
  ImGui_ImplOpenGL3_NewFrame();
  renderer_.draw(app.scene());
  // The panels were laid out before the texture of this context was made.
  ImDrawData* panels = ImGui::GetDrawData();
  for (int i = 0; i < panels->CmdListsCount; ++i) {
    for (ImDrawCmd& command : panels->CmdLists[i]->CmdBuffer) {
      command.TextureId = ImGui::GetIO().Fonts->TexID;
    }
  }
  ImGui_ImplOpenGL3_RenderDrawData(panels);
}

}  // namespace marrow
