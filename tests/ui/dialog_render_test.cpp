// Pictures of every dialog and menu of the window against golden ones.
#include "tests/ui/golden_picture.hpp"
#include "ui/shell/gallery.hpp"

namespace replan::app::dialog_render_test {
namespace {

/// A window with little in it but the dialog: what else changes in the window shall not change these pictures.
RenderRequest with_dialog(const std::string& name) {
  RenderRequest request;
  request.scenario.name = "Field";
  request.scenario.map = GridMap(12, 8);
  request.scenario.start = {1, 4};
  request.scenario.goal = {10, 4};
  request.scenario.planners = {{.id = "dstar-lite", .settings = {}}};
  request.overlays = OverlaySet();
  request.legend = false;
  request.window = true;
  request.width = 1280;
  request.height = 800;
  request.theme = "dark";
  request.dialog = name;
  return request;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const std::string_view name : ui::gallery_names()) all.emplace_back(name);
  return all;
}

class DialogRenderGolden : public testing::TestWithParam<std::string> {};

TEST_P(DialogRenderGolden, Dark) {
  compare_with_golden(with_dialog(GetParam()), "dialog_" + GetParam() + "_dark");
}

INSTANTIATE_TEST_SUITE_P(All, DialogRenderGolden, testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

class DialogRenderGoldenToo : public testing::TestWithParam<std::string> {};

TEST_P(DialogRenderGoldenToo, Light) {
  RenderRequest request = with_dialog(GetParam());
  request.theme = "light";
  compare_with_golden(request, "dialog_" + GetParam() + "_light");
}

TEST_P(DialogRenderGoldenToo, InASmallWindow) {
  RenderRequest request = with_dialog(GetParam());
  request.width = 640;
  request.height = 480;
  compare_with_golden(request, "dialog_" + GetParam() + "_small");
}

TEST_P(DialogRenderGoldenToo, AtTwiceTheSize) {
  RenderRequest request = with_dialog(GetParam());
  request.width *= 2;
  request.height *= 2;
  request.scale = 2;
  compare_with_golden(request, "dialog_" + GetParam() + "_2x");
}

INSTANTIATE_TEST_SUITE_P(Some, DialogRenderGoldenToo,
                         testing::Values("film_window", "open", "keys", "unsaved", "menu_view", "batch",
                                         "batch_results"),
                         [](const auto& name) { return name.param; });

/// Of a world of several layers, of which these dialogs show more.
RenderRequest in_space(const std::string& name) {
  RenderRequest request = with_dialog(name);
  GridMap& map = request.scenario.map;
  map = GridMap(24, 16, 8);
  for (int z = 0; z < 6; ++z)
    for (int y = 2; y < 12 - z; ++y) map.set({8 + z, y, z}, true);
  request.scenario.start = {1, 8, 1};
  request.scenario.goal = {22, 8, 6};
  return request;
}

class DialogRenderGoldenInSpace : public testing::TestWithParam<std::string> {};

TEST_P(DialogRenderGoldenInSpace, Dark) {
  compare_with_golden(in_space(GetParam()), "dialog_" + GetParam() + "_space_dark");
}

TEST_P(DialogRenderGoldenInSpace, LightAndTwiceTheSize) {
  RenderRequest request = in_space(GetParam());
  request.theme = "light";
  request.width *= 2;
  request.height *= 2;
  request.scale = 2;
  compare_with_golden(request, "dialog_" + GetParam() + "_space_light_2x");
}

INSTANTIATE_TEST_SUITE_P(Worlds, DialogRenderGoldenInSpace, testing::Values("resize", "generate"),
                         [](const auto& name) { return name.param; });

TEST(DialogRender, AWrongNameShowsThoseThereAre) {
  RenderRequest request = with_dialog("abuot");
  request.output = "/tmp/never.png";
  const auto drawn = render(request);
  ASSERT_FALSE(drawn.ok());
  for (const std::string& name : names())
    EXPECT_NE(drawn.error().find(name), std::string::npos) << drawn.error();
  request.dialog = "about";
  request.window = false;
  EXPECT_FALSE(render(request).ok()) << "a canvas has no dialogs";
}

}  // namespace
}  // namespace replan::app::dialog_render_test
