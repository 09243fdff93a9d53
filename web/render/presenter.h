// Brings an app's frame onto the screen: its scene, and the panels on top.
#pragma once

#include <string>

#include "app.h"
#include "render/panel_renderer.h"
#include "render/renderer.h"
#include "render/textures.h"

namespace marrow {

/// The OpenGL context must be current wherever this is used.
class Presenter {
 public:
  void draw(const App& app);
  /// Why a shader did not compile; empty when all did.
  std::string log() const { return renderer_.log() + panels_.log(); }

 private:
  Renderer renderer_;
  PanelRenderer panels_;
  Textures textures_;
};

}  // namespace marrow
