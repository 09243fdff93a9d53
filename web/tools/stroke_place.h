// Where the plane of a new stroke lies, and whether the stroke gets a twin.
#pragma once

#include <optional>
#include <vector>

#include "base/frame.h"
#include "document/evaluation.h"
#include "pick.h"
#include "ui_state.h"

namespace marrow {

/// Set when a stroke begins; then asked again and again while it grows.
///
/// The plane faces the viewer. It goes through the surface under the start of the stroke, so that a
/// limb begins on the body it is drawn over; or through the middle of the selected parts, where the
/// user wants that; where nothing is, through the middle of the model's ground.
///
/// With symmetry on and the character seen from its side, a stroke that does not look like a limb
/// lies in the plane of symmetry: heads, necks and tails go on where the body ends. Limbs lie on
/// the body's side and have a twin on the other. In any other view, what is drawn off the plane has
/// a twin; where nobody sketched the plane, only what touches the character.
class StrokePlace {
 public:
  struct Place {
    Frame frame;
    std::optional<Plane> mirror;
    bool completed = false;  // `stroke` is the given one with its mirror image
    std::vector<Vec2> stroke;
  };

  /// ground: the middle of what the model stands on. through_selected: instead of the surface.
  void begin(Vec2 pixel, const Camera& camera, const Document& document,
             const Evaluation& evaluation, const UiState& ui, Vec3 ground, bool through_selected);
  /// stroke: so far, as DrawTool gives it.
  Place at(const std::vector<Vec2>& stroke) const;

 private:
  Frame frameThrough(Vec3 world) const;
  bool looksLikeLimb(const std::vector<Vec2>& stroke) const;
  bool touchesCharacter(const std::vector<Vec2>& stroke) const;

  struct End {  // of the bones of the body under the start, in the view
    Vec2 position, outward;
    double radius = 0;
  };

  Vec3 right_, up_, back_;
  Vec3 through_;
  std::optional<Hit> hit_;
  bool chosen_ = false;  // the user said what the plane goes through
  std::optional<Plane> symmetry_;
  bool side_view_ = false;  // the plane of symmetry faces the viewer
  bool line_ = false;       // the user sketched the line of symmetry
  double reach_ = 0;        // how near to it a half outline ends, model units
  std::vector<End> ends_;
  std::vector<std::vector<Vec2>> outlines_;  // of all visible parts, in the view
};

}  // namespace marrow
