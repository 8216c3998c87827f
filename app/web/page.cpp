#include "app/web/page.hpp"

#include <cstdlib>
#include <string_view>

#include <emscripten.h>
#include <imgui.h>

namespace replan::app {
namespace {

// clang-format off
EM_JS(void, js_tell, (const char* sentence), { Module.replan.tell(UTF8ToString(sentence)); });
EM_JS(void, js_reveal, (void), { Module.replan.reveal(); });
EM_JS(void, js_cursor, (const char* name), { Module.canvas.style.cursor = UTF8ToString(name); });
EM_JS(void, js_copy, (const char* text), { Module.replan.copy(UTF8ToString(text)); });
EM_JS(char*, js_pasted, (void), { return stringToNewUTF8(Module.replan.pasted); });
EM_JS(void, js_pick, (const char* extensions), { Module.replan.pick(UTF8ToString(extensions)); });
EM_JS(void, js_typing, (int typing), { Module.replan.type(typing !== 0); });
EM_JS(int, js_touched, (void), { return matchMedia('(pointer: coarse)').matches ? 1 : 0; });
EM_JS(char*, js_address, (void), { return stringToNewUTF8(location.href.split('#')[0]); });
EM_JS(char*, js_link, (void), { return stringToNewUTF8(location.hash.length > 1 ? location.hash : ''); });
EM_JS(void, js_keep, (void), { Module.replan.keep(); });
// clang-format on

/// A text that JavaScript has allocated.
std::string taken(char* text) {
  std::string held = text;
  std::free(text);
  return held;
}

const char* css_cursor(int cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_TextInput:
      return "text";
    case ImGuiMouseCursor_ResizeNS:
      return "ns-resize";
    case ImGuiMouseCursor_ResizeEW:
      return "ew-resize";
    case ImGuiMouseCursor_ResizeAll:
      return "move";
    case ImGuiMouseCursor_ResizeNESW:
      return "nesw-resize";
    case ImGuiMouseCursor_ResizeNWSE:
      return "nwse-resize";
    case ImGuiMouseCursor_Hand:
      return "pointer";
    case ImGuiMouseCursor_NotAllowed:
      return "not-allowed";
    default:
      return cursor < 0 ? "none" : "default";
  }
}

}  // namespace

void tell_page(const std::string& sentence) {
  js_tell(sentence.c_str());
}

void reveal_page() {
  js_reveal();
}

std::string page_address() {
  return taken(js_address());
}

std::string page_link() {
  return taken(js_link());
}

void set_page_cursor(int cursor) {
  js_cursor(css_cursor(cursor));
}

void pick_file(const std::string& extensions) {
  js_pick(extensions.c_str());
}

void copy_text(const char* text) {
  js_copy(text);
}

const char* pasted_text() {
  static std::string held;
  held = taken(js_pasted());
  return held.c_str();
}

bool is_clipboard_key(const char* key) {
  const std::string_view name = key;
  return name == "c" || name == "x" || name == "v" || name == "C" || name == "X" || name == "V";
}

void set_page_typing(bool typing) {
  js_typing(typing ? 1 : 0);
}

bool page_is_touched() {
  return js_touched() != 0;
}

void keep_files() {
  js_keep();
}

}  // namespace replan::app
