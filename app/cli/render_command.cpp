#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/render.hpp"

namespace replan::cli {
namespace {

struct RenderArguments {
  WorldArguments world;
  std::string out;
  std::string size = "1440x900";
  std::string scale = "1";
  std::string at;
  bool at_end = false;
  bool at_plan = false;
  std::vector<std::string> overlays;
  std::string theme;
  bool canvas_only = false;
};

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* app = program.add_subcommand("render", "Draw a scenario without a display: a still or numbered frames");
  const auto arguments = std::make_shared<RenderArguments>();
  return {app, [] { return Result<int>(0); }};
}

}  // namespace replan::cli
