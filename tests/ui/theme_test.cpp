// Colours that must be told apart, worked out from the themes.
#include "ui/theme.hpp"

#include <array>
#include <cmath>

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

/// Of a colour in CIE L*a*b*.
std::array<double, 3> lab(ImU32 colour) {
  const auto linear = [colour](int shift) {
    const double v = static_cast<double>(colour >> shift & 255u) / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double r = linear(IM_COL32_R_SHIFT), g = linear(IM_COL32_G_SHIFT), b = linear(IM_COL32_B_SHIFT);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047),
               y = f(0.2126 * r + 0.7152 * g + 0.0722 * b),
               z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// How different two colours look (CIE 1976); 2.3 can just be seen.
double difference(ImU32 a, ImU32 b) {
  const auto p = lab(a), q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

TEST_P(Themes, TheFirstExpansionsStandApartFromTheGround) {
  for (const FieldColoursInfo& each : all_field_colours())
    EXPECT_GE(contrast(field_colours_over_free(theme_, each.colours).front(), theme_.free), 1.6f) << each.id;
}

TEST_P(Themes, EveryColourOfAFieldStandsApartFromGroundAndObstacles) {
  for (const FieldColoursInfo& each : all_field_colours())
    for (const ImU32 colour : field_colours_over_free(theme_, each.colours)) {
      EXPECT_GE(difference(colour, theme_.free), 9) << each.id;
      EXPECT_GE(difference(colour, theme_.obstacle), 9) << each.id;
    }
}

TEST_P(Themes, AColourMapRisesInLightness) {
  for (const FieldColoursInfo& each : all_field_colours()) {
    const Colormap map = field_colours_over_free(theme_, each.colours);
    for (std::size_t i = 16; i < map.size(); i += 8)
      EXPECT_GT(lab(map[i])[0], lab(map[i - 16])[0]) << each.id << " " << i;
    EXPECT_GT(lab(map.back())[0] - lab(map.front())[0], 20) << each.id;
  }
}

TEST(Colours, AreThoseOfThePublishedTables) {
  const auto near = [](FieldColours colours, std::size_t at, double r, double g, double b) {
    const ImU32 colour = published(colours)[at];
    EXPECT_NEAR(colour & 255u, r * 255, 2) << at;
    EXPECT_NEAR(colour >> 8 & 255u, g * 255, 2) << at;
    EXPECT_NEAR(colour >> 16 & 255u, b * 255, 2) << at;
  };
  near(FieldColours::cividis, 0, 0, 0.135112, 0.304751);
  near(FieldColours::cividis, 51, 0.208926, 0.272546, 0.424809);
  near(FieldColours::cividis, 127, 0.485141, 0.482451, 0.470384);
  near(FieldColours::cividis, 255, 0.995737, 0.909344, 0.217772);
  for (const FieldColoursInfo& each : all_field_colours())
    for (std::size_t i = 4; i < 256; ++i)
      EXPECT_GT(lab(published(each.colours)[i])[0], lab(published(each.colours)[i - 4])[0]) << each.id << i;
  near(FieldColours::viridis, 127, 0.127568, 0.566949, 0.550556);
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
  for (const FieldColoursInfo& each : all_field_colours()) {
    const Scene scene = build_scene(run, view, {900, 100}, scene_palette(theme_, each.colours));
    const Colormap legend = field_colours_over_free(theme_, each.colours);
    ASSERT_EQ(scene.raster.columns, 9);
    EXPECT_EQ(scene.raster.texels.back(), legend.front()) << "the goal has the least";
    EXPECT_EQ(scene.raster.texels.front(), legend.back());
    EXPECT_EQ(scene.raster.texels[4], legend[128]);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Themes, testing::Values("dark", "light"),
                         [](const auto& theme) { return std::string(theme.param); });

}  // namespace
}  // namespace replan::ui::theme_test
