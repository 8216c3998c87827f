// Pictures of the demo world against golden ones. REPLAN_UPDATE_GOLDEN=1 writes them anew: look at them then.
#include <algorithm>
#include <filesystem>

#include "core/base/file.hpp"
#include "tests/ui/golden_picture.hpp"

namespace replan::app::render_test {
namespace {

namespace fs = std::filesystem;

RenderRequest demo(const std::string& theme) {
  auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/demo.json");
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error());
  RenderRequest request;
  if (scenario.ok()) request.scenario = *scenario;
  request.width = 640;
  request.height = 480;
  request.theme = theme;
  return request;
}

/// Where the n-th plan of the demo stands, `back` events before its end.
std::size_t plan_end(const RenderRequest& request, int n) {
  Session session(request.scenario);
  EXPECT_TRUE(session.apply(RunToEnd{}).ok());
  for (const auto& run : session.runs()) run->finish(Target::end());
  for (const Milestone& milestone : session.run().milestones())
    if (milestone.kind == EventKind::plan_end && n-- == 0) return milestone.event + 1;
  return session.run().timeline().size();
}

class RenderGolden : public testing::TestWithParam<const char*> {};

TEST_P(RenderGolden, PlanStands) {
  compare_with_golden(demo(GetParam()), std::string("demo_plan_") + GetParam());
}

TEST_P(RenderGolden, MidSearch) {
  RenderRequest request = demo(GetParam());
  request.at = plan_end(request, 0) / 2;
  OverlaySet overlays = default_overlays();
  for (const Overlay overlay : {Overlay::queue, Overlay::consistency, Overlay::sight})
    overlays.set(overlay, true);
  request.overlays = overlays;
  compare_with_golden(request, std::string("demo_search_") + GetParam());
}

TEST_P(RenderGolden, AfterTheSurprise) {
  RenderRequest request = demo(GetParam());
  request.at = plan_end(request, 1);
  compare_with_golden(request, std::string("demo_repair_") + GetParam());
}

TEST_P(RenderGolden, Numbers) {
  RenderRequest request = demo(GetParam());
  request.at = plan_end(request, 1);
  OverlaySet overlays = default_overlays();
  overlays.set(Overlay::numbers, true);
  request.overlays = overlays;
  request.scenario.view.camera = ViewSetup::Camera{14, 24, 80};
  compare_with_golden(request, std::string("demo_numbers_") + GetParam());
}

TEST_P(RenderGolden, Arrival) {
  RenderRequest request = demo(GetParam());
  request.at = Moment::end;
  compare_with_golden(request, std::string("demo_arrival_") + GetParam());
}

/// The same from outside, cut at a slice that stands upright.
TEST_P(RenderGolden, BoxFromOutside) {
  RenderRequest request = demo(GetParam());
  auto decks = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/decks.json");
  ASSERT_TRUE(decks.ok()) << decks.error();
  request.scenario = *decks;
  request.slice = Slice{Axis::y, 12};
  request.orbit = Orbit{0.5, 0.6, 0, {}};
  request.cut = true;
  request.at = plan_end(request, 1);
  compare_with_golden(request, std::string("decks_orbit_") + GetParam());
}

/// Into boxes of glass, with the curve of a path between them and the field on the slice.
TEST_P(RenderGolden, BoxesOfGlass) {
  RenderRequest request = demo(GetParam());
  auto auv = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/auv.json");
  ASSERT_TRUE(auv.ok()) << auv.error();
  request.scenario = *auv;
  request.scenario.planners.erase(request.scenario.planners.begin());
  request.slice = Slice{Axis::z, 5};
  request.orbit = Orbit{-0.6, 0.5, 0, {}};
  request.glass = true;
  request.at = "move:20";
  OverlaySet overlays;
  for (const Overlay overlay : {Overlay::g, Overlay::path, Overlay::spline, Overlay::trail, Overlay::sensor})
    overlays.set(overlay, true);
  request.overlays = overlays;
  compare_with_golden(request, std::string("auv_glass_") + GetParam());
}

/// From so near that cells are large, at twice the scale: lines keep their place before walls.
TEST_P(RenderGolden, BoxesFromNear) {
  RenderRequest request = demo(GetParam());
  auto auv = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/auv.json");
  ASSERT_TRUE(auv.ok()) << auv.error();
  request.scenario = *auv;
  request.slice = Slice{Axis::z, 5};
  request.orbit = Orbit{-0.9, 0.35, 14, {12, 8, 5}};
  request.scale = 2;
  request.at = "move:12";
  request.pinned = Cell{13, 8, 5};
  compare_with_golden(request, std::string("auv_near_") + GetParam());
}

/// The upper deck once the plan is repaired: the path rises into it, and what runs below is faint.
TEST_P(RenderGolden, SliceOfABox) {
  RenderRequest request = demo(GetParam());
  auto decks = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/decks.json");
  ASSERT_TRUE(decks.ok()) << decks.error();
  request.scenario = *decks;
  request.slice = Slice{Axis::z, 3};
  request.at = plan_end(request, 1);
  compare_with_golden(request, std::string("decks_slice_") + GetParam());
}

/// The Drive tab before a box that is on no map, with an arc that runs into it clicked.
TEST_P(RenderGolden, WhyAnArc) {
  RenderRequest request = demo(GetParam());
  auto boxes = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/fusion-boxes.json");
  ASSERT_TRUE(boxes.ok()) << boxes.error();
  request.scenario = *boxes;
  request.window = true;
  request.width = 1280;
  request.height = 900;
  request.panes = 1;
  request.at = "move:52";
  request.camera = ViewSetup::Camera{7, 4, 46};
  request.motion = Twist{0.42, 0.15};
  request.actions = {"show_drive"};
  compare_with_golden(request, std::string("drive_why_") + GetParam());
}

/// A curve, its control polygon, and where it was pulled in beside a door.
TEST_P(RenderGolden, SplineWithAPullIn) {
  RenderRequest request = demo(GetParam());
  auto office = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/office.json");
  ASSERT_TRUE(office.ok()) << office.error();
  request.scenario = *office;
  Settings corners_only;
  corners_only.set("corners_only", 1);
  request.scenario.planners = {{.id = "astar", .settings = {}, .stages = {{"bspline", corners_only}}}};
  request.at = plan_end(request, 0);
  request.camera = ViewSetup::Camera{54, 29, 40};
  OverlaySet overlays;
  for (const Overlay overlay : {Overlay::path, Overlay::spline, Overlay::grid}) overlays.set(overlay, true);
  request.overlays = overlays;
  compare_with_golden(request, std::string("spline_") + GetParam());
}

INSTANTIATE_TEST_SUITE_P(Themes, RenderGolden, testing::Values("dark", "light"),
                         [](const auto& theme) { return std::string(theme.param); });

TEST(Render, TwiceTheSamePixels) {
  const test::TemporaryFolder folder;
  RenderRequest request = demo("dark");
  request.at = Moment::end;
  std::vector<ui::Image> pictures;
  for (const char* name : {"a.png", "b.png"}) {
    request.output = folder.file(name);
    ASSERT_TRUE(render(request).ok());
    auto picture = ui::read_image(request.output);
    ASSERT_TRUE(picture.ok());
    pictures.push_back(std::move(*picture));
  }
  EXPECT_EQ(pictures[0].rgba, pictures[1].rgba);
}

TEST(Render, SvgIsWritten) {
  const test::TemporaryFolder folder;
  RenderRequest request = demo("light");
  request.output = folder.file("still.svg");
  ASSERT_TRUE(render(request).ok());
  EXPECT_GT(fs::file_size(request.output), 2000u);
}

/// Of the pane that leads, and of one in 3D with a word that it is not what the pane shows.
TEST(Render, SvgShowsTheSliceOfItsPane) {
  const test::TemporaryFolder folder;
  auto decks = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/decks.json");
  ASSERT_TRUE(decks.ok()) << decks.error();
  Session session(*decks);
  session.settle();
  ui::ViewState state;
  state.slices.set_all({Axis::z, 1});
  state.slices.set(1, {Axis::z, 3}, ui::SlicePanes::alone);
  const auto drawing = [&](std::size_t pane) {
    EXPECT_TRUE(write_drawing(folder.file("pane.svg"), session.run(), state, pane, {300, 200}).ok());
    return *read_file(folder.file("pane.svg"));
  };
  const std::string first = drawing(0);
  EXPECT_NE(first, drawing(1));
  EXPECT_EQ(drawing_note(session.run(), state, 0), "");
  state.slices.set_orbits(0, true);
  EXPECT_EQ(drawing(0), first);
  EXPECT_NE(drawing_note(session.run(), state, 0).find("an .svg has no 3D"), std::string::npos);
  EXPECT_EQ(drawing_note(session.run(), state, 1), "");
}

/// A wall seen from the front, all of it as far away.
TEST(Render, WhatIsHighIsLighterInWorldsOfManyLayers) {
  const test::TemporaryFolder folder;
  const auto lighter_by = [&](int layers) {
    RenderRequest request;
    request.scenario.map = GridMap(layers, 20, layers);
    for (int z = 0; z < layers; ++z)
      for (int x = 0; x < layers; ++x) request.scenario.map.set({x, 10, z}, true);
    request.scenario.start = {0, 0, 0};
    request.scenario.goal = {layers - 1, 0, 0};
    request.scenario.planners = {{"astar", {}, {}}};
    request.width = request.height = 400;
    request.overlays = OverlaySet{};
    request.overlays->set(Overlay::unknown, true);
    request.orbit = Orbit{0, 0, 0, {}};
    request.legend = false;
    request.output = folder.file("front.png");
    const auto drawn = render(request);
    EXPECT_TRUE(drawn.ok()) << drawn.error();
    const auto picture = ui::read_image(request.output);
    const auto green = [&](int top) {
      int sum = 0;
      for (int y = top; y < top + 20; ++y)
        for (int x = 190; x < 210; ++x) sum += picture->rgba[static_cast<std::size_t>(y * 400 + x) * 4 + 1];
      return sum / 400;
    };
    return green(150) - green(250);
  };
  EXPECT_EQ(lighter_by(12), 0);
  EXPECT_GT(lighter_by(16), 5);
  EXPECT_GT(lighter_by(40), 5);
}

TEST(Render, AnActionOpensItsDialogFirst) {
  const test::TemporaryFolder folder;
  RenderRequest request = demo("dark");
  request.window = true;
  std::vector<ui::Image> pictures;
  for (const char* action : {"", "keys"}) {
    request.actions.clear();
    if (*action != '\0') request.actions.emplace_back(action);
    request.output = folder.file(std::string("with-") + action + ".png");
    const auto drawn = render(request);
    ASSERT_TRUE(drawn.ok()) << drawn.error();
    pictures.push_back(*ui::read_image(request.output));
  }
  EXPECT_NE(pictures[0].rgba, pictures[1].rgba);
  request.actions = {"kes"};
  EXPECT_NE(render(request).error().find("did you mean 'keys'?"), std::string::npos);
  request.actions = {"keys"};
  request.window = false;
  EXPECT_FALSE(render(request).ok()) << "a canvas has no dialogs";
}

std::vector<ui::Image> frames_in(const std::string& folder) {
  std::vector<fs::path> names(fs::directory_iterator(folder), {});
  std::sort(names.begin(), names.end());
  std::vector<ui::Image> frames;
  for (const fs::path& name : names) {
    auto frame = ui::read_image(name);
    EXPECT_TRUE(frame.ok()) << name;
    if (frame) frames.push_back(std::move(*frame));
  }
  return frames;
}

TEST(Render, AFilmHasTheSameFramesEachTime) {
  RenderRequest request = demo("light");
  request.window = true;
  request.film.speed = {FilmSpeed::Kind::move, 0};
  request.film.from = "move:8";
  request.film.to = "move:20";
  std::vector<std::vector<ui::Image>> films;
  for (int i = 0; i < 2; ++i) {
    const test::TemporaryFolder folder;
    request.output = folder.path();
    const auto drawn = render(request);
    ASSERT_TRUE(drawn.ok()) << drawn.error();
    films.push_back(frames_in(folder.path()));
  }
  ASSERT_GT(films[0].size(), 12u);
  ASSERT_EQ(films[0].size(), films[1].size());
  for (std::size_t i = 0; i < films[0].size(); ++i)
    EXPECT_TRUE(films[0][i].rgba == films[1][i].rgba) << "frame " << i;
  EXPECT_FALSE(films[0].front().rgba == films[0].back().rgba);
}

TEST(Render, AFolderHoldsTheLastFilmAlone) {
  const test::TemporaryFolder folder;
  RenderRequest request = demo("dark");
  request.width = request.height = 64;
  request.output = folder.path();
  request.film.speed = {FilmSpeed::Kind::move, 0};
  ASSERT_TRUE(render(request).ok());
  const std::size_t whole = frames_in(folder.path()).size();
  request.film.to = "plan";
  ASSERT_TRUE(render(request).ok());
  EXPECT_LT(frames_in(folder.path()).size(), whole);
}

TEST(Render, PanesShareTheCanvas) {
  const test::TemporaryFolder folder;
  RenderRequest request = demo("dark");
  std::vector<ui::Image> pictures;
  for (const std::size_t panes : {1u, 2u, 4u}) {
    request.panes = panes;
    request.output = folder.file("panes.png");
    ASSERT_TRUE(render(request).ok());
    auto picture = ui::read_image(request.output);
    ASSERT_TRUE(picture.ok());
    pictures.push_back(std::move(*picture));
  }
  EXPECT_FALSE(pictures[0].rgba == pictures[1].rgba);
  EXPECT_TRUE(pictures[1].rgba == pictures[2].rgba) << "the demo has two planners";
}

TEST(Render, MistakesAreNamed) {
  RenderRequest request = demo("dark");
  request.output = "/tmp/picture.bmp";
  EXPECT_FALSE(render(request).ok());
  request.output = "/tmp/picture.png";
  request.at = std::size_t{1} << 40;
  const auto beyond = render(request);
  ASSERT_FALSE(beyond.ok());
  EXPECT_NE(beyond.error().find("beyond"), std::string::npos);
  request.theme = "blue";
  EXPECT_FALSE(render(request).ok());
}

}  // namespace
}  // namespace replan::app::render_test
