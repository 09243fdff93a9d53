#include "keep/keeping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/document_json.h"
#include "io/json.h"

namespace marrow {
namespace {

constexpr size_t kLongestName = 80;  // bytes

/// Parts that did not change are shared, so that this costs no more than a look at each.
bool same(const Document& a, const Document& b) {
  return a.drawing == b.drawing && a.parts == b.parts && a.references == b.references &&
         a.refine == b.refine && a.symmetry == b.symmetry && a.poses == b.poses &&
         a.blend == b.blend && a.weight_strokes == b.weight_strokes && a.last_part == b.last_part &&
         a.extra == b.extra;
}

bool isEmpty(const Document& document) {
  return document.parts.empty() && document.references.empty();
}

std::string trimmed(const std::string& text) {
  const auto low = text.find_first_not_of(" \t\r\n");
  if (low == std::string::npos) return {};
  return text.substr(low, text.find_last_not_of(" \t\r\n") - low + 1);
}

/// Cut between two characters.
std::string cut(std::string text) {
  if (text.size() <= kLongestName) return text;
  size_t end = kLongestName;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end);
}

}  // namespace

const char* toString(Job::Kind kind) {
  switch (kind) {
    case Job::Kind::open:
      return "open";
    case Job::Kind::save:
      return "save";
    case Job::Kind::save_as:
      return "saveAs";
    case Job::Kind::keep:
      return "keep";
    case Job::Kind::list:
      return "list";
    case Job::Kind::peek:
      return "peek";
    case Job::Kind::restore:
      return "restore";
    case Job::Kind::dismiss:
      return "dismiss";
    case Job::Kind::picture:
      return "picture";
    case Job::Kind::work:
      return "work";
    case Job::Kind::hand_over:
      return "handOver";
    case Job::Kind::decode:
      return "decode";
  }
  return "";
}

std::string ageInWords(double seconds) {
  const auto some = [](double number, const char* unit) {
    const auto whole = static_cast<long>(number);
    return std::to_string(whole) + " " + unit + (whole == 1 ? "" : "s") + " ago";
  };
  if (seconds < 60) return "just now";
  if (seconds < 3600) return some(seconds / 60, "minute");
  if (seconds < 24 * 3600) return some(seconds / 3600, "hour");
  if (seconds < 48 * 3600) return "yesterday";
  return some(seconds / (24 * 3600), "day");
}

std::string nameIn(const Document& document) {
  const auto extra = parseJson(document.extra);
  if (!extra) return {};
  const Json* name = field(*extra, "title");
  return name && name->is_string() ? cut(trimmed(name->get<std::string>())) : std::string();
}

std::string textWithName(const Document& document, const std::string& name) {
  if (name.empty() || nameIn(document) == name) return writeDocument(document);
  auto extra = parseJson(document.extra);
  Json fields = extra && extra->is_object() ? std::move(*extra) : Json::object();
  fields["title"] = name;
  Document named = document;
  named.extra = toText(fields);
  return writeDocument(named);
}

std::string fileName(const std::string& name) {
  std::string file;
  for (const char c : cut(trimmed(name))) {
    const bool forbidden = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ||
                           std::string("/\\:*?\"<>|").find(c) != std::string::npos;
    file += forbidden ? '-' : c;
  }
  while (!file.empty() && (file.front() == '.' || file.front() == ' ')) file.erase(0, 1);
  return file.empty() ? Keeping::kNoName : file;
}

std::string nameOfFile(const std::string& path) {
  std::string name = path.substr(path.find_last_of("/\\") + 1);
  const auto dot = name.rfind('.');
  if (dot != std::string::npos && dot > 0) name.resize(dot);
  return cut(trimmed(name));
}

const Keeping::Drawing* Keeping::find() const {
  const auto found = drawings_.find(seen_.drawing);
  return found == drawings_.end() ? nullptr : &found->second;
}

bool Keeping::isKept() const {
  const Drawing* drawing = find();
  return isEmpty(seen_) || (drawing && drawing->kept && same(*drawing->kept, seen_));
}

void Keeping::update(const Document& document, double now_ms, bool busy) {
  busy_ = busy;
  if (!same(document, seen_)) {
    // What was under way when another drawing came must not wait for a change of its own.
    if (document.drawing != seen_.drawing) keepNow();
    seen_ = document;
    if (isKept()) {
      changed_ms_ = -1;
    } else if (changed_ms_ < 0) {
      changed_ms_ = now_ms;
    }
  }
  if (changed_ms_ >= 0 && now_ms >= due_ms()) keepNow();
}

double Keeping::due_ms() const {
  if (changed_ms_ < 0) return std::numeric_limits<double>::infinity();
  return changed_ms_ + (busy_ ? kLatest_ms : kKeepAfter_ms);
}

void Keeping::keepNow() {
  if (changed_ms_ < 0) return;
  changed_ms_ = -1;
  if (isKept()) return;
  current().kept = seen_;
  Job job;
  job.kind = Job::Kind::keep;
  job.name = name();
  job.text = textWithName(seen_, name());
  job.parts = seen_.parts.size();
  job.saved = !changed();
  ask(std::move(job));
}

uint64_t Keeping::add(const Document& document, const Origin& origin) {
  const uint64_t number = ++last_drawing_;
  Document numbered = document;
  numbered.drawing = number;
  Drawing drawing;
  drawing.name = origin.name.empty() ? nameIn(document) : origin.name;
  drawing.place = origin.place;
  if (origin.saved) drawing.saved = numbered;
  if (origin.kept || origin.known) drawing.kept = numbered;
  drawings_[number] = std::move(drawing);
  return number;
}

const std::string& Keeping::name() const {
  static const std::string none;
  const Drawing* drawing = find();
  return drawing ? drawing->name : none;
}

const std::string& Keeping::place() const {
  static const std::string none;
  const Drawing* drawing = find();
  return drawing ? drawing->place : none;
}

bool Keeping::changed() const {
  const Drawing* drawing = find();
  if (!drawing || !drawing->saved) return !isEmpty(seen_);
  return !same(*drawing->saved, seen_);
}

bool Keeping::empty() const { return isEmpty(seen_); }

std::string Keeping::title() const {
  const std::string shown = name().empty() && changed() ? kNoName : name();
  if (shown.empty()) return "Marrow";
  return (changed() ? "\xE2\x80\xA2 " : "") + shown + " \xE2\x80\x93 Marrow";
}

void Keeping::rename(const std::string& name) {
  const std::string wanted = cut(trimmed(name));
  Drawing& drawing = current();
  if (wanted.empty() || wanted == drawing.name) return;
  drawing.name = wanted;
  drawing.kept.reset();
  if (!isEmpty(seen_) && changed_ms_ < 0) changed_ms_ = 0;
}

void Keeping::askOpen(const std::string& path) {
  Job job;
  job.kind = Job::Kind::open;
  job.name = path;
  ask(std::move(job));
}

void Keeping::askSave(bool as, const std::string& path) {
  Job job;
  job.kind = as ? Job::Kind::save_as : Job::Kind::save;
  job.name = path.empty() ? fileName(name()) : path;
  // The file says the name that it will have, whichever of the two it is.
  job.text = textWithName(seen_, nameOfFile(path.empty() ? job.name + ".json" : path));
  ask(std::move(job));
  saving_.push_back({last_job_, seen_});
}

void Keeping::ask(Job::Kind kind, const std::string& slot) {
  Job job;
  job.kind = kind;
  job.slot = slot;
  ask(std::move(job));
}

void Keeping::ask(Job job) {
  job.id = ++last_job_;
  if (job.kind != Job::Kind::decode) job.drawing = seen_.drawing;
  jobs_.push_back(std::move(job));
}

std::vector<Job> Keeping::takeJobs() { return std::exchange(jobs_, {}); }

void Keeping::saved(uint64_t job, const std::string& name, const std::string& place) {
  const auto found = std::find_if(saving_.begin(), saving_.end(),
                                  [&](const Saving& saving) { return saving.job == job; });
  if (found == saving_.end()) return;
  Drawing& drawing = drawings_[found->document.drawing];
  drawing.saved = found->document;
  if (!name.empty()) drawing.name = cut(trimmed(name));
  drawing.place = place;
  // Older ones were given up, or are overtaken.
  saving_.erase(saving_.begin(), found + 1);
}

void Keeping::notKept(uint64_t drawing) {
  const auto found = drawings_.find(drawing);
  if (found != drawings_.end()) found->second.kept.reset();
}

void Keeping::setRecent(std::vector<Recent> recent, double now_ms) {
  recent_ = std::move(recent);
  recent_since_ms_ = now_ms;
}

const Recent* Keeping::offer() const {
  for (const Recent& recent : recent_) {
    if (recent.offered) return &recent;
  }
  return nullptr;
}

void Keeping::withdrawOffer() {
  for (Recent& recent : recent_) recent.offered = false;
}

}  // namespace marrow
