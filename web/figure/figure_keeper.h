// Keeps the figure up to date by work that the platform does elsewhere: when the rig or the mesh
// has changed it asks for another one, and what is under way for an older one is given up.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "document/evaluation.h"
#include "figure/figure.h"
#include "figure/work_order.h"

namespace marrow {

class FigureKeeper {
 public:
  // How long the drawing must stay as it is before work begins.
  static constexpr double kCalm_ms = 900, kCalmWhilePosing_ms = 80;

  /// Looks at the drawing after every change of it.
  void see(const Document& document, const Evaluation& evaluation, double now_ms);
  /// Once a frame, with the document seen last. busy: it is changing under a hand. posing: somebody
  /// waits.
  std::optional<WorkOrder> update(const Document& document, bool busy, bool posing, double now_ms);
  /// When `update` has something to do even if nothing happens.
  double due_ms() const { return due_ms_; }

  // What the platform tells of the work with this number; of any other than the last it is ignored.
  void made(uint64_t number, const std::string& bytes);
  void progress(uint64_t number, double done);
  /// why: a sentence where the work came to nothing.
  void ended(uint64_t number, const std::string& why);

  /// Of the drawing's present parts, or null. Its seams may still be as soft as they were before;
  /// its weights may be a guess, or of the rig before.
  const std::shared_ptr<const Figure>& figure() const { return shown_; }
  /// Of the figure, where there is one (see figure.h).
  const Figure& outermost() const { return outermost_; }
  /// Changes with the figure; never reused, nor that of any other mesh.
  uint64_t meshId() const { return mesh_id_; }
  /// It is of the drawing as it is now, with its final weights, and all that is painted over them.
  bool ready() const { return shown_ && of_ == wanted_ && !shown_->guessed; }
  /// 0 … 1 while one is made, else −1.
  double done() const { return number_ == 0 ? -1 : done_; }
  /// Why there is none; empty: there is no reason why not.
  const std::string& failure() const { return failure_; }
  size_t ordered() const { return ordered_; }

 private:
  /// See workshop.h; 0: nothing.
  struct Keys {
    uint64_t parts = 0, mesh = 0, body = 0, strokes = 0;
    bool operator==(const Keys& other) const {
      return parts == other.parts && mesh == other.mesh && body == other.body &&
             strokes == other.strokes;
    }
  };

  std::shared_ptr<const Figure> made_, shown_;
  Figure outermost_;  // of made_
  Keys of_;           // what made_ was made of
  Keys wanted_;       // what there is now
  Keys begun_;        // of the work under way
  double changed_ms_ = 0;
  double due_ms_ = std::numeric_limits<double>::infinity();
  uint64_t number_ = 0;  // of the work under way; 0: none
  size_t ordered_ = 0;
  double done_ = 0;
  uint64_t mesh_id_ = uint64_t{1} << 63;  // the evaluation counts up from 1
  std::string failure_;
};

}  // namespace marrow
