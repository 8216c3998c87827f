// The window by GLFW.
#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <GLFW/glfw3.h>

#include "app/platform/gl_choice.hpp"
#include "app/platform/window.hpp"
#include "ui/keys.hpp"

namespace replan::app {
namespace {

namespace key = ui::key;
static_assert(key::kEscape == GLFW_KEY_ESCAPE && key::kEnter == GLFW_KEY_ENTER && key::kTab == GLFW_KEY_TAB);
static_assert(key::kBackspace == GLFW_KEY_BACKSPACE && key::kInsert == GLFW_KEY_INSERT);
static_assert(key::kDelete == GLFW_KEY_DELETE && key::kRight == GLFW_KEY_RIGHT &&
              key::kLeft == GLFW_KEY_LEFT);
static_assert(key::kDown == GLFW_KEY_DOWN && key::kUp == GLFW_KEY_UP && key::kPageUp == GLFW_KEY_PAGE_UP);
static_assert(key::kPageDown == GLFW_KEY_PAGE_DOWN && key::kHome == GLFW_KEY_HOME &&
              key::kEnd == GLFW_KEY_END);
static_assert(key::kF1 == GLFW_KEY_F1 && key::kKeypadEnter == GLFW_KEY_KP_ENTER);
static_assert(key::kLeftShift == GLFW_KEY_LEFT_SHIFT && key::kRightSuper == GLFW_KEY_RIGHT_SUPER);
static_assert(key::kCount == GLFW_KEY_LAST + 1);

constexpr double kIdleSeconds = 0.5;  // how long a still window sleeps at most; a caret blinks by it
constexpr double kFrameSeconds = 1.0 / 120;

void* find_window_function(const char* name) {
  return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "unknown reason";
}

Error no_window() {
  return Error{"Cannot open a window (" + last_error() +
               "). Without a display, draw pictures and films with: replan render SCENARIO -o OUT.png"};
}

/// REPLAN_SCALE, or 0 if it is unset or not a number.
float scale_from_environment() {
  const char* text = std::getenv("REPLAN_SCALE");
  return text != nullptr ? std::strtof(text, nullptr) : 0.0f;
}

float display_scale(GLFWwindow* window) {
  float x = 1;
  float y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::max(x, y);
}

void request_core() {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_NATIVE_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
}

void request_es() {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_ANY_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_FALSE);
}

void request_window(bool maximized, bool follows_display_scale) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_MAXIMIZED, maximized ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, follows_display_scale ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "replan");
}

std::vector<GLFWcursor*> standard_cursors() {
  std::vector<GLFWcursor*> cursors(ImGuiMouseCursor_COUNT, nullptr);
  const auto set = [&](int slot, int shape) {
    cursors[static_cast<std::size_t>(slot)] = glfwCreateStandardCursor(shape);
  };
  set(ImGuiMouseCursor_Arrow, GLFW_ARROW_CURSOR);
  set(ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR);
  set(ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR);
  set(ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR);
  set(ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR);
  return cursors;
}

/// GLFW numbers keys by their place on an American keyboard; shortcuts go by the letter printed on them.
int by_layout(int code, int scan) {
  if (code >= GLFW_KEY_KP_0 && code <= GLFW_KEY_KP_EQUAL) return code;
  const char* name = glfwGetKeyName(code, scan);
  if (name == nullptr || name[0] == '\0' || name[1] != '\0') return code;
  const char letter = name[0];
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 'A';
  return letter > ' ' && letter < 'a' ? letter : code;
}

const char* clipboard(void* window) {
  return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
}

void set_clipboard(void* window, const char* text) {
  glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
}

}  // namespace

/// GLFW's side, and what GLFW calls: each leads to the Window behind the handle.
struct Window::System {
  GLFWwindow* handle = nullptr;
  std::vector<GLFWcursor*> cursors;
  bool follow_display_scale = true;

  /// Framebuffer pixels per screen coordinate: 1 on X11, the display's scale on Wayland.
  [[nodiscard]] float pixel_ratio() const {
    int width = 0;
    int framebuffer = 0;
    int height = 0;
    glfwGetWindowSize(handle, &width, &height);
    glfwGetFramebufferSize(handle, &framebuffer, &height);
    return width > 0 ? static_cast<float>(framebuffer) / static_cast<float>(width) : 1.0f;
  }
  /// Fails with the first reason: who has no OpenGL at all need not hear of OpenGL ES.
  Result<void> create(GlChoice choice, std::pair<int, int> size, const std::string& title);

  static Window& of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }
  static ui::InputQueue& input(GLFWwindow* handle) { return of(handle).stage_->input(); }

  static void move(GLFWwindow* handle, double x, double y) {
    const auto ratio = static_cast<double>(of(handle).system_->pixel_ratio());
    input(handle).mouse_move(static_cast<float>(x * ratio), static_cast<float>(y * ratio));
  }
  static void enter(GLFWwindow* handle, int entered) {
    if (entered == GLFW_FALSE) input(handle).mouse_leave();
  }
  static void button(GLFWwindow* handle, int button, int action, int) {
    input(handle).mouse_button(button, action != GLFW_RELEASE);
  }
  static void scroll(GLFWwindow* handle, double x, double y) {
    input(handle).wheel(static_cast<float>(x), static_cast<float>(y));
  }
  static void key(GLFWwindow* handle, int code, int scan, int action, int) {
    if (action != GLFW_REPEAT) input(handle).key(by_layout(code, scan), action == GLFW_PRESS);
  }
  static void character(GLFWwindow* handle, unsigned code_point) { input(handle).character(code_point); }
  static void focus(GLFWwindow* handle, int focused) {
    if (focused == GLFW_FALSE) input(handle).release_all();
  }
  static void drop(GLFWwindow* handle, int count, const char** paths) {
    if (of(handle).drop_) of(handle).drop_({paths, paths + count});
  }
  static void close(GLFWwindow* handle) {
    const auto& may_close = of(handle).may_close_;
    if (may_close && !may_close()) glfwSetWindowShouldClose(handle, GLFW_FALSE);
  }
  static void scale(GLFWwindow* handle, float x, float y) {
    Window& window = of(handle);
    if (window.system_->follow_display_scale) window.stage_->set_scale(std::max(x, y));
  }
  static void redraw(GLFWwindow* handle) { of(handle).settle_frames_ = 2; }

  static void install(GLFWwindow* handle) {
    glfwSetCursorPosCallback(handle, move);
    glfwSetCursorEnterCallback(handle, enter);
    glfwSetMouseButtonCallback(handle, button);
    glfwSetScrollCallback(handle, scroll);
    glfwSetKeyCallback(handle, key);
    glfwSetCharCallback(handle, character);
    glfwSetWindowFocusCallback(handle, focus);
    glfwSetDropCallback(handle, drop);
    glfwSetWindowCloseCallback(handle, close);
    glfwSetWindowContentScaleCallback(handle, scale);
    glfwSetWindowRefreshCallback(handle, redraw);
  }
};

Result<std::unique_ptr<Window>> Window::open(const WindowSettings& settings) {
  std::unique_ptr<Window> window(new Window);
  if (glfwInit() == GLFW_FALSE) return no_window();
  if (const Result<void> started = window->start(settings); !started) return Error{started.error()};
  return window;
}

namespace {

/// The size to open with, in screen coordinates: what the settings ask for at that scale, no larger than the
/// display.
std::pair<int, int> first_size(const WindowSettings& settings, float scale) {
  int width = static_cast<int>(std::lround(static_cast<float>(settings.width) * scale));
  int height = static_cast<int>(std::lround(static_cast<float>(settings.height) * scale));
  if (GLFWmonitor* display = glfwGetPrimaryMonitor(); display != nullptr) {
    int x = 0, y = 0, most_width = 0, most_height = 0;
    glfwGetMonitorWorkarea(display, &x, &y, &most_width, &most_height);
    if (most_width > 0) width = std::min(width, most_width);
    if (most_height > 0) height = std::min(height, most_height);
  }
  return {width, height};
}

/// Sleeps until the next frame is due: with a pace, that long after the last one.
void wait(bool busy, double pace, double last_time) {
  if (pace > 0) {
    // Input waits for its frame, or a moving mouse would make the time of the film run faster.
    glfwPollEvents();
    for (double left = 1; (left = pace - (glfwGetTime() - last_time)) > 0;) glfwWaitEventsTimeout(left);
    return;
  }
  // Drivers without vertical sync would otherwise draw as fast as they can.
  const double pause = busy ? kFrameSeconds - (glfwGetTime() - last_time) : kIdleSeconds;
  if (pause > 0) {
    glfwWaitEventsTimeout(pause);
  } else {
    glfwPollEvents();
  }
}

}  // namespace

Window::Window() : system_(std::make_unique<System>()) {}

Result<void> Window::start(const WindowSettings& settings) {
  settings_ = settings;
  const Result<GlChoice> choice = gl_choice();
  if (!choice) return Error{choice.error()};
  const float wanted = settings.scale > 0 ? settings.scale : scale_from_environment();
  const bool follows = !(wanted > 0);
  system_->follow_display_scale = follows;
  request_window(settings.maximized, follows);
  if (const Result<void> created =
          system_->create(*choice, first_size(settings, follows ? 1 : wanted), settings.title);
      !created)
    return created;
  GLFWwindow* handle = system_->handle;
  glfwSetWindowUserPointer(handle, this);
  glfwMakeContextCurrent(handle);
  glfwSwapInterval(1);
  if (const Result<void> loaded = gl_.load(find_window_function); !loaded) return loaded;
  auto stage = ui::Stage::create(gl_, follows ? display_scale(handle) : wanted);
  if (!stage) return Error{stage.error()};
  stage_ = std::move(*stage);
  ImGuiIO& io = stage_->io();
  io.BackendPlatformName = "replan";
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.ClipboardUserData = handle;
  io.GetClipboardTextFn = clipboard;
  io.SetClipboardTextFn = set_clipboard;
  system_->cursors = standard_cursors();
  System::install(handle);
  return {};
}

Result<void> Window::System::create(GlChoice choice, std::pair<int, int> size, const std::string& title) {
  Result<void> failed;
  for (const GlChoice tried : {GlChoice::core, GlChoice::es}) {
    if (choice != GlChoice::any && choice != tried) continue;
    tried == GlChoice::es ? request_es() : request_core();
    handle = glfwCreateWindow(size.first, size.second, title.c_str(), nullptr, nullptr);
    if (handle != nullptr) return {};
    if (failed) failed = no_window();
  }
  return failed;
}

Window::~Window() {
  GLFWwindow* handle = system_->handle;
  if (handle != nullptr) glfwMakeContextCurrent(handle);
  stage_.reset();
  for (GLFWcursor* cursor : system_->cursors) {
    if (cursor != nullptr) glfwDestroyCursor(cursor);
  }
  if (handle != nullptr) glfwDestroyWindow(handle);
  glfwTerminate();
}

void Window::run(std::function<bool()> frame) {
  GLFWwindow* handle = system_->handle;
  last_time_ = glfwGetTime();
  while (glfwWindowShouldClose(handle) == GLFW_FALSE) {
    const bool hidden = glfwGetWindowAttrib(handle, GLFW_ICONIFIED) == GLFW_TRUE;
    wait(!hidden && busy(), pace_, last_time_);
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(handle, &width, &height);
    draw_frame(frame, width, height, glfwGetTime());
    if (width > 0 && height > 0) glfwSwapBuffers(handle);
  }
}

void Window::update_cursor() {
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  const std::vector<GLFWcursor*>& cursors = system_->cursors;
  GLFWcursor* cursor = wanted >= 0 ? cursors[static_cast<std::size_t>(wanted)] : nullptr;
  glfwSetCursor(system_->handle, cursor != nullptr ? cursor : cursors[ImGuiMouseCursor_Arrow]);
  glfwSetInputMode(system_->handle, GLFW_CURSOR, wanted < 0 ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
}

void Window::close() {
  glfwSetWindowShouldClose(system_->handle, GLFW_TRUE);
}

void Window::wake() {
  glfwPostEmptyEvent();
}

void Window::hide() {
  glfwHideWindow(system_->handle);
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(system_->handle, title.c_str());
}

WindowSettings Window::state() const {
  WindowSettings now = settings_;
  now.maximized = glfwGetWindowAttrib(system_->handle, GLFW_MAXIMIZED) == GLFW_TRUE;
  if (now.maximized) return now;
  glfwGetWindowSize(system_->handle, &now.width, &now.height);
  const float shrunk = system_->pixel_ratio() / stage_->look().px.scale;
  now.width = static_cast<int>(std::lround(static_cast<float>(now.width) * shrunk));
  now.height = static_cast<int>(std::lround(static_cast<float>(now.height) * shrunk));
  return now;
}

}  // namespace replan::app
