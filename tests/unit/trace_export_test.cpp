// Traces for other programs: JSON Lines that the run can be rebuilt from, and Posthoc's format to the letter.
#include "core/session/trace_export.hpp"

#include <bit>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

#include "core/base/file.hpp"
#include "core/base/random.hpp"
#include "core/export/json_lines.hpp"
#include "core/export/posthoc.hpp"
#include "core/export/trace_text.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/posthoc_check.hpp"
#include "tests/support/schema_check.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/worlds.hpp"

namespace replan::trace_export_test {
namespace {

using Json = nlohmann::json;

std::shared_ptr<const Scenario> demo() {
  const auto read = read_scenario(REPLAN_SOURCE_DIR "/maps/demo.json");
  return std::make_shared<const Scenario>(read.ok() ? *read : Scenario{});
}

/// A small mission with a replan.
std::shared_ptr<const Scenario> closing_gap() {
  const auto read = parse_scenario(R"({"replan": 1,
      "map": {"rows": ["........", "...@....", "...@....", "...@....", "........"]},
      "start": [0, 2], "goal": [7, 2], "planners": [{"id": "dstar-lite"}],
      "robot": {"knowledge": "map", "sensor_radius": 2},
      "surprises": [{"at": {"move": 1}, "add": {"cells": [[3, 0]]}}]})",
                                   "gap", "");
  return std::make_shared<const Scenario>(read.ok() ? *read : Scenario{});
}

/// A world, a robot and surprises by chance, seen and unseen, with something that moves in every third; with
/// `layers` a box of voxels.
std::shared_ptr<const Scenario> random_mission(std::uint32_t seed, const std::string& planner,
                                               int layers = 1) {
  Random random(seed);
  Scenario scenario;
  scenario.name = "mission \"" + std::to_string(seed) + "\"";
  const int width = random.between(5, 14), height = random.between(5, 14);
  scenario.map = GridMap(width, height, layers);
  for (std::size_t cell = 0; cell < scenario.map.blocked.size(); ++cell)
    scenario.map.blocked[cell] = random.chance(0.25) ? (random.chance(0.2) ? kUnmapped : kObstacle) : kFree;
  scenario.start = {0, 0};
  scenario.goal = {scenario.map.width - 1, scenario.map.height - 1, layers - 1};
  scenario.map.set(scenario.start, false);
  scenario.map.set(scenario.goal, false);
  const PlannerInfo* info = find_planner(planner);
  scenario.planners = {{planner, test::random_settings(random, *info)}};
  scenario.robot.knowledge = static_cast<Knowledge>(random.below(3));
  scenario.robot.sensor_radius = random.between(1, 4);
  for (int i = random.between(0, 4); i > 0; --i) {
    Surprise surprise;
    surprise.at.move = random.between(0, 8);
    surprise.announced = random.chance(0.5);
    for (NodeId node = 0; node < scenario.map.blocked.size(); ++node)
      if (random.chance(0.08))
        surprise.cells.push_back({scenario.map.box().position(node), random.chance(0.6)});
    if (!surprise.cells.empty()) scenario.surprises.push_back(surprise);
  }
  if (seed % 3 == 0)
    scenario.movers.push_back({.way = {{1, 1}, {3, 3, layers - 1}}, .depth = layers, .speed = 4});
  return std::make_shared<const Scenario>(std::move(scenario));
}

/// The trace of a whole mission as text.
std::string trace(const std::shared_ptr<const Scenario>& scenario, const std::string& name) {
  const test::TemporaryFolder folder;
  replan::Run run(scenario, 0);
  run.finish(Target::end());
  const std::string path = folder.file(name);
  const auto written = write_trace(path, trace_run(run));
  EXPECT_TRUE(written.ok()) << (written.ok() ? "" : written.error());
  const auto text = read_file(path);
  return text.ok() ? *text : "";
}

// --- Costs ---

TEST(TraceText, CostsReadBackExactly) {
  Random random(7);
  for (int i = 0; i < 200'000; ++i) {
    const int bits = random.between(1, 52);
    const auto raw = static_cast<std::int64_t>(
        (std::uint64_t{random.below(1u << 31)} << 31 | random.below(1u << 31)) >> (62 - bits));
    std::string text;
    append_cost(text, {raw});
    ASSERT_EQ(std::llround(std::stod(text) * static_cast<double>(Cost::kScale)), raw) << text;
    ASSERT_TRUE(text.find('.') == std::string::npos || text.back() != '0') << text;
  }
  // Beyond what a double holds: exact as a decimal number.
  for (const std::int64_t raw :
       {Cost::kInfinityRaw - 1, (std::int64_t{1} << 60) + 1, (std::int64_t{1} << 30) - 1}) {
    std::string text;
    append_cost(text, {raw});
    const std::size_t point = text.find('.');
    std::string fraction = point == std::string::npos ? "" : text.substr(point + 1);
    fraction.resize(10, '0');
    __extension__ using Wide = unsigned __int128;
    const Wide decimal = Wide{std::stoull(text.substr(0, point))} * 10'000'000'000u + std::stoull(fraction);
    EXPECT_EQ(static_cast<std::int64_t>((decimal * 2 * static_cast<Wide>(Cost::kScale) + 10'000'000'000u) /
                                        20'000'000'000u),
              raw);
  }
}

TEST(TraceText, ShortCostsAreShort) {
  const auto text = [](std::int64_t raw) {
    std::string out;
    append_cost(out, {raw});
    return out;
  };
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(Cost::kScale * 41), "41");
  EXPECT_EQ(text(Cost::kScale * 41 + Cost::kScale / 2), "41.5");
  EXPECT_EQ(text(kStepCost[2].raw), "1.4142135624");
}

// --- JSON Lines ---

Cost cost_of(const Json& value) {
  if (value == "inf") return Cost::infinity();
  return {std::llround(value.get<double>() * static_cast<double>(Cost::kScale))};
}

/// A run's states, built from the lines alone.
class Rebuilt {
 public:
  explicit Rebuilt(const Json& head)
      : box_(head["width"], head["height"], head.contains("depth") ? head["depth"].get<int>() : 1),
        values_(find_planner(head["planner"].get<std::string>())->values) {
    std::vector<std::uint8_t> known, truth;
    for (const auto& row : head["known"])
      for (const char c : row.get<std::string>()) known.push_back(c == '@');
    for (const auto& row : head["walls"])
      for (const char c : row.get<std::string>()) truth.push_back(c == '@');
    for (const auto& moving : head["moving"])
      truth[node(moving)] = static_cast<std::uint8_t>(truth[node(moving)] + 2 * moving.back().get<int>());
    state_ = SearchState(known, truth, values_.all_fields());
  }

  /// False if the line's `before` is not what stood there.
  bool take(const Json& line) {
    if (line["kind"] == "epoch") state_.apply(Event{.kind = EventKind::epoch});
    if (!line.contains("before")) return true;
    Event event;
    event.kind = kind(line["kind"]);
    event.node = event.kind == EventKind::scalar ? scalar(line["name"])
                 : line.contains("vertex")       ? line["vertex"].get<NodeId>()
                 : line.contains("path")         ? place_of(line)
                                                 : node(line["cell"]);
    const std::uint64_t before = raw(event, line["before"]), after = raw(event, line["after"]);
    if (state_.value(event.kind, event.node) != before) return false;
    event.delta = before ^ after;
    state_.apply(event);
    return true;
  }
  [[nodiscard]] std::uint64_t hash() const { return state_.hash(); }

 private:
  [[nodiscard]] EventKind kind(const std::string& name) const {
    int kind = 0;
    while (event_name(values_, static_cast<EventKind>(kind)) != name)
      if (++kind == kEventKinds) kind = kFirstOwnField;  // there are none between
    return static_cast<EventKind>(kind);
  }
  static NodeId scalar(const std::string& name) {
    NodeId which = 0;
    while (scalar_name(static_cast<Scalar>(which)) != name) ++which;
    return which;
  }
  /// A path of a population, or a place in one.
  static NodeId place_of(const Json& line) {
    const auto path = line["path"].get<NodeId>();
    return line.contains("place") ? path * kPlacesOfPath + line["place"].get<NodeId>() : path;
  }
  [[nodiscard]] NodeId node(const Json& cell) const {
    return box_.node({cell[0].get<int>(), cell[1].get<int>(), box_.solid() ? cell[2].get<int>() : 0});
  }
  [[nodiscard]] std::uint64_t raw(const Event& event, const Json& value) const {
    if (value.is_null()) return 0;
    if (value.is_array()) return std::uint64_t{node(value)} + 1;
    if (value.is_boolean()) return value.get<bool>();
    if (value.contains("times"))
      return value["times"].get<std::uint64_t>() << 32 | value["order"].get<std::uint64_t>();
    if (value.contains("wall"))
      return value["moving"].get<std::uint64_t>() << 1 | std::uint64_t{value["wall"].get<bool>()};
    if (is_own_field(event.kind) && values_.field(event.kind).type == FieldType::count)
      return value.get<std::uint64_t>();
    if (is_own_field(event.kind) && values_.field(event.kind).type == FieldType::name) {
      const auto names = values_.field(event.kind).names;
      return static_cast<std::uint64_t>(std::find(names.begin(), names.end(), value.get<std::string>()) -
                                        names.begin());
    }
    if (is_own_field(event.kind) && values_.field(event.kind).type == FieldType::vertex)
      return value.get<std::uint64_t>() + 1;
    if (event.kind == EventKind::scalar) return raw(scalar_type(static_cast<Scalar>(event.node)), value);
    return static_cast<std::uint64_t>(cost_of(value).raw) + (event.kind == EventKind::queue ? 1 : 0);
  }

  static std::uint64_t raw(ScalarType type, const Json& value) {
    switch (type) {
      case ScalarType::real:
        return std::bit_cast<std::uint64_t>(value.get<double>());
      case ScalarType::score:
        return score_bits(value.get<double>());
      case ScalarType::some_count:
      case ScalarType::vertex:
      case ScalarType::path:
        return value.get<std::uint64_t>() + 1;
      case ScalarType::cost:
      case ScalarType::found_cost:
        return static_cast<std::uint64_t>(cost_of(value).raw);
      default:
        return value.get<std::uint64_t>();
    }
  }

  Box box_;
  const SearchValues& values_;
  SearchState state_;
};

void expect_rebuilds(const std::shared_ptr<const Scenario>& scenario) {
  const auto schema = read_file(REPLAN_SOURCE_DIR "/assets/trace.schema.json");
  ASSERT_TRUE(schema.ok()) << schema.error();
  const Json rules = Json::parse(*schema);
  const test::SchemaCheck check(rules);
  replan::Run run(scenario, 0);
  run.finish(Target::end());
  std::istringstream lines(trace(scenario, "run.jsonl"));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const Json head = Json::parse(line);
  ASSERT_EQ(check.check(head), "") << line;
  ASSERT_EQ(head["events"], run.timeline().size());
  Rebuilt rebuilt(head);
  std::map<std::string, int> seen;
  std::size_t count = 0;
  for (; std::getline(lines, line); ++count) {
    const Json event = Json::parse(line);
    if (seen[event["kind"].get<std::string>()]++ < 40) {  // of each kind: the check takes its time
      ASSERT_EQ(check.check(event), "") << line;
    }
    ASSERT_EQ(event["event"], count);
    ASSERT_TRUE(rebuilt.take(event)) << line;
  }
  EXPECT_EQ(count, run.timeline().size());
  EXPECT_EQ(rebuilt.hash(), run.timeline().head().hash());
}

TEST(JsonLines, HoldTheWholeRun) {
  expect_rebuilds(demo());
}

TEST(JsonLines, HoldMissionsWithAllThatCanHappen) {
  for (std::uint32_t seed = 0; seed < 2 * planners().size(); ++seed) {
    const PlannerInfo& info = planners()[seed % planners().size()];
    SCOPED_TRACE(std::string(info.id) + ", seed " + std::to_string(seed));
    expect_rebuilds(random_mission(seed, std::string(info.id)));
  }
}

TEST(JsonLines, HoldMissionsInBoxesOfVoxels) {
  for (std::uint32_t seed = 0; seed < planners().size(); ++seed) {
    const PlannerInfo& info = planners()[seed];
    if (info.planar) continue;
    SCOPED_TRACE(std::string(info.id) + ", seed " + std::to_string(seed));
    expect_rebuilds(random_mission(seed, std::string(info.id), 2 + static_cast<int>(seed % 3)));
  }
}

TEST(JsonLines, HoldTheTurnsOfAVehicle) {
  Scenario scenario = *closing_gap();
  scenario.robot.kind = "vehicle";
  expect_rebuilds(std::make_shared<const Scenario>(scenario));
  EXPECT_NE(trace(std::make_shared<const Scenario>(scenario), "run.jsonl").find(R"("kind":"turn","cell":[)"),
            std::string::npos);
}

TEST(JsonLines, TellTheDepthOfABoxAndNoneOfAPlane) {
  const auto head = [](int layers) {
    std::istringstream lines(trace(random_mission(3, "dstar-lite", layers), "run.jsonl"));
    std::string line;
    std::getline(lines, line);
    return Json::parse(line);
  };
  const Json box = head(3), plane = head(1);
  EXPECT_EQ(box["depth"], 3);
  EXPECT_EQ(box["known"].size(), 3 * box["height"].get<std::size_t>());
  EXPECT_EQ(box["start"], Json({0, 0, 0}));
  EXPECT_EQ(box["moving"].front().size(), 4u);
  EXPECT_FALSE(plane.contains("depth"));
  EXPECT_EQ(plane["start"], Json({0, 0}));
  EXPECT_EQ(plane["moving"].front().size(), 3u);
}

TEST(TraceFile, PosthocIsRefusedInSpaceWithTheMend) {
  const test::TemporaryFolder folder;
  replan::Run run(random_mission(1, "dstar-lite", 4), 0);
  for (const std::string name : {"a.trace.yaml", "a.trace.json"}) {
    const auto written = write_trace(folder.file(name), trace_run(run));
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().find("Posthoc draws planes, and this world has 4 layers: end the name of"),
              std::string::npos)
        << written.error();
  }
}

TEST(JsonLines, TheSchemaRefusesWhatIsWrong) {
  const auto schema = read_file(REPLAN_SOURCE_DIR "/assets/trace.schema.json");
  ASSERT_TRUE(schema.ok());
  const Json rules = Json::parse(*schema);
  const test::SchemaCheck check(rules);
  const Json good =
      Json::parse(R"({"event":1,"line":48,"kind":"rhs","cell":[3,4],"before":"inf","after":41.5})");
  EXPECT_EQ(check.check(good), "");
  for (const char* pointer : {"/event", "/line", "/kind", "/cell", "/before", "/after"}) {
    Json bad = good;
    bad.erase(std::string(pointer + 1));
    EXPECT_NE(check.check(bad), "") << "without " << pointer;
  }
  Json bad = good;
  bad["kind"] = "no such kind";
  EXPECT_NE(check.check(bad), "");
  bad = good;
  bad["after"] = -1;
  EXPECT_NE(check.check(bad), "");
}

TEST(TraceFile, WritesInSlicesWhatItWritesAtOnce) {
  const test::TemporaryFolder folder;
  replan::Run run(demo(), 0);
  run.finish(Target::end());
  for (const std::string name : {"a.jsonl", "a.trace.yaml", "a.trace.json"}) {
    ASSERT_TRUE(write_trace(folder.file(name), trace_run(run)).ok());
    auto sliced = TraceFile::create(folder.file("sliced-" + name), trace_run(run));
    ASSERT_TRUE(sliced.ok()) << sliced.error();
    std::size_t slices = 0, before = 0;
    for (bool done = false; !done; ++slices) {
      const auto advanced = (*sliced)->advance(1000);
      ASSERT_TRUE(advanced.ok()) << advanced.error();
      done = *advanced;
      EXPECT_EQ(read_file(folder.file("sliced-" + name)).ok(), done) << "the name comes with the last slice";
      EXPECT_GT((*sliced)->done(), before);
      before = (*sliced)->done();
    }
    EXPECT_GT(slices, 3u);
    EXPECT_EQ((*sliced)->done(), (*sliced)->total());
    EXPECT_EQ(*read_file(folder.file("sliced-" + name)), *read_file(folder.file(name)));
  }
}

TEST(TraceFile, NamesTheEndingsThatThereAre) {
  EXPECT_EQ(*trace_format("a/b.jsonl"), TraceFormat::json_lines);
  EXPECT_EQ(*trace_format("b.trace.yml"), TraceFormat::posthoc_yaml);
  EXPECT_EQ(*trace_format("b.trace.json"), TraceFormat::posthoc_json);
  EXPECT_NE(trace_format("b.json").error().find("'b.trace.json'"), std::string::npos);
  EXPECT_NE(trace_format("b.txt").error().find(".jsonl"), std::string::npos);
  EXPECT_FALSE(trace_format(".jsonl").ok());
  EXPECT_EQ(trace_ending("x/y.trace.yaml"), ".trace.yaml");
  replan::Run run(demo(), 0);
  EXPECT_NE(TraceFile::create("/nonexistent/a.jsonl", trace_run(run)).error().find("/nonexistent/a.jsonl"),
            std::string::npos);
}

TEST(TraceFile, AnEmptyLogIsATraceToo) {
  const test::TemporaryFolder folder;
  replan::Run run(demo(), 0);
  for (const std::string name : {"a.jsonl", "a.trace.yaml", "a.trace.json"}) {
    ASSERT_TRUE(write_trace(folder.file(name), trace_run(run)).ok());
    EXPECT_NO_THROW(YAML::Load(name == "a.jsonl" ? "" : *read_file(folder.file(name)))) << name;
  }
  EXPECT_EQ(YAML::Load(*read_file(folder.file("a.trace.yaml")))["events"].size(), 0u);
  EXPECT_EQ(Json::parse(*read_file(folder.file("a.trace.json")))["events"].size(), 0u);
}

// --- Posthoc ---

int events_of(const YAML::Node& root, const std::string& type) {
  int count = 0;
  for (const YAML::Node& event : root["events"]) count += event["type"].Scalar() == type ? 1 : 0;
  return count;
}

TEST(Posthoc, AMissionWithAReplanKeepsEveryRule) {
  const auto scenario = demo();
  for (const std::string name : {"demo.trace.yaml", "demo.trace.json"}) {
    const std::string text = trace(scenario, name);
    EXPECT_EQ(test::PosthocCheck::check(name, text), "") << name;
    const YAML::Node root = YAML::Load(text);
    replan::Run run(scenario, 0);
    run.finish(Target::end());
    std::map<EventKind, int> counts;
    for (std::size_t i = 0; i < run.timeline().size(); ++i) ++counts[run.timeline().event(i).kind];
    EXPECT_GT(counts[EventKind::plan_end], 1);
    for (const YAML::Node& event : root["events"])
      if (event["type"].Scalar() == "plan") {
        EXPECT_GE(event["points"].size(), 2u) << "every plan of the demo has a path";
      }
    EXPECT_EQ(events_of(root, "plan"), counts[EventKind::plan_end]);
    EXPECT_EQ(events_of(root, "expanding") + events_of(root, "updating"), counts[EventKind::visit]);
    EXPECT_GT(events_of(root, "updating"), 0) << "a repair raises";
    EXPECT_EQ(events_of(root, "move"), counts[EventKind::move] + 1);
    EXPECT_EQ(events_of(root, "block") + events_of(root, "unblock"), counts[EventKind::known]);
    EXPECT_EQ(events_of(root, "end"), 1);
    EXPECT_EQ(events_of(root, "generating") + events_of(root, "closing"),
              counts[EventKind::queue] - counts[EventKind::pop]);
  }
}

TEST(Posthoc, JsonAndYamlSayTheSame) {
  const YAML::Node yaml = YAML::Load(trace(demo(), "a.trace.yaml"));
  const Json json = Json::parse(trace(demo(), "a.trace.json"));
  ASSERT_EQ(yaml["events"].size(), json["events"].size());
  for (std::size_t i = 0; i < json["events"].size(); ++i) {
    ASSERT_EQ(yaml["events"][i].size(), json["events"][i].size());
    for (const auto& [key, value] : json["events"][i].items()) {
      const YAML::Node other = yaml["events"][i][key];
      if (value.is_null() && key != "pId") {
        ASSERT_EQ(other.Scalar(), ".inf");
      }
      if (value.is_string()) {
        ASSERT_EQ(other.Scalar(), value.get<std::string>());
      }
      if (value.is_number()) {
        ASSERT_EQ(other.as<double>(), value.get<double>());
      }
    }
  }
}

TEST(Posthoc, EveryPlannerAndRandomMissionsKeepEveryRule) {
  int plans = 0, cuts = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const PlannerInfo& info = planners()[seed % planners().size()];
    const std::string text = trace(random_mission(seed, std::string(info.id)), "a.trace.yaml");
    ASSERT_EQ(test::PosthocCheck::check("a.trace.yaml", text, info.sampling), "")
        << info.id << ", seed " << seed;
    plans += text.find("pass: 2") != std::string::npos ? 1 : 0;
    cuts += text.find("pId: none") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(plans, 10) << "missions that replan are what this is about";
  EXPECT_GT(cuts, 3);
}

/// Our own text with the first `from` replaced: broken in that one place.
std::string broken(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "nothing to break: " << from;
  return at == std::string::npos ? text : std::string(text).replace(at, from.size(), to);
}

TEST(Posthoc, TheCheckerCatchesEachRuleBroken) {
  const std::string good = trace(closing_gap(), "a.trace.yaml");
  ASSERT_EQ(test::PosthocCheck::check("a.trace.yaml", good), "");
  const auto fault = [&](const std::string& from, const std::string& to) {
    return test::PosthocCheck::check("a.trace.yaml", broken(good, from, to));
  };
  EXPECT_NE(test::PosthocCheck::check("a.yaml", good).find("name must end"), std::string::npos);
  EXPECT_NE(fault("\"1.4.0\"", "\"1.0.5\"").find("version"), std::string::npos);
  EXPECT_NE(fault("version:", "edition:").find("unknown key"), std::string::npos);
  EXPECT_NE(fault("pivot:", "pivots:").find("unknown key"), std::string::npos);
  EXPECT_NE(fault("\"main\"", "\"start\"").find("main"), std::string::npos);
  EXPECT_NE(fault("\"$\": \"rect\"", "\"$\": \"box\"").find("neither a primitive nor a view"),
            std::string::npos);
  EXPECT_NE(fault("\"fill\": \"${{ $.paint }}\",", "").find("without fill"), std::string::npos);
  EXPECT_NE(fault("\"$\": \"rect\", ", "\"$\": \"vertex\", ").find("contains itself"), std::string::npos);
  EXPECT_NE(fault("!!color[$.type] && $.f !== undefined", "$.f !== undefined").find("guard it"),
            std::string::npos);
  EXPECT_NE(fault("theme.foreground", "theme.front").find("theme has no"), std::string::npos);
  EXPECT_NE(fault("color.end", "colors.end").find("not in scope"), std::string::npos);
  EXPECT_NE(fault("color.end", "color.finish").find("no colour"), std::string::npos);
  EXPECT_NE(fault("${{ $.points }}", "{{ $.points }}").find("no lone expression"), std::string::npos);
  EXPECT_NE(fault("\"alpha\": 0.75", "\"clear\": \"expanding\"").find("quadratic"), std::string::npos);
  EXPECT_NE(fault("type: expanding", "type: considering").find("nothing draws"), std::string::npos);
  EXPECT_NE(fault("pId: c", "pId: d").find("no earlier event"), std::string::npos);
  EXPECT_NE(fault("pId: null", "pId: 0").find("parent 0"), std::string::npos);
  EXPECT_NE(fault("g: .inf", "g: inf").find("read as text"), std::string::npos);
  EXPECT_NE(fault("g: .inf", "g: 1e999").find("read as text"), std::string::npos);
  EXPECT_NE(fault("g: .inf", "g: \"1\"").find("read as text"), std::string::npos);
  EXPECT_NE(fault("pass: 2", "pass: 4").find("pass counts"), std::string::npos);
  EXPECT_NE(fault("id: robot", "id: car").find("about the robot"), std::string::npos);
  EXPECT_NE(fault("id: plan", "id: plan2").find("one id"), std::string::npos);
  // A point that lies neither in the middle of a cell nor between two.
  const std::size_t x = good.find(".5, y: "), y = good.find(".5 }", x);
  ASSERT_NE(y, std::string::npos);
  const std::string off = std::string(good).replace(y, 2, ".25").replace(x, 2, ".25");
  EXPECT_NE(test::PosthocCheck::check("a.trace.yaml", off).find("centres"), std::string::npos);
  // Rules that span events, on a trace of our own with one event more.
  const std::string head = good.substr(0, good.find("events:\n") + 8);
  const auto events = [&](const std::string& list) {
    return test::PosthocCheck::check("a.trace.yaml", head + list);
  };
  const std::string plan = "- { type: plan, id: plan, pass: 1, points: [] }\n";
  const auto cell = [](const std::string& id, const std::string& parent, const std::string& rest) {
    return "- { type: " + rest + ", id: c" + id + ", pId: " + parent + ", x: " + id.substr(0, 1) +
           ", y: " + id.substr(2) + ", pass: 1 }\n";
  };
  const std::string values = "generating, f: 1, g: .inf, rhs: 1, k1: 1, k2: 1, km: 0";
  EXPECT_EQ(events(plan + cell("1_1", "null", values) + cell("1_2", "c1_1", values)), "");
  EXPECT_NE(events(cell("1_1", "null", values)).find("no plan"), std::string::npos);
  EXPECT_NE(events(plan + cell("1_1", "c1_1", values)).find("own parent"), std::string::npos);
  EXPECT_NE(
      events(plan + cell("1_1", "null", values) + cell("1_2", "c1_1", values) + cell("1_1", "c1_2", values))
          .find("circle"),
      std::string::npos);
  EXPECT_NE(
      events(plan + cell("1_1", "null", values) + cell("1_2", "c1_1", values) + cell("1_2", "null", values))
          .find("does not forget"),
      std::string::npos);
  EXPECT_NE(events(plan + cell("1_1", "null", "expanding, f: 1, g: .inf, rhs: 1, k1: 1, k2: 1, km: 0"))
                .find("consistent"),
            std::string::npos);
  EXPECT_NE(
      events(plan + cell("1_1", "null", "updating, f: 1, g: 1, rhs: 1, k1: 1, k2: 1, km: 0")).find("raised"),
      std::string::npos);
  EXPECT_NE(events(plan + cell("1_1", "null", "generating, f: 2, g: .inf, rhs: 1, k1: 1, k2: 1, km: 0"))
                .find("f is k1"),
            std::string::npos);
  EXPECT_NE(
      events(plan + cell("1_1", "null", "generating, f: 1, g: .inf, rhs: 1, k1: 1, k2: 2, km: 0")).find("k2"),
      std::string::npos);
  EXPECT_NE(events(plan + cell("1_1", "null", "closing")).find("without f"), std::string::npos);
  EXPECT_NE(events(plan + "- { type: end, id: c1_2, x: 1, y: 1, pass: 1 }\n").find("the id is the cell's"),
            std::string::npos);
  EXPECT_NE(events(plan + "- { type: end, id: 12, x: 1, y: 1, pass: 1 }\n").find("read as a number"),
            std::string::npos);
  const std::string block = "- { type: block, id: c1_1, x: 1, y: 1, pass: 1 }\n";
  EXPECT_NE(events(plan + block + block).find("twice the same"), std::string::npos);
}

TEST(Posthoc, SaysHowLargeATraceWillBe) {
  const auto scenario = demo();
  replan::Run run(scenario, 0);
  run.finish(Target::end());
  const std::string text = trace(scenario, "a.trace.yaml");
  const PosthocSize size = posthoc_size(run.timeline());
  const double steps = static_cast<double>(YAML::Load(text)["events"].size());
  EXPECT_NEAR(static_cast<double>(size.steps), steps, steps * 0.02 + 5);
  EXPECT_NEAR(static_cast<double>(size.bytes), static_cast<double>(text.size()),
              static_cast<double>(text.size()) * 0.3);
}

}  // namespace
}  // namespace replan::trace_export_test
