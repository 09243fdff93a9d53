// The app in a browser: a WebGL 2 context, and the functions that the scripts beside it call. This
// file and those scripts are the only ones that know Emscripten.
#include <emscripten.h>
#include <emscripten/html5.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "figure/workshop.h"
#include "io/document_json.h"
#include "io/json.h"
#include "io/rig_export.h"
#include "platform/browser_files.h"
#include "platform/key_names.h"
#include "render/presenter.h"
#include "report.h"

// From a worker to its page; see worker.js.
EM_JS(void, marrow_tell_made, (const char* bytes, int size), {
  const made = HEAPU8.slice(bytes, bytes + size);
  postMessage({made : made.buffer}, [made.buffer]);
});
EM_JS(void, marrow_tell_progress, (double done), { postMessage({done}); });
EM_JS(void, marrow_tell_ended, (const char* why), { postMessage({ended : UTF8ToString(why)}); });

namespace marrow {
namespace {

double now_ms() { return emscripten_performance_now(); }

/// Everything alive in the page; lives as long as it does.
struct Page {
  App app{now_ms};
  BrowserFiles files{app};
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
  std::unique_ptr<Presenter> presenter;  // none while the context is lost
  std::string answer;                    // of the last call, until the next one
};
std::unique_ptr<Page> page;

bool openContext() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.alpha = false;
  attributes.depth = true;
  attributes.antialias = true;
  attributes.enableExtensionsByDefault = false;
  page->context = emscripten_webgl_create_context("#canvas", &attributes);
  if (page->context <= 0) return false;
  emscripten_webgl_make_context_current(page->context);
  page->presenter = std::make_unique<Presenter>();
  return true;
}

std::string verdict(const Result<bool>& result) {
  return toText(result ? Json{{"ok", true}} : Json{{"error", result.message()}});
}

std::string call(const std::string& name, const std::string& text) {
  App& app = page->app;
  if (const auto answer = page->files.call(name, text)) return *answer;
  if (name == "document") return writeDocument(app.document());
  if (name == "load") return verdict(app.load(text));
  if (name == "parts") return partsReport(app);
  if (name == "rig") return rigToJson(app.evaluation());
  if (name == "stats") return statsReport(app);
  if (name == "undo") return app.undo() ? "true" : "false";
  if (name == "redo") return app.redo() ? "true" : "false";
  if (name == "wantsText") return app.wantsText() ? "true" : "false";
  if (name == "key") {
    app.post(keyNamed(text));
    return "true";
  }
  return "null";
}

}  // namespace
}  // namespace marrow

using marrow::page;

extern "C" {

/// Milliseconds until the next frame is needed; 0: at once, −1: not before something happens.
EMSCRIPTEN_KEEPALIVE double marrow_frame() {
  const marrow::App::FrameResult result = page->app.frame(marrow::now_ms());
  if (result.draw && page->presenter) page->presenter->draw(page->app);
  if (result.again) return 0;
  return std::isfinite(result.wake_after_ms) ? std::fmax(result.wake_after_ms, 1) : -1;
}

EMSCRIPTEN_KEEPALIVE void marrow_resize(double width, double height, double dpr) {
  page->app.resize({width, height}, dpr);
}

/// type, kind and button: numbers of the enums in input.h. held: 1 Alt, 2 Shift.
EMSCRIPTEN_KEEPALIVE void marrow_pointer(int type, int kind, int id, int button, double x, double y,
                                         double pressure, double time_ms, int held) {
  marrow::PointerEvent event;
  event.type = static_cast<marrow::PointerEvent::Type>(type);
  event.kind = static_cast<marrow::PointerKind>(kind);
  event.id = id;
  event.button = static_cast<marrow::Button>(button);
  event.position_px = {x, y};
  event.pressure = pressure;
  event.time_ms = time_ms;
  event.alt = (held & 1) != 0;
  event.shift = (held & 2) != 0;
  page->app.post(event);
}

EMSCRIPTEN_KEEPALIVE void marrow_wheel(double x, double y, double zoom, double pan_x,
                                       double pan_y) {
  page->app.post(marrow::WheelEvent{{x, y}, zoom, {pan_x, pan_y}});
}

EMSCRIPTEN_KEEPALIVE void marrow_text(int character) {
  page->app.post(marrow::TextEvent{static_cast<char32_t>(character)});
}

/// The pixels of a reference picture: texture, its size, the picture's own size, and RGBA from the
/// top.
EMSCRIPTEN_KEEPALIVE void marrow_pixels(int texture, int width, int height, int natural_width,
                                        int natural_height, const uint8_t* rgba) {
  marrow::Pixels pixels{width, height, natural_width, natural_height, {}};
  pixels.rgba.assign(rgba, rgba + static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  page->app.shelf().pictures.decoded(static_cast<marrow::TextureId>(texture), std::move(pixels));
  page->app.redraw();
}

/// What became of the work with this number: bytes of what was made; how much is done; or that it
/// has ended, and in a sentence why it came to nothing.
EMSCRIPTEN_KEEPALIVE void marrow_work_made(double number, const char* bytes, int size) {
  page->app.workMade(static_cast<uint64_t>(number), std::string(bytes, static_cast<size_t>(size)));
}
EMSCRIPTEN_KEEPALIVE void marrow_work_progress(double number, double done) {
  page->app.workProgress(static_cast<uint64_t>(number), done);
}
EMSCRIPTEN_KEEPALIVE void marrow_work_ended(double number, const char* why) {
  page->app.workEnded(static_cast<uint64_t>(number), why);
}

/// In a worker: does the work and tells what has been made.
EMSCRIPTEN_KEEPALIVE void marrow_work(const char* request) {
  marrow::WorkTeller teller;
  teller.made = [](const std::string& bytes) {
    marrow_tell_made(bytes.data(), static_cast<int>(bytes.size()));
  };
  teller.progress = [](double done) {
    marrow_tell_progress(done);
    return true;  // who wants no more of it ends the worker
  };
  static marrow::Workshop workshop;
  const auto result = workshop.work(request, teller, marrow::now_ms);
  marrow_tell_ended(result ? "" : result.message().c_str());
}

/// The WebGL context was lost, or is back.
EMSCRIPTEN_KEEPALIVE void marrow_context(int alive) {
  page->presenter.reset();
  if (!alive) return;
  page->presenter = std::make_unique<marrow::Presenter>();
  page->app.redraw();
}

/// A slice of the warm-up; 1 when it is done.
EMSCRIPTEN_KEEPALIVE int marrow_warm(double budget_ms) {
  page->app.warmUp().slice(budget_ms, marrow::now_ms);
  if (!page->app.warmUp().done()) return 0;
  const std::string log = page->presenter ? page->presenter->log() : "";
  if (!log.empty()) emscripten_console_error(log.c_str());
  return 1;
}

/// name: what to do, text: with what. The answer is JSON, valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* marrow_call(const char* name, const char* text) {
  page->answer = marrow::call(name, text);
  return page->answer.c_str();
}

/// A file that was chosen or dropped. head: JSON that says where it comes from. The answer is JSON,
/// as above.
EMSCRIPTEN_KEEPALIVE const char* marrow_file(const char* head, const char* bytes, int size) {
  page->answer = page->files.openFile(head, std::string(bytes, static_cast<size_t>(size)));
  return page->answer.c_str();
}

/// Addresses and lengths of a part's mesh: positions, normals (double), triangles (uint32), vertex
/// count, triangle count; null where there is none.
EMSCRIPTEN_KEEPALIVE const uint32_t* marrow_mesh(int index) {
  static uint32_t table[5];
  const auto& parts = page->app.parts();
  if (index < 0 || static_cast<size_t>(index) >= parts.size()) return nullptr;
  const auto& part = parts[static_cast<size_t>(index)].part;
  if (!part) return nullptr;
  table[0] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(part->mesh.positions.data()));
  table[1] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(part->normals.data()));
  table[2] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(part->mesh.triangles.data()));
  table[3] = static_cast<uint32_t>(part->mesh.positions.size());
  table[4] = static_cast<uint32_t>(part->mesh.triangles.size());
  return table;
}

/// The same of the figure as it is posed; null while there is none. Valid until the next call.
EMSCRIPTEN_KEEPALIVE const uint32_t* marrow_posed() {
  static uint32_t table[5];
  static marrow::SkinnedVertices vertices;
  const auto& figure = page->app.figure().figure();
  if (!figure) return nullptr;
  vertices = marrow::posedFigure(page->app);
  table[0] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(vertices.positions.data()));
  table[1] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(vertices.normals.data()));
  table[2] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(figure->triangles.data()));
  table[3] = static_cast<uint32_t>(vertices.positions.size());
  table[4] = static_cast<uint32_t>(figure->triangles.size());
  return table;
}

/// Address and length of a job's bytes, given once and valid until the next call.
EMSCRIPTEN_KEEPALIVE const uint32_t* marrow_job_bytes(double job) {
  static uint32_t table[2];
  page->answer = page->files.takeText(static_cast<uint64_t>(job));
  table[0] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(page->answer.data()));
  table[1] = static_cast<uint32_t>(page->answer.size());
  return table;
}

}  // extern "C"

int main() {
  page = std::make_unique<marrow::Page>();
  return marrow::openContext() ? 0 : 1;
}
