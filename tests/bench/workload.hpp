// Replanning workloads: a map, a robot on its way, and cells that change near it (`.ev` files).
#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/lattice/lattice.hpp"
#include "core/world/grid_map.hpp"

namespace replan::bench {

/// One replan: where the robot stands, what changes, and the length of the best path then (from the file).
struct WorkloadEvent {
  Cell robot;
  double optimum = 0;
  std::vector<CellEdit> edits;
};

struct Workload {
  std::string file;
  GridMap map;
  Cell start;
  Cell goal;
  double optimum = 0;
  std::vector<WorkloadEvent> events;
};

/// Reads an `.ev` file and the map beside it. Format: a line `MAP sx sy gx gy optimum events`, then per event
/// `x y optimum k` followed by k times `x y v`, v = 1 blocked, 0 free.
Result<Workload> read_workload(const std::string& path);

/// What replaying a workload with one planner took.
struct ReplayRow {
  std::string planner;
  double init_ms = 0;  ///< first plan; allocation and building of the lattice not counted
  std::int64_t init_expansions = 0;
  std::size_t replans = 0;
  double median_us = 0, mean_us = 0, p95_us = 0,
         total_ms = 0;          ///< update of the map and the costs, and the search
  std::int64_t expansions = 0;  ///< of all replans
  double bytes_per_cell = 0;    ///< lattice and planner, open list at its peak
  std::size_t wrong = 0;        ///< plans whose cost is not exactly a fresh plan's, or not the file's optimum
};

/// Replays the workload, `repeats` times; times are the medians over the repeats.
ReplayRow replay(const Workload& workload, std::string_view planner, int repeats);

}  // namespace replan::bench
