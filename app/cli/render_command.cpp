#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/render.hpp"
#include "core/base/file.hpp"
#include "core/lattice/box_words.hpp"
#include "core/robots/drive_sense.hpp"
#include "core/world/choices.hpp"
#include "core/world/formats/text_lines.hpp"

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
  std::string range;
  std::string colours;
  std::string theme;
  bool canvas_only = false;
  std::vector<std::string> actions;
  std::string dialog;
  std::string pin;
  std::string arc;
  std::string camera;
  std::string slice;
  std::string orbit;
  bool cut = false, glass = false;
  std::string panes;
  std::string fps;
  std::string speed;
  std::string hold;
  std::string from;
  std::string to;
};

/// What a link says of the moment and the look. Of a film that is the look alone.
Result<void> read_link(const RenderArguments& arguments, app::RenderRequest& request) {
  request.note = [](const std::string& sentence) { tell_notes(std::vector{sentence}); };
  if (!arguments.world.is_link()) return {};
  Result<Link> link = parse_link(arguments.world.scenario);
  if (!link) return Error{link.error()};
  request.link = std::move(link->view);
  if (file_extension(request.output) != ".svg") request.panes = request.scenario.planners.size();
  return {};
}

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
  const bool given = !arguments.at.empty() || arguments.at_end || arguments.at_plan;
  if (given && app::is_film(request.output))
    return Error{"--at, --at-end and --at-plan are for stills; a film takes --from and --to"};
  if (arguments.at_end) request.at = app::Moment::end;
  if (!given && request.link && request.link->event) request.at = app::LinkMoment{};
  if (arguments.at.empty()) return {};
  request.at = arguments.at;
  return {};
}

Result<void> read_colours(const std::string& name, app::RenderRequest& request) {
  if (name.empty()) return {};
  const auto colours = ui::field_colours_named(name);
  if (!colours) return Error{"--colours cannot be '" + name + "': give viridis, cividis or grey"};
  request.colours = *colours;
  return {};
}

Result<void> read_looks(const RenderArguments& arguments, app::RenderRequest& request) {
  if (!arguments.theme.empty()) request.theme = arguments.theme;
  if (!arguments.scale.empty()) {
    const auto scale = number_from<double>(arguments.scale);
    if (!scale) return Error{"--scale cannot be '" + arguments.scale + "': give a number from 0.5 to 4"};
    request.scale = *scale;
  }
  if (!arguments.range.empty()) {
    if (arguments.range != "whole-run" && arguments.range != "so-far")
      return Error{"--range cannot be '" + arguments.range + "': give whole-run or so-far"};
    request.range = arguments.range == "so-far" ? FieldSpan::so_far : FieldSpan::whole_run;
  }
  if (const auto colours = read_colours(arguments.colours, request); !colours) return colours;
  if (arguments.overlays.empty()) return {};
  const auto overlays = parse_overlays(split_list(arguments.overlays));
  if (!overlays)
    return Error{"--overlay: " + overlays.error() +
                 (overlays.error().ends_with('?') ? "" : "; 'replan list overlays' shows those there are")};
  request.overlays = *overlays;
  return {};
}

/// All numbers of a list such as 12,8.5,48; nothing if it has other parts (nan and inf are such), or another number of
/// them.
std::optional<std::vector<double>> numbers_in(const std::string& list, std::size_t count) {
  const std::vector<std::string> parts = split_list(std::vector{list});
  std::vector<double> numbers;
  for (const std::string& part : parts)
    if (const auto number = number_from<double>(part); number && std::isfinite(*number))
      numbers.push_back(*number);
  if (parts.size() != count || numbers.size() != count) return std::nullopt;
  return numbers;
}

/// What the fastest of the robots that drive can do.
DriveLimits limits_of_drives(const Scenario& scenario) {
  DriveLimits most;
  most.v_max = most.w_max = 0;
  for (const PlannerChoice& choice : scenario.planners) {
    if (!drives(scenario, choice)) continue;
    const DriveLimits own = drive_settings(resolved(choice, scenario.robot).robot.settings).limits;
    most.v_max = std::max(most.v_max, own.v_max);
    most.w_max = std::max(most.w_max, own.w_max);
  }
  return most;
}

Result<void> read_arc(const RenderArguments& arguments, app::RenderRequest& request) {
  if (arguments.arc.empty()) return {};
  if (!drives(request.scenario))
    return Error{"--arc is for a robot that drives, and this one goes from cell to cell: leave it out"};
  const auto motion = numbers_in(arguments.arc, 2);
  if (!motion)
    return Error{"--arc cannot be '" + arguments.arc +
                 "': give V,W, the speed in m/s and the turn rate in rad/s, for example 0.4,-0.1"};
  const DriveLimits most = limits_of_drives(request.scenario);
  const double v = (*motion)[0], w = (*motion)[1];
  if (!(v >= 0 && v <= most.v_max && std::abs(w) <= most.w_max))
    return Error{"--arc " + arguments.arc + " is more than the robot can do: give a speed from 0 to " +
                 decimals(most.v_max, 2) + " m/s, and a turn rate of at most " + decimals(most.w_max, 2) +
                 " rad/s to either side"};
  request.motion = Twist{v, w};
  return {};
}

Result<void> read_place(const RenderArguments& arguments, app::RenderRequest& request) {
  if (!arguments.pin.empty()) {
    const Box world = request.scenario.map.box();
    const auto cell =
        parse_cell_in(request.scenario.map, "--pin", arguments.pin, "the world of " + size_text(world));
    if (!cell) return Error{cell.error()};
    request.pinned = *cell;
  }
  if (arguments.camera.empty()) return {};
  const auto numbers = numbers_in(arguments.camera, 3);
  if (!numbers || !((*numbers)[2] > 0))
    return Error{"--camera cannot be '" + arguments.camera +
                 "': give X,Y,ZOOM, the point in the middle and pixels per cell, for example 12,8.5,48"};
  request.camera = ViewSetup::Camera{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  return {};
}

Result<void> read_slice(const RenderArguments& arguments, app::RenderRequest& request) {
  if (arguments.slice.empty()) return {};
  const int depth = request.scenario.map.depth;
  if (depth == 1)
    return Error{"--slice is for a world of more than one layer, and " + arguments.world.source() +
                 " is a plane: leave it out"};
  if (arguments.slice == "robot") {
    request.follows_robot = true;
    return {};
  }
  const std::string& text = arguments.slice;
  const bool named = text.size() > 2 && text[1] == '=';
  const std::string_view axis = named ? std::string_view(text).substr(0, 1) : "z";
  const std::size_t number = std::string_view("xyz").find(axis);
  const auto layer = number_from<int>(named ? text.substr(2) : text);
  const Axis along = number == std::string_view::npos ? Axis::z : static_cast<Axis>(number);
  const int layers = SeenBox(request.scenario.map.box(), along).depth();
  if (number == std::string_view::npos || !layer || *layer < 0 || *layer >= layers)
    return Error{"--slice cannot be '" + text + "': give a layer from 0 to " + std::to_string(layers - 1) +
                 ", with x= or y= before it to look along another axis than z, or 'robot' for the layer that "
                 "the robot is in"};
  request.slice = Slice{along, *layer};
  return {};
}

Result<void> read_orbit(const RenderArguments& arguments, app::RenderRequest& request) {
  if (arguments.orbit.empty())
    return arguments.cut || arguments.glass
               ? Result<void>(Error{std::string(arguments.cut ? "--cut" : "--glass") +
                                    " is for a world from outside: add --orbit YAW,PITCH"})
               : Result<void>();
  if (request.scenario.map.depth == 1)
    return Error{"--orbit is for a world of more than one layer, and " + arguments.world.source() +
                 " is a plane: leave it out"};
  request.cut = arguments.cut;
  request.glass = arguments.glass;
  if (file_extension(request.output) == ".svg")
    return Error{"--orbit is not for .svg, which draws planes; take .png"};
  auto numbers = numbers_in(arguments.orbit, 2);
  if (!numbers) numbers = numbers_in(arguments.orbit, 6);
  if (!numbers || std::abs((*numbers)[1]) > 89 || (numbers->size() == 6 && (*numbers)[2] <= 0))
    return Error{
        "--orbit cannot be '" + arguments.orbit +
        "': give YAW,PITCH in degrees, how far it is turned and how high above the horizon it is seen "
        "from (at most 89), for example 30,35; and from how many cells away which point is seen, if not all "
        "of "
        "the world, for example 30,35,20,5,8,2"};
  const double degree = std::numbers::pi / 180;
  request.orbit = Orbit{(*numbers)[0] * degree, (*numbers)[1] * degree, 0, {}};
  if (numbers->size() == 2) return {};
  request.orbit->distance = (*numbers)[2];
  request.orbit->focus = {(*numbers)[3], (*numbers)[4], (*numbers)[5]};
  return {};
}

Result<void> read_panes(const RenderArguments& arguments, app::RenderRequest& request) {
  if (arguments.panes.empty()) return {};
  const auto count = number_from<int>(arguments.panes);
  if (arguments.panes != "all" && (!count || *count < 1))
    return Error{"--panes cannot be '" + arguments.panes + "': give a number, or all"};
  if (file_extension(request.output) == ".svg")
    return Error{"--panes is not for .svg, which draws one planner; take .png"};
  request.panes = count ? static_cast<std::size_t>(*count) : request.scenario.planners.size();
  return {};
}

Result<void> read_film(const RenderArguments& arguments, app::RenderRequest& request) {
  const std::pair<const char*, const std::string&> given[] = {{"--fps", arguments.fps},
                                                              {"--speed", arguments.speed},
                                                              {"--hold", arguments.hold},
                                                              {"--from", arguments.from},
                                                              {"--to", arguments.to}};
  if (!app::is_film(request.output))
    for (const auto& [name, text] : given)
      if (!text.empty())
        return Error{std::string(name) + " is for films (.gif, .webp, .mp4) and frames (FOLDER/), and " +
                     request.output + " is neither"};
  if (!arguments.fps.empty()) {
    const auto fps = number_from<int>(arguments.fps);
    if (!fps || *fps < 1 || *fps > kFastestFilm)
      return Error{"--fps cannot be '" + arguments.fps + "': give frames per second, from 1 to " +
                   std::to_string(kFastestFilm)};
    request.film.fps = *fps;
  }
  if (!arguments.hold.empty()) {
    const auto hold = number_from<double>(arguments.hold);
    if (!hold) return Error{"--hold cannot be '" + arguments.hold + "': give seconds, for example 0.5"};
    request.film.hold = *hold;
  }
  if (!arguments.speed.empty()) {
    const auto speed = parse_film_speed(arguments.speed);
    if (!speed) return Error{"--speed: " + speed.error()};
    request.film.speed = *speed;
  }
  if (!arguments.from.empty()) request.film.from = arguments.from;
  if (!arguments.to.empty()) request.film.to = arguments.to;
  return {};
}

Result<int> render(const RenderArguments& arguments) {
  auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  tell_notes(world->map_found.notes_for_planning());
  app::RenderRequest request;
  request.scenario = std::move(world.value());
  request.output = arguments.out;
  request.window = !arguments.canvas_only;
  request.actions = split_list(arguments.actions);
  request.dialog = arguments.dialog;
  if (const auto link = read_link(arguments, request); !link) return Error{link.error()};
  if (!arguments.size.empty())
    if (const auto size = read_size(arguments.size, request); !size) return Error{size.error()};
  if (const auto moment = read_moment(arguments, request); !moment) return Error{moment.error()};
  if (const auto looks = read_looks(arguments, request); !looks) return Error{looks.error()};
  if (const auto place = read_place(arguments, request); !place) return Error{place.error()};
  if (const auto arc = read_arc(arguments, request); !arc) return Error{arc.error()};
  if (const auto slice = read_slice(arguments, request); !slice) return Error{slice.error()};
  if (const auto orbit = read_orbit(arguments, request); !orbit) return Error{orbit.error()};
  if (const auto panes = read_panes(arguments, request); !panes) return Error{panes.error()};
  if (const auto film = read_film(arguments, request); !film) return Error{film.error()};
  std::optional<ProgressBar> bar;
  std::size_t frames = 0;
  request.progress = [&](std::size_t done, std::size_t all) {
    if (!bar) bar.emplace("frames", all);
    bar->show(frames = done);
  };
  const auto drawn = app::render(request);
  bar.reset();
  if (!drawn) return Error{drawn.error()};
  const std::string count =
      frames > 0 ? counted(static_cast<std::int64_t>(frames), "frame") + " into " : std::string();
  const app::FrameSize size = app::written_size(request);
  print("wrote " + count + arguments.out + ", " + std::to_string(size.width) + " x " +
        std::to_string(size.height) + " pixels\n");
  if (size.width != request.width || size.height != request.height)
    print("note: an .mp4 has even sides, so there is a black edge of one pixel at the right or the bottom\n");
  return kDone;
}

std::string render_footer() {
  return "Examples:\n"
         "  replan render maps/demo.json -o demo.png --at-end\n"
         "      The window as it looks once the robot has arrived.\n"
         "  replan render maps/demo.json -o demo.mp4 --size 1280x720\n"
         "      A film of the whole run. FFmpeg makes it; frames/ instead of demo.mp4 gives the bare "
         "frames.\n"
         "  replan render maps/demo.json -o repair.gif --canvas-only --panes all --from replan:1 --speed "
         "4/s\n"
         "      What follows the first replan, all planners side by side, at four robot moves per second.\n"
         "  replan render --map arena.map --start 1,11 --goal 40,30 --planner dld-star-lite -o plan.svg "
         "--overlay path,rp\n"
         "      A drawing of the plan, for a paper.\n"
         "  replan render maps/decks.json -o deck.png --slice 2 --canvas-only\n"
         "      One layer of a world in space. What runs and stands in other layers is faint.\n"
         "  replan render 'replan.html#v=1&at=1200&world=...' -o moment.png\n"
         "      What a link leads to. Options come before what the link says.\n\n"
         "Needs neither a display nor a graphics card. Where nothing else is said, a picture shows the first "
         "plan.\n\n"
         "A film shows the same frames each time. It stands under its name once it is complete; until then "
         "an "
         "old file\nstays whole, and an interrupted film leaves nothing.\n\n" +
         settings_help();
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* app = program.add_subcommand("render", "Draw a picture or a film of a run, without a display");
  const auto arguments = std::make_shared<RenderArguments>();
  RenderArguments& into = *arguments;
  into.world.declare(*app);
  app->add_option("-o,--output", into.out,
                  "Where to: a .png or .svg; a .gif, .webp or .mp4; a folder/ for numbered frames")
      ->type_name("OUT")
      ->required();
  app->add_option("--size", into.size, "Pixels of the picture (default 1440x900)")->type_name("WxH");
  app->add_option("--scale", into.scale, "Device pixels per design pixel, 0.5 to 4 (default 1)")
      ->type_name("S");
  app->add_option("--at", into.at,
                  "The moment: after that many events of the log, or start, plan, replan:N, move:N, end")
      ->type_name("MOMENT");
  app->add_flag("--at-end", into.at_end, "The moment: the end of the run");
  app->add_flag("--at-plan", into.at_plan, "The moment: when the first plan stands (the default)");
  app->add_option("--overlay", into.overlays, "What to lay over the world; 'replan list overlays' shows them")
      ->type_name("ID[,ID...]")
      ->allow_extra_args(false);
  app->add_option(
         "--range", into.range,
         "Over what a field's colours reach: the values of the whole run (the default), or those so far")
      ->type_name("whole-run|so-far");
  app->add_option("--colours", into.colours, "What fields are coloured by (default viridis)")
      ->type_name("viridis|cividis|grey");
  app->add_option("--theme", into.theme, "The colours; else the scenario's, else dark")
      ->type_name("light|dark");
  app->add_option(
         "--action", into.actions,
         "Of a picture of the window: do these actions of it first, one after the other, such as keys, or "
         "check_laws,show_debug; 'replan list actions' shows them")
      ->type_name("NAME[,NAME...]")
      ->allow_extra_args(false);
  app->add_option(
         "--dialog", into.dialog,
         "Of a picture of the window: the dialog that is open, such as open or keys, or the menu, such as "
         "menu_view, with contents that are the same on every machine; a wrong name shows them all")
      ->type_name("NAME");
  app->add_option("--arc", into.arc,
                  "Of a robot that drives: the speed in m/s and the turn rate in rad/s, above 0 to the "
                  "right, that the "
                  "Drive tab tells of")
      ->type_name("V,W");
  app->add_option("--pin", into.pin, "The cell that is pinned: the Cell tab tells of it")
      ->type_name("X,Y[,Z]");
  app->add_option(
         "--slice", into.slice,
         "Of a world of more than one layer: the one that is shown, across z or, with x= or y=, across "
         "another axis, or 'robot' for that of the robot; else that of the start")
      ->type_name("[x=|y=|z=]N");
  app->add_option(
         "--orbit", into.orbit,
         "Of a world of more than one layer: from outside, in 3D, turned by so many degrees and so many "
         "above the horizon; all of it, or from so many cells away from a point")
      ->type_name("YAW,PITCH[,DISTANCE,X,Y,Z]");
  app->add_flag("--cut", into.cut,
                "With --orbit: what lies beyond the slice, towards the viewer, is left out");
  app->add_flag("--glass", into.glass, "With --orbit: obstacles are like glass, and what is inside shows");
  app->add_option(
         "--camera", into.camera,
         "The point in the middle, in cells, and pixels per cell; else the scenario's, else all of the world")
      ->type_name("X,Y,ZOOM");
  app->add_flag("--canvas-only", into.canvas_only, "The world alone, without the window around it");
  app->add_option("--panes", into.panes,
                  "How many planners are shown side by side; else all in a window, one with --canvas-only")
      ->type_name("N|all");
  app->add_option("--fps", into.fps, "Film: frames per second, 1 to 60 (default 30)")->type_name("N");
  app->add_option("--speed", into.speed,
                  "Film: auto, expansion or move (one per frame), events per frame (50), or robot moves per "
                  "second (4/s)")
      ->type_name("SPEED");
  app->add_option("--hold", into.hold, "Film: seconds that each new plan stands still (default 1/3)")
      ->type_name("SECONDS");
  app->add_option("--from", into.from,
                  "Film: where it begins: a number of events, start, plan, replan:N, move:N or end")
      ->type_name("MOMENT");
  app->add_option("--to", into.to, "Film: where it ends, likewise")->type_name("MOMENT");
  app->footer(render_footer);
  return {app, [arguments] { return render(*arguments); }};
}

}  // namespace replan::cli
