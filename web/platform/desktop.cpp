// The app in a window of its own, by GLFW: for developing and testing without a browser. The only
// file that knows GLFW.
#include "render/gl.h"
// GLFW's header goes after OpenGL's.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "io/stroke_json.h"
#include "platform/desktop_files.h"
#include "platform/options.h"
#include "render/presenter.h"
#include "report.h"

namespace marrow {
namespace {

constexpr size_t kSamplesPerFrame = 8;
constexpr double kLongestWait_s = 3600;

double now_ms() { return glfwGetTime() * 1000; }

struct Desktop {
  App app{now_ms};
  std::unique_ptr<DesktopFiles> files;
  std::string title;  // of the window
  std::unique_ptr<Presenter> presenter;
  GLFWwindow* window = nullptr;
  ViewSize size;
  double dpr = 1;
  double cursor_scale = 1;  // window coordinates → CSS pixels
  // In screen coordinates, as the last event told: to ask would give where it is by now, so that
  // all moves that were waiting would be one.
  Vec2 cursor;
  bool held[3] = {false, false, false};
};

Desktop& desktopOf(GLFWwindow* window) {
  return *static_cast<Desktop*>(glfwGetWindowUserPointer(window));
}

void resize(Desktop& desktop) {
  int width = 1, height = 1, framebuffer_width = 1, framebuffer_height = 1;
  float scale_x = 1, scale_y = 1;
  glfwGetWindowSize(desktop.window, &width, &height);
  glfwGetFramebufferSize(desktop.window, &framebuffer_width, &framebuffer_height);
  glfwGetWindowContentScale(desktop.window, &scale_x, &scale_y);
  if (framebuffer_width == 0 || framebuffer_height == 0) return;  // minimised
  desktop.dpr = std::max(1.0f, scale_x);
  desktop.size = {framebuffer_width / desktop.dpr, framebuffer_height / desktop.dpr};
  desktop.cursor_scale = desktop.size.width / std::max(width, 1);
  desktop.app.resize(desktop.size, desktop.dpr);
}

PointerEvent pointerEvent(Desktop& desktop, PointerEvent::Type type, int button) {
  PointerEvent event;
  event.type = type;
  event.id = 1;
  event.button = button == GLFW_MOUSE_BUTTON_RIGHT    ? Button::secondary
                 : button == GLFW_MOUSE_BUTTON_MIDDLE ? Button::middle
                                                      : Button::primary;
  event.position_px = desktop.cursor * desktop.cursor_scale;
  event.time_ms = now_ms();
  const auto isHeld = [&](int key) { return glfwGetKey(desktop.window, key) == GLFW_PRESS; };
  event.alt = isHeld(GLFW_KEY_LEFT_ALT);
  event.shift = isHeld(GLFW_KEY_LEFT_SHIFT) || isHeld(GLFW_KEY_RIGHT_SHIFT);
  return event;
}

Key keyOf(int key, int mods) {
  if (mods & GLFW_MOD_CONTROL) {
    if (key == GLFW_KEY_Z) return mods & GLFW_MOD_SHIFT ? Key::redo : Key::undo;
    if (key == GLFW_KEY_S) return mods & GLFW_MOD_SHIFT ? Key::save_as : Key::save;
    if (key == GLFW_KEY_O) return Key::open;
    return key == GLFW_KEY_Y ? Key::redo : key == GLFW_KEY_A ? Key::select_all : Key::none;
  }
  switch (key) {
    case GLFW_KEY_DELETE:
      return Key::delete_forward;
    case GLFW_KEY_BACKSPACE:
      return Key::backspace;
    case GLFW_KEY_ENTER:
      return Key::enter;
    case GLFW_KEY_ESCAPE:
      return Key::escape;
    case GLFW_KEY_LEFT:
      return Key::left_arrow;
    case GLFW_KEY_RIGHT:
      return Key::right_arrow;
    case GLFW_KEY_HOME:
      return Key::home;
    case GLFW_KEY_END:
      return Key::end;
    default:
      return Key::none;
  }
}

void listen(GLFWwindow* window) {
  Vec2& cursor = desktopOf(window).cursor;
  glfwGetCursorPos(window, &cursor.x, &cursor.y);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { resize(desktopOf(w)); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { desktopOf(w).app.redraw(); });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    Desktop& desktop = desktopOf(w);
    desktop.cursor = {x, y};
    desktop.app.post(pointerEvent(desktop, PointerEvent::Type::move, 0));
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    Desktop& desktop = desktopOf(w);
    const bool held = std::any_of(std::begin(desktop.held), std::end(desktop.held),
                                  [](bool down) { return down; });
    if (!entered && !held) {
      desktop.app.post(pointerEvent(desktop, PointerEvent::Type::leave, 0));
    }
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
    Desktop& desktop = desktopOf(w);
    if (button > 2) return;
    const auto others = std::count(std::begin(desktop.held), std::end(desktop.held), true) -
                        (desktop.held[button] ? 1 : 0);
    desktop.held[button] = action == GLFW_PRESS;
    if (others > 0) return;  // the first button decides what the pointer does
    desktop.app.post(pointerEvent(
        desktop, action == GLFW_PRESS ? PointerEvent::Type::down : PointerEvent::Type::up, button));
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) {
    Desktop& desktop = desktopOf(w);
    const Vec2 at = pointerEvent(desktop, PointerEvent::Type::move, 0).position_px;
    desktop.app.post(WheelEvent{at, y * 0.16, {}});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
    const Key known = keyOf(key, mods);
    if (action != GLFW_RELEASE && known != Key::none) desktopOf(w).app.post(KeyEvent{known});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    Desktop& desktop = desktopOf(w);
    if (count > 0) desktop.files->open(paths[0]);
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
    desktopOf(w).app.post(TextEvent{character});
    if (character > 32 && character < 127) {
      desktopOf(w).app.post(KeyEvent{Key::none, static_cast<char>(character)});
    }
  });
}

App::FrameResult drawFrame(Desktop& desktop) {
  const App::FrameResult result = desktop.app.frame(now_ms());
  desktop.files->perform();
  const std::string title = desktop.app.shelf().keeping.title();
  if (title != desktop.title) glfwSetWindowTitle(desktop.window, title.c_str());
  desktop.title = title;
  if (result.draw) {
    desktop.presenter->draw(desktop.app);
    glfwSwapBuffers(desktop.window);
  }
  return result;
}

void settle(Desktop& desktop) {
  const double until_ms = now_ms() + 3000;
  while (drawFrame(desktop).again && now_ms() < until_ms) glfwPollEvents();
}

// Draws a stroke in the middle of the window, one unit a pixel.
void play(Desktop& desktop, const std::vector<Vec2>& points) {
  PointerEvent event;
  event.id = 1;
  for (size_t i = 0; i < points.size(); ++i) {
    event.type = i == 0 ? PointerEvent::Type::down : PointerEvent::Type::move;
    event.position_px = {desktop.size.width / 2 + points[i].x,
                         desktop.size.height / 2 - points[i].y};
    event.time_ms = now_ms();
    desktop.app.post(event);
    if (i % kSamplesPerFrame == 0) drawFrame(desktop);
  }
  event.type = PointerEvent::Type::up;
  desktop.app.post(event);
  settle(desktop);
}

bool writeScreenshot(Desktop& desktop, const std::string& file) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(desktop.window, &width, &height);
  desktop.presenter->draw(desktop.app);
  std::vector<unsigned char> pixels(static_cast<size_t>(width) * static_cast<size_t>(height) * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  stbi_flip_vertically_on_write(1);
  return stbi_write_png(file.c_str(), width, height, 3, pixels.data(), width * 3) != 0;
}

int fail(const std::string& sentence) {
  std::fprintf(stderr, "marrow-app: %s\n", sentence.c_str());
  return 2;
}

int run(Desktop& desktop, const DesktopOptions& options) {
  desktop.files = std::make_unique<DesktopFiles>(desktop.app, !options.endsByItself(), now_ms,
                                                 glfwPostEmptyEvent);
  desktop.files->start();
  if (options.restore && !desktop.files->restoreNewest()) return fail("no drawing is kept.");
  if (!options.document.empty()) {
    const auto opened = desktop.files->open(options.document);
    if (!opened) return fail(opened.message());
    settle(desktop);
  }
  for (const std::string& file : options.strokes) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return fail(file + ": cannot be read.");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto stroke = readStroke(text);
    if (!stroke) return fail(file + ": " + stroke.message());
    play(desktop, stroke->points);
  }
  if (options.endsByItself()) {
    settle(desktop);
    if (!options.screenshot.empty() && !writeScreenshot(desktop, options.screenshot)) {
      return fail(options.screenshot + ": cannot be written.");
    }
    if (!options.save.empty() && !desktop.files->write(options.save)) {
      return fail(options.save + ": cannot be written.");
    }
    if (!options.dump.empty()) {
      std::ofstream out(options.dump, std::ios::binary);
      if (!(out << partsReport(desktop.app) << '\n')) {
        return fail(options.dump + ": cannot be written.");
      }
    }
    return 0;
  }
  while (!glfwWindowShouldClose(desktop.window)) {
    if (!desktop.app.warmUp().done()) desktop.app.warmUp().slice(4, now_ms);
    const App::FrameResult result = drawFrame(desktop);
    if (result.again) {
      glfwPollEvents();
    } else {
      glfwWaitEventsTimeout(std::clamp(result.wake_after_ms / 1000, 0.001, kLongestWait_s));
    }
  }
  desktop.app.keepNow();
  desktop.files->perform();
  return 0;
}

}  // namespace
}  // namespace marrow

int main(int count, char** arguments) {
  using namespace marrow;
  const auto options = readOptions(count, arguments);
  if (!options || options->help) {
    std::fputs(kDesktopUsage, options ? stdout : stderr);
    return options ? 0 : fail(options.message());
  }
  if (!glfwInit()) return fail("there is no screen to open a window on.");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 4);
  int result = 0;
  {
    Desktop desktop;
    desktop.window = glfwCreateWindow(options->width, options->height, "Marrow", nullptr, nullptr);
    if (!desktop.window) {
      glfwTerminate();
      return fail("OpenGL 3.3 is not available here.");
    }
    glfwMakeContextCurrent(desktop.window);
    glfwSwapInterval(options->strokes.empty() ? 1 : 0);
    glfwSetWindowUserPointer(desktop.window, &desktop);
    desktop.presenter = std::make_unique<Presenter>();
    if (!desktop.presenter->log().empty()) {
      std::fprintf(stderr, "marrow-app: %s\n", desktop.presenter->log().c_str());
    }
    resize(desktop);
    if (!options->endsByItself()) listen(desktop.window);
    result = run(desktop, *options);
    desktop.presenter.reset();
    glfwDestroyWindow(desktop.window);
  }
  glfwTerminate();
  return result;
}
