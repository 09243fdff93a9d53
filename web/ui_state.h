// What the app shows and how: never part of the document, never undone.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/box.h"
#include "camera.h"
#include "document/command.h"
#include "figure/file_options.h"
#include "input.h"
#include "pose/skin.h"

namespace marrow {

struct ViewSwitches {
  bool mesh = true;
  bool wireframe = false;
  bool bones = true;
  bool straight_skeleton = false;
  bool proxy = false;
};

/// One calm sentence at the bottom of the canvas, gone after a while.
struct Toast {
  std::string text;
  double shown_ms = 0;  // when it appeared
};

/// One open sheet at a time where the canvas is narrow.
struct PanelsOpen {
  bool part = true;    // shown while a part is selected
  bool parts = false;  // the list of all parts
  bool view = false;
  bool performance = false;
  bool help = false;
  bool file = false;
  bool gallery = false;
  bool picture = false;  // to draw after
  bool exporting = false;

  bool skeleton = false;    // thresholds in a panel of their own, once no part's is there
  bool bones = false;       // in the part's panel: the same
  bool attachment = false;  // in the part's panel: where it hangs

  bool pose = false;  // on a narrow canvas; a wide one shows it as long as poses are made

  /// Those that Esc closes.
  bool anySheet() const {
    return pose || view || performance || help || file || gallery || picture || exporting;
  }
  void closeSheets() {
    pose = view = performance = help = file = gallery = picture = exporting = false;
  }
};

/// What the thresholds on the screen are those of.
enum class RefineScope : uint8_t { branch, part, model };

/// What the primary button, one finger or the pen does on the canvas.
enum class ToolKind : uint8_t {
  draw,
  select,   // and move, turn, scale
  redraw,   // stretches of the selected part's outline
  reshape,  // the same, by dragging its points
  line,     // of symmetry
  pose,     // the joints of the finished character
};

const char* toString(ToolKind tool);

/// How the character is posed and shown while the tool in hand is ToolKind::pose.
struct Posing {
  enum class Weights : uint8_t { hidden, joint, all };  // those of the chosen joint, or of all

  std::string pose;            // name of the one shown and changed; empty, or none's: at rest
  std::string mix;             // name of another one, or empty for rest
  double amount = 0;           // 0 … 1 of `mix` in what is shown
  std::string joint;           // id of the one chosen last; may be empty
  std::set<std::string> pins;  // ids of joints that stay where they are
  bool turns = false;          // a drag turns a bone; else it pulls a joint
  Skinning skinning = Skinning::linear;
  Weights weights = Weights::hidden;
  std::optional<WeightStroke::Kind> brush;  // a drag paints weights, while they are shown
  static constexpr double kLeastBrush_px = 6, kLargestBrush_px = 160;
  double brush_px = 26, brush_strength = 0.6;

  /// What is about the character alone; how poses are made and shown stays.
  void forgetCharacter() {
    pose.clear();
    mix.clear();
    amount = 0;
    joint.clear();
    pins.clear();
  }
};

/// What is to be taken away, as chosen in the sheet.
struct Exporting {
  bool seen = false;         // the sheet is open
  FileOptions file;          // without name and scale
  double height_m = 1;       // of the whole character at rest; 0: 100 units are a metre
  std::string path;          // typed where the platform has no dialogs
  bool path_edited = false;  // else it follows the drawing's name
  bool making = false;       // as it was shown last
  double since_ms = -1e9;    // how long that has been so

  void forgetCharacter() {
    file.pose.clear();
    path_edited = false;
  }
};

inline bool paints(const Posing& posing) {
  return posing.brush && posing.weights != Posing::Weights::hidden;
}

/// What the user has chosen.
struct Selection {
  std::vector<std::string> ids;  // of placed parts; the last one chosen is the last
  std::string branch;            // key of a branch of the only part; may be empty

  bool empty() const { return ids.empty(); }
  /// The id of the placed part chosen last; empty where there is none.
  std::string primary() const { return ids.empty() ? std::string() : ids.back(); }
  bool has(const std::string& id) const {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  }
  void set(std::string id) { *this = id.empty() ? Selection{} : Selection{{std::move(id)}, {}}; }
  void toggle(const std::string& id) {
    const auto found = std::find(ids.begin(), ids.end(), id);
    branch.clear();
    if (found != ids.end()) {
      ids.erase(found);
    } else {
      ids.push_back(id);
    }
  }
  void clear() { *this = {}; }
};

/// A setting under the user's hand: shown, but not in the document until the hand lets go.
struct PendingEdit {
  Command command;
};

struct UiState {
  ViewSize size;
  double dpr = 1;  // device pixels per CSS pixel
  double now_ms = 0;

  Camera camera;
  CameraGlide glide;

  ViewSwitches show;
  PanelsOpen open;
  ToolKind tool = ToolKind::draw;
  bool symmetry = true;           // strokes off the plane of symmetry get a twin
  bool through_selected = false;  // new strokes lie as deep as the selected parts
  Selection selection;
  Posing posing;
  Exporting exporting;
  RefineScope refine_scope = RefineScope::part;
  bool attaching = false;  // the next click on a bone or a part says where the selected part hangs
  std::optional<PendingEdit> edit;
  std::optional<Toast> toast;
  std::optional<Box2>
      start_button;               // of the invitation, where it is shown: clicks open the samples
  double hint_since_ms = -1;      // when the invitation appeared; −1: not yet
  bool file_listed = false;       // kept drawings were asked for since the file panel is open
  std::set<std::string> peeked;   // keys of kept drawings whose thumbnails were asked for
  std::string file_path;          // typed where the platform has no dialogs
  bool file_path_edited = false;  // else it follows the drawing's name
  PointerKind last_pointer = PointerKind::mouse;
  double pressed_ms = 0;  // when a button or a finger went down last

  /// Phones, held upright or across: panels become bars and sheets.
  bool narrow() const { return size.width < 700 || size.height < 480; }
  /// Opens one sheet and closes the others, but for the selected part's.
  void openOnly(bool PanelsOpen::*sheet) {
    const PanelsOpen before = open;
    open = PanelsOpen{};
    open.part = before.part && !narrow();
    open.skeleton = before.skeleton && !narrow();
    open.bones = before.bones && !narrow();
    open.attachment = before.attachment && !narrow();
    open.*sheet = true;
  }
  /// Fingers need larger targets than a mouse.
  bool touch() const { return narrow() || last_pointer == PointerKind::touch; }
};

}  // namespace marrow
