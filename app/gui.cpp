#include "app/gui.hpp"

#include <utility>

#include "app/first_document.hpp"
#include "app/gui_program.hpp"
#include "app/gui_settings.hpp"
#include "core/base/disposal.hpp"

namespace replan::app {

namespace {

Result<void> run_program(FirstDocument document, bool in_step) {
  if (in_step) dispose_at_once();
  WorkPlace work = in_step || !kThreads ? WorkPlace::in_steps() : WorkPlace::beside([] { Window::wake(); });
  GuiProgram program(std::move(document), read_settings(settings_path()), std::move(work));
  if (const Result<void> opened = program.open(); !opened) return opened;
  program.run();
  return program.close();
}

}  // namespace

Result<void> run_window(const std::optional<std::string>& file, bool in_step) {
  Result<FirstDocument> document = first_document(file);
  if (!document) return Error{document.error()};
  return run_program(std::move(*document), in_step);
}

Result<void> run_window(Scenario world) {
  return run_program({std::move(world), {}}, false);
}

}  // namespace replan::app
