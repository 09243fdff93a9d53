// Brings an app's frame onto the screen: its scene, and the panels on top.
#pragma once

#include <memory>
#include <string>

#include "app.h"
#include "render/renderer.h"

namespace marrow {

/// The OpenGL context must be current wherever this is used.
class Presenter {
 public:
  Presenter();
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  void draw(const App& app);
  /// Why a shader did not compile; empty when all did.
  std::string log() const { return renderer_.log(); }

 private:
  Renderer renderer_;
  int fonts_version_ = 0;  // of the texture
};

}  // namespace marrow
