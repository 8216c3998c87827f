// Field D* after 60 000 random changes, none skipped: its cost is that of a search from scratch, bit for bit, its path enters
// no obstacle and is no longer than its bound. And how long its paths are on the shared maps, against A* and the optimum.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/planners/interpolated_path.hpp"
#include "core/world/formats/movingai.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::field_dstar_property_test {
namespace {

constexpr int kReplansPerShard = 15'000, kReplansPerWorld = 50;

struct Tally {
  std::int64_t replans = 0, found = 0, no_path = 0, ends_blocked = 0, moved = 0;
  double over_cost = 0, under_lattice = 0, most_over_cost = 0;
  std::int64_t longer_than_lattice = 0;
};

/// One world, many changes.
class FieldTrial {
 public:
  explicit FieldTrial(std::uint64_t seed)
      : info_(*find_planner("field-dstar")),
        random_(seed),
        settings_(random_settings(random_, info_)),
        size_(random_size<2>(random_, {10, 10}, {26, 20})),
        world_(size_, random_cells<2>(random_, size_), move_rules(settings_)),
        start_(random_free(random_, world_.plain)),
        goal_(random_free(random_, world_.plain)),
        planner_(make_planner(info_, world_.lattice, settings_, nobody_)) {
    planner_->begin(start_, goal_);
    finish(*planner_);
  }

  /// What is wrong with the plan after the next change, or empty.
  std::string replan(Tally& tally) {
    while (random_.chance(0.1)) {  // now and then a change comes while the search is under way
      change(tally);
      planner_->advance(random_.between(1, 20));
    }
    change(tally);
    finish(*planner_);
    ++tally.replans;
    const auto fresh = make_planner(info_, world_.lattice, {}, nobody_);  // under another heuristic as well
    fresh->begin(start_, goal_);
    if (finish(*fresh) != planner_->status()) return "another status than a fresh plan";
    if (fresh->cost() != planner_->cost()) return "another cost than a fresh plan";
    return planner_->status() == PlanStatus::found ? path_fault(tally) : no_path(tally);
  }

 private:
  void change(Tally& tally) {
    auto edits = random_edits<2>(random_, world_.plain, random_.chance(0.2) ? 12 : 4);
    for (const NodeId end : {start_, goal_}) {
      std::erase_if(edits, [end](const CellEdit& edit) { return edit.node == end; });
      const bool covered = world_.plain.blocked[end] != 0;
      const auto same = [end](const CellEdit& edit) { return edit.node == end; };
      if (random_.chance(covered ? 0.7 : 0.03) && std::none_of(edits.begin(), edits.end(), same))
        edits.push_back({end, !covered});
    }
    const auto moves = world_.apply(edits);
    if (random_.chance(0.5)) {
      start_ = random_free(random_, world_.plain);
      ++tally.moved;
    }
    planner_->update({.cells = edits, .moves = moves}, start_);
  }

  std::string no_path(Tally& tally) {
    ++(planner_->status() == PlanStatus::no_path ? tally.no_path : tally.ends_blocked);
    return planner_->path().empty() ? "" : "a path without a plan";
  }

  std::string path_fault(Tally& tally) {
    ++tally.found;
    const Path path = planner_->path();
    const double length = path_length(path), cost = planner_->cost().to_double();
    const MoveRules rules = move_rules(settings_);
    const double lattice =
        static_cast<double>(oracle::costs_to(world_.plain, rules, {}, goal_)[start_]) / oracle::kUnit;
    if (cost > lattice) return "dearer than the lattice's path";
    if (length > cost * kMostOverInterpolated + 1e-6) return "longer than its bound";
    tally.over_cost += cost > 0 ? length / cost - 1 : 0;
    tally.most_over_cost = std::max(tally.most_over_cost, cost > 0 ? length / cost - 1 : 0);
    tally.under_lattice += lattice > 0 ? length / lattice - 1 : 0;
    tally.longer_than_lattice += length > lattice + 1e-6 ? 1 : 0;
    return fault_of_segments(info_, settings_, world_.plain, start_, goal_, path);
  }

  const PlannerInfo& info_;
  Random random_;
  NoTrace nobody_;
  Settings settings_;
  Grid2::Coordinates size_;
  TwinWorld<2> world_;
  NodeId start_, goal_;
  std::unique_ptr<Planner<Grid2>> planner_;
};

class FieldDStarRepairs : public ::testing::TestWithParam<int> {};

TEST_P(FieldDStarRepairs, costWhatASearchFromScratchCosts) {
  Tally tally;
  for (std::uint64_t world = 0; tally.replans < kReplansPerShard; ++world) {
    const std::uint64_t seed = 1'000'000u * static_cast<std::uint64_t>(GetParam() + 1) + world;
    FieldTrial trial(seed);
    for (int i = 0; i < kReplansPerWorld; ++i)
      ASSERT_EQ(trial.replan(tally), "") << "seed " << seed << ", change " << i;
  }
  const auto found = static_cast<double>(tally.found);
  std::printf(
      "field-dstar: %lld changes, %lld with a path, %lld with another start; paths %.3f %% over their cost "
      "(at most "
      "%.2f %%), %.3f %% over the lattice's, %lld longer than that\n",
      static_cast<long long>(tally.replans), static_cast<long long>(tally.found),
      static_cast<long long>(tally.moved), 100 * tally.over_cost / found, 100 * tally.most_over_cost,
      100 * tally.under_lattice / found, static_cast<long long>(tally.longer_than_lattice));
  EXPECT_GT(tally.found, tally.replans / 2);
  EXPECT_GT(tally.no_path, tally.replans / 100);
  EXPECT_GT(tally.ends_blocked, tally.replans / 100);
  EXPECT_LT(tally.under_lattice / found, -0.01);
  EXPECT_LT(tally.longer_than_lattice, tally.found / 1000);
}
INSTANTIATE_TEST_SUITE_P(Shards, FieldDStarRepairs, ::testing::Values(0, 1, 2, 3));

/// `computed.tsv`: centre_length is the shortest way of a point between the cells' centres, lattice_length A*'s.
TEST(FieldDStarLengths, areBetweenTheComputedOptimumAndTheBound) {
  REPLAN_NEED_SHARED_DATA();
  std::ifstream in(shared_data() / "anyangle" / "computed.tsv");
  std::map<std::string, std::unique_ptr<Grid2>> maps;
  std::int64_t questions = 0, longer = 0;
  double over_optimum = 0, under_lattice = 0, most_over_lattice = -1;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#') || line.empty()) continue;
    std::istringstream words(line);
    std::string name;
    Cell start, goal;
    double vertex_length = 0, least = 0, lattice = 0;
    words >> name >> start.x >> start.y >> goal.x >> goal.y >> vertex_length >> least >> lattice;
    ASSERT_TRUE(static_cast<bool>(words)) << line;
    auto& map = maps[name];
    if (!map) {
      const auto read = read_movingai_map((shared_data() / "movingai" / (name + ".map")).string());
      ASSERT_TRUE(read.ok()) << read.error();
      map = std::make_unique<Grid2>(Grid2::Coordinates{read->width, read->height}, read->blocked.plain());
    }
    if (++questions % 4 != 0) continue;  // a quarter of them says as much
    NoTrace nobody;
    const auto planner = make_planner(*find_planner("field-dstar"), *map, {}, nobody);
    planner->begin(map->node(start), map->node(goal));
    ASSERT_EQ(finish(*planner), PlanStatus::found) << line;
    const Path path = planner->path();
    const double length = path_length(path);
    ASSERT_TRUE(path_is_free(*map, path)) << line;
    ASSERT_GE(length, least - 1e-6) << line;
    ASSERT_LE(planner->cost().to_double(), lattice * (1 + 1e-4) + 0.006) << line;
    ASSERT_LE(length, planner->cost().to_double() * kMostOverInterpolated + 1e-6) << line;
    over_optimum += length / least - 1;
    under_lattice += length / lattice - 1;
    most_over_lattice = std::max(most_over_lattice, length / lattice - 1);
    longer += length > lattice + 0.01 ? 1 : 0;
  }
  const double asked = static_cast<double>(questions / 4);
  std::printf(
      "field-dstar: %.0f paths, %.3f %% above the shortest, %.3f %% under A*'s on average; at most %.3f %% "
      "over "
      "A*'s, %lld longer than that\n",
      asked, 100 * over_optimum / asked, -100 * under_lattice / asked, 100 * most_over_lattice,
      static_cast<long long>(longer));
  EXPECT_EQ(questions, 1602);
  EXPECT_LT(over_optimum / asked, 0.05);
  EXPECT_LT(under_lattice / asked, -0.02);
}

}  // namespace
}  // namespace replan::test::field_dstar_property_test
