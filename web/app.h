// The app: one frame in a fixed order. Knows no OpenGL and no platform, so that a test can run it
// without either.
#pragma once

#include <deque>
#include <limits>
#include <string>
#include <utility>

#include "document/evaluation.h"
#include "document/history.h"
#include "figure/figure_keeper.h"
#include "figure/file_maker.h"
#include "input.h"
#include "io/mesh_import.h"
#include "keep/shelf.h"
#include "meter.h"
#include "panels/panel_layer.h"
#include "render/scene.h"
#include "scene_builder.h"
#include "tools/hand.h"
#include "tools/tools.h"
#include "ui_state.h"
#include "warm_up.h"

namespace marrow {

class App {
 public:
  /// clock: milliseconds, the same as the events' and frames' times.
  explicit App(Clock clock);

  void resize(ViewSize size, double dpr);
  void post(InputEvent event) { input_.push_back(std::move(event)); }

  struct FrameResult {
    bool draw = false;   // something on the screen changes
    bool again = false;  // another frame is needed at once
    double wake_after_ms = std::numeric_limits<double>::infinity();  // else, without an event
  };
  /// Input → tools → commands → evaluation → scene → panels. What panels ask for is applied in the
  /// next frame.
  FrameResult frame(double now_ms);
  /// What to draw; ImGui's draw data goes on top.
  const Scene& scene() const { return scene_; }
  int fontsVersion() const { return panels_.fontsVersion(); }
  bool wantsText() const { return panels_.wantsText(); }
  /// The next frame draws, whatever has changed: the picture was lost, or something came that no
  /// event told of.
  void redraw();

  /// The same as the user's hand does.
  bool undo();
  bool redo();
  /// Opens a document from its JSON. Errors leave everything as it is.
  Result<bool> load(const std::string& json);

  // What the platform does with files, and what it tells about them (app_files.cpp).
  std::vector<Job> takeJobs() { return shelf_.keeping.takeJobs(); }
  /// The same, for a text of a file or of what is kept; the drawing's number. Errors are said.
  /// file: what to call it where it cannot be opened.
  Result<uint64_t> open(const std::string& text, const std::string& file, const Origin& origin);
  /// A file as it was chosen or dropped: a drawing, also one in a GLB of ours, or else a mesh,
  /// which becomes a part in the middle of the view. Errors are said.
  struct Opened {
    uint64_t drawing = 0;
    bool has_file = false;  // the drawing is kept in this file from now on
  };
  Result<Opened> openFile(const std::string& bytes, const std::string& file, const Origin& origin);
  /// Puts a picture behind the view the camera is nearest to. image: a data URL.
  void addPicture(const std::string& image, int width, int height);
  /// The text of a kept drawing.
  void peeked(const std::string& slot, const std::string& text);
  /// Keeps what is not kept yet, without waiting.
  void keepNow();
  // What became of the work that a job asked for (app_pose.cpp).
  void workMade(uint64_t number, const std::string& bytes);
  void workProgress(uint64_t number, double done);
  /// why: a sentence where it came to nothing.
  void workEnded(uint64_t number, const std::string& why);

  /// One calm sentence on the canvas.
  void say(std::string sentence);
  Shelf& shelf() { return shelf_; }
  const Shelf& shelf() const { return shelf_; }

  const Document& document() const { return history_.current(); }
  const Evaluation& evaluation() const { return evaluation_; }
  const std::vector<EvaluatedPart>& parts() const { return evaluation_.parts(); }
  /// The rig with the part under the hand, and the placed parts that its indices mean.
  const Rig& rig() const { return live_rig_ ? *live_rig_ : evaluation_.rig(); }
  const Hand& hand() const { return hand_; }
  const FigureKeeper& figure() const { return figure_; }
  const FileMaker& file() const { return file_; }
  const Stance& stance() const { return stance_; }
  const LivePart& livePart() const { return live_; }
  const Error& liveError() const { return live_error_; }
  const DrawTool& drawing() const { return tools_.drawing(); }
  const UiState& ui() const { return ui_; }
  const Meter& meter() const { return meter_; }
  const WarmUp& warmUp() const { return warm_up_; }
  WarmUp& warmUp() { return warm_up_; }
  uint64_t framesDrawn() const { return frames_drawn_; }

 private:
  void takeInput();
  bool handle(const PointerEvent& event);  // whether the panels had it
  bool followKey(const PointerEvent& event);
  void handle(const KeyEvent& event);
  bool handleCharacter(char character);
  bool escape();
  void applyRequests();
  void joinLastSteps();
  void apply(const Command& command);
  void finishStroke();
  /// Whether a part hangs on another, or another on it.
  bool hangsTogether(const std::string& id) const;
  void transformByKey(TransformKind kind);
  void useTool(ToolKind tool);
  void toggleVisible(bool show_all);
  void layer(bool nearer);
  void update();
  void forgetWhatIsGone();
  void updateLivePart();
  void updateFigure(FrameResult& result);
  void makeFile(const std::string& name);
  void updateStance();
  Pose wantedPose() const;
  void endPoseGlide();
  void followPoseNames(const Document& before);
  bool posingKey(char character);
  bool takesHold(Vec2 pixel) const;
  void chooseJoint(Vec2 pixel);
  void click(Vec2 pixel, bool shift);
  /// The joint at the end of the bone that a click there means.
  std::optional<size_t> boneUnder(Vec2 pixel) const;
  void attachAt(Vec2 pixel);
  Hand::World world() const {
    return {document(), evaluation_, ground(), stance_, figure_.figure()};
  }
  Vec3 ground() const;
  void replace(Document document, const Origin& origin, const std::string& step);
  Result<bool> importFile(const std::string& bytes, const std::string& file, MeshFormat format);
  void act(const FileAction& action);
  bool handleFileKey(Key key);
  void updateShelf(FrameResult& result);
  void show(StandardView view);
  void frameAll();
  Insets frameInsets(const Insets& covered) const;
  void makeRoom();
  std::pair<Vec3, Vec3> modelBox() const;
  Vec3 pivot() const;
  void closeEdit();

  Clock clock_;
  UiState ui_;
  Tools tools_;
  Hand hand_;
  PanelLayer panels_;
  History history_;
  Evaluation evaluation_;
  Document shown_;  // the current document with the edit under the hand
  Scene scene_;
  Meter meter_;
  WarmUp warm_up_;
  Shelf shelf_;
  /// Where the camera was before a sheet came, and where it is beside the sheet.
  struct Room {
    Camera before, beside;
    Insets covered;
  };
  std::optional<Room> room_;
  bool frame_all_next_ = false;  // once the scene shows what was opened
  LivePart live_;
  Error live_error_;
  size_t live_points_ = 0;      // of the stroke, when the live part was made
  double next_preview_ms_ = 0;  // earliest time for another one
  std::optional<Rig> live_rig_;
  FigureKeeper figure_;
  FileMaker file_;
  Stance stance_;  // while poses are made
  uint64_t stance_rig_ = 0;
  // A change of pose that no hand made glides.
  Pose shown_pose_, wanted_pose_, glide_from_;
  double glide_since_ms_ = -1e9, last_amount_ = 0;
  Vec2 pointer_px_;          // where the pointer was last
  bool shift_ = false;       // held at the last press
  bool swallow_up_ = false;  // the press that ended a transformation by key goes up unheard

  std::deque<InputEvent> input_;
  Requests requests_;
  bool document_changed_ = true;
  double let_go_ms_ = -1;  // when the last step came from a setting under the hand; −1: it did not
  int frames_to_settle_ = 3;  // ImGui needs some to react to what it saw
  uint64_t drawn_fingerprint_ = 0;
  uint64_t frames_drawn_ = 0;
};

}  // namespace marrow
