// Draws Dear ImGui's draw lists. Its own OpenGL backend asks for twenty pieces of OpenGL's state
// each frame to restore them later; in a browser each question waits for the graphics process.
#pragma once

#include "render/gl.h"
#include "render/program.h"
#include "render/textures.h"

struct ImDrawData;

namespace marrow {

class PanelRenderer {
 public:
  PanelRenderer();
  /// fonts_version: another one means that the atlas is to be uploaded again.
  /// textures: what ImGui's texture ids mean; 0 is the font atlas.
  void draw(const ImDrawData& data, int fonts_version, const Textures& textures);
  std::string log() const { return program_.log(); }

 private:
  void uploadFonts();

  Program program_;
  GlTexture fonts_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_, indices_;
  int fonts_version_ = -1;
};

}  // namespace marrow
