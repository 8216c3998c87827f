// replan_bench: Google Benchmark, or with --events the replay of replanning workloads.
//   replan_bench [Google Benchmark's options]
//   replan_bench --events FILE.ev... [--planner ID,...] [--repeats N] [--json]

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include "core/plan/registry.hpp"
#include "workload.hpp"
#include "worlds.hpp"

namespace {

using replan::bench::ReplayRow;

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> planners = {"dstar-lite", "astar"};
  int repeats = 5;
  bool json = false;
};

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    parts.emplace_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--events") continue;
    if (argument == "--json")
      options.json = true;
    else if (argument == "--planner" && i + 1 < argc)
      options.planners = split(argv[++i]);
    else if (argument == "--repeats" && i + 1 < argc)
      options.repeats = std::max(1, std::atoi(argv[++i]));
    else
      options.files.emplace_back(argument);
  }
  // A plan from scratch stands beside every repair.
  if (std::find(options.planners.begin(), options.planners.end(), "astar") == options.planners.end())
    options.planners.emplace_back("astar");
  return options;
}

nlohmann::json to_json(const std::string& file, const ReplayRow& row) {
  return {{"file", file},
          {"planner", row.planner},
          {"init_ms", row.init_ms},
          {"init_expansions", row.init_expansions},
          {"replans", row.replans},
          {"median_us", row.median_us},
          {"mean_us", row.mean_us},
          {"p95_us", row.p95_us},
          {"total_ms", row.total_ms},
          {"expansions", row.expansions},
          {"bytes_per_cell", row.bytes_per_cell},
          {"wrong", row.wrong}};
}

void print_row(const std::string& file, const ReplayRow& row) {
  const std::string name = file.substr(file.find_last_of('/') + 1);
  const double rate = row.init_ms > 0 ? static_cast<double>(row.init_expansions) / row.init_ms / 1000 : 0;
  std::printf("%-22s %-16s %9.2f %6.1f %5zu %9.1f %9.1f %9.1f %9.2f %9lld %6.1f %5zu\n", name.c_str(),
              row.planner.c_str(), row.init_ms, rate, row.replans, row.median_us, row.mean_us, row.p95_us,
              row.total_ms, static_cast<long long>(row.expansions), row.bytes_per_cell, row.wrong);
}

int run_events(const Options& options) {
  for (const std::string& id : options.planners)
    if (const auto info = replan::require_planner(id); !info) {
      std::fprintf(stderr, "replan_bench: %s\n", info.error().c_str());
      return 2;
    }
  if (!options.json)
    std::printf("%-22s %-16s %9s %6s %5s %9s %9s %9s %9s %9s %6s %5s\n", "file", "planner", "init ms", "Me/s",
                "n", "median us", "mean us", "p95 us", "total ms", "expand", "B/cell", "wrong");
  std::size_t wrong = 0;
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& file : options.files) {
    const auto workload = replan::bench::read_workload(file);
    if (!workload) {
      std::fprintf(stderr, "replan_bench: %s\n", workload.error().c_str());
      return 2;
    }
    for (const std::string& id : options.planners) {
      const ReplayRow row = replan::bench::replay(*workload, id, options.repeats);
      wrong += row.wrong;
      if (options.json)
        rows.push_back(to_json(file, row));
      else
        print_row(file, row);
    }
  }
  if (options.json) std::printf("%s\n", rows.dump(1).c_str());
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]) == "--events") return run_events(parse(argc, argv));
  replan::bench::register_plans();
  replan::bench::register_checks();
  replan::bench::register_sight();
  replan::bench::register_voxels();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
