#include "app/gui.hpp"

#include <utility>

#include "app/gui_program.hpp"
#include "app/gui_settings.hpp"

namespace replan::app {

Result<void> run_window(const std::optional<std::string>& file) {
  Result<FirstDocument> document = first_document(file);
  if (!document) return Error{document.error()};
  GuiProgram program(std::move(*document), read_settings(settings_path()));
  if (const Result<void> opened = program.open(); !opened) return opened;
  program.run();
  return program.close();
}

}  // namespace replan::app
