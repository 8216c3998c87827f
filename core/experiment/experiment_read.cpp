#include <algorithm>
#include <filesystem>

#include <glob.h>

#include "core/base/file.hpp"
#include "core/experiment/experiment.hpp"
#include "core/world/choice_json.hpp"
#include "core/world/choices.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/generators/list.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/scenario_map.hpp"

namespace replan {
namespace {

constexpr std::int64_t kMaxExperimentBytes = std::int64_t{1} << 24;
constexpr std::int64_t kMostSeed = 1'000'000'000;  // what planners take
constexpr double kLongestTime = 86'400;            // seconds
constexpr int kMostRepeats = 1000;
constexpr std::int64_t kMostSamples = 1'000'000'000;
constexpr const char* kFormat = "replan experiment";

/// The files that a pattern names, in the order of their names.
Result<std::vector<std::string>> files_of(const std::string& pattern, const std::string& folder) {
  if (is_generator_spec(pattern) || pattern.find_first_of("*?[") == std::string::npos)
    return std::vector{pattern};
  std::string escaped;  // nothing in the folder's own name is a pattern
  for (const char c : folder) {
    if (std::string_view("*?[\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  const bool absolute = pattern.starts_with("/");
  glob_t found{};
  const int failed = ::glob((absolute ? pattern : escaped + "/" + pattern).c_str(), 0, nullptr, &found);
  std::vector<std::string> files;
  for (std::size_t i = 0; failed == 0 && i < found.gl_pathc; ++i) {
    const std::string file = found.gl_pathv[i];
    files.push_back(absolute ? file : file.substr(folder.size() + 1));
  }
  ::globfree(&found);
  if (files.empty()) return Error{"no file matches '" + pattern + "' in '" + folder + "'"};
  std::sort(files.begin(), files.end());
  return files;
}

/// Reads one experiment. Errors are kept in the JsonReader; each step after the first is harmless.
class ExperimentReader {
 public:
  ExperimentReader(JsonNode root, const std::string& folder) : root_(root) { experiment_.folder = folder; }

  Experiment read() {
    check_version();
    if (!root_.expect_object({"format", "version", "name", "planners", "robots", "worlds", "surprises",
                              "seeds", "drive", "repeat", "limit"}))
      return {};
    if (const auto node = root_.find("name")) experiment_.name = node->text();
    if (const auto node = root_.find("drive")) experiment_.drive = node->toggle();
    if (const auto node = root_.find("repeat"))
      experiment_.repeat = static_cast<int>(node->whole(1, kMostRepeats));
    if (const auto node = root_.require("planners"))
      for (const JsonNode& item : node->items(1, kMostPlanned, "a list of planners")) read_swept(item);
    if (const auto node = root_.find("limit")) read_limit(*node);
    if (const auto node = root_.find("robots")) read_robots(*node);
    if (const auto node = root_.require("worlds"))
      for (const JsonNode& item : node->items(1, kMostPlanned, "a list of worlds")) read_world(item);
    if (const auto node = root_.find("surprises")) read_surprises(*node);
    if (!experiment_.drive) experiment_.surprises = {{ExperimentSurprises::Kind::none, {}}};
    if (const auto node = root_.find("seeds")) read_seeds(*node);
    return std::move(experiment_);
  }

 private:
  void check_version() const {
    const auto format = root_.find("format");
    if (!format || format->value() != kFormat)
      return root_.fail("not an experiment: the key \"format\" with the value \"" + std::string(kFormat) +
                        "\" is missing");
    if (const auto version = root_.require("version"); version && version->value() != 1)
      version->fail("must be 1, the only version of the format, not " + version->shown());
  }

  /// A planner for each combination of the values that are listed; the last setting varies fastest.
  void read_swept(const JsonNode& node) {
    if (!node.expect_object({"id", "settings", "stages"})) return;
    const auto id = node.require("id");
    if (!id) return;
    const Result<const PlannerInfo*> info = require_choice(id->text());
    if (!info) return id->fail(info.error());
    std::vector<PlannerChoice> swept(1);
    swept.front().id = id->text();
    if (const auto stages = node.find("stages")) read_stages(*stages, swept.front().stages);
    if (const auto settings = node.find("settings")) {
      if (!settings->value().is_object())
        return settings->fail("must be an object {...}, not " + settings->shown());
      for (auto item = settings->value().begin(); item != settings->value().end(); ++item)
        sweep(*settings->find(item.key()), item.key(), (*info)->parameters, swept);
    }
    for (PlannerChoice& choice : swept) add_planner(node, std::move(choice));
  }

  static void sweep(const JsonNode& node, const std::string& key, std::span<const Parameter> parameters,
                    std::vector<PlannerChoice>& swept) {
    if (key == "seed") return node.fail("the seed of a run is one of 'seeds'");
    std::vector<JsonNode> values{node};
    if (node.value().is_array()) values = node.items(1, kMostPlanned, "a value or a list of values");
    std::vector<PlannerChoice> more;
    for (const PlannerChoice& choice : swept)
      for (const JsonNode& value : values) {
        if (more.size() == kMostPlanned)
          return node.fail("makes more than " + std::to_string(kMostPlanned) + " planners of one");
        more.push_back(choice);
        read_setting(value, parameters, key, more.back().settings);
      }
    swept = std::move(more);
  }

  void add_planner(const JsonNode& node, PlannerChoice choice) {
    auto& all = experiment_.planners;
    if (std::find(all.begin(), all.end(), choice) != all.end())
      return node.fail("is '" + choice.id + "' with the same settings as a planner before it");
    all.push_back(std::move(choice));
  }

  /// What planners that become better with work are given. As many samples is a setting of theirs.
  void read_limit(const JsonNode& node) {
    if (!node.expect_object({"samples", "seconds"})) return;
    if (const auto seconds = node.find("seconds")) {
      experiment_.seconds = seconds->number(0.001, kLongestTime);
      if (experiment_.drive)
        seconds->fail("is for planning alone: leave out \"drive\", or limit the samples");
    }
    const auto samples = node.find("samples");
    if (!samples) return;
    const auto count = samples->whole(1, kMostSamples);
    for (PlannerChoice& choice : experiment_.planners) {
      const auto* parameter = find_parameter(find_choice(choice.id)->parameters, "samples");
      if (parameter == nullptr || choice.settings.has("samples")) continue;
      const auto number = static_cast<double>(count);
      if (number < parameter->low || number > parameter->high)
        return samples->fail("'" + choice.id + "' takes from " + plain_number(parameter->low).dump() +
                             " to " + plain_number(parameter->high).dump() + " samples, not " +
                             samples->shown());
      choice.settings.set("samples", number);
    }
  }

  void read_robots(const JsonNode& node) {
    experiment_.robots.clear();
    for (const JsonNode& item : node.items(1, kMostPlanned, "a list of robots")) {
      std::optional<RobotSetup> robot;
      if (item.value().is_object())
        read_robot_setup(item, Box(1, 1), robot.emplace());
      else if (item.value() != "own")
        return item.fail("must be a robot {...}, or \"own\" for that of the scenario, not " + item.shown());
      auto& all = experiment_.robots;
      if (std::find(all.begin(), all.end(), robot) != all.end()) return item.fail("is there twice");
      all.push_back(std::move(robot));
    }
  }

  void read_world(const JsonNode& node) {
    ExperimentWorld world;
    if (node.value().is_string())
      world.file = node.text();
    else if (node.expect_object({"file", "map", "limit", "start", "goal", "threshold", "invert", "unknown",
                                 "occupied", "heights"})) {
      const auto file = node.require("file"), map = node.find("map"), limit = node.find("limit"),
                 start = node.find("start"), goal = node.find("goal");
      if (!file) return;
      world.file = file->text();
      if (map) world.map = map->text();
      if (limit) world.limit = static_cast<std::size_t>(limit->whole(1, kMostRuns));
      if (start) world.start = coordinates(*start);
      if (goal) world.goal = coordinates(*goal);
      world.reading = read_map_reading(node);
    }
    const auto files = files_of(world.file, experiment_.folder);
    if (!files) return node.fail(one_line(files.error()));
    for (const std::string& file : *files) {
      world.file = file;
      add_world(node, world);
    }
  }

  /// What goes with its kind of file, and whether it is there already.
  void add_world(const JsonNode& node, const ExperimentWorld& world) {
    const std::string extension = file_extension(world.file);
    const bool problems = extension == ".scen" || extension == ".3dscen", scenario = extension == ".json";
    const auto refuse = [&](const char* key, const char* why) {
      if (const auto given = node.find(key)) given->fail(why);
    };
    if (!problems) {
      refuse("map", "goes with a file of problems, .scen or .3dscen");
      refuse("limit", "goes with a file of problems, .scen or .3dscen");
    }
    if (problems || scenario) {
      refuse("start", "goes with a map: this file has its own");
      refuse("goal", "goes with a map: this file has its own");
    }
    if (is_generator_spec(world.file))
      for (const char* key : {"threshold", "invert", "unknown", "occupied", "heights"})
        refuse(key, "goes with a map's file: a generator has settings of its own");
    if (scenario)
      for (const char* key : {"threshold", "invert", "unknown", "occupied", "heights"})
        refuse(key, "goes with a map: the scenario says itself how its map is read");
    for (const ExperimentWorld& other : experiment_.worlds)
      if (other.file == world.file && other.start == world.start && other.goal == world.goal)
        return node.fail(one_line("'" + world.file + "' is there twice"));
    if (experiment_.worlds.size() == kMostPlanned)
      return node.fail("there are more than " + std::to_string(kMostPlanned) + " worlds");
    experiment_.worlds.push_back(world);
  }

  static std::vector<int> coordinates(const JsonNode& node) {
    std::vector<int> all;
    for (const JsonNode& item : node.items(2, 3, "a cell [x, y], in space [x, y, z]"))
      all.push_back(static_cast<int>(item.whole(0, INT32_MAX)));
    return all;
  }

  void read_surprises(const JsonNode& node) {
    using Kind = ExperimentSurprises::Kind;
    experiment_.surprises.clear();
    for (const JsonNode& item : node.items(1, kMostPlanned, "a list of surprises")) {
      ExperimentSurprises one;
      if (item.value().is_object())
        one = {Kind::blocks, blocks(item)};
      else if (item.value() == "none")
        one.kind = Kind::none;
      else if (item.value() != "own")
        return item.fail(
            R"(must be "none", "own" for those of the scenario, or {"blocks": COUNT, ...}, not )" +
            item.shown());
      if (one.kind != Kind::none && !experiment_.drive)
        return item.fail("only a robot that drives meets surprises: give \"drive\": true");
      auto& all = experiment_.surprises;
      if (std::find(all.begin(), all.end(), one) != all.end()) return item.fail("is there twice");
      all.push_back(one);
    }
  }

  static RandomBlocks blocks(const JsonNode& node) {
    RandomBlocks blocks;
    if (!node.expect_object({"blocks", "side", "ahead"})) return blocks;
    if (const auto count = node.require("blocks"))
      blocks.count = static_cast<int>(count->whole(1, kMostBlocks));
    if (const auto side = node.find("side")) blocks.side = static_cast<int>(side->whole(1, kLongestBlock));
    const double least = blocks.side + kBlockMargin;
    blocks.ahead = std::max(blocks.ahead, least);
    if (const auto ahead = node.find("ahead")) blocks.ahead = ahead->number(least, 10 * kLongestBlock);
    return blocks;
  }

  void read_seeds(const JsonNode& node) {
    auto& seeds = experiment_.seeds;
    seeds.clear();
    if (node.value().is_object()) {
      if (!node.expect_object({"from", "count"})) return;
      const auto from = node.find("from"), count = node.require("count");
      const std::int64_t first = from ? from->whole(0, kMostSeed) : 1;
      const std::int64_t all =
          count ? count->whole(1, std::min<std::int64_t>(kMostPlanned, kMostSeed - first + 1)) : 0;
      for (std::int64_t i = 0; i < all; ++i) seeds.push_back(static_cast<std::uint64_t>(first + i));
      return;
    }
    for (const JsonNode& item :
         node.items(1, kMostPlanned, R"(a list of seeds, or {"from": 1, "count": 20})")) {
      const auto seed = static_cast<std::uint64_t>(item.whole(0, kMostSeed));
      if (std::find(seeds.begin(), seeds.end(), seed) != seeds.end()) return item.fail("is there twice");
      seeds.push_back(seed);
    }
  }

  JsonNode root_;
  Experiment experiment_;
};

}  // namespace

Result<Experiment> parse_experiment(const std::string& text, const std::string& origin,
                                    const std::string& folder) {
  JsonReader reader(origin);
  if (!reader.parse(text)) return Error{reader.error()};
  Experiment experiment = ExperimentReader(reader.root(), folder).read();
  if (!reader.ok()) return Error{reader.error()};
  return experiment;
}

Result<Experiment> read_experiment(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxExperimentBytes);
  if (!text) return Error{text.error()};
  return parse_experiment(*text, path, file_folder(path));
}

std::string path_in(const Experiment& experiment, const std::string& file) {
  return (std::filesystem::path(experiment.folder) / file).string();
}

}  // namespace replan
