// What the window remembers: a file of this version, and those of older ones.
#include <gtest/gtest.h>

#include "app/gui_settings.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::app::settings_test {
namespace {

std::string tab_of(const std::string& json) {
  const test::TemporaryFolder folder;
  return read_settings(folder.with("window.json", json)).tab;
}

TEST(Settings, KeepATabByItsId) {
  const test::TemporaryFolder folder;
  Remembered settings;
  settings.tab = "figures";
  settings.brush = 7;
  settings.colours_so_far = true;
  settings.size_step = 3;
  settings.large_targets = true;
  settings.side_share = 0.5f;
  settings.metres = false;
  settings.minimap = false;
  settings.colours = ui::FieldColours::cividis;
  ASSERT_TRUE(write_settings(settings, folder.file("window.json")).ok());
  const Remembered read = read_settings(folder.file("window.json"));
  EXPECT_EQ(read.tab, "figures");
  EXPECT_EQ(read.brush, 7);
  EXPECT_TRUE(read.colours_so_far);
  EXPECT_EQ(read.size_step, 3);
  EXPECT_TRUE(read.large_targets);
  EXPECT_FLOAT_EQ(read.side_share, 0.5f);
  EXPECT_FALSE(read.metres);
  EXPECT_FALSE(read.minimap);
  EXPECT_EQ(read.colours, ui::FieldColours::cividis);
}

TEST(Settings, ReadATabsNumberOfOlderVersions) {
  EXPECT_EQ(tab_of(R"({"tab": 0})"), "planner");
  EXPECT_EQ(tab_of(R"({"tab": 6})"), "log");
  EXPECT_EQ(tab_of(R"({"tab": 7})"), "");
  EXPECT_EQ(tab_of(R"({"tab": true})"), "");
  EXPECT_EQ(tab_of("{}"), "");
}

TEST(Settings, ColoursThatThereAreNotAreTheUsualOnes) {
  const test::TemporaryFolder folder;
  for (const char* json : {R"({"colours": "jet"})", R"({"colours": 2})", "{}"})
    EXPECT_EQ(read_settings(folder.with("window.json", json)).colours, ui::FieldColours::viridis) << json;
}

TEST(Settings, ATabThatThereIsNotIsTheOneThatShowsAtFirst) {
  const auto at_first = [](std::string_view id) { return ui::tab_kinds()[ui::tab_number(id)].id; };
  EXPECT_EQ(at_first(""), "cell");
  EXPECT_EQ(at_first("gone"), "cell");
  EXPECT_EQ(at_first("log"), "log");
}

}  // namespace
}  // namespace replan::app::settings_test
