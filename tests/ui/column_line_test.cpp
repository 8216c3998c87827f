// Lines of charts with more points than pixels.
#include "ui/widgets/column_line.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/base/random.hpp"

namespace replan::ui::column_line_test {
namespace {

std::vector<ImVec2> random_line(std::size_t count, float width) {
  Random random(5);
  std::vector<ImVec2> line;
  for (std::size_t i = 0; i < count; ++i)
    line.push_back(
        {width * static_cast<float>(i) / static_cast<float>(count), static_cast<float>(random.below(1000))});
  return line;
}

/// Least and greatest y by column.
std::map<int, std::pair<float, float>> reach(std::span<const ImVec2> line) {
  std::map<int, std::pair<float, float>> columns;
  for (const ImVec2& point : line) {
    auto& [least, greatest] =
        columns.try_emplace(static_cast<int>(std::floor(point.x)), point.y, point.y).first->second;
    least = std::min(least, point.y);
    greatest = std::max(greatest, point.y);
  }
  return columns;
}

TEST(ColumnLine, KeepsTheReachOfEachColumnAndNoMore) {
  const std::vector<ImVec2> line = random_line(50'000, 300), kept = column_line(line);
  EXPECT_LE(kept.size(), 600u);
  EXPECT_EQ(reach(kept), reach(line));
  EXPECT_TRUE(
      std::is_sorted(kept.begin(), kept.end(), [](const ImVec2& a, const ImVec2& b) { return a.x < b.x; }));
}

TEST(ColumnLine, ALineWithRoomForItsPointsIsAsItWas) {
  const std::vector<ImVec2> line = {{0, 3}, {1.5f, 2}, {4, 2}, {9, 7}};
  const std::vector<ImVec2> kept = column_line(line);
  ASSERT_EQ(kept.size(), line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_EQ(kept[i].x, line[i].x);
    EXPECT_EQ(kept[i].y, line[i].y);
  }
  EXPECT_TRUE(column_line({}).empty());
}

/// Indices are 16 bit: they must not come round to the corners of an earlier part.
TEST(ColumnLine, AVeryLongLineIsDrawnInPieces) {
  ImDrawListSharedData shared;
  ImDrawList list(&shared);
  list._ResetForNewFrame();
  list.Flags = ImDrawListFlags_AllowVtxOffset;
  draw_long_line(list, random_line(40'000, 40'000), IM_COL32_WHITE, 1);
  EXPECT_GT(list.VtxBuffer.Size, 1 << 16);
  std::set<int> columns;
  for (const ImDrawCmd& command : list.CmdBuffer)
    for (unsigned i = 0; i < command.ElemCount; ++i) {
      const int index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
      const ImVec2 corner = list.VtxBuffer[static_cast<int>(command.VtxOffset) + index].pos;
      columns.insert(static_cast<int>(std::lround(corner.x)));
    }
  EXPECT_GE(columns.size(), 39'999u);
}

}  // namespace
}  // namespace replan::ui::column_line_test
