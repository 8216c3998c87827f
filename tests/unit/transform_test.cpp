// Worlds turned, mirrored and given another size, with all that stands in them.
#include "core/world/transform.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <gtest/gtest.h>

namespace replan::transform_test {
namespace {

/// 5 x 3 with something of every kind in it.
Scenario furnished() {
  Scenario scenario;
  scenario.map = GridMap(5, 3);
  scenario.map.set({1, 0}, true);
  scenario.map.blocked[scenario.map.index({4, 2})] = kUnmapped;
  scenario.map_file = "five.map";
  scenario.start = {0, 0};
  scenario.goal = {4, 1};
  Surprise near;
  near.at.near = Cell{3, 1};
  near.at.within = 2;
  near.cells = {{{2, 0}, true}, {{1, 1}, false}};
  Surprise moves;
  moves.at.move = 4;
  moves.goal = Cell{2, 2};
  scenario.surprises = {near, moves};
  MovingObstacle mover;
  mover.way = {{1, 1}, {3, 1}};
  mover.width = 2;
  mover.height = 1;
  scenario.movers = {mover};
  scenario.view.camera = ViewSetup::Camera{1.5, 0.5, 20};
  return scenario;
}

TEST(Transform, ATurnCarriesEverythingAlong) {
  const Scenario left = turned(furnished(), Turn::left);
  EXPECT_EQ(left.map.width, 3);
  EXPECT_EQ(left.map.height, 5);
  EXPECT_TRUE(left.map.at({0, 3}));
  EXPECT_EQ(left.map.blocked[left.map.index({2, 0})], kUnmapped);
  EXPECT_EQ(left.start, (Cell{0, 4}));
  EXPECT_EQ(left.goal, (Cell{1, 0}));
  EXPECT_EQ(left.surprises[0].at.near, (Cell{1, 1}));
  EXPECT_EQ(left.surprises[0].cells, (std::vector<CellChange>{{{0, 2}, true}, {{1, 3}, false}}));
  EXPECT_EQ(left.surprises[1].goal, (Cell{2, 2}));
  EXPECT_TRUE(left.map_file.empty());
  // A box 2 x 1 lies on its end now; its upper left cell is another one.
  EXPECT_EQ(left.movers[0].width, 1);
  EXPECT_EQ(left.movers[0].height, 2);
  EXPECT_EQ(left.movers[0].way, (std::vector<Cell>{{1, 2}, {1, 0}}));
  EXPECT_DOUBLE_EQ(left.view.camera->x, 0.5);
  EXPECT_DOUBLE_EQ(left.view.camera->y, 3.5);
}

TEST(Transform, SurpriseCellsStayInTheOrderOfRows) {
  for (const Turn turn : {Turn::left, Turn::right, Turn::left_right, Turn::top_bottom}) {
    const auto cells = turned(furnished(), turn).surprises.front().cells;
    EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end(), [](const CellChange& a, const CellChange& b) {
      return std::pair(a.cell.y, a.cell.x) < std::pair(b.cell.y, b.cell.x);
    }));
  }
}

TEST(Transform, WhatIsTurnedBackIsAsItWas) {
  Scenario before = furnished();
  before.map_file.clear();
  EXPECT_EQ(turned(turned(before, Turn::left), Turn::right), before);
  EXPECT_EQ(turned(turned(before, Turn::right), Turn::left), before);
  EXPECT_EQ(turned(turned(before, Turn::top_bottom), Turn::top_bottom), before);
  before.movers[0].way = {{1, 1}, {2, 1}};  // the box does not reach over the edge
  EXPECT_EQ(turned(turned(before, Turn::left_right), Turn::left_right), before);
  Scenario round = before;
  for (int i = 0; i < 4; ++i) round = turned(round, Turn::right);
  EXPECT_EQ(round, before);
  EXPECT_EQ(turned(turned(before, Turn::left), Turn::left),
            turned(turned(before, Turn::left_right), Turn::top_bottom));
}

TEST(Transform, ATurnedRosMapKeepsItsPlace) {
  Scenario scenario = furnished();
  scenario.map.resolution = 0.5;
  scenario.map.origin = {10, 20, 0};
  const GridMap left = turned(scenario, Turn::left).map;
  EXPECT_DOUBLE_EQ(left.origin[0], 10);
  EXPECT_DOUBLE_EQ(left.origin[1], 21.5);
  EXPECT_DOUBLE_EQ(left.origin[2], -std::numbers::pi / 2);
  const GridMap right = turned(scenario, Turn::right).map;
  EXPECT_DOUBLE_EQ(right.origin[0], 12.5);
  EXPECT_DOUBLE_EQ(right.origin[1], 20);
}

TEST(Transform, AResizeKeepsWhatFits) {
  const Result<Resized> larger = resized(furnished(), {9, 5, Side::middle, Side::high, true});
  ASSERT_TRUE(larger.ok());
  const Scenario& scenario = larger->scenario;
  EXPECT_EQ(scenario.start, (Cell{2, 2}));
  EXPECT_EQ(scenario.goal, (Cell{6, 3}));
  EXPECT_TRUE(scenario.map.at({3, 2}) && scenario.map.at({0, 0}));
  EXPECT_FALSE(scenario.map.at({2, 2}));
  EXPECT_EQ(scenario.map.blocked[scenario.map.index({6, 4})], kUnmapped);
  EXPECT_EQ(scenario.surprises[0].cells[0].cell, (Cell{4, 2}));
  EXPECT_FALSE(larger->ends_moved);
  EXPECT_EQ(larger->cells_lost, 0u);
}

TEST(Transform, AResizeSaysWhatIsLost) {
  const Result<Resized> smaller = resized(furnished(), {1, 3, Side::low, Side::low, false});
  ASSERT_TRUE(smaller.ok());
  EXPECT_TRUE(smaller->ends_moved);
  EXPECT_EQ(smaller->scenario.goal, (Cell{0, 1}));
  EXPECT_EQ(smaller->cells_lost, 2u);
  EXPECT_EQ(smaller->surprises_lost, (std::vector<std::size_t>{0}));
  ASSERT_EQ(smaller->scenario.surprises.size(), 1u);
  EXPECT_EQ(smaller->scenario.surprises[0].goal, (Cell{0, 2}));
  for (const Cell corner : smaller->scenario.movers[0].way)
    EXPECT_TRUE(smaller->scenario.map.contains(corner));
}

TEST(Transform, AResizedRosMapKeepsItsPlace) {
  Scenario scenario = furnished();
  scenario.map.resolution = 2;
  scenario.map.origin = {1, 1, 0};
  const GridMap map = resized(scenario, {7, 4, Side::high, Side::low, false})->scenario.map;
  EXPECT_DOUBLE_EQ(map.origin[0], 1 - 2 * 2);
  EXPECT_DOUBLE_EQ(map.origin[1], 1 - 1 * 2);
}

TEST(Transform, ImpossibleSizesAreRefused) {
  for (const auto& [width, height] : {std::pair(0, 5), std::pair(5, -1), std::pair(100000, 100000)}) {
    const Result<Resized> result = resized(furnished(), {width, height, Side::low, Side::low, false});
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().find("give sides from 1"), std::string::npos) << result.error();
  }
}

TEST(Transform, TheLayersOfABoxAreTurnedAlike) {
  Scenario before;
  before.map = GridMap(4, 3, 2);
  before.map.set({1, 0, 0}, true);
  before.map.set({3, 2, 1}, true);
  before.start = {0, 0, 1};
  before.goal = {3, 1, 0};
  Surprise surprise;
  surprise.at.move = 1;
  surprise.cells = {{{2, 1, 0}, true}, {{0, 0, 1}, false}};
  before.surprises = {surprise};
  before.movers = {{.way = {{1, 1, 0}, {2, 0, 1}}, .depth = 2}};
  const Scenario left = turned(before, Turn::left);
  EXPECT_EQ(left.map.box(), Box(3, 4, 2));
  EXPECT_TRUE(left.map.at({0, 2, 0}) && left.map.at({2, 0, 1}));
  EXPECT_EQ(left.start, (Cell{0, 3, 1}));
  EXPECT_EQ(left.surprises[0].cells, (std::vector<CellChange>{{{1, 1, 0}, true}, {{0, 3, 1}, false}}));
  EXPECT_EQ(left.movers[0].way, (std::vector<Cell>{{1, 2, 0}, {0, 1, 1}}));
  EXPECT_EQ(turned(left, Turn::right), before);
  const Result<Resized> wider = resized(before, {5, 3, Side::high, Side::low, true, 2});
  ASSERT_TRUE(wider.ok()) << wider.error();
  EXPECT_EQ(wider->scenario.map.box(), Box(5, 3, 2));
  EXPECT_TRUE(wider->scenario.map.at({4, 2, 1}) && wider->scenario.map.at({0, 1, 1}));
  EXPECT_EQ(wider->scenario.start, (Cell{1, 0, 1}));
  EXPECT_EQ(wider->scenario.surprises[0].cells[1].cell, (Cell{1, 0, 1}));
  EXPECT_EQ(inversion(before.map, {}).size(), 24u);
}

TEST(Transform, AnInversionSparesWhatStandsThere) {
  const Scenario scenario = furnished();
  const std::vector<Cell> keep = {scenario.start, scenario.goal};
  const auto changes = inversion(scenario.map, keep);
  EXPECT_EQ(changes.size(), 13u);
  GridMap map = scenario.map;
  for (const CellChange& change : changes) {
    EXPECT_NE(map.at(change.cell), change.blocked);
    map.set(change.cell, change.blocked);
  }
  EXPECT_FALSE(map.at({1, 0}) || map.at({4, 2}) || map.at({0, 0}) || map.at({4, 1}));
  EXPECT_TRUE(map.at({2, 1}));
}

/// 3 x 4 x 5 with something of every kind in it.
Scenario furnished_in_space() {
  Scenario scenario;
  scenario.map = GridMap(3, 4, 5);
  for (NodeId node = 0; node < scenario.map.blocked.size(); node += 7) scenario.map.blocked[node] = kObstacle;
  scenario.map.blocked[scenario.map.index({2, 3, 4})] = kUnmapped;
  scenario.start = {1, 0, 0};
  scenario.goal = {2, 1, 4};
  Surprise surprise;
  surprise.at.near = Cell{0, 2, 3};
  surprise.cells = {{{2, 0, 1}, true}, {{1, 1, 3}, false}};
  scenario.surprises = {surprise};
  scenario.movers = {{.way = {{0, 1, 2}, {1, 2, 2}}, .width = 2, .height = 1, .depth = 3}};
  return scenario;
}

constexpr Turn kTurns[] = {Turn::left,        Turn::right,       Turn::left_right,
                           Turn::top_bottom,  Turn::upside_down, Turn::tip_back,
                           Turn::tip_forward, Turn::tip_left,    Turn::tip_right};

/// The turn that takes one back.
Turn opposite(Turn turn) {
  switch (turn) {
    case Turn::left:
      return Turn::right;
    case Turn::right:
      return Turn::left;
    case Turn::tip_back:
      return Turn::tip_forward;
    case Turn::tip_forward:
      return Turn::tip_back;
    case Turn::tip_left:
      return Turn::tip_right;
    case Turn::tip_right:
      return Turn::tip_left;
    default:
      return turn;
  }
}

TEST(Transform, AWorldOfLayersIsTurnedBackToWhatItWas) {
  const Scenario before = furnished_in_space();
  for (const Turn turn : kTurns) {
    const Scenario after = turned(before, turn);
    EXPECT_NE(after, before);
    EXPECT_EQ(turned(after, opposite(turn)), before) << static_cast<int>(turn);
    if (opposite(turn) == turn) continue;
    Scenario round = before;
    for (int i = 0; i < 4; ++i) round = turned(round, turn);
    EXPECT_EQ(round, before) << static_cast<int>(turn);
  }
}

/// Every cell of the world, of a surprise and of a moving obstacle's body comes to lie where `turned` says.
TEST(Transform, EverythingOfAWorldOfLayersGoesTheSameWay) {
  const Scenario before = furnished_in_space();
  const Box box = before.map.box();
  const auto body = [](const MovingObstacle& mover, std::size_t corner) {
    const Cell low = mover.way[corner];
    return CellBox{low, {low.x + mover.width - 1, low.y + mover.height - 1, low.z + mover.depth - 1}};
  };
  for (const Turn turn : kTurns) {
    const Scenario after = turned(before, turn);
    for (NodeId node = 0; node < box.node_count(); ++node)
      ASSERT_EQ(before.map.blocked[node],
                after.map.blocked[after.map.index(turned(box.position(node), box, turn))]);
    EXPECT_EQ(after.start, turned(before.start, box, turn));
    EXPECT_EQ(after.goal, turned(before.goal, box, turn));
    EXPECT_EQ(after.surprises[0].at.near, turned(*before.surprises[0].at.near, box, turn));
    EXPECT_EQ(after.surprises[0].cells.size(), 2u);
    for (std::size_t corner = 0; corner < 2; ++corner) {
      const CellBox was = body(before.movers[0], corner), is = body(after.movers[0], corner);
      EXPECT_EQ(is, box_of(turned(was.low, box, turn), turned(was.high, box, turn)));
    }
  }
}

/// What is on top, at z = 4, comes to the side that the turn is named for.
TEST(Transform, TippingGoesWhereItSays) {
  const Box box(3, 4, 5);
  EXPECT_EQ(turned({1, 2, 4}, box, Turn::tip_back).y, 0);
  EXPECT_EQ(turned({1, 2, 4}, box, Turn::tip_forward).y, 4);
  EXPECT_EQ(turned({1, 2, 4}, box, Turn::tip_left).x, 0);
  EXPECT_EQ(turned({1, 2, 4}, box, Turn::tip_right).x, 4);
  EXPECT_EQ(turned({1, 2, 4}, box, Turn::upside_down), (Cell{1, 2, 0}));
  const GridMap tipped = turned(furnished_in_space(), Turn::tip_back).map;
  EXPECT_EQ(tipped.box(), Box(3, 5, 4));
}

TEST(Transform, AFrameIsKeptUnlessTheWorldIsTipped) {
  Scenario before = furnished_in_space();
  before.map.resolution = 0.5;
  before.map.origin = {10, 20, 1};
  for (const Turn turn : kTurns) {
    const GridMap map = turned(before, turn).map;
    EXPECT_EQ(map.resolution, 0.5);
    if (map.depth != before.map.depth)
      EXPECT_EQ(map.origin, (std::array<double, 3>{})) << static_cast<int>(turn);
    else if (turn == Turn::left || turn == Turn::right)
      EXPECT_NE(map.origin, before.map.origin) << static_cast<int>(turn);
    else
      EXPECT_EQ(map.origin, before.map.origin) << static_cast<int>(turn);
  }
}

TEST(Transform, AMovingObstacleIsNoHigherThanItsWorld) {
  const auto read_again = [](Scenario scenario) {
    scenario.planners = {{"astar", {}}};
    const auto again = parse_scenario(scenario_text(scenario), "s.json", ".");
    EXPECT_TRUE(again.ok()) << again.error();
    return again.ok() ? again->movers : std::vector<MovingObstacle>{};
  };
  const auto plane = resized(furnished_in_space(), {.width = 3, .height = 4, .up = Side::middle});
  ASSERT_TRUE(plane.ok()) << plane.error();
  EXPECT_EQ(plane->scenario.movers[0].depth, 1);
  EXPECT_EQ(read_again(plane->scenario), plane->scenario.movers);
  const auto lower = resized(furnished_in_space(), {.width = 3, .height = 4, .depth = 2});
  EXPECT_EQ(lower->scenario.movers[0].depth, 2);
  EXPECT_EQ(read_again(lower->scenario), lower->scenario.movers);
  Scenario wall;  // one cell thick, and what moves beside it two
  wall.map = GridMap(5, 1, 4);
  wall.goal = {4, 0, 0};
  wall.movers = {{.way = {{1, 0, 1}, {3, 0, 1}}, .width = 1, .height = 2, .depth = 3}};
  const Scenario tipped = turned(wall, Turn::tip_back);
  EXPECT_EQ(tipped.map.box(), Box(5, 4, 1));
  EXPECT_EQ(tipped.movers[0].height, 3);
  EXPECT_EQ(tipped.movers[0].depth, 1);
  EXPECT_EQ(read_again(tipped), tipped.movers);
}

TEST(Transform, LayersAreAddedAndCutOffWhereOneWants) {
  const Scenario before = furnished_in_space();
  const auto higher =
      resized(before, {.width = 3, .height = 4, .blocked = true, .depth = 8, .up = Side::high});
  ASSERT_TRUE(higher.ok());
  EXPECT_EQ(higher->scenario.map.box(), Box(3, 4, 8));
  EXPECT_EQ(higher->scenario.start, (Cell{1, 0, 3}));
  EXPECT_TRUE(higher->scenario.map.at({1, 0, 2}));
  for (NodeId node = 0; node < before.map.blocked.size(); ++node) {
    const Cell cell = before.map.box().position(node);
    ASSERT_EQ(before.map.blocked[node],
              higher->scenario.map.blocked[higher->scenario.map.index({cell.x, cell.y, cell.z + 3})]);
  }
  EXPECT_EQ(higher->scenario.surprises[0].cells[0].cell, (Cell{2, 0, 4}));
  const auto back = resized(higher->scenario, {.width = 3, .height = 4, .depth = 5, .up = Side::high});
  EXPECT_EQ(back->scenario, before);
  const auto lowest = resized(before, {.width = 3, .height = 4, .depth = 2});
  EXPECT_EQ(lowest->scenario.goal, (Cell{2, 1, 1}));
  EXPECT_TRUE(lowest->ends_moved);
  EXPECT_EQ(lowest->cells_lost, 1u);
  const auto plane = resized(before, {.width = 3, .height = 4, .up = Side::middle});
  EXPECT_EQ(plane->scenario.map.box(), Box(3, 4, 1));
  EXPECT_EQ(plane->scenario.map.at({0, 0}), before.map.at({0, 0, 2}));
  EXPECT_EQ(resized(before, {.width = 3, .height = 4, .depth = 0}).error(),
            "a world cannot have 3 x 4 x 0 cells: give sides from 1 and at most 67108864 cells in all");
  EXPECT_FALSE(resized(before, {.width = 1000, .height = 1000, .depth = 1000}).ok());
}

}  // namespace
}  // namespace replan::transform_test
