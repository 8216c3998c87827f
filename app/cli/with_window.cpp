#include "app/cli/window.hpp"
#include "app/gui.hpp"
#include "app/study_pictures.hpp"
#include "ui/shell/actions.hpp"

namespace replan::cli {

bool has_window() {
  return true;
}

Result<void> open_window(const std::optional<std::string>& file, bool in_step) {
  return app::run_window(file, in_step);
}

Result<void> open_window(Scenario world) {
  return app::run_window(std::move(world));
}

std::vector<Command> add_drawing(CLI::App& program) {
  return {add_render(program)};
}

app::DrawPicture study_pen() {
  return app::draw_study_picture;
}

std::vector<ListedAction> listed_actions() {
  std::vector<ListedAction> all;
  for (const ui::Action& each : ui::actions())
    all.push_back(
        {std::string(each.name), std::string(each.keys), std::string(each.label), std::string(each.teach)});
  return all;
}

}  // namespace replan::cli
