// What the scripts files.js, storage.js and pictures.js ask of the app, and the app of them.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "app.h"

namespace marrow {

class BrowserFiles {
 public:
  explicit BrowserFiles(App& app) : app_(app) {}
  /// The answer to a call of the scripts; nothing where the name is none of theirs. What comes with
  /// a long text has it after the first line.
  std::optional<std::string> call(const std::string& name, const std::string& text);
  /// The text of a job, once.
  std::string takeText(uint64_t job);
  /// The same for a file as it is. head: JSON that says where it comes from.
  std::string openFile(const std::string& head, const std::string& bytes);

 private:
  std::string jobs();

  App& app_;
  std::map<uint64_t, std::string> texts_;  // of jobs, until they are fetched
};

}  // namespace marrow
