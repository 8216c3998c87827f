#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/window.hpp"
#include "core/base/file.hpp"
#include "core/base/markdown.hpp"
#include "core/lattice/box_words.hpp"
#include "core/lesson/lesson.hpp"
#include "core/plan/glossary.hpp"
#include "core/plan/pages.hpp"
#include "core/plan/stage.hpp"
#include "core/scene/view.hpp"
#include "core/study/study.hpp"
#include "core/world/choices.hpp"
#include "core/world/generators/list.hpp"
#include "core/world/library.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"

namespace replan::cli {
namespace {

using Json = nlohmann::ordered_json;
using enum Table::Align;

/// What is listed, as text and as JSON.
struct Listing {
  std::string text;
  Json json;
};

Json parameter_json(const Parameter& parameter) {
  constexpr const char* kTypes[] = {"choice", "real", "whole", "toggle"};
  Json result = {{"key", parameter.key},
                 {"label", parameter.label},
                 {"type", kTypes[static_cast<std::size_t>(parameter.type)]}};
  if (parameter.type == ParameterType::choice) {
    result["choices"] = parameter.choices;
    result["default"] = format_value(parameter, parameter.initial);
  } else if (parameter.type == ParameterType::toggle) {
    result["default"] = parameter.initial != 0;
  } else {
    result["low"] = parameter.low;
    result["high"] = parameter.high;
    result["unit"] = parameter.unit;
    result["default"] = parameter.initial;
  }
  result["help"] = parameter.help;
  return result;
}

Json settings_json(std::span<const Parameter> parameters) {
  Json settings = Json::array();
  for (const Parameter& parameter : parameters) settings.push_back(parameter_json(parameter));
  return settings;
}

Result<Listing> list_planners() {
  Listing listing;
  Table table({{"id", left}, {"name", left}, {"what it does", left}});
  for (const PlannerInfo& info : choices()) {
    table.add({std::string(info.id), std::string(info.name), std::string(info.summary)});
    listing.json["planners"].push_back({{"id", info.id},
                                        {"name", info.name},
                                        {"summary", info.summary},
                                        {"source", info.source},
                                        {"incremental", info.incremental},
                                        {"keeps_start", info.keeps_start},
                                        {"planar", info.planar},
                                        {"drives", find_pilot(info.id) != nullptr},
                                        {"any_angle", info.any_angle},
                                        {"clearance", info.clearance != nullptr},
                                        {"exercise", info.exercise},
                                        {"settings", settings_json(info.parameters)}});
  }
  listing.text = table.text();
  if (const std::string folder = assets_folder(); !folder.empty())
    listing.text +=
        "\nThe page of each, with its idea, pseudo-code and limits, is " + folder + "/planners/ID.md.\n";
  return listing;
}

Result<Listing> list_stages() {
  Listing listing;
  Table table({{"id", left}, {"name", left}, {"what it does to a path", left}});
  for (const StageInfo& info : stages()) {
    table.add({std::string(info.id), std::string(info.name), std::string(info.summary)});
    listing.json["stages"].push_back({{"id", info.id},
                                      {"name", info.name},
                                      {"summary", info.summary},
                                      {"source", info.source},
                                      {"settings", settings_json(info.parameters)}});
  }
  listing.text = table.text();
  return listing;
}

Result<Listing> list_robots() {
  Listing listing;
  Table table({{"id", left}, {"name", left}, {"how it moves", left}});
  for (const RobotInfo& info : robots()) {
    table.add({std::string(info.id), std::string(info.name), std::string(info.summary)});
    listing.json["robots"].push_back({{"id", info.id},
                                      {"name", info.name},
                                      {"summary", info.summary},
                                      {"settings", settings_json(info.parameters)}});
  }
  listing.text = table.text();
  return listing;
}

std::string parameter_line(const Parameter& parameter) {
  constexpr std::size_t kIndent = 8;
  const auto number = [&](double value) { return format_value(parameter, value); };
  return "    " + std::string(parameter.key) + "=" + number(parameter.low) + ".." + number(parameter.high) +
         (parameter.unit.empty() ? "" : " " + std::string(parameter.unit)) + "  (default " +
         number(parameter.initial) + ")\n" + std::string(kIndent, ' ') + wrapped(parameter.help, kIndent) +
         "\n";
}

Result<Listing> list_generators() {
  Listing listing;
  Table table({{"id", left}, {"name", left}, {"what it makes", left}});
  std::string settings = "\nSettings, as in generator:maze?width=61&height=41&corridor=2&seed=7:\n  all\n";
  for (const Parameter& parameter : generator_size_parameters()) settings += parameter_line(parameter);
  for (const GeneratorInfo& info : generators()) {
    table.add({std::string(info.id), std::string(info.name), std::string(info.summary)});
    settings += "  " + std::string(info.id) + "\n";
    if (info.solid) settings += parameter_line(generator_layers_parameter(info));
    for (const Parameter& parameter : info.parameters) settings += parameter_line(parameter);
    listing.json["generators"].push_back({{"id", info.id},
                                          {"name", info.name},
                                          {"summary", info.summary},
                                          {"settings", settings_json(info.parameters)}});
    listing.json["generators"].back()["layers"] = info.layers;
    listing.json["generators"].back()["solid"] = info.solid;
  }
  listing.json["all"] = settings_json(generator_size_parameters());
  listing.text = table.text() + settings;
  return listing;
}

Result<Listing> list_overlays() {
  Listing listing;
  Table table({{"id", left}, {"kind", left}, {"what it shows", left}});
  for (const OverlayInfo& info : overlays()) {
    const char* kind = info.is_field() ? "field" : "mark";
    table.add({std::string(info.id), kind, std::string(info.help)});
    listing.json["overlays"].push_back(
        {{"id", info.id}, {"label", info.label}, {"kind", kind}, {"help", info.help}});
  }
  listing.text =
      table.text() + "\nFields colour whole cells, one at a time; any number of marks is drawn on top.\n";
  return listing;
}

/// One file of the maps folder; nothing if it is no world.
void list_world(const std::string& path, Table& table, Json& json) {
  const std::string kind = file_extension(path) == ".json" ? "scenario" : "map";
  Scenario world;
  if (kind == "scenario") {
    auto scenario = read_scenario(path);
    if (!scenario) return;
    world = std::move(scenario.value());
  } else {
    auto map = read_map(path);
    if (!map) return;
    world.map = std::move(map.value());
  }
  table.add({path, kind, sides_text(world.map.box()), world.name});
  Json entry = {{"path", path}, {"kind", kind}, {"width", world.map.width}, {"height", world.map.height}};
  if (world.map.depth > 1) entry["depth"] = world.map.depth;
  entry["name"] = world.name;
  entry["caption"] = world.caption;
  json.push_back(std::move(entry));
}

Result<Listing> list_maps() {
  const std::string folder = library_folder();
  const std::vector<std::string> files = library_files(folder);
  if (files.empty()) return Error{"no maps were found in '" + folder + "'"};
  Listing listing;
  listing.json["maps"] = Json::array();
  Table table({{"file", left}, {"kind", left}, {"cells"}, {"name", left}});
  for (const std::string& file : files) list_world(file, table, listing.json["maps"]);
  listing.text = table.text();
  return listing;
}

Result<Listing> list_lessons() {
  Listing listing;
  listing.json["lessons"] = Json::array();
  Table table({{"id", left}, {"name", left}, {"steps"}, {"what it is about", left}});
  for (const LessonFile& file : lesson_files()) {
    const Result<Lesson> lesson = read_lesson(file);
    if (!lesson) return Error{lesson.error()};
    const std::string summary = without_markdown(lesson->summary);
    table.add({lesson->id, lesson->title, std::to_string(lesson->steps.size()), summary});
    Json entry = {{"id", lesson->id}, {"name", lesson->title}, {"summary", summary}, {"path", file.path}};
    for (const LessonStep& step : lesson->steps) entry["steps"].push_back(step.title);
    listing.json["lessons"].push_back(std::move(entry));
  }
  listing.text = table.text() + "\nA lesson is opened in the window: Help > Lessons.\n";
  return listing;
}

Result<Listing> list_studies() {
  Listing listing;
  Table table({{"id", left}, {"name", left}, {"seeds"}, {"after", left}});
  for (const StudyInfo& study : studies()) {
    table.add({std::string(study.id), std::string(study.title), std::to_string(study.seeds),
               std::string(study.source)});
    listing.json["studies"].push_back({{"id", study.id},
                                       {"name", study.title},
                                       {"source", study.source},
                                       {"setting", study.setting},
                                       {"seeds", study.seeds}});
  }
  listing.text = table.text();
  return listing;
}

Result<Listing> list_terms() {
  constexpr std::size_t kIndent = 4;
  Listing listing;
  for (const GlossaryTerm& term : glossary()) {
    listing.text +=
        std::string(term.title) + "\n" + std::string(kIndent, ' ') + wrapped(term.text, kIndent) + "\n";
    listing.json["terms"].push_back({{"id", term.id}, {"title", term.title}, {"text", term.text}});
  }
  return listing;
}

Result<Listing> list_actions() {
  Listing listing;
  Table table({{"id", left}, {"keys", left}, {"label", left}, {"what it does", left}});
  for (const ListedAction& each : listed_actions()) {
    table.add({each.name, each.keys, each.label, each.help});
    listing.json["actions"].push_back(
        {{"id", each.name}, {"keys", each.keys}, {"label", each.label}, {"help", each.help}});
  }
  listing.text = table.text();
  return listing;
}

struct Kind {
  std::string_view name;
  Result<Listing> (*list)();
};
constexpr Kind kKinds[] = {{"planners", list_planners}, {"stages", list_stages},
                           {"robots", list_robots},     {"maps", list_maps},
                           {"overlays", list_overlays}, {"generators", list_generators},
                           {"terms", list_terms},       {"actions", list_actions},
                           {"lessons", list_lessons},   {"studies", list_studies}};

Result<int> list(const std::string& what, bool json) {
  std::vector<std::string_view> names;
  for (const Kind& kind : kKinds) {
    names.push_back(kind.name);
    if (kind.name != what) continue;
    const auto listing = kind.list();
    if (!listing) return Error{listing.error()};
    print(json ? listing->json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : listing->text);
    return kDone;
  }
  return Error{
      "cannot list '" + what + "'" +
      suggestion(
          what, names,
          "; give planners, stages, robots, maps, overlays, generators, terms, actions, lessons or studies")};
}

std::string list_footer() {
  return "Examples:\n"
         "  replan list planners\n"
         "      Each planner's id, as --planner takes it, and what it does.\n"
         "  replan list overlays --json\n"
         "      What 'replan render --overlay' can draw, for a program.\n"
         "  replan list terms\n"
         "      What g, rhs, km and the other words of the window mean.\n\n" +
         settings_help();
}

}  // namespace

Command add_list(CLI::App& program) {
  struct Arguments {
    std::string what;
    bool json = false;
  };
  CLI::App* app = program.add_subcommand(
      "list",
      "Show which planners, stages, robots, maps, overlays, generators, lessons, studies or actions of the "
      "window there are, and what words mean");
  const auto arguments = std::make_shared<Arguments>();
  app->add_option("WHAT", arguments->what,
                  "planners, stages, robots, maps, overlays, generators, terms, actions, lessons or studies")
      ->required();
  app->add_flag("--json", arguments->json, "Print the list as JSON");
  app->footer(list_footer);
  return {app, [arguments] { return list(arguments->what, arguments->json); }};
}

}  // namespace replan::cli
