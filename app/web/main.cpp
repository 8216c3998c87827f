// Replan in a page. The page's script has brought its home folder back before it calls main().
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <emscripten.h>

#include "app/first_document.hpp"
#include "app/gui_program.hpp"
#include "app/gui_settings.hpp"
#include "app/web/page.hpp"

namespace replan::app {
namespace {

/// Stays for as long as the page does: main() returns before the first frame.
GuiProgram* program = nullptr;

/// With the world of the page's own address, if there is one in it, else with the demo.
Result<void> start() {
  const std::string link = page_link();
  Result<FirstDocument> document = first_document(link.empty() ? std::nullopt : std::optional(link));
  const std::string unreadable = document ? "" : document.error();
  if (!document && !link.empty()) document = first_document(std::nullopt);
  if (!document) return Error{document.error()};
  auto made = std::make_unique<GuiProgram>(std::move(*document), read_settings(settings_path()),
                                           WorkPlace::in_steps());
  if (const Result<void> opened = made->open(); !opened) return opened;
  program = made.release();
  program->set_link_address(page_address());
  if (!unreadable.empty()) program->tell(unreadable, true);
  program->run();
  return {};
}

}  // namespace

extern "C" {

/// Files that the page wrote into its file system, a line each: dropped, or chosen by the browser's picker.
EMSCRIPTEN_KEEPALIVE void replan_drop(const char* paths) {
  if (program == nullptr) return;
  std::vector<std::string> all;
  std::istringstream lines(paths);
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  program->drop(all);
}

/// The page's address has another link in it.
EMSCRIPTEN_KEEPALIVE void replan_open_link(const char* link) {
  if (program != nullptr) program->open_link(link);
}

/// Ctrl and that letter, which the browser had kept for an event of its own.
EMSCRIPTEN_KEEPALIVE void replan_clipboard_key(int letter) {
  if (program != nullptr) press_in_page(letter);
}

/// A character from the keyboard on the screen (see type_in_page()).
EMSCRIPTEN_KEEPALIVE void replan_type(int code_point) {
  if (program != nullptr) type_in_page(static_cast<unsigned>(code_point));
}

/// The page may go: what is to be remembered is written.
EMSCRIPTEN_KEEPALIVE void replan_leave() {
  if (program != nullptr) program->remember();
}

/// The link to this moment, for tests; else it goes through the clipboard.
EMSCRIPTEN_KEEPALIVE const char* replan_link() {
  static std::string held;
  const Result<std::string> link = program == nullptr ? Result<std::string>(Error{""}) : program->link();
  held = link ? *link : "";
  return held.c_str();
}

/// Facts of the session as JSON, for tests.
EMSCRIPTEN_KEEPALIVE const char* replan_facts() {
  static std::string held;
  held = program == nullptr ? "{}" : program->facts();
  return held.c_str();
}

}  // extern "C"

}  // namespace replan::app

int main() {
  if (const replan::Result<void> started = replan::app::start(); !started) {
    replan::app::tell_page(started.error());
    return 1;
  }
  replan::app::reveal_page();
  return 0;
}
