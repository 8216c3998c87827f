// --planner, --set and --stage: what they ask for, and what is wrong with it.
#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/output.hpp"
#include "core/base/words.hpp"
#include "core/plan/nth_name.hpp"
#include "core/plan/stage.hpp"
#include "core/world/choices.hpp"
#include "core/world/json_reader.hpp"

namespace replan::cli {
namespace {

/// One `--set [ID[#N].]KEY=VALUE`, taken apart.
struct Assignment {
  std::string_view typed, owner, key, value;
};

Result<Assignment> take_apart(std::string_view typed) {
  const std::size_t equals = typed.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return Error{"--set " + std::string(typed) +
                 ": give KEY=VALUE, or ID.KEY=VALUE for one planner or stage"};
  Assignment result{typed, {}, typed.substr(0, equals), typed.substr(equals + 1)};
  if (const std::size_t dot = result.key.find('.'); dot != std::string_view::npos) {
    result.owner = result.key.substr(0, dot);
    result.key = result.key.substr(dot + 1);
  }
  return result;
}

/// What has settings: a planner, or a stage of one.
struct Settable {
  std::string_view id;
  std::size_t number;  ///< it is so manyeth of that id here
  std::span<const Parameter> declared;
  Settings& settings;

  /// Whether "ID", or "ID#N" for the N-th of several, names it.
  [[nodiscard]] bool is_named(std::string_view owner) const {
    return owner == id || owner == nth_name(id, number);
  }
};

std::vector<Settable> settables(std::span<PlannerChoice> choices) {
  std::vector<Settable> all;
  const auto add = [&all](std::string_view id, std::span<const Parameter> declared, Settings& settings) {
    const auto before = std::count_if(all.begin(), all.end(), [id](const Settable& e) { return e.id == id; });
    all.push_back({id, static_cast<std::size_t>(before) + 1, declared, settings});
  };
  for (PlannerChoice& choice : choices) {
    add(choice.id, find_choice(choice.id)->parameters, choice.settings);
    for (StageChoice& stage : choice.stages) add(stage.id, find_stage(stage.id)->parameters, stage.settings);
  }
  return all;
}

/// Why a setting fits none of the planners and stages of a run.
Error unknown_setting(const Assignment& set, std::span<const Settable> here) {
  std::vector<std::string_view> owners, keys;
  for (const PlannerInfo& info : choices())
    if (find_parameter(info.parameters, set.key) != nullptr) owners.push_back(info.id);
  for (const StageInfo& info : stages())
    if (find_parameter(info.parameters, set.key) != nullptr) owners.push_back(info.id);
  for (const Settable& each : here)
    for (const Parameter& parameter : each.declared)
      if (std::find(keys.begin(), keys.end(), parameter.key) == keys.end()) keys.push_back(parameter.key);
  const std::string start = "--set " + std::string(set.typed) + ": ";
  if (!owners.empty())
    return {start + "none of the planners and stages here has the setting '" + std::string(set.key) +
            "'; these have: " + joined(owners)};
  return {start + "unknown setting '" + std::string(set.key) + "'" +
          suggestion(set.key, keys, "; known: " + joined(keys))};
}

/// Why the one that is named has no settings here.
Error nobody_here(const Assignment& set) {
  const std::string start = "--set " + std::string(set.typed) + ": ",
                    id(set.owner.substr(0, set.owner.find('#')));
  if (id != set.owner && find_choice(id) != nullptr)
    return {start + "there are not so many of '" + id + "' here; they are counted from 1"};
  if (find_stage(id) != nullptr)
    return {start + "stage '" + id + "' is not among those here; add it with --stage"};
  if (const auto info = require_choice(id); !info) return {start + info.error()};
  return {start + "planner '" + id + "' is not among the planners here; add it with --planner"};
}

/// A length may be given in metres ("0.8m") where the map says how large its cells are.
Result<void> assign(const Assignment& set, const Settable& to, const GridMap* world) {
  const Parameter& parameter = *find_parameter(to.declared, set.key);
  std::string value(set.value);
  const auto metres = parameter.unit == "cells" ? typed_metres(set.value) : std::nullopt;
  if (metres && world != nullptr) {
    const auto cells = metres_in_cells("--set " + std::string(set.typed), *metres, *world);
    if (!cells) return Error{cells.error()};
    value = plain_number(*cells).dump();
  } else if (metres) {
    return {};  // asked before there is a map: it is asked again
  }
  if (const auto done = set_from_text(to.settings, to.declared, set.key, value); !done)
    return Error{"--set " + std::string(set.typed) + ": for '" + std::string(to.id) + "' " + done.error()};
  return {};
}

Result<void> assign(const Assignment& set, std::span<PlannerChoice> choices, const GridMap* world) {
  const std::vector<Settable> here = settables(choices);
  bool known = false, present = set.owner.empty();
  for (const Settable& each : here) {
    if (!set.owner.empty() && !each.is_named(set.owner)) continue;
    present = true;
    if (find_parameter(each.declared, set.key) == nullptr) continue;
    known = true;
    if (const auto done = assign(set, each, world); !done) return done;
  }
  if (!present) return nobody_here(set);
  return known ? Result<void>() : unknown_setting(set, here);
}

/// "STAGE" for all planners, or "PLANNER.STAGE" for one.
Result<void> add_stage(std::string_view typed, std::vector<PlannerChoice>& choices) {
  const std::size_t dot = typed.find('.');
  const std::string_view planner = dot == std::string_view::npos ? "" : typed.substr(0, dot);
  const std::string_view id = dot == std::string_view::npos ? typed : typed.substr(dot + 1);
  const Result<const StageInfo*> stage = require_stage(id);
  if (!stage) return Error{"--stage: " + stage.error()};
  bool added = false;
  for (PlannerChoice& choice : choices) {
    if (!planner.empty() && planner != choice.id) continue;
    choice.stages.push_back({std::string(id), {}});
    added = true;
  }
  if (added) return {};
  if (const auto info = require_choice(planner); !info) return Error{"--stage: " + info.error()};
  return Error{"--stage " + std::string(typed) + ": planner '" + std::string(planner) +
               "' is not among the planners here; add it with --planner"};
}

/// "all" are all that search and can do so in that world; who is named and cannot is refused.
Result<std::vector<PlannerChoice>> chosen(std::span<const std::string> ids,
                                          std::span<const PlannerChoice> own, const GridMap* world,
                                          double radius) {
  const auto can_plan = [world, radius](const PlannerInfo& info) {
    return world == nullptr ? Result<void>() : fits(info, world->box(), radius);
  };
  std::vector<PlannerChoice> result;
  for (const std::string& id : ids) {
    if (id == "all") {
      for (const PlannerInfo& info : sound_planners())
        if (can_plan(info)) result.push_back({std::string(info.id), {}});
      continue;
    }
    const auto info = require_choice(id);
    if (!info) return Error{"--planner: " + info.error()};
    if (const auto can = can_plan(**info); !can) return Error{"--planner: " + can.error()};
    const auto kept =
        std::find_if(own.begin(), own.end(), [&](const PlannerChoice& c) { return c.id == id; });
    result.push_back(kept != own.end() ? *kept : PlannerChoice{id, {}});
  }
  if (ids.empty()) result.assign(own.begin(), own.end());
  if (result.empty())
    return Error{"no planner is named: give --planner ID[,ID...]; 'replan list planners' shows them"};
  return result;
}

bool same_choice(const Parameter& a, const Parameter& b) {
  return a.key == b.key && a.choices == b.choices && a.help == b.help;
}

std::string values_text(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::toggle:
      return "true|false";
    case ParameterType::choice:
      return joined(parameter.choices, "|");
    case ParameterType::real:
    case ParameterType::whole:
      break;
  }
  return format_value(parameter, parameter.low) + ".." + format_value(parameter, parameter.high) +
         (parameter.unit.empty() ? "" : " " + std::string(parameter.unit));
}

}  // namespace

void PlannerArguments::declare(CLI::App& command) {
  command
      .add_option("--planner", ids,
                  "Planners to run, or 'all' that search; 'replan list planners' shows them")
      ->type_name("ID[,ID...]")
      ->allow_extra_args(false);
  command
      .add_option("--set", settings,
                  "A setting, for each planner and stage that has it or for the one named (ID#2: the second "
                  "of that ID); a length in "
                  "metres too (0.8m) where "
                  "the map says how large its cells are (repeatable)")
      ->type_name("[ID[#N].]KEY=VALUE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--stage", stages,
          "What paths go through once they are found, for each planner or for the one named (repeatable); "
          "'replan list stages' shows them")
      ->type_name("[ID.]STAGE")
      ->allow_extra_args(false);
}

Result<std::vector<PlannerChoice>> PlannerArguments::choose(std::span<const PlannerChoice> own,
                                                            const GridMap* world, double radius) const {
  auto choices = chosen(split_list(ids), own, world, radius);
  if (!choices) return choices;
  for (const std::string& typed : stages)
    if (const auto done = add_stage(typed, choices.value()); !done) return Error{done.error()};
  for (const std::string& typed : settings) {
    const auto set = take_apart(typed);
    if (!set) return Error{set.error()};
    if (const auto done = assign(*set, choices.value(), world); !done) return Error{done.error()};
  }
  for (const PlannerChoice& choice : choices.value()) {
    if (world == nullptr) break;
    if (const auto fit = fits(info_of(choice), world->box(), radius); !fit) return Error{fit.error()};
  }
  return choices;
}

std::string settings_help() {
  constexpr std::size_t kIndent = 6;
  std::string text = "Planner settings (--set):\n";
  std::vector<Parameter> shown;
  for (const PlannerInfo& info : choices())
    for (const Parameter& parameter : info.parameters) {
      const auto again = [&](const Parameter& other) { return same_choice(other, parameter); };
      if (std::any_of(shown.begin(), shown.end(), again)) continue;
      shown.push_back(parameter);
      std::vector<std::string_view> owners, others;
      for (const PlannerInfo& other : choices())
        (std::any_of(other.parameters.begin(), other.parameters.end(), again) ? owners : others)
            .push_back(other.id);
      text += "  " + std::string(parameter.key) + "=" + values_text(parameter) + "  (default " +
              format_value(parameter, parameter.initial) + ")\n" + std::string(kIndent, ' ') +
              wrapped(parameter.help, kIndent) + "\n" + std::string(kIndent, ' ') +
              wrapped(others.empty()       ? "For all planners."
                      : others.size() <= 2 ? "For all planners but " + joined(others) + "."
                                           : "For " + joined(owners) + ".",
                      kIndent) +
              "\n";
    }
  return text;
}

}  // namespace replan::cli
