#include "app/cli/run_trace.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/output.hpp"
#include "core/export/posthoc.hpp"
#include "core/plan/nth_name.hpp"
#include "core/session/trace_export.hpp"
#include "core/world/map_file.hpp"

namespace replan::cli {
namespace {

/// Events written between two looks at the progress bar.
constexpr std::size_t kSlice = 100'000;

/// A word on traces that the visualiser will be slow with, before they are written.
void announce(const Run& run, const std::string& file) {
  if (trace_ending(file) == ".jsonl") return;
  const PosthocSize size = posthoc_size(run.timeline());
  if (size.steps <= kManyPosthocSteps) return;
  complain(
      "note: " + file + " will have about " + std::to_string(size.steps) + " steps and " +
      std::to_string(size.bytes / 1'000'000) +
      " MB; Posthoc takes long to load so many. A smaller world, or .jsonl for other programs, is quicker");
}

Result<void> write_one(const Scenario& scenario, std::size_t planner, bool plan_alone,
                       const std::string& file) {
  Run run(std::make_shared<const Scenario>(scenario), planner);
  run.finish(plan_alone ? Target::plan() : Target::end());
  if (const std::string failure = run.failure(); !failure.empty()) return Error{failure};
  announce(run, file);
  auto trace = TraceFile::create(file, trace_run(run));
  if (!trace) return Error{trace.error()};
  ProgressBar bar("writing " + file, (*trace)->total());
  for (;;) {
    const auto done = (*trace)->advance(kSlice);
    if (!done) return Error{done.error()};
    if (*done) return {};
    bar.show((*trace)->done());
  }
}

/// The map that the robot sets out with: what the visualiser shows under the trace.
GridMap known_map(const Scenario& scenario) {
  GridMap map = scenario.map;
  map.blocked = initial_knowledge(scenario);
  return map;
}

}  // namespace

void TraceArguments::declare(CLI::App& command) {
  command
      .add_option(
          "--trace", file,
          "Write every event of the run too: FILE.jsonl as JSON Lines (assets/trace.schema.json tells of "
          "what), FILE.trace.yaml or FILE.trace.json for the Posthoc visualiser. With several planners "
          "each writes its own file, with its id before the ending")
      ->type_name("FILE");
  command
      .add_option(
          "--trace-map", map,
          "Write the map that the robot sets out with too (.map): the map layer under a Posthoc trace")
      ->type_name("FILE");
}

Result<void> TraceArguments::check(const Box& world) const {
  if (!file.empty())
    if (const auto format = trace_format(file, world); !format) return Error{"--trace: " + format.error()};
  if (!map.empty() && file.empty()) return Error{"--trace-map goes with a trace: give --trace FILE too"};
  if (!map.empty() && !map.ends_with(".map"))
    return Error{"--trace-map: Posthoc reads MovingAI maps: end the name of '" + map + "' in .map"};
  if (!map.empty() && world.solid())
    return Error{"--trace-map goes with a Posthoc trace, which is of a plane: leave it out in a world of " +
                 std::to_string(world.depth()) + " layers"};
  return {};
}

std::string trace_name(const std::string& file, const Scenario& scenario, std::size_t planner) {
  const auto& all = scenario.planners;
  if (all.size() == 1) return file;
  const std::string& id = all[planner].id;
  const auto same = [&](const PlannerChoice& choice) { return choice.id == id; };
  const auto before = std::count_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(planner), same);
  const std::string_view ending = trace_ending(file);
  return file.substr(0, file.size() - ending.size()) + "." +
         nth_name(id, static_cast<std::size_t>(before) + 1) + std::string(ending);
}

Result<void> TraceArguments::write(const Scenario& scenario, bool plan_alone) const {
  if (file.empty()) return {};
  for (std::size_t i = 0; i < scenario.planners.size(); ++i)
    if (const auto written = write_one(scenario, i, plan_alone, trace_name(file, scenario, i)); !written)
      return written;
  return map.empty() ? Result<void>() : write_map(known_map(scenario), map);
}

}  // namespace replan::cli
