#include "workload.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <sstream>

#include "core/base/file.hpp"
#include "core/plan/registry.hpp"
#include "core/world/formats/movingai.hpp"

namespace replan::bench {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration elapsed) {
  return std::chrono::duration<double, std::micro>(elapsed).count();
}

bool read_event(std::istream& in, const GridMap& map, WorkloadEvent& event) {
  std::size_t count = 0;
  in >> event.robot.x >> event.robot.y >> event.optimum >> count;
  for (std::size_t i = 0; in && i < count; ++i) {
    Cell cell;
    int value = 0;
    in >> cell.x >> cell.y >> value;
    if (!map.contains(cell)) return false;
    event.edits.push_back({static_cast<NodeId>(map.index(cell)), value != 0});
  }
  return static_cast<bool>(in) && map.contains(event.robot);
}

/// Whether a cost is the optimum of the file; infinite stands for -1, no path. The files hold sums of
/// single-precision numbers, a little off in the fifth digit; the exact test is the fresh plan.
bool is_near_optimum(Cost cost, double optimum) {
  if (optimum < 0) return cost.is_infinite();
  return std::abs(cost.to_double() - optimum) <= 2e-5 * optimum + 1e-6;
}

/// Whether the plan's cost is exactly that of a fresh plan of the same kind, and near the file's optimum
/// where the planner is an optimal one.
bool is_right(const Planner<Grid2>& planner, const PlannerInfo& info, const Grid2& lattice, Cell robot,
              Cell goal, double optimum) {
  const Settings settings;
  NoTrace tracer;
  const auto fresh = make_planner(info, lattice, settings, tracer);
  fresh->begin(lattice.node(robot), lattice.node(goal));
  finish(*fresh);
  return planner.cost() == fresh->cost() &&
         (!info.optimal(settings) || is_near_optimum(planner.cost(), optimum));
}

struct Pass {
  double init_us = 0;
  std::vector<double> event_us;
};

Pass run_once(const Workload& workload, const PlannerInfo& info, ReplayRow& row, bool check) {
  const Settings settings;
  Grid2 lattice({workload.map.width, workload.map.height}, workload.map.blocked.plain(),
                move_rules(settings));
  NoTrace tracer;
  const auto planner = make_planner(info, lattice, settings, tracer);
  Pass pass;
  const auto begin = Clock::now();
  planner->begin(lattice.node(workload.start), lattice.node(workload.goal));
  finish(*planner);
  pass.init_us = microseconds(Clock::now() - begin);
  row.init_expansions = planner->counters().expansions;
  const auto wrong = [&](Cell robot, double optimum) {
    return check && !is_right(*planner, info, lattice, robot, workload.goal, optimum);
  };
  row.wrong += wrong(workload.start, workload.optimum);
  row.expansions = 0;
  for (const WorkloadEvent& event : workload.events) {
    const std::int64_t before = planner->counters().expansions;
    const auto event_begin = Clock::now();
    const auto moves = lattice.apply(event.edits);
    planner->update({.cells = event.edits, .moves = moves}, lattice.node(event.robot));
    finish(*planner);
    pass.event_us.push_back(microseconds(Clock::now() - event_begin));
    row.expansions += planner->counters().expansions - before;
    row.wrong += wrong(event.robot, event.optimum);
  }
  const double lattice_bytes = static_cast<double>(lattice.node_count()) * 2;
  row.bytes_per_cell = (lattice_bytes + static_cast<double>(planner->memory_bytes())) /
                       static_cast<double>(lattice.node_count());
  return pass;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Result<Workload> read_workload(const std::string& path) {
  Result<std::string> text = read_file(path);
  if (!text) return Error{text.error()};
  std::istringstream in(*text);
  Workload workload;
  workload.file = path;
  std::string map_name;
  std::size_t count = 0;
  in >> map_name >> workload.start.x >> workload.start.y >> workload.goal.x >> workload.goal.y >>
      workload.optimum >> count;
  if (!in) return Error{path + ":1: expected 'MAP sx sy gx gy optimum events'"};
  Result<GridMap> map = read_movingai_map((std::filesystem::path(path).parent_path() / map_name).string());
  if (!map) return Error{map.error()};
  workload.map = *std::move(map);
  if (!workload.map.contains(workload.start) || !workload.map.contains(workload.goal))
    return Error{path + ":1: start or goal lies outside the map"};
  for (std::size_t i = 0; i < count; ++i) {
    WorkloadEvent event;
    if (!read_event(in, workload.map, event))
      return Error{path + ":" + std::to_string(i + 2) +
                   ": expected 'x y optimum k' and k times 'x y v' on the map"};
    workload.events.push_back(std::move(event));
  }
  return workload;
}

ReplayRow replay(const Workload& workload, std::string_view planner, int repeats) {
  const PlannerInfo& info = *find_planner(planner);
  ReplayRow row;
  row.planner = planner;
  row.replans = workload.events.size();
  std::vector<double> init, events(workload.events.size());
  std::vector<std::vector<double>> by_event(workload.events.size());
  for (int pass = 0; pass < repeats; ++pass) {  // the first one is checked; checking empties the caches
    const Pass result = run_once(workload, info, row, pass == 0);
    init.push_back(result.init_us);
    for (std::size_t i = 0; i < result.event_us.size(); ++i) by_event[i].push_back(result.event_us[i]);
  }
  row.init_ms = median(init) / 1000;
  for (std::size_t i = 0; i < events.size(); ++i) events[i] = median(by_event[i]);
  row.median_us = median(events);
  const double total = std::accumulate(events.begin(), events.end(), 0.0);
  row.total_ms = total / 1000;
  row.mean_us = events.empty() ? 0 : total / static_cast<double>(events.size());
  std::sort(events.begin(), events.end());
  row.p95_us = events.empty() ? 0 : events[(events.size() - 1) * 95 / 100];
  return row;
}

}  // namespace replan::bench
