// What lies under a pixel, and in a box on the screen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera.h"
#include "document/evaluation.h"

namespace marrow {

/// A place on the surface of a placed part.
struct Hit {
  size_t placed = 0;  // index of the placed part
  Vec3 position;      // world
  double facing = 0;  // of the surface to the viewer: 1 straight on, 0 at the rim
};

/// The visible surface nearest to the viewer there. Locked parts too: whoever selects leaves them
/// out.
std::optional<Hit> surfaceAt(Vec2 pixel, const Evaluation& evaluation, const Camera& camera,
                             ViewSize size);

/// The joint at the lower end of the visible bone nearest to the pixel, within `reach_px`.
std::optional<size_t> boneAt(Vec2 pixel, const Evaluation& evaluation, const Camera& camera,
                             ViewSize size, double reach_px);

/// Ids of the visible, unlocked placed parts of which something lies in the box with these corners.
std::vector<std::string> partsInBox(Vec2 a_px, Vec2 b_px, const Evaluation& evaluation,
                                    const Camera& camera, ViewSize size);

/// Middle of the box around a placed part's outline, world.
Vec3 middleOf(const EvaluatedPart& part, const Frame& frame);

}  // namespace marrow
