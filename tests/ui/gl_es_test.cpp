// OpenGL ES 3.0 draws what OpenGL 3.3 core draws: its shaders without a display, and a window of its own on one.
#include <cstdlib>
#include <string>
#include <type_traits>

#if __has_include(<GLES3/gl3.h>)
#include <GLES3/gl3.h>
#endif

#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "app/platform/window.hpp"
#include "app/render.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/gl/shader.hpp"
#include "ui/image.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app::gl_es_test {
namespace {

#if __has_include(<GLES3/gl3.h>)
// The header of OpenGL ES 3.0 declares every function of the table.
#define REPLAN_IN_ES(type, name) static_assert(std::is_same_v<decltype(&gl##name), PFNGL##type##PROC>);
REPLAN_GL_FUNCTIONS(REPLAN_IN_ES)
#undef REPLAN_IN_ES
#endif

/// What the environment asks for, for the rest of a scope.
class AskedGl {
 public:
  explicit AskedGl(const char* name) { setenv("REPLAN_GL", name, 1); }
  ~AskedGl() { unsetenv("REPLAN_GL"); }
  AskedGl(const AskedGl&) = delete;
  AskedGl& operator=(const AskedGl&) = delete;
};

/// Grey levels by which pictures may differ: a driver may round otherwise.
constexpr int kFewLevels = 4;

void expect_alike(const ui::Image& core, const ui::Image& es, const std::string& what) {
  const ui::Difference difference = ui::compare(core, es, kFewLevels);
  EXPECT_TRUE(difference.same_size) << what;
  EXPECT_LT(difference.share, 0.0005) << what << ": max " << difference.max << ", mean " << difference.mean;
}

Scenario shipped(const std::string& name) {
  auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/" + name);
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error());
  return scenario.ok() ? *scenario : Scenario();
}

RenderRequest request_for(const std::string& world) {
  RenderRequest request;
  request.scenario = shipped(world);
  request.width = 640;
  request.height = 480;
  request.at = Moment::end;
  return request;
}

ui::Image drawn_by(const char* gl, RenderRequest request) {
  const AskedGl asked(gl);
  const test::TemporaryFolder folder;
  request.output = folder.file("picture.png");
  const auto drawn = render(request);
  EXPECT_TRUE(drawn.ok()) << drawn.error();
  auto picture = ui::read_image(request.output);
  EXPECT_TRUE(picture.ok());
  return picture.ok() ? std::move(*picture) : ui::Image();
}

void expect_same_picture(const RenderRequest& request, const std::string& what) {
  expect_alike(drawn_by("core", request), drawn_by("es", request), what);
}

TEST(GlEs, ShadersDrawAWindowOfThePlane) {
  RenderRequest request = request_for("demo.json");
  request.window = true;
  request.width = 1280;
  request.height = 800;
  expect_same_picture(request, "the demo");
}

/// Faces, small cubes, lines, the sheet of the slice and outlines: all shaders of worlds in space.
TEST(GlEs, ShadersDrawWorldsFromOutside) {
  RenderRequest request = request_for("decks.json");
  request.slice = Slice{Axis::y, 12};
  request.orbit = Orbit{0.5, 0.6, 0, {}};
  request.cut = true;
  expect_same_picture(request, "a cut");
  request = request_for("auv.json");
  request.at = "move:20";
  request.slice = Slice{Axis::z, 5};
  request.orbit = Orbit{-0.6, 0.5, 0, {}};
  request.pinned = Cell{13, 8, 5};
  expect_same_picture(request, "solid boxes");
  request.glass = true;
  expect_same_picture(request, "boxes of glass");
}

/// Else the pictures above would be drawn twice by the same shaders.
TEST(GlEs, ShadersAreThoseOfEs) {
  for (const char* gl : {"core", "es"}) {
    const AskedGl asked(gl);
    auto offscreen = Offscreen::create({16, 16, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    (*offscreen)->frame([&] {
      const ui::Gl& table = (*offscreen)->stage().renderer().gl();
      const auto built =
          ui::build_program(table, "void main() { gl_Position = vec4(0); }\n",
                            "layout(location = 0) out vec4 result;\n"
                            "void main() { float of_core_alone = 1; result = vec4(of_core_alone); }\n");
      EXPECT_EQ(built.ok(), std::string(gl) == "core");
      if (built) table.DeleteProgram(*built);
    });
  }
}

TEST(GlEs, AnotherNameIsRefused) {
  const AskedGl asked("vulkan");
  const auto offscreen = Offscreen::create({16, 16, 1});
  ASSERT_FALSE(offscreen.ok());
  EXPECT_NE(offscreen.error().find("REPLAN_GL is 'vulkan'; it must be"), std::string::npos)
      << offscreen.error();
}

/// What a window shows once everything is planned, in the plane or from outside.
ui::Image shown_by(const char* gl, const std::string& world, bool from_outside) {
  const AskedGl asked(gl);
  Session session(shipped(world));
  session.settle();
  ui::Image shown;
  auto window = Window::open({.width = 1000, .height = 700, .scale = 1});
  EXPECT_TRUE(window.ok()) << (window.ok() ? "" : window.error());
  if (!window) return shown;
  ui::Stage& stage = (*window)->stage();
  EXPECT_EQ(stage.renderer().gl().es, std::string(gl) == "es");
  ui::Shell shell(stage.renderer());
  for (std::size_t pane = 0; from_outside && pane < 4; ++pane) shell.view().slices.set_orbits(pane, true);
  (*window)->pace(0.01);
  int frames = 0;
  (*window)->run([&] {
    session.update(0);
    shell.draw(stage.look(), session, 0);
    if (++frames == 5) (*window)->capture([&](const ui::Image& picture) { shown = picture; });
    if (frames == 6) (*window)->close();
    return true;
  });
  return shown;
}

/// On the display that gl_es_test.sh makes: windows shall not open on anybody's desk.
TEST(GlEsWindow, ShowsTheSameFrames) {
  if (std::getenv("REPLAN_OWN_DISPLAY") == nullptr) GTEST_SKIP() << "gl_es_test.sh gives it a display";
  for (const char* world : {"demo.json", "decks.json"}) {
    const bool from_outside = std::string(world) == "decks.json";
    expect_alike(shown_by("core", world, from_outside), shown_by("es", world, from_outside), world);
  }
}

}  // namespace
}  // namespace replan::app::gl_es_test
