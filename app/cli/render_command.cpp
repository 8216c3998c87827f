#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/render.hpp"
#include "core/world/text_lines.hpp"

namespace replan::cli {
namespace {

struct RenderArguments {
  WorldArguments world;
  std::string out;
  std::string size;
  std::string scale;
  std::string at;
  bool at_end = false;
  bool at_plan = false;
  std::vector<std::string> overlays;
  std::string theme;
  bool canvas_only = false;
};

Result<void> read_size(const std::string& text, app::RenderRequest& request) {
  const std::size_t cross = text.find('x');
  const auto width = number_from<int>(text.substr(0, cross));
  const auto height = cross == std::string::npos ? std::nullopt : number_from<int>(text.substr(cross + 1));
  if (!width || !height)
    return Error{"--size cannot be '" + text + "': give WxH in pixels, for example 1440x900"};
  request.width = *width;
  request.height = *height;
  return {};
}

Result<void> read_moment(const RenderArguments& arguments, app::RenderRequest& request) {
  if (int{!arguments.at.empty()} + int{arguments.at_end} + int{arguments.at_plan} > 1)
    return Error{"give only one of --at, --at-end and --at-plan"};
  if (arguments.at_end) request.at = app::Moment::end;
  if (arguments.at.empty()) return {};
  const auto event = parse_count("--at", arguments.at, 0);
  if (!event) return Error{event.error()};
  request.at = static_cast<std::size_t>(*event);
  return {};
}

Result<void> read_looks(const RenderArguments& arguments, app::RenderRequest& request) {
  if (!arguments.theme.empty()) request.theme = arguments.theme;
  if (!arguments.scale.empty()) {
    const auto scale = number_from<double>(arguments.scale);
    if (!scale) return Error{"--scale cannot be '" + arguments.scale + "': give a number from 0.5 to 4"};
    request.scale = *scale;
  }
  if (arguments.overlays.empty()) return {};
  const auto overlays = parse_overlays(split_list(arguments.overlays));
  if (!overlays)
    return Error{"--overlay: " + overlays.error() +
                 (overlays.error().ends_with('?') ? "" : "; 'replan list overlays' shows those there are")};
  request.overlays = *overlays;
  return {};
}

Result<int> render(const RenderArguments& arguments) {
  auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  app::RenderRequest request;
  request.scenario = std::move(world.value());
  request.output = arguments.out;
  request.window = !arguments.canvas_only;
  if (!arguments.size.empty())
    if (const auto size = read_size(arguments.size, request); !size) return Error{size.error()};
  if (const auto moment = read_moment(arguments, request); !moment) return Error{moment.error()};
  if (const auto looks = read_looks(arguments, request); !looks) return Error{looks.error()};
  std::optional<ProgressBar> bar;
  std::size_t frames = 0;
  request.progress = [&](std::size_t done, std::size_t all) {
    if (!bar) bar.emplace("frames", all);
    bar->show(frames = done);
  };
  const auto drawn = app::render(request);
  bar.reset();
  if (!drawn) return Error{drawn.error()};
  const bool folder = frames > 0;
  print("wrote " + (folder ? counted(static_cast<std::int64_t>(frames), "frame") + " into " : std::string()) +
        arguments.out + ", " + std::to_string(request.width) + " x " + std::to_string(request.height) +
        " pixels\n");
  return kDone;
}

std::string footer() {
  return "Examples:\n"
         "  replan render maps/demo.json -o demo.png --at-end\n"
         "      The window as it looks once the robot has arrived.\n"
         "  replan render maps/demo.json -o frames/ --size 1280x720\n"
         "      The whole run as numbered frames, for a film.\n"
         "  replan render --map arena.map --start 1,11 --goal 40,30 --planner dld-star-lite -o plan.svg "
         "--overlay path,rp\n"
         "      A drawing of the plan, for a paper.\n\n"
         "Needs neither a display nor a graphics card. Where nothing else is said, a picture shows the first "
         "plan.\n\n" +
         settings_help();
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("render", "Draw a picture or the frames of a run, without a display");
  const auto arguments = std::make_shared<RenderArguments>();
  RenderArguments& into = *arguments;
  into.world.declare(*app);
  app->add_option("-o,--output", into.out, "Where to: a .png, an .svg, or a folder/ for numbered frames")
      ->type_name("OUT")
      ->required();
  app->add_option("--size", into.size, "Pixels of the picture (default 1440x900)")->type_name("WxH");
  app->add_option("--scale", into.scale, "Device pixels per design pixel, 0.5 to 4 (default 1)")
      ->type_name("S");
  app->add_option("--at", into.at, "The moment: after that many events of the log")->type_name("EVENT");
  app->add_flag("--at-end", into.at_end, "The moment: the end of the run");
  app->add_flag("--at-plan", into.at_plan, "The moment: when the first plan stands (the default)");
  app->add_option("--overlay", into.overlays, "What to lay over the world; 'replan list overlays' shows them")
      ->type_name("ID[,ID...]")
      ->allow_extra_args(false);
  app->add_option("--theme", into.theme, "The colours; else the scenario's, else dark")
      ->type_name("light|dark");
  app->add_flag("--canvas-only", into.canvas_only, "The world alone, without the window around it");
  app->footer(footer);
  return {app, [arguments] { return render(*arguments); }};
}

}  // namespace replan::cli
