#include "platform/autosaves.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "io/json.h"

namespace marrow {
namespace {

namespace fs = std::filesystem;

constexpr char kText[] = ".json", kEntry[] = ".entry", kLock[] = ".lock";

std::string readAll(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

/// Whole or not at all, also when the machine stops.
bool writeAll(const std::string& path, const std::string& text) {
  const std::string draft = path + ".new";
  {
    std::ofstream out(draft, std::ios::binary | std::ios::trunc);
    if (!(out << text) || !out.flush()) return false;
  }
  std::error_code error;
  fs::rename(draft, path, error);
  return !error;
}

double age_s(const std::string& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error);
  if (error) return 0;
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - time).count();
}

std::string newSlot() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  static int count = 0;
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(now).count()) + "-" +
         std::to_string(getpid()) + "-" + std::to_string(++count);
}

}  // namespace

Autosaves::Autosaves(std::string folder) : folder_(std::move(folder)) {}

Autosaves::~Autosaves() {
  for (const auto& [slot, descriptor] : locks_) {
    close(descriptor);
    std::error_code error;
    fs::remove(path(slot, kLock), error);
  }
}

std::string Autosaves::standardFolder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data && *data == '/') return std::string(data) + "/marrow";
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.local/share/marrow" : std::string();
}

std::string Autosaves::path(const std::string& slot, const char* ending) const {
  return folder_ + "/" + slot + ending;
}

bool Autosaves::lock(const std::string& slot) {
  if (locks_.count(slot) > 0) return true;
  const int descriptor = open(path(slot, kLock).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    close(descriptor);
    return false;
  }
  locks_[slot] = descriptor;
  return true;
}

bool Autosaves::isTaken(const std::string& slot) const {
  if (locks_.count(slot) > 0) return false;
  const int descriptor = open(path(slot, kLock).c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  close(descriptor);
  return taken;
}

bool Autosaves::writeEntry(const std::string& slot, const Entry& entry) const {
  Json json;
  json["name"] = entry.name;
  json["place"] = entry.place;
  json["parts"] = entry.parts;
  json["saved"] = entry.saved;
  json["dismissed"] = entry.dismissed;
  return writeAll(path(slot, kEntry), toText(json));
}

Autosaves::Entry Autosaves::entry(const std::string& slot) const {
  Entry entry;
  const auto json = parseJson(readAll(path(slot, kEntry)));
  if (!json || !json->is_object()) return entry;
  const auto text = [&](const char* key) {
    const Json* value = field(*json, key);
    return value && value->is_string() ? value->get<std::string>() : std::string();
  };
  const auto flag = [&](const char* key) {
    const Json* value = field(*json, key);
    return value && value->is_boolean() && value->get<bool>();
  };
  entry.name = text("name");
  entry.place = text("place");
  entry.saved = flag("saved");
  entry.dismissed = flag("dismissed");
  const Json* parts = field(*json, "parts");
  if (parts && parts->is_number_unsigned()) entry.parts = parts->get<size_t>();
  return entry;
}

bool Autosaves::keep(const Job& job, const std::string& place) {
  if (folder_.empty()) return false;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return false;
  std::string& slot = slots_[job.drawing];
  if (slot.empty()) slot = newSlot();
  lock(slot);
  Entry entry;
  entry.name = job.name;
  entry.place = place;
  entry.parts = job.parts;
  entry.saved = job.saved;
  if (!writeAll(path(slot, kText), job.text) || !writeEntry(slot, entry)) return false;
  makeRoom();
  return true;
}

std::vector<Recent> Autosaves::list(uint64_t drawing) const {
  std::vector<Recent> recent;
  std::error_code error;
  const auto own = slots_.find(drawing);
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != kText) continue;
    const std::string slot = it->path().stem().string();
    if (isTaken(slot) || (own != slots_.end() && own->second == slot)) continue;
    const Entry known = entry(slot);
    Recent one;
    one.slot = slot;
    one.name = known.name;
    one.parts = known.parts;
    one.age_s = std::max(0.0, age_s(it->path().string()));
    one.changed = static_cast<double>(fs::file_size(it->path(), error));
    one.offered = !known.dismissed && locks_.count(slot) == 0;
    recent.push_back(std::move(one));
  }
  std::sort(recent.begin(), recent.end(), [](const Recent& a, const Recent& b) {
    return a.age_s != b.age_s ? a.age_s < b.age_s : a.slot > b.slot;
  });
  for (size_t i = 1; i < recent.size(); ++i) recent[i].offered = false;
  if (recent.size() > kMost) recent.resize(kMost);
  return recent;
}

std::string Autosaves::text(const std::string& slot) const { return readAll(path(slot, kText)); }

void Autosaves::dismiss(const std::string& slot) {
  Entry known = entry(slot);
  known.dismissed = true;
  writeEntry(slot, known);
}

bool Autosaves::adopt(const std::string& slot, uint64_t drawing) {
  if (!lock(slot)) return false;
  slots_[drawing] = slot;
  return true;
}

void Autosaves::makeRoom() {
  std::vector<std::pair<double, std::string>> all;  // age, slot
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == kText) {
      all.emplace_back(age_s(it->path().string()), it->path().stem().string());
    }
  }
  std::sort(all.begin(), all.end());
  for (size_t i = kMost; i < all.size(); ++i) {
    const std::string& slot = all[i].second;
    if (locks_.count(slot) > 0 || isTaken(slot)) continue;
    for (const char* ending : {kText, kEntry, kLock}) fs::remove(path(slot, ending), error);
  }
}

}  // namespace marrow
