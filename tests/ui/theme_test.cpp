// Colours that must be told apart, worked out from the themes.
#include "ui/theme.hpp"

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/colormap.hpp"

namespace replan::ui::theme_test {
namespace {

class Themes : public testing::TestWithParam<const char*> {
 protected:
  const Theme& theme_ = theme_named(GetParam());
};

TEST_P(Themes, TheFirstExpansionsStandApartFromTheGround) {
  EXPECT_GE(contrast(field_colours_over_free(theme_).front(), theme_.free), 1.6f);
}

TEST_P(Themes, TheWorldStandsApartFromWhatIsAroundIt) {
  EXPECT_GE(contrast(theme_.free, theme_.surround), 1.15f);
  EXPECT_GE(contrast(theme_.obstacle, theme_.surround), 1.4f) << "its edge";
}

TEST_P(Themes, UnknownCellsLookLikeNeitherObstacleNorGround) {
  EXPECT_GE(contrast(theme_.unseen, theme_.obstacle), 1.4f);
  EXPECT_GE(contrast(theme_.unseen, theme_.free), 1.6f);
}

TEST_P(Themes, BothNumbersCanBeReadOnTheirGround) {
  EXPECT_GE(contrast(theme_.rhs, theme_.background), 4.0f);
  EXPECT_GE(contrast(theme_.text, theme_.background), 4.5f);
}

TEST_P(Themes, ALegendHasTheColoursOfTheMap) {
  Scenario scenario;
  scenario.map = GridMap(9, 1);
  scenario.start = {0, 0};
  scenario.goal = {8, 0};
  scenario.planners = {{"dstar-lite", {}}};
  replan::Run run(std::make_shared<const Scenario>(scenario), 0);
  run.finish(Target::plan());
  run.timeline().seek(run.timeline().size());
  View view;
  view.overlays = {};
  view.overlays.set(Overlay::g, true);
  const Scene scene = build_scene(run, view, {900, 100}, scene_palette(theme_));
  const Colormap legend = field_colours_over_free(theme_);
  ASSERT_EQ(scene.raster.columns, 9);
  EXPECT_EQ(scene.raster.texels.back(), legend.front()) << "the goal has the least";
  EXPECT_EQ(scene.raster.texels.front(), legend.back());
  EXPECT_EQ(scene.raster.texels[4], legend[128]);
}

INSTANTIATE_TEST_SUITE_P(All, Themes, testing::Values("dark", "light"),
                         [](const auto& theme) { return std::string(theme.param); });

}  // namespace
}  // namespace replan::ui::theme_test
