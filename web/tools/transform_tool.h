// Moves, turns and scales what is selected: by a handle of the gizmo, by dragging a part, or by
// G, R, S and then the pointer, an axis and a number.
#pragma once

#include <string>
#include <vector>

#include "camera.h"
#include "document/command.h"

namespace marrow {

enum class TransformKind : uint8_t { move, rotate, scale };
enum class TransformAxis : uint8_t { none, x, y, z };  // none: in the plane of the screen

class TransformTool {
 public:
  /// ids: of placed parts. pivot: what is turned and scaled about. by_key: ends with a click or
  /// Enter instead of with the button that began it.
  void begin(TransformKind kind, TransformAxis axis, std::vector<std::string> ids, Vec3 pivot,
             Vec2 pointer_px, const Camera& camera, ViewSize size, bool by_key);
  void move(Vec2 pointer_px);
  /// Axis letters, digits, point, minus and backspace ('\b'); whether it was one of them.
  bool key(char character);
  void end() { active_ = false; }

  bool active() const { return active_; }
  bool byKey() const { return by_key_; }
  TransformKind kind() const { return kind_; }
  TransformAxis axis() const { return axis_; }
  Vec3 pivot() const { return pivot_; }
  /// The pointer has left where it was, or a number was typed.
  bool changed() const { return changed_; }
  /// The document's change so far.
  TransformParts command() const;
  /// "Move X: 35", for the hand to see.
  std::string label() const;

 private:
  double amount() const;  // model units, degrees or a factor
  Affine map() const;

  bool active_ = false, by_key_ = false, changed_ = false;
  TransformKind kind_ = TransformKind::move;
  TransformAxis axis_ = TransformAxis::none;
  std::vector<std::string> ids_;
  Vec3 pivot_;
  Vec2 pivot_px_, start_px_, now_px_;
  double turned_rad_ = 0;  // of the pointer about the pivot, counter-clockwise on the screen
  Camera camera_;
  std::string typed_;
};

/// The unit vector of an axis; of none: towards the viewer.
Vec3 axisDirection(TransformAxis axis, const Camera& camera);

}  // namespace marrow
