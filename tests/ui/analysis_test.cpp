// The Analysis tab in the real window: axes, rectangle, clicks and the playhead; the tree of parents about the pinned cell.
#include "ui/tabs/analysis.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/debug/measures.hpp"
#include "core/debug/shown_family.hpp"
#include "core/world/choices.hpp"
#include "tests/ui/golden_picture.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/keys.hpp"
#include "ui/tabs/scatter_picture.hpp"

namespace replan::ui::analysis_test {
namespace {

class AnalysisTest : public ShellTest {
 protected:
  void run_demo(const char* planner = "dstar-lite") {
    std::string rows;
    for (int y = 0; y < 20; ++y) {
      const bool wall = y >= 3 && y < 17;
      rows += std::string(y > 0 ? ", " : "") + "\"............" + (wall ? "@@" : "..") + "................\"";
    }
    const std::string scenario = R"({"replan": 1, "map": {"rows": [)" + rows +
                                 R"(]}, "start": [3, 10], "goal": [26, 10], "planners": [{"id": ")" +
                                 planner + R"("}]})";
    open("analysis.json", scenario);
    for (const auto& each : session_->runs()) each->finish(Target::end());
    to(session_->run().timeline().size());
    analysis().show_scatter();
    shell_->view().tab = "analysis";
    frames(4);
  }
  void to(std::size_t position) {
    ASSERT_TRUE(session_->apply(Seek{position}).ok());
    frames(4);
  }
  [[nodiscard]] AnalysisTab& analysis() { return shell_->panels().tabs.get<AnalysisTab>(); }
  [[nodiscard]] ScatterView& scatter() { return analysis().scatter(); }
  [[nodiscard]] const replan::Run& run() { return session_->run(); }
  [[nodiscard]] View& view() { return shell_->view().view; }
  [[nodiscard]] PlotPlace place() { return {scatter().plot(), *scatter().picture()}; }
  void drag(ImVec2 from, ImVec2 to) {
    InputQueue& input = offscreen_->stage().input();
    input.mouse_move(from.x, from.y);
    frames(2);
    input.mouse_button(0, true);
    frames(2);
    input.mouse_move(to.x, to.y);
    frames(2);
    input.mouse_button(0, false);
    frames(3);
  }
  /// A place of the plot, both from 0 to 1.
  ImVec2 at(float x, float y) {
    const ScreenArea& plot = scatter().plot();
    return {plot.min.x + x * (plot.max.x - plot.min.x), plot.max.y - y * (plot.max.y - plot.min.y)};
  }
};

TEST_F(AnalysisTest, ThePlotFollowsThePlayheadBothWays) {
  run_demo();
  scatter().choose("expansion", "g");
  std::vector<std::size_t> points;
  const std::size_t size = run().timeline().size();
  for (const std::size_t part : {4u, 2u, 1u, 2u, 4u}) {
    to(size * part / 4);
    ASSERT_TRUE(scatter().picture());
    const RunColumns& columns = *scatter().picture()->columns;
    EXPECT_EQ(columns.position, run().timeline().cursor());
    points.push_back(columns.points.size());
    for (std::size_t i = 0; i < columns.points.size(); ++i) {
      EXPECT_EQ(columns.x[i], run().timeline().state().order(columns.points[i]));
      EXPECT_EQ(columns.y[i], run().timeline().state().g(columns.points[i]).to_double());
    }
  }
  EXPECT_EQ(points[0], points[4]);
  EXPECT_EQ(points[1], points[3]);
  EXPECT_GT(points[0], points[2]);
}

TEST_F(AnalysisTest, ARectangleLightsTheCellsOfItsPoints) {
  run_demo();
  scatter().choose("event", "g");
  frames(3);
  EXPECT_EQ(view().brushed, nullptr);
  drag(at(0.25f, 0.2f), at(0.75f, 0.8f));
  ASSERT_TRUE(scatter().brush().has_value());
  ASSERT_NE(view().brushed, nullptr);
  const RunColumns& columns = *scatter().picture()->columns;
  std::size_t within = 0;
  for (std::size_t i = 0; i < columns.points.size(); ++i) {
    const bool in = scatter().brush()->has(columns.x[i], columns.y[i]);
    within += in ? 1 : 0;
    EXPECT_EQ(view().brushed->has(columns.points[i]), in);
  }
  EXPECT_GT(within, 0u);
  EXPECT_LT(within, columns.points.size());
  EXPECT_EQ(view().brushed->size(), within);
  // It stays with the numbers, not with the cells; and goes with the tab.
  to(run().timeline().size() / 2);
  EXPECT_LT(view().brushed->size(), within);
  shell_->view().tab = "cell";
  frames(2);
  EXPECT_EQ(view().brushed, nullptr);
}

TEST_F(AnalysisTest, AClickOnAPointPinsItsCellAndOneBesideTakesTheRectangleAway) {
  run_demo();
  scatter().choose("event", "to_goal");
  frames(3);
  const RunColumns& columns = *scatter().picture()->columns;
  const std::size_t row = columns.points.size() / 3;
  const ImVec2 there = place().of(row);
  click(there);
  ASSERT_TRUE(view().pinned.has_value());
  const NodeId pinned = run().lattice().node(*view().pinned);
  const auto own = std::find(columns.points.begin(), columns.points.end(), pinned);
  ASSERT_NE(own, columns.points.end());
  const ImVec2 found = place().of(static_cast<std::size_t>(own - columns.points.begin()));
  EXPECT_NEAR(found.x, there.x, 1);
  EXPECT_NEAR(found.y, there.y, 1);
  drag(at(0.1f, 0.1f), at(0.4f, 0.9f));
  EXPECT_TRUE(scatter().brush().has_value());
  scatter().choose("event", "event");
  scatter().set_brush(PlotBrush{1, 2, 1, 2});
  frames(3);
  click(at(0.9f, 0.1f));
  EXPECT_FALSE(scatter().brush().has_value());
}

TEST_F(AnalysisTest, BeforeTheFirstPointItSpeaksOfThePlannersOwnSteps) {
  EXPECT_NE(no_points_words(*find_choice("dstar-lite")).find("the first expansion; every cell"),
            std::string::npos);
  EXPECT_NE(no_points_words(*find_choice("rrt-star")).find("the first sample; every vertex"),
            std::string::npos);
  EXPECT_NE(no_points_words(*find_choice("improved-ga")).find("the first child; every cell that the paths"),
            std::string::npos);
  for (const auto& [planner, label] : {std::pair{"rrt-star", "sample"}, {"improved-ga", "child"}}) {
    const auto measures = measures_of(*find_choice(planner));
    EXPECT_EQ(std::count_if(measures.begin(), measures.end(),
                            [wanted = label](const Measure& each) {
                              return each.id == "reached" && each.label == wanted;
                            }),
              1)
        << planner;
  }
}

/// In a window of 1280 x 800, whose bar has one row.
TEST_F(AnalysisTest, IsBehindTheDotsAtTheEndOfTheBar) {
  run_demo();
  shell_->view().tab = "cell";
  frames(3);
  click({1267, 56});
  EXPECT_EQ(shell_->view().tab, "cell");
  click({1185, 90});
  EXPECT_EQ(shell_->view().tab, "analysis");
  frames(3);
  EXPECT_TRUE(has_scatter(*session_, shell_->panels()));
}

TEST_F(AnalysisTest, WithoutARunOrParentsItSaysSo) {
  run_demo("improved-ga");
  to(0);
  analysis().show_family();
  view().pinned = Cell{3, 10};
  frames(3);
  EXPECT_EQ(view().family, nullptr);
  EXPECT_TRUE(analysis().family().rows().empty());
}

TEST_F(AnalysisTest, TheTreeOfParentsIsThatOfThePlayhead) {
  run_demo();
  view().pinned = Cell{5, 9};
  analysis().show_family();
  frames(4);
  FamilyView& family = analysis().family();
  ASSERT_TRUE(family.tree());
  EXPECT_EQ(family.tree()->table().position, run().timeline().cursor());
  const NodeId node = run().lattice().node({5, 9});
  EXPECT_EQ(family.point(), node);
  const Ancestry up = ancestry(run().info(), run().timeline().state(), node);
  ASSERT_GT(up.points.size(), 2u);
  ASSERT_FALSE(family.rows().empty());
  EXPECT_EQ(family.rows().front().point, up.points.back()) << "the root stands first";
  ASSERT_NE(view().family, nullptr);
  EXPECT_EQ(view().family->way.size(), up.points.size());
  ASSERT_NE(view().family->below, nullptr);
  EXPECT_EQ(view().family->below->size(), family.tree()->below(node));
  // Back to where the search has not come to it, and forth again.
  to(3);
  EXPECT_EQ(view().family, nullptr);
  to(run().timeline().size());
  ASSERT_NE(view().family, nullptr);
  EXPECT_EQ(view().family->way.size(), up.points.size());
}

TEST_F(AnalysisTest, TreesOfSamplesHaveBothToo) {
  run_demo("rrt-star");
  ASSERT_TRUE(scatter().picture());
  EXPECT_GT(scatter().picture()->columns->points.size(), 10u);
  EXPECT_FALSE(scatter().picture()->columns->cells.empty());
  view().pinned = Cell{20, 4};
  analysis().show_family();
  frames(4);
  const FamilyView& family = analysis().family();
  ASSERT_TRUE(family.tree());
  ASSERT_FALSE(family.rows().empty());
  const SearchState& state = run().timeline().state();
  std::size_t rows_of_path = 0;
  for (const FamilyRow& row : family.rows())
    if (row.kind == FamilyRow::Kind::ancestor || row.kind == FamilyRow::Kind::self) ++rows_of_path;
  EXPECT_EQ(rows_of_path, ancestry(run().info(), state, family.point()).points.size());
}

/// Both parts, in both themes, at 1x and one at 2x.
class AnalysisGolden : public testing::TestWithParam<const char*> {
 protected:
  static app::RenderRequest request(const char* action) {
    auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/demo.json");
    EXPECT_TRUE(scenario.ok());
    app::RenderRequest request;
    if (scenario.ok()) request.scenario = *scenario;
    request.width = 1280;
    request.height = 800;
    request.window = true;
    request.theme = GetParam();
    request.panes = 1;
    request.pinned = Cell{15, 33};
    request.actions = {action};
    return request;
  }
};

TEST_P(AnalysisGolden, ScatterPlot) {
  app::compare_with_golden(request("scatter_plot"), std::string("scatter_plot_") + GetParam());
}

TEST_P(AnalysisGolden, TreeOfParents) {
  app::compare_with_golden(request("parent_tree"), std::string("parent_tree_") + GetParam());
}

INSTANTIATE_TEST_SUITE_P(Themes, AnalysisGolden, testing::Values("dark", "light"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace replan::ui::analysis_test
