// What one frame shows, as plain data: made by buildScene, drawn by the Renderer. Coordinates are
// relative to the camera's target, so that float is precise enough wherever the model lies.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/frame.h"
#include "camera.h"
#include "figure/figure.h"
#include "part/part.h"

namespace marrow {

struct Float3 {
  float x = 0, y = 0, z = 0;
};

struct Rgba {
  float r = 0, g = 0, b = 0, a = 1;
};

struct Scene {
  /// A part's mesh in its frame; the GPU keeps it under its id.
  struct Body {
    uint64_t mesh_id = 0;
    std::shared_ptr<const Part> part;
    Frame frame;
    Rgba color;
    bool selected = false;
  };
  /// The whole character as it is posed.
  struct PosedFigure {
    /// A joint's motion about the figure's origin, and its colour.
    struct Joint {
      std::array<float, 4> rotation{0, 0, 0, 1};
      std::array<float, 4> move{}, color{};
    };
    enum class Show : uint8_t { parts, joints, weight };  // weight: the red of the joints' colours
    uint64_t mesh_id = 0;
    std::shared_ptr<const Figure> figure;
    Skinning skinning = Skinning::linear;
    Show show = Show::parts;
    std::vector<Joint> joints;  // of the figure
    std::vector<Rgba> colors;   // of its stretches
  };
  /// A see-through rectangle: the plane that a stroke is drawn in.
  struct Sheet {
    Float3 center, x, y;  // x, y: from the centre to its sides
    Rgba color;
  };
  /// A picture to draw after, behind everything.
  struct Picture {
    Float3 center, x, y;  // as of a Sheet
    uint32_t texture = 0;
    float opacity = 1;
  };
  /// A line with round ends, as wide on the screen as it says.
  struct Segment {
    Float3 a, b;
    float width_px = 1;
    Rgba color;
  };
  struct Bone {
    Float3 head, tail;
    float radius = 0;  // model units
    Rgba color;
  };
  struct Ball {
    Float3 center;
    float radius = 0;  // model units
    Rgba color;
  };
  /// Part of the cone that touches both balls.
  struct Cone {
    Float3 a, b;
    float radius_a = 0, radius_b = 0;
    Rgba color;
  };

  Camera camera;
  ViewSize size;
  double dpr = 1;
  float depth = 1;  // nothing lies farther from the target, model units

  bool show_mesh = true, show_wireframe = false, show_shadow = false;
  Float3 low, high;  // box around the bodies
  std::vector<Picture> pictures;
  std::vector<Body> bodies;
  std::optional<PosedFigure> figure;  // drawn in place of the bodies
  std::vector<Sheet> sheets;
  std::vector<Segment> overlay;  // straight skeletons
  std::vector<Ball> proxy_balls;
  std::vector<Cone> proxy_cones;
  std::vector<Bone> bones;
  std::vector<Ball> joints;
  std::vector<Segment> ink;  // in the view of `ink_camera`
  Camera ink_camera;
};

/// Two scenes with the same fingerprint look the same.
uint64_t fingerprint(const Scene& scene);
/// The same for any bytes.
uint64_t fingerprint(const void* data, size_t bytes, uint64_t seed);

}  // namespace marrow
