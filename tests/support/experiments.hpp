// Experiments of tests: a folder with worlds in it, and their runs made.
#pragma once

#include <string>
#include <vector>

#include "core/experiment/run_experiment.hpp"
#include "core/experiment/run_list.hpp"

namespace replan::test {

/// Eight by six cells: a wall with a gap; the room at the lower right is closed.
inline constexpr const char* kRoomMap =
    "type octile\nheight 6\nwidth 8\nmap\n"
    "........\n"
    "...@....\n"
    "...@....\n"
    "...@.@@@\n"
    "...@.@.@\n"
    ".....@@@\n";
/// Four problems on it: solved, solved, skipped, without a path.
inline constexpr const char* kRoomProblems =
    "version 1\n"
    "0\troom.map\t8\t6\t0\t0\t2\t0\t2\n"
    "0\troom.map\t8\t6\t0\t0\t1\t1\t1.41421\n"
    "0\troom.map\t8\t6\t3\t1\t0\t0\t9\n"
    "1\troom.map\t8\t6\t0\t0\t6\t4\t9\n";

/// All of them, in the order in which they are taken.
inline std::vector<RunResult> results_of(const RunList& list, const std::vector<std::int64_t>& runs,
                                         std::size_t jobs = 1) {
  std::vector<RunResult> results;
  const auto take = [&](RunResult result) {
    results.push_back(std::move(result));
    return true;
  };
  make_runs(list, runs, jobs, {.take = take, .stop = {}});
  return results;
}
inline std::vector<RunResult> results_of(const RunList& list) {
  std::vector<std::int64_t> runs;
  for (std::int64_t run = 0; run < list.count(); ++run) runs.push_back(run);
  return results_of(list, runs);
}

}  // namespace replan::test
