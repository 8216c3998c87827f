// The debugger's panels on frames without a display: what clicks in them come to.
#include <algorithm>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "tests/ui/panel_fixture.hpp"
#include "ui/keys.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/timeline_marks.hpp"
#include "ui/tabs/cell_past.hpp"
#include "ui/tabs/debug.hpp"
#include "ui/tabs/open_list.hpp"

namespace replan::ui::debugger_test {
namespace {

/// A replanned mission: a wall falls in the robot's way.
Scenario scenario_with_surprise(const char* planner) {
  Scenario scenario;
  scenario.map = GridMap(20, 10);
  scenario.start = {1, 5};
  scenario.goal = {18, 5};
  scenario.planners = {{planner, {}}};
  Surprise surprise;
  surprise.at.move = 2;
  for (int y = 2; y < 9; ++y) surprise.cells.push_back({{9, y}, true});
  scenario.surprises = {surprise};
  return scenario;
}

TEST_F(PanelTest, HistoryLeadsToTheEventsThatWroteTheCell) {
  const Cell cell{8, 4};
  open(scenario_with_surprise("dstar-lite"), [&](Frame& frame) { past_.draw(frame, cell); });
  const NodeId node = run().lattice().node(cell);
  const std::vector<Seek> sought = sweep<Seek>(60, 20);
  ASSERT_GE(sought.size(), 3u);
  std::set<std::size_t> positions;
  for (const Seek& seek : sought) {
    const Event event = run().timeline().event(seek.position - 1);
    EXPECT_EQ(event.node, node);
    EXPECT_TRUE(event.kind == EventKind::g || event.kind == EventKind::rhs) << seek.position;
    positions.insert(seek.position);
  }
  EXPECT_GE(positions.size(), 3u);
  EXPECT_TRUE(past_.history.complete());
}

TEST_F(PanelTest, HistoryKeepsThePlayheadInSight) {
  const Cell cell{8, 4};
  open(scenario_with_surprise("dstar-lite"), [&](Frame& frame) { past_.draw(frame, cell); });
  past_.every_value = true;
  frames(2);
  const CellHistory& history = past_.history;
  ASSERT_GT(history.size(), 12u);
  const auto first = past_.rows.first;
  EXPECT_EQ(first, 0);  // at the end of the log the newest stands first
  ASSERT_TRUE(session_->apply(Seek{history[history.size() - 1].event + 1}).ok());
  frames(2);
  EXPECT_GT(past_.rows.first, first);
}

TEST_F(PanelTest, AGutterSetsBreakpointsOnLinesThatAreReached) {
  open(scenario_with_surprise("dstar-lite"), tab("code"));
  const auto page = read_page("dstar-lite");
  ASSERT_TRUE(page.ok()) << page.error();
  const std::vector<AddBreakpoint> set = sweep<AddBreakpoint>(44, 10);
  std::set<std::string> conditions;
  for (const AddBreakpoint& each : set) conditions.insert(each.condition);
  std::set<std::string> reached;
  for (const PseudoBlock& block : page->code)
    for (const PseudoLine& line : block.lines)
      if (line.number != 0) reached.insert(when_line(line.number));
  EXPECT_GE(conditions.size(), 10u);
  for (const std::string& condition : conditions) EXPECT_TRUE(reached.count(condition) == 1) << condition;
  // Beside the gutter a click is nothing.
  EXPECT_TRUE(sweep<AddBreakpoint>(200, 40).empty());
}

TEST_F(PanelTest, OpenListRowsPinTheirCellsInOrder) {
  open(scenario_with_surprise("dstar-lite"), tab("open_list"));
  const Timeline& log = run().timeline();
  std::size_t middle = log.size() / 3;
  while (log.event(middle).kind != EventKind::pop) ++middle;
  ASSERT_TRUE(session_->apply(Seek{middle}).ok());
  frames(2);
  const OpenOrder& order = panels_.tabs.get<OpenListTab>().order();
  ASSERT_GT(order.size(), 3u);
  EXPECT_EQ(order[0].node, log.event(middle).node);
  std::vector<Cell> pinned;
  for (float y = 60; y < 300; y += 8) {
    click(100, y);
    if (view_.view.pinned && (pinned.empty() || pinned.back() != *view_.view.pinned))
      pinned.push_back(*view_.view.pinned);
  }
  ASSERT_GE(pinned.size(), 3u);
  for (std::size_t i = 0; i < pinned.size(); ++i)
    EXPECT_EQ(pinned[i], run().lattice().position(order[i].node)) << i;
  // The row under the mouse shows its cell on the canvas.
  EXPECT_EQ(view_.view.hovered, panels_.pointed);
}

TEST_F(PanelTest, WhatTheReplanTouchedIsListed) {
  open(scenario_with_surprise("dstar-lite"), tab("open_list"));
  panels_.tabs.get<OpenListTab>().show_repair();
  frames(2);
  const TouchedList* touched = &panels_.touched;
  ASSERT_GT(touched->list().size(), 5u);
  for (float y = 80; y < 200 && !view_.view.pinned; y += 8) click(60, y);
  ASSERT_TRUE(view_.view.pinned.has_value());
  EXPECT_NE(touched->find(run().lattice().node(*view_.view.pinned)), nullptr);
}

TEST_F(PanelTest, AReplanIsOverOnceThePlayheadIsBehindIt) {
  open(scenario_with_surprise("dstar-lite"), tab("open_list"));
  const auto whole = last_replan(run());
  ASSERT_TRUE(whole.has_value());
  EXPECT_TRUE(whole->over);
  ASSERT_TRUE(session_->apply(Seek{whole->end - 1}).ok());
  EXPECT_FALSE(last_replan(run())->over) << "its last event is to come";
  ASSERT_TRUE(session_->apply(Seek{whole->end}).ok());
  EXPECT_TRUE(last_replan(run())->over);
  EXPECT_EQ(last_replan(run())->end, whole->end);
  ASSERT_TRUE(session_->apply(Seek{whole->begin + 1}).ok());
  EXPECT_FALSE(last_replan(run())->over);
}

TEST_F(PanelTest, AValueLeadsToWhoWroteIt) {
  open(scenario_with_surprise("dstar-lite"), tab("cell"));
  view_.view.pinned = Cell{8, 4};
  frames(2);
  const NodeId node = run().lattice().node(*view_.view.pinned);
  commands_.clear();
  for (float y = 24; y < 80 && commands_.empty(); y += 4) click(60, y);
  ASSERT_FALSE(commands_.empty());
  const Seek* seek = std::get_if<Seek>(&commands_.front());
  ASSERT_NE(seek, nullptr);
  EXPECT_EQ(run().timeline().last_event(node, {EventKind::g}, run().timeline().cursor()), seek->position - 1);
}

TEST_F(PanelTest, AConditionIsTypedAndAddedIfItIsSound) {
  open(scenario_with_surprise("dstar-lite"), tab("debug"));
  std::string& draft = panels_.tabs.get<DebugTab>().breakpoint;
  for (float y = 60; y < 240 && draft.empty(); y += 8) {
    click(60, y);
    draft.clear();  // an example was taken over
    type("g(3,");
  }
  ASSERT_EQ(draft, "g(3,");
  commands_.clear();
  press(key::kEnter);
  EXPECT_TRUE(commands_.empty()) << "half a condition was added";
  panels_.tabs.get<DebugTab>().breakpoint = "g(3, 4) > 5";
  EXPECT_EQ(language_error(*session_, "g(3, 4) > 5", false), "");
  EXPECT_NE(language_error(*session_, "g(3, 4) >", false), "");
  EXPECT_NE(language_error(*session_, "g(3, 4) > 5", true), "") << "a condition is no quantity";
}

TEST_F(PanelTest, ConditionsThatMenusWriteAreSound) {
  open(scenario_with_surprise("dld-star-lite"), [](Frame&) {});
  const Box world = session_->run().lattice();
  for (const EventKind kind : {EventKind::g, EventKind::rhs, EventKind::dist, EventKind::queue, EventKind::lp,
                               EventKind::rp, EventKind::visit, EventKind::known})
    EXPECT_EQ(language_error(*session_, when_changed(kind, {3, 4}, world), false), "");
  for (const EventKind kind :
       {EventKind::g, EventKind::rhs, EventKind::dist, EventKind::queue, EventKind::visit})
    EXPECT_EQ(language_error(*session_, value_expression(kind, {3, 4}, world), true), "");
  EXPECT_EQ(language_error(*session_, when_taken({3, 4}, world), false), "");
  EXPECT_EQ(language_error(*session_, when_line(48), false), "");
  for (const char* each : {"event(replan)", "event(invariant)", "event(oracle)", "km > 5 && size(U) >= 100"})
    EXPECT_EQ(language_error(*session_, each, false), "") << each;
  EXPECT_FALSE(language_words(true).empty());
}

TEST_F(PanelTest, MillionsOfRowsScrollToEachSingleOne) {
  constexpr std::size_t kRows = 20'000'000;
  RowScroll scroll;
  std::vector<std::size_t> drawn;
  open(scenario_with_surprise("astar"), [&](Frame& frame) {
    drawn.clear();
    const RowsInSight sight = begin_rows(frame.look, "rows", kRows, 23 * 10, scroll);
    for (std::size_t row = sight.first; row < sight.last; ++row) {
      drawn.push_back(row);
      ImGui::Dummy({1, frame.look.px.row});
    }
    end_rows();
  });
  for (const std::size_t row : {std::size_t{0}, std::size_t{12'345'677}, kRows - 10}) {
    scroll.first = static_cast<double>(row);
    frames(1);
    EXPECT_EQ(drawn.front(), row);
    EXPECT_LE(drawn.size(), 11u);
  }
  EXPECT_EQ(drawn.back(), kRows - 1);
  scroll.first = 5e9;
  frames(1);
  EXPECT_EQ(drawn.back(), kRows - 1);
  move_to(60, 60);
  input().wheel(0, 1);
  frames(2);
  EXPECT_EQ(drawn.front(), kRows - 13);  // three rows for a notch
  reveal_row(offscreen_->stage().look(), 77, kRows, 23 * 10, scroll);
  EXPECT_EQ(scroll.first, 77);
  reveal_row(offscreen_->stage().look(), 90, kRows, 23 * 10, scroll);
  EXPECT_EQ(scroll.first, 81);
}

TEST_F(PanelTest, CrowdedMarksShareTheirPlaces) {
  open(scenario_with_surprise("dstar-lite"), [](Frame&) {});
  const Look& look = offscreen_->stage().look();
  std::size_t before = 0;
  for (const float width : {4.0f, 40.0f, 400.0f, 100000.0f}) {
    const TimelineScale scale{0, width, run().timeline().size()};
    const std::vector<MarkGroup> groups = happenings(look, run(), scale);
    ASSERT_FALSE(groups.empty());
    EXPECT_GE(groups.size(), before);
    before = groups.size();
    if (width == 4.0f) {
      EXPECT_EQ(groups.size(), 1u);
      EXPECT_EQ(groups[0].style.shape, MarkShape::circle) << "the arrival matters most";
      EXPECT_NE(groups[0].others.find("replan"), std::string::npos) << groups[0].others;
    }
  }
  // What is set up before the first expansion takes a narrow stretch; every place of the strip is some event's.
  const TimelineScale scale = timeline_scale(look, run(), 0, 400);
  EXPECT_LE(scale.narrow, look.px(10));
  for (std::size_t event = 0; event <= scale.size; event += 7)
    EXPECT_NEAR(static_cast<double>(scale.position(scale.x(event))), static_cast<double>(event),
                static_cast<double>(scale.size) / 400)
        << event;
  // With room enough every mark stands alone, and leads behind its event.
  const std::vector<MarkGroup> all = happenings(look, run(), {0, 1e6f, run().timeline().size()});
  for (const MarkGroup& group : all) EXPECT_EQ(group.others, "");
  EXPECT_EQ(run().timeline().event(all.front().position - 1).kind, EventKind::plan_begin);
}

}  // namespace
}  // namespace replan::ui::debugger_test
