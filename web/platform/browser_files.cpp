#include "platform/browser_files.h"

#include <cstdlib>
#include <utility>

#include "io/json.h"

namespace marrow {
namespace {

/// A text of two: JSON in the first line, and what comes after it.
struct Message {
  Json head = Json::object();
  std::string body;
};

Message split(const std::string& text) {
  Message message;
  const size_t end = text.find('\n');
  auto head = parseJson(text.substr(0, end));
  if (head && head->is_object()) message.head = std::move(*head);
  if (end != std::string::npos) message.body = text.substr(end + 1);
  return message;
}

std::string textIn(const Json& json, const char* key) {
  const Json* value = field(json, key);
  return value && value->is_string() ? value->get<std::string>() : std::string();
}

double numberIn(const Json& json, const char* key) {
  const Json* value = field(json, key);
  return value && value->is_number() ? value->get<double>() : 0;
}

bool flagIn(const Json& json, const char* key, bool otherwise) {
  const Json* value = field(json, key);
  return value && value->is_boolean() ? value->get<bool>() : otherwise;
}

uint64_t number(const std::string& text) { return std::strtoull(text.c_str(), nullptr, 10); }

std::vector<Recent> recentIn(const std::string& text) {
  std::vector<Recent> recent;
  const auto list = parseJson(text);
  if (!list || !list->is_array()) return recent;
  for (const Json& one : *list) {
    if (!one.is_object()) continue;
    Recent entry;
    entry.slot = textIn(one, "slot");
    entry.name = textIn(one, "name");
    entry.changed = numberIn(one, "changed");
    entry.age_s = numberIn(one, "age");
    entry.parts = static_cast<size_t>(numberIn(one, "parts"));
    entry.offered = flagIn(one, "offered", false);
    recent.push_back(std::move(entry));
  }
  return recent;
}

}  // namespace

std::string BrowserFiles::jobs() {
  Json answer;
  answer["title"] = app_.shelf().keeping.title();
  answer["jobs"] = Json::array();
  for (Job& job : app_.takeJobs()) {
    answer["jobs"].push_back({{"kind", toString(job.kind)},
                              {"id", job.id},
                              {"drawing", job.drawing},
                              {"number", job.number},
                              {"name", job.name},
                              {"slot", job.slot},
                              {"parts", job.parts},
                              {"saved", job.saved}});
    if (!job.text.empty()) texts_[job.id] = std::move(job.text);
  }
  return toText(answer);
}

std::string BrowserFiles::takeText(uint64_t job) {
  const auto found = texts_.find(job);
  if (found == texts_.end()) return {};
  std::string text = std::move(found->second);
  texts_.erase(found);
  return text;
}

std::string BrowserFiles::openFile(const std::string& head, const std::string& bytes) {
  const Json json = split(head).head;
  Origin origin;
  origin.name = textIn(json, "name");
  origin.place = textIn(json, "place");
  const auto opened = app_.openFile(bytes, textIn(json, "file"), origin);
  if (!opened) return toText(Json{{"error", opened.message()}});
  return toText(Json{{"drawing", opened->drawing}, {"hasFile", opened->has_file}});
}

std::optional<std::string> BrowserFiles::call(const std::string& name, const std::string& text) {
  Keeping& keeping = app_.shelf().keeping;
  const std::string done = "true";
  if (name == "jobs") return jobs();
  if (name == "jobText") return takeText(number(text));
  if (name == "open") {
    const Message message = split(text);
    Origin origin;
    origin.name = textIn(message.head, "name");
    origin.place = textIn(message.head, "place");
    origin.saved = flagIn(message.head, "saved", true);
    origin.kept = flagIn(message.head, "kept", false);
    const auto drawing = app_.open(message.body, textIn(message.head, "file"), origin);
    return toText(drawing ? Json{{"drawing", *drawing}} : Json{{"error", drawing.message()}});
  }
  if (name == "saved") {
    const Message message = split(text);
    keeping.saved(static_cast<uint64_t>(numberIn(message.head, "job")),
                  textIn(message.head, "name"), textIn(message.head, "place"));
    return done;
  }
  if (name == "picture") {
    const Message message = split(text);
    app_.addPicture(message.body, static_cast<int>(numberIn(message.head, "width")),
                    static_cast<int>(numberIn(message.head, "height")));
    return done;
  }
  if (name == "peeked") {
    const size_t end = text.find('\n');
    if (end != std::string::npos) app_.peeked(text.substr(0, end), text.substr(end + 1));
    return done;
  }
  if (name == "recent") {
    keeping.setRecent(recentIn(text), app_.ui().now_ms);
  } else if (name == "noPixels") {
    app_.shelf().pictures.broken(static_cast<TextureId>(number(text)));
  } else if (name == "notKept") {
    keeping.notKept(number(text));
  } else if (name == "noStorage") {
    keeping.has_storage = false;
  } else if (name == "keepNow") {
    app_.keepNow();
  } else if (name == "say") {
    app_.say(text);
  } else {
    return std::nullopt;
  }
  app_.redraw();
  return done;
}

}  // namespace marrow
