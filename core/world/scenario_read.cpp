#include "core/base/file.hpp"
#include "core/debug/condition.hpp"
#include "core/world/choice_json.hpp"
#include "core/world/choices.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/scenario.hpp"
#include "core/world/scenario_map.hpp"
#include "core/world/scenario_places.hpp"

// Keys and ranges stand in assets/scenario.schema.json too; tests/unit/world_scenario_test.cpp holds the two
// together.

namespace replan {
namespace {

constexpr std::int64_t kMaxScenarioBytes = std::int64_t{1} << 28;
constexpr std::size_t kMaxSurprises = std::size_t{1} << 22;
constexpr std::size_t kMaxPlanners = 16;
constexpr std::int64_t kMaxCount = 1'000'000'000'000;  // steps of the robot
constexpr double kMaxReach = 10'000;                   // cells
constexpr std::size_t kMaxWay = 1000;                  // corners
constexpr double kMaxCamera = 1e9;                     // cells
constexpr double kMinZoom = 0.001, kMaxZoom = 10'000;  // pixels per cell

/// Reads one scenario. Errors are kept in the JsonReader; each step after the first is harmless.
class ScenarioReader {
 public:
  ScenarioReader(JsonNode root, const std::string& folder) : root_(root), folder_(folder) {}

  Scenario read() {
    check_version();
    if (!root_.expect_object({"replan", "name", "caption", "map", "start", "goal", "planners", "robot",
                              "surprises", "movers", "view", "debug", "seed"}))
      return {};
    if (const auto node = root_.find("name")) scenario_.name = node->text();
    if (const auto node = root_.find("caption")) scenario_.caption = node->text();
    if (const auto node = root_.require("map")) read_map_of(*node, folder_, scenario_);
    if (scenario_.map.blocked.empty()) return {};
    places_ = PlaceReader(scenario_.map.box());
    if (const auto node = root_.require("start")) scenario_.start = places_.cell(*node);
    if (const auto node = root_.require("goal")) scenario_.goal = places_.cell(*node);
    if (const auto node = root_.require("planners"))
      for (const JsonNode& item : node->items(1, kMaxPlanners, "a list of 1 to 16 planners"))
        read_planner(item);
    if (const auto node = root_.find("robot")) read_robot_setup(*node, scenario_.map.box(), scenario_.robot);
    check_radius();
    if (const auto node = root_.find("surprises"))
      for (const JsonNode& item : node->items(0, kMaxSurprises, "a list")) read_surprise(item);
    if (const auto node = root_.find("movers"))
      for (const JsonNode& item : node->items(0, kMaxMovers, "a list of at most 100 moving obstacles"))
        read_mover(item);
    if (const auto node = root_.find("view")) read_view(*node);
    if (const auto node = root_.find("debug")) read_debug(*node);
    if (const auto node = root_.find("seed")) scenario_.seed = seed(*node);
    return std::move(scenario_);
  }

 private:
  void check_version() const {
    const auto version = root_.find("replan");
    if (!version) return root_.fail(what_else_it_is());
    if (version->value() != 1)
      version->fail("must be 1, the only version of the format, not " + version->shown());
  }

  /// The program's other files end in .json too.
  [[nodiscard]] std::string what_else_it_is() const {
    const auto format = root_.find("format");
    if (format && format->value() == "replan experiment")
      return "an experiment, not a scenario: 'replan batch' runs it, and in the window File > Open shows it "
             "in "
             "Run > Batch";
    if (format && (format->value() == "replan batch" || format->value() == "replan results"))
      return "of the results of a batch, not a scenario: in the window File > Open shows them in Run > Batch";
    return "not a Replan scenario: the key \"replan\" with the value 1 is missing";
  }

  void read_planner(const JsonNode& node) {
    if (!node.expect_object({"id", "settings", "stages"})) return;
    const auto id = node.require("id");
    if (!id) return;
    PlannerChoice choice{id->text(), {}};
    const Result<const PlannerInfo*> info = require_choice(choice.id);
    if (!info) return id->fail(info.error());
    if (const auto fit = fits(**info, scenario_.map.box(), 0); !fit) return id->fail(fit.error());
    if (const auto settings = node.find("settings"))
      read_settings(*settings, (*info)->parameters, choice.settings);
    if (const auto stages = node.find("stages")) read_stages(*stages, choice.stages);
    scenario_.planners.push_back(std::move(choice));
  }

  /// Some planners are for a robot without a size alone.
  void check_radius() const {
    for (const PlannerChoice& choice : scenario_.planners)
      if (const auto fit = fits(info_of(choice), scenario_.map.box(), scenario_.robot.radius); !fit)
        return root_.fail(fit.error());
  }

  void read_mover(const JsonNode& node) {
    if (!node.expect_object({"way", "size", "speed", "at_end", "from"})) return;
    MovingObstacle mover;
    if (const auto way = node.require("way"))
      for (const JsonNode& item : way->items(1, kMaxWay, "a list of 1 to 1000 cells"))
        mover.way.push_back(places_.cell(item));
    if (const auto size = node.find("size")) places_.size(*size, mover);
    if (const auto speed = node.find("speed")) mover.speed = speed->number(kMinSpeed, kMaxSpeed);
    if (const auto at_end = node.find("at_end"))
      mover.at_end = static_cast<WayEnd>(at_end->one_of({"back", "loop", "stop"}));
    if (const auto from = node.find("from")) mover.from = from->whole(0, kMaxCount);
    scenario_.movers.push_back(std::move(mover));
  }

  void read_surprise(const JsonNode& node) {
    if (!node.expect_object({"at", "add", "remove", "announced", "goal", "robot"})) return;
    Surprise surprise;
    if (const auto at = node.require("at")) surprise.at = trigger(*at);
    const auto add = node.find("add"), removed = node.find("remove");
    const auto goal = node.find("goal"), robot = node.find("robot");
    if (!add && !removed && !goal && !robot)
      return node.fail("changes nothing: give 'add', 'remove', 'goal' or 'robot'");
    if (goal) surprise.goal = places_.cell(*goal);
    if (robot) surprise.robot = places_.cell(*robot);
    if (add) places_.cells(*add, true, surprise.cells);
    if (removed) places_.cells(*removed, false, surprise.cells);
    places_.tidy(node, surprise.cells);
    if (const auto announced = node.find("announced")) surprise.announced = announced->toggle();
    scenario_.surprises.push_back(std::move(surprise));
  }

  [[nodiscard]] Trigger trigger(const JsonNode& node) const {
    Trigger trigger;
    if (!node.expect_object({"move", "near", "within"})) return trigger;
    const auto move = node.find("move"), near = node.find("near");
    if (move.has_value() == near.has_value()) node.fail("needs exactly one of 'move' and 'near'");
    if (move) trigger.move = move->whole(0, kMaxCount);
    const auto within = near ? node.require("within") : node.find("within");
    if (near) trigger.near = places_.cell(*near);
    if (within && !near) within->fail("goes only with 'near'");
    if (within) trigger.within = within->number(0, kMaxReach);
    return trigger;
  }

  void read_view(const JsonNode& node) {
    if (!node.expect_object({"overlays", "theme", "camera"})) return;
    ViewSetup& view = scenario_.view;
    if (const auto overlays = node.find("overlays"))
      for (const JsonNode& item : overlays->items(0, 64, "a list of overlay names"))
        view.overlays.push_back(item.text());
    if (const auto theme = node.find("theme"))
      view.theme = theme->one_of({"dark", "light"}) == 0 ? "dark" : "light";
    const auto camera = node.find("camera");
    if (!camera || !camera->expect_object({"x", "y", "zoom"})) return;
    const auto x = camera->require("x"), y = camera->require("y"), zoom = camera->require("zoom");
    if (!x || !y || !zoom) return;
    view.camera = {x->number(-kMaxCamera, kMaxCamera), y->number(-kMaxCamera, kMaxCamera),
                   zoom->number(kMinZoom, kMaxZoom)};
  }

  void read_debug(const JsonNode& node) {
    if (!node.expect_object({"breakpoints", "watches"})) return;
    if (const auto breakpoints = node.find("breakpoints"))
      for (const JsonNode& item : breakpoints->items(0, kMaxBreakpoints, "a list of at most 64 breakpoints"))
        read_breakpoint(item);
    if (const auto watches = node.find("watches"))
      for (const JsonNode& item : watches->items(0, kMaxWatches, "a list of at most 16 watches")) {
        scenario_.debug.watches.push_back(item.text());
        if (!item.value().is_string()) continue;
        if (const auto error = error_anywhere(scenario_.debug.watches.back(), parse_quantity))
          item.fail(*error);
      }
  }

  /// Why a condition makes no sense in any world. One that was written when the world was larger, or had more layers or
  /// none, stays: it may be so again, and whoever looks for it is told.
  template <class Parse>
  [[nodiscard]] std::optional<std::string> error_anywhere(const std::string& text, const Parse& parse) const {
    const auto here = parse(text, scenario_.map.box(), own_fields());
    if (here) return std::nullopt;
    constexpr int kAnySide = static_cast<int>(kMaxCells);
    for (const Box& other : {Box(kAnySide, kAnySide), Box(kAnySide, kAnySide, kAnySide)})
      if (parse(text, other, own_fields())) return std::nullopt;
    return here.error();
  }

  void read_breakpoint(const JsonNode& node) {
    if (!node.expect_object({"condition", "enabled"})) return;
    const auto condition = node.require("condition");
    if (!condition) return;
    Breakpoint breakpoint{condition->text(), true};
    if (const auto enabled = node.find("enabled")) breakpoint.enabled = enabled->toggle();
    if (condition->value().is_string())
      if (const auto error = error_anywhere(breakpoint.condition, parse_condition)) condition->fail(*error);
    scenario_.debug.breakpoints.push_back(std::move(breakpoint));
  }

  static std::uint64_t seed(const JsonNode& node) {
    if (node.value().is_number_unsigned()) return node.value().get<std::uint64_t>();
    node.fail("must be a whole number from 0 to 18446744073709551615, not " + node.shown());
    return 0;
  }

  JsonNode root_;
  const std::string& folder_;
  Scenario scenario_;
  PlaceReader places_;  // on its map
};

}  // namespace

Result<Scenario> parse_scenario(const std::string& text, const std::string& origin,
                                const std::string& folder) {
  JsonReader reader(origin);
  if (!reader.parse(text)) return Error{reader.error()};
  Scenario scenario = ScenarioReader(reader.root(), folder).read();
  if (!reader.ok()) return Error{reader.error()};
  return scenario;
}

Result<Scenario> read_scenario(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxScenarioBytes);
  if (!text) return Error{text.error()};
  return parse_scenario(*text, path, file_folder(path));
}

}  // namespace replan
