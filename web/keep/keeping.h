// Where drawings are kept: their names, unsaved changes, what is kept by itself, and what the
// platform is asked to do with files. Knows no platform: jobs go out, and what became of them comes
// in.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"

namespace marrow {

/// Something that only the platform can do.
struct Job {
  enum class Kind : uint8_t {
    open,     // a file: the one at `name`, or one that the user chooses
    save,     // `text` to the drawing's own file; to one that the user chooses where it has none
    save_as,  // `text` to a file that the user chooses, called `name`
    keep,     // `text` where the app keeps drawings by itself
    list,     // tell which drawings are kept there
    peek,     // the text of the kept drawing `slot`, to show it small
    restore,  // open the kept drawing `slot`
    dismiss,  // the kept drawing `slot` need not be offered again
    picture,  // a picture that the user chooses
    work,     // `text` is done elsewhere (figure/workshop.h) in place of what is under way; empty:
              // stop
    hand_over,  // `text`, a finished file, to where the user chooses; called `name`, with its
                // ending
    decode,     // the pixels of the picture `drawing`: `text` is a data URL
  };
  Kind kind = Kind::open;
  uint64_t id = 0;
  uint64_t drawing = 0;  // Document::drawing
  uint64_t number = 0;   // of work
  std::string name;      // without folder and ending, but a path where the platform has no dialogs
  std::string slot;
  std::string text;
  size_t parts = 0;    // of the drawing
  bool saved = false;  // the text is also in the drawing's file
};
const char* toString(Job::Kind kind);

/// A drawing that was kept by itself and that nobody has open.
struct Recent {
  std::string slot;
  std::string name;    // may be empty
  double changed = 0;  // when it was changed last, as the platform counts
  double age_s = 0;    // since then, when it was listed
  size_t parts = 0;
  bool offered = false;  // to be offered: the newest one, unless it was dismissed

  /// Of its thumbnail.
  std::string key() const { return slot + " " + std::to_string(changed); }
};
/// "5 minutes ago".
std::string ageInWords(double seconds);

/// Where an opened text comes from.
struct Origin {
  std::string name;    // of the drawing, without folder and ending; empty: the text says it
  std::string place;   // the file, as the platform calls it; empty: it is in none
  bool saved = true;   // the file holds the same
  bool kept = false;   // it is kept already
  bool known = false;  // it can be opened again at any time: kept only once it is changed
};

/// The name that a document's own text gives it; empty: none.
std::string nameIn(const Document& document);
/// What is written to a file: the document with its name.
std::string textWithName(const Document& document, const std::string& name);
/// The name as a file may be called everywhere.
std::string fileName(const std::string& name);
/// "folder/dog.json" → "dog".
std::string nameOfFile(const std::string& path);

class Keeping {
 public:
  static constexpr double kKeepAfter_ms = 1000;  // of a change
  static constexpr double kLatest_ms = 5000;     // of a change, however busy the hand is
  static constexpr const char* kNoName = "Untitled";

  /// Looks at the current document, once a frame. busy: a stroke or a slider is under the hand.
  void update(const Document& document, double now_ms, bool busy);
  /// Asks for what is not kept yet, at once.
  void keepNow();
  /// When `update` has something to do even if nothing happens.
  double due_ms() const;

  /// A number for a document that is about to be opened or begun.
  uint64_t add(const Document& document, const Origin& origin);

  // Of the drawing that `update` saw last.
  const std::string& name() const;  // empty: none yet
  const std::string& place() const;
  bool changed() const;  // since it was saved
  bool empty() const;
  /// For the window: "• dog – Marrow".
  std::string title() const;
  void rename(const std::string& name);

  void askOpen(const std::string& path = {});
  void askSave(bool as, const std::string& path = {});
  void ask(Job::Kind kind, const std::string& slot = {});
  void ask(Job job);
  std::vector<Job> takeJobs();

  /// A job of saving is done. name, place: as in Origin.
  void saved(uint64_t job, const std::string& name, const std::string& place);
  /// The drawing could not be kept: it is tried again with the next change.
  void notKept(uint64_t drawing);

  void setRecent(std::vector<Recent> recent, double now_ms);
  const std::vector<Recent>& recent() const { return recent_; }
  double recentSince_ms() const { return recent_since_ms_; }
  /// The one to be offered on the canvas, if any.
  const Recent* offer() const;
  /// It was offered long enough, or answered.
  void withdrawOffer();

  // What the platform can do.
  bool dialogs = true;  // lets the user choose files
  bool has_storage = true;

 private:
  struct Drawing {
    std::string name, place;
    std::optional<Document> saved, kept;
  };
  struct Saving {
    uint64_t job = 0;
    Document document;
  };
  Drawing& current() { return drawings_[seen_.drawing]; }
  const Drawing* find() const;
  bool isKept() const;

  std::map<uint64_t, Drawing> drawings_{{0, {}}};
  uint64_t last_drawing_ = 0;
  Document seen_;
  double changed_ms_ = -1;  // since when something is not kept; −1: nothing
  bool busy_ = false;
  std::vector<Job> jobs_;
  uint64_t last_job_ = 0;
  std::vector<Saving> saving_;
  std::vector<Recent> recent_;
  double recent_since_ms_ = 0;
};

}  // namespace marrow
