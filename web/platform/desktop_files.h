// Files for the desktop app: what the browser's scripts do for the one in a page.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app.h"
#include "platform/autosaves.h"
#include "platform/worker_thread.h"

namespace marrow {

class DesktopFiles {
 public:
  /// keeps: drawings are kept by themselves. wake: called from other threads when there is
  /// something to do.
  DesktopFiles(App& app, bool keeps, Clock clock, std::function<void()> wake);

  /// Tells the app which drawings are kept; the newest one is offered.
  void start();
  /// Opens a drawing, imports a 3D model, or takes a picture to draw after. Errors are said in the
  /// app.
  Result<bool> open(const std::string& path);
  /// Opens the newest kept drawing; false where there is none.
  bool restoreNewest();
  /// Writes the drawing as it is; false where it cannot.
  bool write(const std::string& path);
  /// Does what the app asked for; once a frame.
  void perform();

 private:
  void perform(const Job& job);
  void save(const Job& job);
  void handOver(const Job& job);
  void restore(const std::string& slot);
  void list(bool offering);

  App& app_;
  bool keeps_;
  Autosaves autosaves_{Autosaves::standardFolder()};
  std::map<uint64_t, std::string> places_;  // files of the drawings
  bool said_not_kept_ = false;
  WorkerThread worker_;
};

}  // namespace marrow
