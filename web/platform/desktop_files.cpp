#include "platform/desktop_files.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <utility>

#include "platform/desktop_pictures.h"

namespace marrow {
namespace {

constexpr size_t kLargestFile = 256u << 20;

std::string withoutFolder(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

bool writeAll(const std::string& path, const std::string& text) {
  // Beside the file first, so that nothing is lost where the disk is full.
  const std::string draft = path + ".new";
  {
    std::ofstream out(draft, std::ios::binary | std::ios::trunc);
    if (!(out << text) || !out.flush()) {
      std::remove(draft.c_str());
      return false;
    }
  }
  return std::rename(draft.c_str(), path.c_str()) == 0;
}

bool isPicture(const std::vector<uint8_t>& file) {
  const auto starts = [&](std::initializer_list<uint8_t> bytes) {
    return file.size() >= bytes.size() && std::equal(bytes.begin(), bytes.end(), file.begin());
  };
  return starts({0x89, 'P', 'N', 'G'}) || starts({0xFF, 0xD8, 0xFF}) ||
         starts({'R', 'I', 'F', 'F'}) || starts({'G', 'I', 'F', '8'}) || starts({'B', 'M'});
}

}  // namespace

DesktopFiles::DesktopFiles(App& app, bool keeps, Clock clock, std::function<void()> wake)
    : app_(app), keeps_(keeps), worker_(clock, std::move(wake)) {
  app_.shelf().keeping.dialogs = false;
}

void DesktopFiles::start() { list(true); }

void DesktopFiles::list(bool offering) {
  std::vector<Recent> recent = autosaves_.list(app_.document().drawing);
  for (Recent& one : recent) one.offered &= offering;
  app_.shelf().keeping.setRecent(std::move(recent), app_.ui().now_ms);
}

Result<bool> DesktopFiles::open(const std::string& path) {
  const std::string name = withoutFolder(path);
  std::ifstream in(path, std::ios::binary);
  const std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad() || bytes.size() > kLargestFile) {
    app_.say(name + " cannot be read.");
    return {Status::notFound, name + " cannot be read."};
  }
  if (isPicture(bytes)) {
    if (const auto picture = pictureText(bytes)) {
      app_.addPicture(picture->image, picture->width, picture->height);
      return true;
    }
    const std::string sentence = name +
                                 " cannot be shown: it is not a PNG or JPEG picture that "
                                 "can be read.";
    app_.say(sentence);
    return {Status::unreadable, sentence};
  }
  Origin origin;
  origin.name = nameOfFile(path);
  origin.place = path;
  const auto opened = app_.openFile(std::string(bytes.begin(), bytes.end()), name, origin);
  if (!opened) return opened.error();
  if (opened->has_file) places_[opened->drawing] = path;
  return true;
}

bool DesktopFiles::restoreNewest() {
  const auto recent = autosaves_.list(app_.document().drawing);
  if (recent.empty()) return false;
  restore(recent.front().slot);
  return true;
}

bool DesktopFiles::write(const std::string& path) {
  return writeAll(path, textWithName(app_.document(), app_.shelf().keeping.name()));
}

void DesktopFiles::perform() {
  worker_.tell(app_);
  // What is done may ask for more.
  for (int round = 0; round < 4; ++round) {
    const std::vector<Job> jobs = app_.takeJobs();
    if (jobs.empty()) return;
    for (const Job& job : jobs) perform(job);
    app_.redraw();
  }
}

void DesktopFiles::perform(const Job& job) {
  Keeping& keeping = app_.shelf().keeping;
  switch (job.kind) {
    case Job::Kind::open:
      open(job.name);
      break;
    case Job::Kind::save:
    case Job::Kind::save_as:
      save(job);
      break;
    case Job::Kind::keep:
      if (!keeps_ || autosaves_.keep(job, places_[job.drawing])) break;
      keeping.notKept(job.drawing);
      if (!std::exchange(said_not_kept_, true)) {
        app_.say("Your drawing cannot be kept by itself, so please save it.");
      }
      break;
    case Job::Kind::list:
      list(false);
      break;
    case Job::Kind::peek:
      app_.peeked(job.slot, autosaves_.text(job.slot));
      break;
    case Job::Kind::restore:
      restore(job.slot);
      break;
    case Job::Kind::dismiss:
      autosaves_.dismiss(job.slot);
      break;
    case Job::Kind::picture:
      app_.say("Drop a PNG or JPEG file on the window.");
      break;
    case Job::Kind::work:
      worker_.begin(job.number, job.text);
      break;
    case Job::Kind::hand_over:
      handOver(job);
      break;
    case Job::Kind::decode: {
      const auto texture = static_cast<TextureId>(job.drawing);
      if (auto pixels = pixelsOf(job.text)) {
        app_.shelf().pictures.decoded(texture, std::move(*pixels));
      } else {
        app_.shelf().pictures.broken(texture);
      }
      break;
    }
  }
}

void DesktopFiles::save(const Job& job) {
  const auto own = places_.find(job.drawing);
  std::string path = job.name;
  if (job.kind == Job::Kind::save && own != places_.end()) path = own->second;
  if (path.size() < 6 || path.compare(path.size() - 5, 5, ".json") != 0) path += ".json";
  if (!writeAll(path, job.text)) {
    app_.say(path + " cannot be written. Is the folder there, and are you allowed to write to it?");
    return;
  }
  places_[job.drawing] = path;
  app_.shelf().keeping.saved(job.id, nameOfFile(path), path);
  app_.say("Saved " + withoutFolder(path) + ".");
}

void DesktopFiles::handOver(const Job& job) {
  const std::string& path = job.name;
  app_.say(writeAll(path, job.text)
               ? "Saved " + withoutFolder(path) + "."
               : path +
                     " cannot be written. Is the folder there, and are you allowed to write to "
                     "it?");
}

void DesktopFiles::restore(const std::string& slot) {
  const std::string text = autosaves_.text(slot);
  if (text.empty()) {
    app_.say("This drawing is no longer there.");
    return;
  }
  const Autosaves::Entry entry = autosaves_.entry(slot);
  Origin origin;
  origin.name = entry.name;
  origin.place = entry.place;
  origin.saved = entry.saved;
  origin.kept = true;
  const auto drawing = app_.open(text, entry.name, origin);
  if (!drawing) return;
  autosaves_.adopt(slot, *drawing);
  if (!entry.place.empty()) places_[*drawing] = entry.place;
  list(false);
}

}  // namespace marrow
