#include "platform/worker_thread.h"

#include <utility>
namespace marrow {

WorkerThread::WorkerThread(Clock clock, std::function<void()> wake)
    : clock_(clock), wake_(std::move(wake)) {}

WorkerThread::~WorkerThread() {
  for (Run& run : runs_) run.stopped = true;
  for (Run& run : runs_) run.thread.join();
}

void WorkerThread::begin(uint64_t number, const std::string& request) {
  for (auto run = runs_.begin(); run != runs_.end();) {
    run->stopped = true;
    if (run->done) {
      run->thread.join();
      run = runs_.erase(run);
    } else {
      ++run;
    }
  }
  if (request.empty()) return;
  Run& run = runs_.emplace_back();
  run.thread = std::thread([this, &run, number, request] {
    WorkTeller teller;
    teller.made = [&](const std::string& bytes) {
      add(run, [number, bytes](App& app) { app.workMade(number, bytes); });
    };
    teller.progress = [&](double done) {
      add(run, [number, done](App& app) { app.workProgress(number, done); });
      return !run.stopped;
    };
    const std::lock_guard<std::mutex> lock(at_work_);
    if (run.stopped) {
      run.done = true;
      return;
    }
    const auto result = workshop_.work(request, teller, clock_);
    const std::string why = result ? std::string() : result.message();
    add(run, [number, why](App& app) { app.workEnded(number, why); });
    run.done = true;
  });
}

void WorkerThread::add(const Run& run, News news) {
  if (run.stopped) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.push_back(std::move(news));
  }
  wake_();
}

void WorkerThread::tell(App& app) {
  std::vector<News> news;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    news.swap(news_);
  }
  for (const News& one : news) one(app);
}

}  // namespace marrow
