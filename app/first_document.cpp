#include "app/first_document.hpp"

#include <filesystem>
#include <utility>

#include "core/base/file.hpp"
#include "core/experiment/held_results.hpp"
#include "core/plan/pages.hpp"
#include "ui/documents/files.hpp"

namespace replan::app {
namespace {

/// A small world in code, for a program that was copied without its files.
Scenario built_in_world() {
  Scenario scenario;
  scenario.name = "Two walls";
  scenario.map = GridMap(36, 24);
  for (int y = 0; y < 17; ++y) scenario.map.set({12, y}, true);
  for (int y = 7; y < 24; ++y) scenario.map.set({23, y}, true);
  scenario.start = {3, 12};
  scenario.goal = {32, 12};
  scenario.planners = {{.id = std::string(sound_planners().back().id), .settings = {}}};
  return scenario;
}

}  // namespace

Result<FirstDocument> first_document(const std::optional<std::string>& file) {
  if (file && is_link(*file)) {
    Result<Link> link = parse_link(*file);
    if (!link) return Error{link.error()};
    Scenario scenario = link->scenario;
    return FirstDocument{.scenario = std::move(scenario), .file = {}, .link = std::move(link.value())};
  }
  const bool batch = file && batch_paper(*file) != BatchPaper::none;
  if (file && !batch) {
    const Result<Scenario> opened = ui::open_document(*file, built_in_world());
    if (!opened) return Error{opened.error()};
    return FirstDocument{*opened, *file};
  }
  const std::filesystem::path demo = std::filesystem::path(assets_folder()) / "../maps/demo.json";
  // The demo is nobody's file: saving asks for a name.
  const Result<Scenario> opened = read_scenario(demo.lexically_normal().string());
  return FirstDocument{opened ? *opened : built_in_world(), {}, batch ? *file : "", false};
}

}  // namespace replan::app
