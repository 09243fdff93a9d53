// Work in threads of its own; the newest wins.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app.h"
#include "figure/workshop.h"

namespace marrow {

class WorkerThread {
 public:
  /// wake: called from the thread whenever there is something to tell.
  WorkerThread(Clock clock, std::function<void()> wake);
  ~WorkerThread();

  /// Gives up what is under way, without waiting for it; an empty request begins nothing.
  void begin(uint64_t number, const std::string& request);
  /// Tells the app what has happened since, in the app's thread.
  void tell(App& app);

 private:
  using News = std::function<void(App&)>;
  struct Run {
    std::thread thread;
    std::atomic<bool> stopped{false}, done{false};
  };
  void add(const Run& run, News news);

  Clock clock_;
  std::function<void()> wake_;
  Workshop workshop_;
  std::mutex at_work_;   // of the workshop
  std::list<Run> runs_;  // the newest last
  std::mutex mutex_;     // of the news
  std::vector<News> news_;
};

}  // namespace marrow
