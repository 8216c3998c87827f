// What holds for every stage that a path can go through, and what each of them is for.
#include "core/plan/stage.hpp"

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/registry.hpp"
#include "core/sim/mission.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::stage_test {
namespace {

/// Paths of all planners in random worlds, one at a time.
template <int D, class Check>
void each_path(const Check& check) {
  typename BoxLattice<D>::Coordinates low{}, high{};
  low.fill(D == 2 ? 8 : 4);
  high.fill(D == 2 ? 20 : 8);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const auto size = random_size<D>(random, low, high);
    const TwinWorld<D> world(size, random_cells<D>(random, size), {});
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    for (const PlannerInfo& info : sound_planners()) {
      if (D == 3 && info.planar) continue;
      NoTrace nobody;
      Settings settings;
      settings.set("samples", kFewSamples);
      const auto planner = make_planner(info, world.lattice, settings, nobody);
      planner->begin(start, goal);
      finish(*planner);
      check(world.lattice, planner->path());
    }
  }
}

Path after(const StageInfo& stage, const Grid2& known, const Path& path) {
  return stage.in_plane(known, path, {});
}
Path after(const StageInfo& stage, const Voxel3& known, const Path& path) {
  return stage.in_space(known, path, {});
}

TEST(Stages, LeaveThePathFreeAndItsEndsWhereTheyAre) {
  const auto check = [](const auto& known, const Path& path) {
    for (const StageInfo& stage : stages()) {
      const Path result = after(stage, known, path);
      ASSERT_EQ(result.empty(), path.empty()) << stage.id;
      if (path.empty()) continue;
      ASSERT_EQ(result.point(0), path.point(0)) << stage.id;
      ASSERT_EQ(result.point(result.size() - 1), path.point(path.size() - 1)) << stage.id;
      ASSERT_TRUE(path_is_free(known, result)) << stage.id;
      ASSERT_EQ(after(stage, known, path), result) << stage.id << ": the same again";
    }
  };
  each_path<2>(check);
  each_path<3>(check);
}

TEST(Stages, AreFoundByTheirIds) {
  ASSERT_FALSE(stages().empty());
  for (const StageInfo& stage : stages()) {
    EXPECT_EQ(find_stage(stage.id), &stage);
    EXPECT_FALSE(stage.name.empty() || stage.summary.empty()) << stage.id;
  }
  EXPECT_EQ(require_stage("colinear").error(), "unknown stage 'colinear'; did you mean 'collinear'?");
}

TEST(Collinear, LeavesTheCornersAndTheWayAsItIs) {
  std::size_t before = 0, left = 0;
  const auto check = [&](const auto& known, const Path& path) {
    const Path corners = after(*find_stage("collinear"), known, path);
    const PathFigures was = path_figures(known, path), is = path_figures(known, corners);
    ASSERT_NEAR(is.length, was.length, 1e-9);
    ASSERT_EQ(is.turns, was.turns);
    ASSERT_EQ(is.nodes, path.empty() ? 0 : path.size() == 1 ? 1 : was.turns + 2);
    const Box box = known.box();
    ASSERT_EQ(lay_out(box, known.cells(), corners).cells, lay_out(box, known.cells(), path).cells);
    before += path.size();
    left += corners.size();
  };
  each_path<2>(check);
  each_path<3>(check);
  EXPECT_LT(left, before * 3 / 4);
}

TEST(Collinear, LeavesTheDriveAsItIs) {
  const auto world = read_scenario(REPLAN_SOURCE_DIR "/maps/office.json");
  ASSERT_TRUE(world.ok()) << world.error();
  for (PlannerChoice choice : world->planners) {
    Recorder plain, staged;
    const auto drive = [&](Recorder& recorder) {
      auto mission = make_mission(*world, choice, &recorder);
      while (mission->advance(1 << 20)) {
      }
      return mission;
    };
    const auto before = drive(plain);
    choice.stages = {{"collinear", {}}};
    const auto after = drive(staged);
    EXPECT_TRUE(std::equal(plain.buffer().begin(), plain.buffer().end(), staged.buffer().begin(),
                           staged.buffer().end()))
        << choice.id;
    EXPECT_NEAR(after->now().figures.travelled, before->now().figures.travelled, 1e-9) << choice.id;
    EXPECT_EQ(after->now().time, before->now().time) << choice.id;
  }
}

TEST(Collinear, TakesPointsAnywhere) {
  const Grid2 known({20, 20});
  const Path bent({{1, 1, 0.5}, {2.25, 3.5, 0.5}, {3.5, 6, 0.5}, {9.1, 6, 0.5}, {9.1, 6.3, 0.5}});
  const Path corners = after(*find_stage("collinear"), known, bent);
  EXPECT_EQ(corners, Path({{1, 1, 0.5}, {3.5, 6, 0.5}, {9.1, 6, 0.5}, {9.1, 6.3, 0.5}}));
}

}  // namespace
}  // namespace replan::test::stage_test
