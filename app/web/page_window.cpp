// The window of a page: its canvas, by the browser's events.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <emscripten.h>
#include <emscripten/html5.h>

#include "app/platform/window.hpp"
#include "app/web/context.hpp"
#include "app/web/keyboard.hpp"
#include "app/web/page.hpp"
#include "ui/keys.hpp"

namespace replan::app {
namespace {

constexpr const char* kCanvas = "#canvas";
constexpr double kIdleSeconds = 0.5;  // how long a still page goes without a frame; a caret blinks by it
/// What browsers call a notch of a wheel, in pixels and in lines.
constexpr double kNotchPixels = 100;
constexpr double kNotchLines = 3;
constexpr unsigned kBackspaceCharacter = 8, kReturnCharacter = 10;

double seconds_now() {
  return emscripten_get_now() / 1000;
}

/// Left, middle, right in the order of browsers to that of ImGui.
int mouse_button_of(unsigned short button) {
  return button == 1 ? 2 : button == 2 ? 1 : button;
}

const char* clipboard_of_page(void*) {
  return pasted_text();
}

void set_clipboard_of_page(void*, const char* text) {
  copy_text(text);
}

}  // namespace

/// What the browser calls, for the one window there is.
struct Window::System {
  std::function<bool()> frame;
  double ratio = 1;  // device pixels per pixel of the page
  int width = 0, height = 0;
  bool wake = false;
  bool closed = false;
  bool typing = false;  // the keyboard on the screen is asked for
  ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;

  static inline Window* window = nullptr;

  static ui::Touches& touches() { return window->stage_->touches(); }
  static ui::InputQueue& input() { return window->stage_->input(); }

  static EM_BOOL move(int, const EmscriptenMouseEvent* event, void*) {
    const double ratio = window->system_->ratio;
    touches().put_aside();
    input().mouse_move(static_cast<float>(event->targetX * ratio),
                       static_cast<float>(event->targetY * ratio));
    return EM_TRUE;
  }
  static EM_BOOL press(int, const EmscriptenMouseEvent* event, void*) {
    input().mouse_button(mouse_button_of(event->button), true);
    return EM_TRUE;
  }
  static EM_BOOL release(int, const EmscriptenMouseEvent* event, void*) {
    input().mouse_button(mouse_button_of(event->button), false);
    return EM_TRUE;
  }
  static EM_BOOL leave(int, const EmscriptenMouseEvent* event, void*) {
    // A drag goes on beyond the edge.
    if (event->buttons == 0) input().mouse_leave();
    return EM_TRUE;
  }
  static EM_BOOL scroll(int, const EmscriptenWheelEvent* event, void*) {
    const double notch = event->deltaMode == DOM_DELTA_PIXEL ? kNotchPixels : kNotchLines;
    input().wheel(static_cast<float>(-event->deltaX / notch), static_cast<float>(-event->deltaY / notch));
    return EM_TRUE;
  }
  /// Each finger that the event is about. Once it is taken, the browser makes no mouse of it.
  template <class Take>
  static EM_BOOL each_changed(const EmscriptenTouchEvent* event, const Take& take) {
    const double ratio = window->system_->ratio;
    for (int i = 0; i < event->numTouches; ++i) {
      const EmscriptenTouchPoint& point = event->touches[i];
      if (point.isChanged)
        take(point.identifier, static_cast<float>(static_cast<double>(point.targetX) * ratio),
             static_cast<float>(static_cast<double>(point.targetY) * ratio));
    }
    window->settle();
    return EM_TRUE;
  }
  static EM_BOOL touch_begin(int, const EmscriptenTouchEvent* event, void*) {
    return each_changed(event, [](long id, float x, float y) { touches().begin(id, x, y, seconds_now()); });
  }
  static EM_BOOL touch_move(int, const EmscriptenTouchEvent* event, void*) {
    return each_changed(event, [](long id, float x, float y) { touches().move(id, x, y, seconds_now()); });
  }
  static EM_BOOL touch_end(int, const EmscriptenTouchEvent* event, void*) {
    each_changed(event, [](long id, float x, float y) { touches().end(id, x, y, seconds_now()); });
    // A browser shows its keyboard for what is focused before the event ends.
    if (!touches().active() && window->system_->cursor == ImGuiMouseCursor_TextInput) draw_all();
    return EM_TRUE;
  }
  static EM_BOOL touch_cancel(int, const EmscriptenTouchEvent*, void*) {
    touches().cancel();
    window->settle();
    return EM_TRUE;
  }
  static EM_BOOL key_down(int, const EmscriptenKeyboardEvent* event, void*) {
    const bool command = event->ctrlKey || event->metaKey;
    // What the page's own copy and paste events bring comes with them (page.js).
    if (command && !event->shiftKey && is_clipboard_key(event->key)) return EM_FALSE;
    const int number = key_number(event->key, event->code);
    const auto typed = typed_character(event->key);
    if (number != 0 && !event->repeat) input().key(number, true);
    if (typed && !command) input().character(*typed);
    // Keyboards on screens do not name their keys: what they type comes by the page's hidden field.
    return number != 0 || typed ? EM_TRUE : EM_FALSE;
  }
  static EM_BOOL key_up(int, const EmscriptenKeyboardEvent* event, void*) {
    if (const int number = key_number(event->key, event->code); number != 0) input().key(number, false);
    return EM_TRUE;
  }
  static EM_BOOL lose_focus(int, const EmscriptenFocusEvent*, void*) {
    input().release_all();
    return EM_TRUE;
  }
  static EM_BOOL resize(int, const EmscriptenUiEvent*, void*) {
    window->settle();
    return EM_TRUE;
  }
  static EM_BOOL lose_context(int, const void*, void*) {
    tell_page(
        "The browser has taken the graphics away from this page. Your world is kept: reload the page to go "
        "on.");
    return EM_TRUE;
  }

  static void install() {
    emscripten_set_mousemove_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, nullptr, EM_TRUE, move);
    emscripten_set_mousedown_callback(kCanvas, nullptr, EM_TRUE, press);
    emscripten_set_mouseup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, nullptr, EM_TRUE, release);
    emscripten_set_mouseleave_callback(kCanvas, nullptr, EM_TRUE, leave);
    emscripten_set_touchstart_callback(kCanvas, nullptr, EM_TRUE, touch_begin);
    emscripten_set_touchmove_callback(kCanvas, nullptr, EM_TRUE, touch_move);
    emscripten_set_touchend_callback(kCanvas, nullptr, EM_TRUE, touch_end);
    emscripten_set_touchcancel_callback(kCanvas, nullptr, EM_TRUE, touch_cancel);
    emscripten_set_wheel_callback(kCanvas, nullptr, EM_TRUE, scroll);
    emscripten_set_keydown_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, nullptr, EM_TRUE, key_down);
    emscripten_set_keyup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, nullptr, EM_TRUE, key_up);
    emscripten_set_blur_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, nullptr, EM_TRUE, lose_focus);
    emscripten_set_resize_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, nullptr, EM_TRUE, resize);
    emscripten_set_webglcontextlost_callback(kCanvas, nullptr, EM_TRUE, lose_context);
  }

  /// Follows the size of the page and what its pixels are made of.
  void measure() {
    double across = 0;
    double down = 0;
    emscripten_get_element_css_size(kCanvas, &across, &down);
    const double now = emscripten_get_device_pixel_ratio();
    const int wide = static_cast<int>(std::lround(across * now));
    const int high = static_cast<int>(std::lround(down * now));
    if (wide != width || high != height) {
      emscripten_set_canvas_element_size(kCanvas, wide, high);
      width = wide;
      height = high;
      window->settle();
    }
    if (now != ratio && window->stage_) window->stage_->set_scale(static_cast<float>(now));
    ratio = now;
  }

  /// Its frames are drawn at once: what the program copies has to be there before the browser's event ends.
  static void press(int key) {
    input().key(key, true);
    input().key(key, false);
    draw_all();
  }

  /// Frames, until all input is taken.
  static void draw_all() {
    do draw(seconds_now());
    while (!input().empty());
  }

  static void draw(double now) {
    System& system = *window->system_;
    window->stage_->follow_touches(now);
    window->draw_frame(system.frame, system.width, system.height, now);
    const bool typing = touches().used() && window->stage_->io().WantTextInput;
    if (typing == std::exchange(system.typing, typing)) return;
    set_page_typing(typing);
  }

  /// The browser calls it as often as its display shows pictures.
  static void tick() {
    System& system = *window->system_;
    system.measure();
    const double now = seconds_now();
    const double since = now - window->last_time_;
    if (window->pace_ > 0 ? since < window->pace_
                          : !window->busy() && !std::exchange(system.wake, false) && since < kIdleSeconds)
      return;
    draw(now);
  }
};

void press_in_page(int key) {
  Window::System::press(key);
}

void type_in_page(unsigned code_point) {
  ui::InputQueue& input = Window::System::input();
  if (code_point == kBackspaceCharacter || code_point == kReturnCharacter) {
    const int key = code_point == kReturnCharacter ? ui::key::kEnter : ui::key::kBackspace;
    input.key(key, true);
    input.key(key, false);
  } else {
    input.character(code_point);
  }
}

Window::Window() : system_(std::make_unique<System>()) {}

Window::~Window() {
  System::window = nullptr;
}

Result<std::unique_ptr<Window>> Window::open(const WindowSettings& settings) {
  std::unique_ptr<Window> window(new Window);
  System::window = window.get();
  if (const Result<void> started = window->start(settings); !started) return Error{started.error()};
  return window;
}

Result<void> Window::start(const WindowSettings& settings) {
  settings_ = settings;
  system_->measure();
  if (const auto context = open_webgl(kCanvas, gl_); !context) return Error{context.error()};
  gl_.es = true;
  auto stage = ui::Stage::create(gl_, static_cast<float>(system_->ratio));
  if (!stage) return Error{stage.error()};
  stage_ = std::move(*stage);
  ImGuiIO& io = stage_->io();
  io.BackendPlatformName = "replan";
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.GetClipboardTextFn = clipboard_of_page;
  io.SetClipboardTextFn = set_clipboard_of_page;
  if (page_is_touched()) stage_->touches().expect();
  System::install();
  return {};
}

void Window::run(std::function<bool()> frame) {
  system_->frame = std::move(frame);
  last_time_ = seconds_now();
  // Not as an endless loop: that would leave this function by an exception, through all destructors.
  emscripten_set_main_loop(System::tick, 0, EM_FALSE);
}

void Window::update_cursor() {
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  if (wanted == system_->cursor) return;
  system_->cursor = wanted;
  set_page_cursor(wanted);
}

void Window::close() {
  system_->closed = true;
}

void Window::wake() {
  if (System::window != nullptr) System::window->system_->wake = true;
}

void Window::hide() {}

void Window::set_title(const std::string& title) {
  emscripten_set_window_title(title.c_str());
}

WindowSettings Window::state() const {
  return settings_;
}

}  // namespace replan::app
