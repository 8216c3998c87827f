// No frame keeps the drawing thread for long, whatever is asked for and however large the world is.
#include <ctime>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/world/ends.hpp"
#include "core/world/generators/list.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/shell/actions.hpp"

namespace replan::ui::frame_time_test {
namespace {

/// What a frame may take of the processor's time on its thread, without the drawing of its pixels.
constexpr double kMostMs = 100;

/// What leads out of the window, or would end the test.
const std::set<std::string> kLeftOut = {"quit"};

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Somebody who tries everything, in no order.
class FrameTime : public ShellTest {
 protected:
  void open_world(const std::string& spec, std::vector<PlannerChoice> planners) {
    Scenario scenario;
    Result<GridMap> map = generate_from_spec(spec);
    ASSERT_TRUE(map.ok()) << map.error();
    scenario.map = std::move(*map);
    scenario.planners = std::move(planners);
    place_ends(scenario, {});
    session_ = std::make_unique<Session>(std::move(scenario));
    session_->set_patience(std::chrono::milliseconds(8));
    auto offscreen = app::Offscreen::create({1280, 800, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    offscreen_->frame([this] { shell_ = std::make_unique<Shell>(offscreen_->stage().renderer()); });
  }
  void frames_of(const std::string& what, int count) {
    for (int i = 0; i < count; ++i)
      offscreen_->frame([&] {
        const double before = thread_ms();
        session_->update(1.0 / 60);
        const double between = thread_ms();
        shell_->draw(offscreen_->stage().look(), *session_, 1.0 / 60);
        note(what + ", frame " + std::to_string(i), between - before, thread_ms() - between);
      });
  }
  void note(const std::string& what, double update, double draw) {
    ++frames_;
    if (update + draw > 16) ++slow_;
    slowest_.emplace_back(update + draw, what + ": " + std::to_string(update) + " ms of update, " +
                                             std::to_string(draw) + " ms of draw");
    std::sort(slowest_.rbegin(), slowest_.rend());
    if (slowest_.size() > 16) slowest_.pop_back();
  }
  void do_action(const Action& action) {
    shell_->perform_next(action.id);
    frames_of(action.name, 3);
    if (!ImGui::GetIO().WantTextInput) return;
    press(key::kEscape);
  }
  void use_the_mouse(Random& random) {
    InputQueue& input = offscreen_->stage().input();
    input.mouse_move(static_cast<float>(random.between(60, 900)), static_cast<float>(random.between(40, 680)));
    frames_of("mouse", 1);
    if (random.chance(0.3)) input.wheel(0, random.chance(0.6) ? 1 : -1);
    frames_of("wheel", 4);
    if (!random.chance(0.4)) return;
    input.mouse_button(0, true);
    frames_of("button", 1);
    if (random.chance(0.5))
      input.mouse_move(static_cast<float>(random.between(60, 900)), static_cast<float>(random.between(40, 680)));
    frames_of("drag", 2);
    input.mouse_button(0, false);
    frames_of("release", 2);
  }
  void use(std::uint64_t seed, int count) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
      const auto all = actions();
      const Action& action = all[random.below(static_cast<std::uint32_t>(all.size()))];
      if (!kLeftOut.contains(action.name)) do_action(action);
      if (random.chance(0.7)) use_the_mouse(random);
      if (random.chance(0.3)) press(key::kEscape);
    }
  }
  void report() const {
    std::printf("%d frames, %d of them over 16 ms; the slowest:\n", frames_, slow_);
    for (const auto& [ms, what] : slowest_) std::printf("%8.1f ms  %s\n", ms, what.c_str());
  }

  int frames_ = 0, slow_ = 0;
  std::vector<std::pair<double, std::string>> slowest_;
};

TEST_F(FrameTime, StaysShortInAHugeWorld) {
  const char* side = std::getenv("REPLAN_SIDE");
  const std::string n = side == nullptr ? "1024" : side;
  open_world("generator:caves?width=" + n + "&height=" + n + "&seed=3", {{"dld-star-lite", {}}});
  frames_of("planning", 20);
  while (session_->runs().front()->busy()) session_->update(0);
  report();
  std::printf("%zu events, %zu MB of log, %zu MB of frames\n", session_->run().timeline().size(), session_->run().timeline().log_bytes() >> 20, session_->run().timeline().frame_bytes() >> 20);
  for (const char* name : {"to_start", "step_forward", "step_forward", "step_back", "line_forward", "to_end", "step_back", "line_back", "move_forward", "play"})
    if (const Action* action = find_action(name)) do_action(*action);
  report();
  use(1, std::atoi(std::getenv("REPLAN_N")));
  report();
  EXPECT_LT(slowest_.front().first, kMostMs);
}

}  // namespace
}  // namespace replan::ui::frame_time_test
