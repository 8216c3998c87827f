#include "core/experiment/run_list.hpp"

#include <algorithm>
#include <cstdio>

#include "core/base/file.hpp"
#include "core/base/hash.hpp"
#include "core/experiment/random_blocks.hpp"
#include "core/plan/registry.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

/// To be counted up when the same run comes to other figures, or figures mean something else.
constexpr std::uint64_t kFiguresVersion = 2;

std::string cell_words(Cell cell, bool solid) {
  return std::to_string(cell.x) + " " + std::to_string(cell.y) + (solid ? " " + std::to_string(cell.z) : "");
}

const Parameter* seed_of(const PlannerChoice& choice) {
  return find_parameter(find_choice(choice.id)->parameters, "seed");
}

std::uint64_t folded(std::uint64_t digest, std::string_view text) {
  return hash_combine(digest, hash_bytes(text));
}

/// Every setting of the planners, those that are not set too: a default that changes makes another experiment.
std::uint64_t settings_digest(const Experiment& experiment, std::uint64_t digest) {
  for (const PlannerChoice& choice : experiment.planners)
    for (const Parameter& parameter : find_choice(choice.id)->parameters)
      digest = folded(
          digest, std::string(parameter.key) + "=" + format_value(parameter, choice.settings.get(parameter)));
  return digest;
}

std::string hexadecimal(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

/// The first planner and robot that cannot plan in the world.
Result<void> check_fits(const Experiment& experiment, const LoadedWorld& world) {
  const Box box = world.scenario.map.box();
  for (const auto& asked : experiment.robots) {
    const RobotSetup& robot = asked ? *asked : world.scenario.robot;
    if (const auto known = require_robot(robot.kind, box); !known)
      return Error{world.file + ": " + known.error()};
    for (const PlannerChoice& choice : experiment.planners)
      if (const auto fit = fits(info_of(choice), box, robot.radius); !fit)
        return Error{world.file + ": " + fit.error()};
  }
  return {};
}

}  // namespace

std::string planner_label(const RunName& name) {
  return name.planner + (name.settings.empty() ? "" : " " + name.settings) +
         (name.stages.empty() ? "" : " | " + name.stages);
}

bool lengths_apply(const PlannerChoice& choice) {
  if (find_pilot(choice.id) != nullptr) return false;
  const MoveRules rules = move_rules(choice.settings);
  return find_planner(choice.id)->optimal(choice.settings) && rules.diagonals &&
         rules.corners == MoveRules{}.corners;
}

Result<RunList> RunList::load(Experiment experiment, std::vector<LoadedWorld> worlds) {
  for (std::size_t i = 0; i < experiment.worlds.size(); ++i) {
    if (i == worlds.size()) {
      auto loaded = load_world(experiment, experiment.worlds[i]);
      if (!loaded) return Error{loaded.error()};
      worlds.push_back(std::move(loaded.value()));
    }
    if (const auto fit = check_fits(experiment, worlds[i]); !fit) return Error{fit.error()};
  }
  std::uint64_t digest = folded(kFiguresVersion, experiment_text(experiment));
  digest = settings_digest(experiment, digest);
  for (const LoadedWorld& world : worlds) digest = hash_combine(digest, world.digest);
  RunList list(std::move(experiment), std::move(worlds), digest);
  if (list.count() > kMostRuns)
    return Error{"the experiment has " + std::to_string(list.count()) + " runs, and can have at most " +
                 std::to_string(kMostRuns) + ": give fewer problems (\"limit\") or seeds"};
  return list;
}

RunList::RunList(Experiment experiment, std::vector<LoadedWorld> worlds, std::uint64_t digest)
    : experiment_(std::move(experiment)), worlds_(std::move(worlds)), digest_(hexadecimal(digest)) {
  number_runs();
}

std::size_t RunList::seeds(std::size_t planner, std::size_t surprises) const {
  const bool random = seed_of(experiment_.planners[planner]) != nullptr ||
                      experiment_.surprises[surprises].kind == ExperimentSurprises::Kind::blocks;
  return random ? experiment_.seeds.size() : 1;
}

std::int64_t RunList::runs_a_problem(std::size_t planner) const {
  std::size_t runs = 0;
  for (std::size_t s = 0; s < experiment_.surprises.size(); ++s) runs += seeds(planner, s);
  return static_cast<std::int64_t>(runs);
}

void RunList::number_runs() {
  std::int64_t next = 0;
  for (std::size_t w = 0; w < worlds_.size(); ++w)
    for (std::size_t r = 0; r < experiment_.robots.size(); ++r)
      for (std::size_t p = 0; p < experiment_.planners.size(); ++p) {
        groups_.push_back({next, w, r, p});
        next += static_cast<std::int64_t>(worlds_[w].problems.size()) * runs_a_problem(p);
      }
  groups_.push_back({next});
}

RunParts RunList::parts(std::int64_t run) const {
  const auto after =
      std::upper_bound(groups_.begin(), groups_.end(), run,
                       [](std::int64_t number, const Group& group) { return number < group.first; });
  const Group& group = *std::prev(after);
  const std::int64_t each = runs_a_problem(group.planner);
  RunParts parts{.world = group.world, .robot = group.robot, .planner = group.planner};
  parts.problem = static_cast<std::size_t>((run - group.first) / each);
  auto rest = static_cast<std::size_t>((run - group.first) % each);
  while (rest >= seeds(group.planner, parts.surprises)) rest -= seeds(group.planner, parts.surprises++);
  parts.seed = rest;
  return parts;
}

RunName RunList::name(const RunParts& parts) const {
  const ScenProblem& asked = problem(parts);
  const bool solid = world(parts).scenario.map.box().solid();
  const PlannerChoice& planner = experiment_.planners[parts.planner];
  return {.world = world(parts).file,
          .line = asked.line,
          .start = cell_words(asked.start, solid),
          .goal = cell_words(asked.goal, solid),
          .planner = planner.id,
          .settings = settings_label(planner),
          .stages = stages_label(planner),
          .robot = robot_label(experiment_.robots[parts.robot]),
          .surprises = drives(parts) ? surprises_label(experiment_.surprises[parts.surprises]) : "none",
          .seed = experiment_.seeds[parts.seed]};
}

PlannerChoice RunList::choice(const RunParts& parts) const {
  PlannerChoice choice = experiment_.planners[parts.planner];
  if (seed_of(choice) != nullptr)
    choice.settings.set("seed", static_cast<double>(experiment_.seeds[parts.seed]));
  return choice;
}

RobotSetup RunList::robot(const RunParts& parts) const {
  return experiment_.robots[parts.robot].value_or(world(parts).scenario.robot);
}

bool RunList::drives(const RunParts& parts) const {
  return experiment_.drive || find_pilot(experiment_.planners[parts.planner].id) != nullptr;
}

bool RunList::length_is_listed(const RunParts& parts) const {
  return !problem(parts).printed.empty() && !drives(parts) && robot(parts).radius == 0 &&
         experiment_.planners[parts.planner].stages.empty() &&
         lengths_apply(experiment_.planners[parts.planner]);
}

bool RunList::skipped(const RunParts& parts) const {
  const ScenProblem& asked = problem(parts);
  const GridMap& map = world(parts).scenario.map;
  return asked.line > 0 && (map.at(asked.start) || map.at(asked.goal));
}

Scenario RunList::scenario(const RunParts& parts) const {
  const LoadedWorld& from = world(parts);
  Scenario run;
  run.name = file_stem(from.file);
  run.map = from.scenario.map;
  run.start = problem(parts).start;
  run.goal = problem(parts).goal;
  run.planners = {choice(parts)};
  run.robot = robot(parts);
  run.seed = experiment_.seeds[parts.seed];
  if (!experiment_.drive) {
    // What is planned once is planned on the map as it is.
    if (!drives(parts)) run.robot.knowledge = Knowledge::all;
    return run;
  }
  const ExperimentSurprises& surprises = experiment_.surprises[parts.surprises];
  if (surprises.kind == ExperimentSurprises::Kind::own) {
    run.surprises = from.scenario.surprises;
    run.movers = from.scenario.movers;
  } else if (surprises.kind == ExperimentSurprises::Kind::blocks) {
    run.surprises = dropped_blocks(run, surprises.blocks);
  }
  return run;
}

}  // namespace replan
