// 'replan render' and the window's answer where there is no display.
#include <algorithm>
#include <filesystem>

#include "tests/cli/child.hpp"

namespace replan::test::render_test {
namespace {

constexpr const char* kScenario = R"({
  "replan": 1,
  "map": {"rows": ["......", "..@...", "......"]},
  "start": [0, 1], "goal": [5, 1],
  "planners": [{"id": "dld-star-lite"}]
})";

class Render : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string scenario_ = folder_.with("small.json", kScenario);
};

/// Width and height of a PNG, from its header.
std::pair<int, int> png_size(const std::string& bytes) {
  if (bytes.size() < 24 || !bytes.starts_with("\x89PNG")) return {0, 0};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(Render, stillHasTheSizeAskedForAndRepeats) {
  const std::string first = folder_.file("a.png"), second = folder_.file("b.png");
  for (const std::string& file : {first, second}) {
    const Outcome outcome =
        run_program({"render", scenario_, "-o", file, "--size", "320x240", "--at-end", "--canvas-only"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "no progress in a pipe";
  }
  EXPECT_EQ(png_size(whole_file(first)), std::pair(320, 240));
  EXPECT_TRUE(whole_file(first) == whole_file(second));
}

TEST_F(Render, pinCameraAndActionsChangeThePicture) {
  std::vector<std::string> pictures;
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--action", "show_cell"},
                                               {"--action", "show_cell", "--pin", "3,1"},
                                               {"--action", "check_laws,show_debug"},
                                               {"--action", "check_laws", "--action", "show_figures"},
                                               {"--camera", "3,1,60"}}) {
    const std::string file = folder_.file("picture.png");
    std::vector<std::string> arguments = {"render", scenario_, "-o", file, "--size", "800x600"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    pictures.push_back(whole_file(file));
  }
  std::sort(pictures.begin(), pictures.end());
  EXPECT_EQ(std::adjacent_find(pictures.begin(), pictures.end()), pictures.end());
}

TEST_F(Render, namesWhatIsWrongWithPinCameraAndAction) {
  const std::string file = folder_.file("picture.png");
  const auto complain = [&](const char* option, const char* value, std::vector<std::string> phrases) {
    expect_complaint({"render", scenario_, "-o", file, option, value}, std::move(phrases));
  };
  complain("--pin", "6,1", {"--pin 6,1", "outside", "6 x 3"});
  complain("--pin", "here", {"--pin", "3,4"});
  complain("--camera", "3,1", {"--camera", "X,Y,ZOOM"});
  complain("--camera", "3,1,-5", {"--camera", "pixels per cell"});
  complain("--action", "show_cel", {"show_cell"});
  const Outcome list = run_program({"list", "actions"});
  EXPECT_NE(list.out.find("show_cell"), std::string::npos) << list.out;
}

TEST_F(Render, windowAndCanvasDiffer) {
  const std::string window = folder_.file("window.png"), canvas = folder_.file("canvas.png");
  EXPECT_EQ(run_program({"render", scenario_, "-o", window, "--size", "800x600"}).code, 0);
  EXPECT_EQ(run_program({"render", scenario_, "-o", canvas, "--size", "800x600", "--canvas-only"}).code, 0);
  EXPECT_EQ(png_size(whole_file(window)), std::pair(800, 600));
  EXPECT_TRUE(whole_file(window) != whole_file(canvas));
}

TEST_F(Render, momentThemeAndOverlaysChangeThePicture) {
  std::vector<std::string> pictures;
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--at-plan"},
                                               {"--at", "0"},
                                               {"--at-end"},
                                               {"--theme", "light"},
                                               {"--overlay", "path"}}) {
    std::vector<std::string> arguments = {"render", scenario_, "-o",           folder_.file("p.png"),
                                          "--size", "200x160", "--canvas-only"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    pictures.push_back(whole_file(folder_.file("p.png")));
  }
  std::sort(pictures.begin(), pictures.end());
  EXPECT_TRUE(std::adjacent_find(pictures.begin(), pictures.end()) == pictures.end());
}

TEST_F(Render, vectorDrawing) {
  EXPECT_EQ(run_program({"render", scenario_, "-o", folder_.file("x.svg")}).code, 0);
  EXPECT_NE(whole_file(folder_.file("x.svg")).find("<svg"), std::string::npos);
}

TEST_F(Render, framesAreNumbered) {
  const Outcome outcome =
      run_program({"render", scenario_, "-o", folder_.file("frames/"), "--size", "64x48", "--canvas-only"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.file("frames")))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  ASSERT_GT(names.size(), 10u);
  EXPECT_EQ(names.front(), "000000.png");
  EXPECT_EQ(names.size(), static_cast<std::size_t>(std::stoi(names.back())) + 1);
}

TEST_F(Render, badInput) {
  const std::string out = folder_.file("x.png");
  expect_complaint({"render", scenario_}, {"--output is required"});
  expect_complaint({"render", "-o", out}, {"give a scenario file"});
  expect_complaint({"render", scenario_, "-o", folder_.file("x.bmp")}, {"x.bmp", ".png", ".gif"});
  expect_complaint({"render", scenario_, "-o", folder_.file("no/such/x.png")}, {"x.png"});
  expect_complaint({"render", scenario_, "-o", out, "--size", "big"}, {"--size cannot be 'big'", "WxH"});
  expect_complaint({"render", scenario_, "-o", out, "--size", "4x4"}, {"16"});
  expect_complaint({"render", scenario_, "-o", out, "--scale", "x"}, {"--scale cannot be 'x'"});
  expect_complaint({"render", scenario_, "-o", out, "--scale", "nan"}, {"scale"});
  expect_complaint({"render", scenario_, "-o", out, "--at", "-1"}, {"no moment '-1'"});
  expect_complaint({"render", scenario_, "-o", out, "--at", "99999999"}, {"99999999"});
  expect_complaint({"render", scenario_, "-o", out, "--at", "1", "--at-end"}, {"only one of"});
  expect_complaint({"render", scenario_, "-o", out, "--theme", "blue"}, {"'blue'"});
  expect_complaint({"render", scenario_, "-o", out, "--overlay", "pth"}, {"did you mean 'path'?"});
}

TEST_F(Render, windowWithoutADisplaySaysHowToRender) {
  expect_complaint({}, {"display", "replan render"});
  expect_complaint({scenario_}, {"display", "replan render"});
}

}  // namespace
}  // namespace replan::test::render_test
