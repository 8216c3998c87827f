// Repairs of a plan while the map changes and the robot moves, each held against a plan that brute force makes from
// scratch: its cost equals that exactly, and its path is one that can be driven.
#pragma once

#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test {

template <int D>
typename BoxLattice<D>::Coordinates small_world_size(Random& random) {
  if constexpr (D == 2)
    return random_size<2>(random, {12, 12}, {24, 18});
  else
    return random_size<3>(random, {5, 5, 5}, {8, 7, 6});
}

/// How the replans ended: a property that only ever met blocked starts would prove little.
struct ReplanTally {
  int found = 0, no_path = 0, ends_blocked = 0;
  int long_segments = 0;  ///< plans with a segment longer than one step
};

/// One world, one planner, many changes.
template <int D>
class ReplanTrial {
 public:
  ReplanTrial(const PlannerInfo& info, std::uint64_t seed)
      : info_(info),
        random_(seed),
        settings_(random_settings(random_, info)),
        size_(small_world_size<D>(random_)),
        world_(size_, random_cells<D>(random_, size_), move_rules(settings_)),
        start_(random_free(random_, world_.plain)),
        goal_(random_free(random_, world_.plain)),
        planner_(make_planner(info, world_.lattice, settings_, trace_)),
        twin_(info.any_angle ? make_planner(lattice_twin(info), world_.lattice, settings_, trace_)
                             : nullptr) {
    planner_->begin(start_, goal_);
    if (twin_) twin_->begin(start_, goal_);
  }

  /// What is wrong with the first plan, or empty.
  std::string plan() {
    finish(*planner_);
    const std::string fault = fault_of_plan<D>(info_, settings_, world_.plain, start_, goal_, *planner_);
    if (!fault.empty() || !info_.any_angle) return fault;
    finish(*twin_);
    return fault_of_length(world_.plain, planner_->path(), twin_->path());
  }

  /// Edits, moves, replans; what is wrong with the new plan, or empty.
  std::string replan(ReplanTally& tally) {
    // Now and then a change comes while the search is under way.
    while (random_.chance(0.1)) {
      const int iterations = random_.between(1, 20);
      planner_->advance(iterations);
      if (twin_) twin_->advance(iterations);
      change();
    }
    change();
    std::string fault = plan();
    count(tally);
    return fault;
  }
  [[nodiscard]] std::string describe() const { return describe_settings(info_, settings_); }

 private:
  void count(ReplanTally& tally) {
    const PlanStatus status = planner_->status();
    ++(status == PlanStatus::found     ? tally.found
       : status == PlanStatus::no_path ? tally.no_path
                                       : tally.ends_blocked);
    const auto path = planner_->path().nodes();
    bool far = false;
    for (std::size_t i = 1; i < path.size(); ++i)
      far |= world_.lattice.squared_distance(path[i - 1], path[i]) > D;
    tally.long_segments += far ? 1 : 0;
  }

  void change() {
    std::vector<CellEdit> edits;
    if (!random_.chance(0.1)) edits = random_edits<D>(random_, world_.plain, random_.chance(0.2) ? 12 : 4);
    keep_ends_mostly_free(edits);
    const auto moves = world_.apply(edits);
    if (random_.chance(0.6)) start_ = next_start();
    planner_->update({.cells = edits, .moves = moves}, start_);
    if (twin_) twin_->update({.cells = edits, .moves = moves}, start_);
  }

  /// Start and goal are covered now and then, and most often uncovered by the next change.
  void keep_ends_mostly_free(std::vector<CellEdit>& edits) {
    for (const NodeId end : {start_, goal_}) {
      std::erase_if(edits, [end](const CellEdit& edit) { return edit.node == end; });
      const bool covered = world_.plain.blocked[end] != 0;
      if (random_.chance(covered ? 0.7 : 0.03)) edits.push_back({end, !covered});
    }
  }

  /// One step on, or anywhere.
  NodeId next_start() {
    const auto near = oracle::neighbours(world_.plain, move_rules(settings_), start_);
    if (random_.chance(0.5) && !near.empty())
      return static_cast<NodeId>(near[random_.below(static_cast<std::uint32_t>(near.size()))]);
    return random_free(random_, world_.plain);
  }

  const PlannerInfo& info_;
  Random random_;
  Settings settings_;
  typename BoxLattice<D>::Coordinates size_;
  TwinWorld<D> world_;
  NodeId start_, goal_;
  NoTrace trace_;
  std::unique_ptr<Planner<BoxLattice<D>>> planner_;
  std::unique_ptr<Planner<BoxLattice<D>>> twin_;  // the same search without sight
};

/// At least so many replans, none skipped; `shard` chooses the worlds.
template <int D>
void check_replans(const char* id, int shard, int replans) {
  constexpr int kReplansPerWorld = 50;
  const PlannerInfo& info = *find_planner(id);
  int done = 0;
  ReplanTally tally;
  for (std::uint64_t world = 0; done < replans; ++world) {
    const std::uint64_t seed = hash_bytes(id, static_cast<std::uint64_t>(D * 1000 + shard)) + world;
    ReplanTrial<D> trial(info, seed);
    ASSERT_EQ(trial.plan(), "") << trial.describe() << ", seed " << seed << ", first plan";
    for (int i = 0; i < kReplansPerWorld; ++i, ++done) {
      const std::string fault = trial.replan(tally);
      ASSERT_EQ(fault, "") << trial.describe() << ", seed " << seed << ", replan " << i;
    }
  }
  EXPECT_GE(done, replans);
  std::printf(
      "%s, %dD: %d replans: %d found, %d without a path, %d with an end covered; %d with long segments\n", id,
      D, done, tally.found, tally.no_path, tally.ends_blocked, tally.long_segments);
  EXPECT_GT(tally.found, done / 2);
  EXPECT_GT(tally.no_path, done / 100);
  EXPECT_GT(tally.ends_blocked, done / 100);
  // Near obstacles DLD* sees nothing, and little else is left of a small world.
  EXPECT_TRUE(!info.any_angle || tally.long_segments > done / (info.clearance ? 200 : 4));
}

}  // namespace replan::test
