#include "app/cli/window.hpp"

namespace replan::cli {

bool has_window() {
  return false;
}

Result<void> open_window(const std::optional<std::string>&, bool) {
  return Error{"this replan was built without a window; 'replan --help' tells its commands"};
}

Result<void> open_window(Scenario) {
  return open_window(std::nullopt, false);
}

std::vector<Command> add_drawing(CLI::App&) {
  return {};
}

app::DrawPicture study_pen() {
  return {};
}

std::vector<ListedAction> listed_actions() {
  return {};
}

}  // namespace replan::cli
