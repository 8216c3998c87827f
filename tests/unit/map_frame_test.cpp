// Cells in the metres of a map's own frame, and back.
#include "core/world/map_frame.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/study/figures_table.hpp"

namespace replan {
namespace {

GridMap map_of(double resolution, std::array<double, 3> origin) {
  GridMap map(8, 4);
  map.resolution = resolution;
  map.origin = origin;
  return map;
}

TEST(MapFrame, HasItsOriginAtTheLowerLeftAndItsYUpwards) {
  const MapFrame frame(map_of(0.05, {-1, 2, 0}));
  EXPECT_TRUE(frame.metric());
  const Point corner = frame.to_metres({0, 4, 0});
  EXPECT_DOUBLE_EQ(corner.x, -1);
  EXPECT_DOUBLE_EQ(corner.y, 2);
  const Point top = frame.to_metres({8, 0, 0});
  EXPECT_DOUBLE_EQ(top.x, -0.6);
  EXPECT_DOUBLE_EQ(top.y, 2.2);
  EXPECT_DOUBLE_EQ(frame.metres(20), 1);
  EXPECT_EQ(metres_text(frame.to_metres(centre_of(Cell{0, 3}))), "(-0.975, 2.025) m");
}

TEST(MapFrame, IsTurnedByItsYaw) {
  const MapFrame frame(map_of(1, {10, 20, std::acos(-1.0) / 2}));
  const Point right = frame.to_metres({8, 4, 0}), up = frame.to_metres({0, 0, 0});
  EXPECT_NEAR(right.x, 10, 1e-12);
  EXPECT_NEAR(right.y, 28, 1e-12);
  EXPECT_NEAR(up.x, 6, 1e-12);
  EXPECT_NEAR(up.y, 20, 1e-12);
}

TEST(MapFrame, LeadsBackFromMetresToTheSameCell) {
  Random random(3);
  for (int i = 0; i < 10'000; ++i) {
    const auto between = [&](double low, double high) { return low + (high - low) * random.unit(); };
    const MapFrame frame(map_of(between(0.01, 2), {between(-100, 100), between(-100, 100), between(-4, 4)}));
    const Cell cell{static_cast<int>(random.below(8)), static_cast<int>(random.below(4))};
    EXPECT_EQ(cell_of(frame.to_cells(frame.to_metres(centre_of(cell)))).x, cell.x);
    EXPECT_EQ(cell_of(frame.to_cells(frame.to_metres(centre_of(cell)))).y, cell.y);
  }
}

TEST(MapFrame, IsNoFrameWhereTheMapSaysNothing) {
  EXPECT_FALSE(MapFrame(GridMap(8, 4)).metric());
  EXPECT_FALSE(metric_frame(GridMap(8, 4)));
  EXPECT_TRUE(metric_frame(map_of(1, {0, 3, 0})));
}

TEST(MapFrame, GivesTheFiguresOfItsRunsMetres) {
  RunReport report = plan_once(map_of(0.5, {}), {0, 0}, {7, 0}, {.id = "astar", .settings = {}});
  const auto row = [](const FiguresTable& table, std::string_view key) {
    return *std::find_if(table.rows.begin(), table.rows.end(),
                         [key](const FigureRow& each) { return each.info->key == key; });
  };
  const FigureRow length = row(figures_table(std::span(&report, 1)), "length");
  EXPECT_EQ(length.unit, "m");
  EXPECT_EQ(length.values[0], 3.5);
  const std::string json = runs_json(std::span(&report, 1)), csv = runs_csv(std::span(&report, 1));
  EXPECT_NE(json.find("\"length_m\": 3.5"), std::string::npos) << json;
  EXPECT_NE(json.find("\"path_m\""), std::string::npos);
  EXPECT_NE(csv.find(",length_m,min_clearance_m,mean_clearance_m,greatest_curvature_per_m\n"),
            std::string::npos)
      << csv;
  report.frame.reset();
  const FigureRow cells = row(figures_table(std::span(&report, 1)), "length");
  EXPECT_EQ(cells.unit, "cells");
  EXPECT_EQ(cells.values[0], 7);
  EXPECT_EQ(runs_csv(std::span(&report, 1)).find("length_m"), std::string::npos);
}

}  // namespace
}  // namespace replan
