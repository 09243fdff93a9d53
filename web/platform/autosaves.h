// Drawings that the desktop app keeps by itself: files in one folder, each locked by the process
// that has it open for as long as that lives.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "keep/keeping.h"

namespace marrow {

class Autosaves {
 public:
  static constexpr size_t kMost = 10;

  /// folder: made when it is needed.
  explicit Autosaves(std::string folder);
  ~Autosaves();
  Autosaves(const Autosaves&) = delete;
  Autosaves& operator=(const Autosaves&) = delete;

  /// $XDG_DATA_HOME/marrow or ~/.local/share/marrow; empty where there is neither.
  static std::string standardFolder();

  /// Keeps the job's text; false where it cannot be written. place: the drawing's file, if any.
  bool keep(const Job& job, const std::string& place);
  /// Those that no other process has open, but for the one of this drawing; newest first.
  std::vector<Recent> list(uint64_t drawing) const;
  std::string text(const std::string& slot) const;  // empty where there is none
  struct Entry {
    std::string name, place;
    size_t parts = 0;
    bool saved = false, dismissed = false;
  };
  Entry entry(const std::string& slot) const;
  void dismiss(const std::string& slot);
  /// The drawing goes on in this slot; false where another process has it.
  bool adopt(const std::string& slot, uint64_t drawing);

 private:
  std::string path(const std::string& slot, const char* ending) const;
  bool writeEntry(const std::string& slot, const Entry& entry) const;
  bool lock(const std::string& slot);
  bool isTaken(const std::string& slot) const;
  void makeRoom();

  std::string folder_;
  std::map<uint64_t, std::string> slots_;  // by drawing
  std::map<std::string, int> locks_;       // file descriptors
};

}  // namespace marrow
