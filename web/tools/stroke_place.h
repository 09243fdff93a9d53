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
/// With symmetry on, what the stroke looks like has a say:
/// - what stays within the outline of a body, such as an eye, lies on its surface;
/// - where the character is seen from its side, what looks like a limb lies on the body's side and
///   has a twin on the other; heads, necks and tails go on in the plane of symmetry;
/// - in other views, what leaves the body goes on in the middle of that body, and has a twin where
///   it is off the plane of symmetry; where nobody sketched the plane, only if it touches the
///   character.
class StrokePlace {
 public:
  struct Place {
    Frame frame;
    std::optional<Plane> mirror;
    bool completed = false;  // `stroke` is the given one with its mirror image
    std::vector<Vec2> stroke;
  };

  /// ground: the middle of what the model stands on. through_selected: instead of the surface. The
  /// evaluation has to stay as it is until the stroke ends.
  void begin(Vec2 pixel, const Camera& camera, const Document& document,
             const Evaluation& evaluation, const UiState& ui, Vec3 ground, bool through_selected);
  /// stroke: so far, as DrawTool gives it.
  Place at(const std::vector<Vec2>& stroke) const;

 private:
  /// The surface of the body that a stroke hangs on.
  struct Anchor {
    Hit hit;
    Vec2 at;  // in the view
  };

  Vec2 inView(Vec3 world) const { return {dot(right_, world), dot(up_, world)}; }
  std::vector<Vec2> outlineInView(size_t placed) const;
  Frame frameThrough(Vec3 world) const;
  std::optional<Anchor> anchorOf(const std::vector<Vec2>& stroke) const;
  bool looksLikeLimb(const std::vector<Vec2>& stroke, const Anchor& anchor) const;
  /// What the plane goes through, as far as the stroke can be told.
  Vec3 throughFor(const std::vector<Vec2>& stroke) const;

  const Evaluation* evaluation_ = nullptr;
  Camera camera_;
  ViewSize size_;
  Vec3 right_, up_, back_;
  Vec3 through_;
  std::optional<Hit> hit_;  // under the start of the stroke
  bool chosen_ = false;     // the user said what the plane goes through
  std::optional<Plane> symmetry_;
  bool side_view_ = false;                   // the plane of symmetry faces the viewer
  bool line_ = false;                        // the user sketched the line of symmetry
  double reach_ = 0;                         // how near to it a half outline ends, model units
  std::vector<std::vector<Vec2>> outlines_;  // of the placed parts, in the view; hidden ones: empty
};

}  // namespace marrow
