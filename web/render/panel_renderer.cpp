#include "render/panel_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "imgui.h"

namespace marrow {
namespace {

const void* offset(size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

PanelRenderer::PanelRenderer()
    : program_("panel.vert", "panel.frag"),
      vertex_array_(makeVertexArray()),
      vertices_(makeBuffer()),
      indices_(makeBuffer()) {
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  constexpr GLsizei kStride = sizeof(ImDrawVert);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, pos)));
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, uv)));
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                        offset(offsetof(ImDrawVert, col)));
  glBindVertexArray(0);
}

void PanelRenderer::uploadFonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  fonts_ = makeTexture(width, height, pixels, false);
}

void PanelRenderer::draw(const ImDrawData& data, int fonts_version, const Textures& textures) {
  if (fonts_version_ != fonts_version) {
    uploadFonts();
    fonts_version_ = fonts_version;
  }
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("u_size", data.DisplaySize.x, data.DisplaySize.y);
  program_.set("u_fonts", 0);
  glActiveTexture(GL_TEXTURE0);
  GLuint bound = 0;
  glBindVertexArray(vertex_array_.name());
  const ImVec2 scale = data.FramebufferScale;
  const float height = data.DisplaySize.y * scale.y;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                 GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4 clip = command.ClipRect;
      const auto left = static_cast<GLint>(std::floor(std::max(clip.x, 0.0f) * scale.x));
      const auto right = static_cast<GLint>(std::ceil(clip.z * scale.x));
      const auto top = static_cast<GLint>(std::floor(std::max(clip.y, 0.0f) * scale.y));
      const auto bottom = static_cast<GLint>(std::ceil(clip.w * scale.y));
      if (right <= left || bottom <= top) continue;
      const auto id = static_cast<TextureId>(reinterpret_cast<uintptr_t>(command.GetTexID()));
      const GLuint texture = id == 0 ? fonts_.name() : textures.find(id);
      if (texture == 0) continue;
      if (texture != bound) glBindTexture(GL_TEXTURE_2D, texture);
      bound = texture;
      glScissor(left, static_cast<GLint>(std::ceil(height)) - bottom, right - left, bottom - top);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                     offset(command.IdxOffset * sizeof(ImDrawIdx)));
    }
  }
  glBindVertexArray(0);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace marrow
