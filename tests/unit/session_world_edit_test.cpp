// Edits of large worlds: worked out beside the session, in order with what is asked for meanwhile.
#include <thread>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "core/world/brush.hpp"
#include "core/world/generators/list.hpp"

namespace replan::session_world_edit_test {
namespace {

Scenario large_world() {
  Scenario scenario;
  scenario.map = generate_from_spec("generator:cells?width=700&height=500&seed=5").value();
  scenario.map.set({3, 4}, false);
  scenario.map.set({690, 480}, false);
  scenario.start = {3, 4};
  scenario.goal = {690, 480};
  scenario.planners = {{"astar", {}}};
  return scenario;
}

class LargeWorldEdit : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_GT(live_.scenario().map.box().node_count(), kLargeWorld);
    live_.set_patience(std::chrono::milliseconds(1));
  }
  void wait() {
    while (live_.editing_world()) {
      live_.update(0);
      std::this_thread::yield();
    }
  }
  /// The same for somebody who waits and for somebody who does not.
  void both(const Command& command) {
    EXPECT_TRUE(live_.apply(command).ok());
    EXPECT_TRUE(patient_.apply(command).ok());
  }

  Session live_{large_world()}, patient_{large_world()};
};

TEST_F(LargeWorldEdit, ComesToTheSameAsInStepWithWhatIsAskedForMeanwhile) {
  both(TurnWorld{Turn::left});
  EXPECT_TRUE(live_.editing_world());
  both(PaintCells{{{{17, 600}, true}, {{18, 600}, false}}, 1});
  both(ResizeWorld{{600, 710, Side::middle, Side::low, true}});
  both(InvertWorld{});
  EXPECT_EQ(live_.history_position(), 0u) << "nothing of it is done yet";
  wait();
  EXPECT_EQ(live_.scenario().map, patient_.scenario().map);
  EXPECT_EQ(live_.scenario().start, patient_.scenario().start);
  EXPECT_EQ(live_.history(), patient_.history());
  while (live_.history_position() > 0) ASSERT_TRUE(live_.apply(Undo{}).ok());
  EXPECT_EQ(live_.scenario().map, large_world().map);
}

/// Cell by cell, what a shape makes of the map.
GridMap with_shape(GridMap map, const std::vector<CellSpan>& spans, bool blocked, std::array<Cell, 2> ends) {
  for (const CellSpan& span : spans)
    for (int x = span.first; x <= span.last; ++x)
      if (!blocked || (Cell{x, span.y} != ends[0] && Cell{x, span.y} != ends[1]))
        map.set({x, span.y}, blocked);
  return map;
}

TEST_F(LargeWorldEdit, DrawsShapesOfVeryManyCellsInTheMap) {
  const Scenario before = large_world();
  const auto box = rectangle_spans({0, 0}, {699, 450});
  const PaintBoxes boxes{{{{0, 0}, {699, 450}}}, true};
  both(boxes);
  wait();
  EXPECT_EQ(live_.scenario().map, with_shape(before.map, box, true, {before.start, before.goal}));
  EXPECT_EQ(live_.scenario().map, patient_.scenario().map);
  EXPECT_TRUE(live_.undo_text().starts_with("paint ")) << live_.undo_text();

  const Scenario walled = live_.scenario();
  const auto is_wall = [&](Cell cell) { return walled.map.at(cell); };
  both(FillRegion{{0, 0}, false});
  wait();
  EXPECT_EQ(live_.scenario().map, with_shape(walled.map, connected_spans(700, 500, {0, 0}, is_wall), false,
                                             {before.start, before.goal}));
  EXPECT_EQ(live_.scenario().map, patient_.scenario().map);
  EXPECT_TRUE(live_.undo_text().starts_with("erase ")) << live_.undo_text();

  // What a tool or the clipboard gives cell by cell comes to the same.
  std::vector<CellChange> cells;
  for (const CellSpan& span : box)
    for (int x = span.first; x <= span.last; ++x) cells.push_back({{x, span.y}, true});
  ASSERT_TRUE(patient_.apply(PaintCells{cells, 3}).ok());
  ASSERT_TRUE(live_.apply(boxes).ok());
  wait();
  EXPECT_EQ(live_.scenario().map, patient_.scenario().map);
  while (live_.history_position() > 0) ASSERT_TRUE(live_.apply(Undo{}).ok());
  EXPECT_EQ(live_.scenario().map, before.map);
}

TEST_F(LargeWorldEdit, SaysWhatItCannotDraw) {
  const auto said = [&](const Command& command) {
    const auto done = patient_.apply(command);
    return done.ok() ? std::string("nothing") : done.error();
  };
  EXPECT_EQ(said(FillRegion{{700, 0}, true}), "a region to fill begins in the world");
  EXPECT_EQ(said(PaintBoxes{{{{0, -1}, {9, -1}}, {{800, 3}, {900, 3}}}, true}),
            "nothing was drawn: every cell of it is like that already");
  std::vector<CellChange> cells(kMostSurprised + 1, CellChange{{9, 9}, true});
  EXPECT_EQ(said(DropSurprise{cells}),
            "a surprise at once changes at most 262144 cells: draw a smaller one, or paint the map instead");
  cells.back().cell = {0, 500};
  EXPECT_EQ(said(PaintCells{cells}), "cell (0, 500) lies outside the world");
  EXPECT_EQ(patient_.history_position(), 0u);
}

TEST_F(LargeWorldEdit, IsGivenUpByCancelTogetherWithAllThatWaits) {
  ASSERT_TRUE(live_.apply(ClearWorld{}).ok());
  ASSERT_TRUE(live_.apply(SetStart{{0, 0}}).ok());
  ASSERT_TRUE(live_.apply(Cancel{}).ok());
  EXPECT_FALSE(live_.editing_world());
  live_.settle();
  EXPECT_EQ(live_.scenario().map, large_world().map);
  EXPECT_EQ(live_.scenario().start, large_world().start);
  EXPECT_EQ(live_.history_position(), 0u);
}

TEST_F(LargeWorldEdit, IsGivenUpByAnotherDocument) {
  Scenario other;
  other.map = GridMap(5, 5);
  other.goal = {4, 4};
  other.planners = {{"astar", {}}};
  ASSERT_TRUE(live_.apply(TurnWorld{Turn::right}).ok());
  ASSERT_TRUE(live_.apply(ReplaceScenario{other, "", 0, {}}).ok());
  live_.settle();
  EXPECT_EQ(live_.scenario().map, other.map);
  EXPECT_FALSE(live_.modified());
}

TEST_F(LargeWorldEdit, SaysOnceWhyItWasRefused) {
  ASSERT_TRUE(live_.apply(GenerateWorld{"maze", {}, 2, 300'000, 1}).ok());
  wait();
  const Session::Notice notice = live_.take_notice();
  EXPECT_TRUE(notice.bad);
  EXPECT_NE(notice.words, "");
  EXPECT_EQ(live_.take_notice().words, "");
  EXPECT_EQ(live_.scenario().map, large_world().map);
}

TEST_F(LargeWorldEdit, InvertsAllButTheEnds) {
  both(InvertWorld{});
  wait();
  const GridMap before = large_world().map;
  const GridMap& after = live_.scenario().map;
  for (NodeId node = 0; node < after.blocked.size(); ++node) {
    const Cell cell = after.box().position(node);
    const bool end = cell == live_.scenario().start || cell == live_.scenario().goal;
    ASSERT_EQ(after.at(cell), !end && !before.at(cell)) << cell.x << ", " << cell.y;
  }
}

}  // namespace
}  // namespace replan::session_world_edit_test
