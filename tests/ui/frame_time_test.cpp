// No frame keeps the drawing thread for long, whatever is asked for and however large the world is.
#include <algorithm>
#include <ctime>
#include <set>
#include <string>

#include "core/base/random.hpp"
#include "core/world/ends.hpp"
#include "core/world/generators/list.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/shell/actions.hpp"

namespace replan::ui::frame_time_test {
namespace {

/// What a frame may take of the processor's time on its thread, without the drawing of its pixels.
constexpr double kMostMs = 100;

/// The processor's time, which is the same on a busy machine.
double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Scenario scenario_of(const std::string& spec) {
  Scenario scenario;
  scenario.map = generate_from_spec(spec).value();
  scenario.planners = {{"dld-star-lite", {}}};
  place_ends(scenario, {});
  return scenario;
}

class FrameTime : public ShellTest {
 protected:
  /// A window on it, whose commands wait for the background no longer than in the program.
  void look_at(Scenario scenario) {
    session_ = std::make_unique<Session>(std::move(scenario));
    session_->set_patience(std::chrono::milliseconds(8));
    auto offscreen = app::Offscreen::create({1280, 800, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    offscreen_->frame([this] { shell_ = std::make_unique<Shell>(offscreen_->stage().renderer()); });
    shell_->documents().settle_in(*session_, {{}, folder_.file("library"), {.in_step = false, .wake = {}}});
  }
  void frames_of(const std::string& what, int count) {
    for (int i = 0; i < count; ++i)
      offscreen_->frame([&] {
        const double before = thread_ms();
        session_->update(1.0 / 60);
        const double between = thread_ms();
        shell_->draw(offscreen_->stage().look(), *session_, 1.0 / 60);
        EXPECT_LT(thread_ms() - before, kMostMs)
            << what << " (after " << last_action_ << "), frame " << i << ": " << between - before
            << " ms of update, " << thread_ms() - between << " ms of drawing";
      });
  }
  void perform(const Action& action) {
    last_action_ = action.name;
    shell_->perform_next(action.id);
    frames_of(action.name, 3);
  }
  /// Carries out a command, and what comes of it, until nothing is at work any more but the search.
  void order(const std::string& what, const Command& command) {
    const double before = thread_ms();
    const auto done = session_->apply(command);
    EXPECT_LT(thread_ms() - before, kMostMs) << what << " as such";
    EXPECT_TRUE(done.ok()) << what << ": " << done.error();
    while (session_->editing_world()) frames_of(what + ", at work", 1);
    frames_of(what, 20);
    static_cast<void>(session_->apply(Cancel{}));
    frames_of(what + ", cancelled", 3);
  }
  /// Until the first plan stands.
  void plan() {
    frames_of("the beginning of the search", 20);
    while (session_->run().busy()) frames_of("the search", 1);
    frames_of("the end of the search", 2);
  }
  /// Actions of the table, in no order, with the mouse in between.
  void try_anything(int times) {
    Random random(1);
    for (int i = 0; i < times && !HasFailure(); ++i) {
      const Action& action = actions()[random.below(static_cast<std::uint32_t>(actions().size()))];
      if (std::string_view(action.name) != "quit") perform(action);
      if (random.chance(0.7)) use_the_mouse(random);
      if (random.chance(0.3)) press(key::kEscape);
    }
  }
  void use_the_mouse(Random& random) {
    InputQueue& input = offscreen_->stage().input();
    const auto move = [&] {
      input.mouse_move(static_cast<float>(random.between(60, 900)),
                       static_cast<float>(random.between(40, 680)));
    };
    move();
    frames_of("the mouse", 1);
    if (random.chance(0.3)) input.wheel(0, random.chance(0.6) ? 1 : -1);
    frames_of("the wheel", 4);
    if (!random.chance(0.4)) return;
    input.mouse_button(0, true);
    frames_of("a button", 1);
    if (random.chance(0.5)) move();
    frames_of("a drag", 2);
    input.mouse_button(0, false);
    frames_of("its end", 2);
  }

 private:
  std::string last_action_ = "nothing";
};

TEST_F(FrameTime, IsShortForStepsThroughAHugeSearch) {
  look_at(scenario_of("generator:caves?width=2048&height=2048&seed=3"));
  plan();
  for (const char* name : {"to_start", "step_forward", "step_forward", "step_back", "line_forward", "to_end",
                           "step_back", "line_back", "move_forward", "play", "play", "replan_back"})
    perform(*find_action(name));
}

TEST_F(FrameTime, IsShortForEditsOfAHugeWorld) {
  look_at(scenario_of("generator:caves?width=4096&height=4096&seed=3"));
  frames_of("the beginning", 20);
  order("stopping", Cancel{});
  for (const Turn turn : {Turn::left_right, Turn::top_bottom, Turn::left, Turn::right})
    order("a turn", TurnWorld{turn});
  order("undoing a turn", Undo{});
  order("redoing a turn", Redo{});
  order("another size", ResizeWorld{{4000, 4100, Side::middle, Side::middle, false}});
  order("inverting", InvertWorld{});
  order("undoing that", Undo{});
  order("clearing", ClearWorld{});
  order("another world", GenerateWorld{"maze", {}, 4095, 4095, 7});
  order("back to the beginning", GoToHistory{0});
  order("another planner", ChoosePlanner{0, "astar"});
  order("two panes", SetPanes{2});
}

TEST_F(FrameTime, IsShortForEveryActionInAHugeWorld) {
  look_at(scenario_of("generator:caves?width=4096&height=4096&seed=3"));
  frames_of("the beginning of the search", 60);
  static_cast<void>(session_->apply(Cancel{}));
  for (const Action& action : actions()) {
    if (std::string_view(action.name) == "quit") continue;
    perform(action);
    while (session_->editing_world()) frames_of(action.name + std::string(", at work"), 1);
    frames_of(action.name + std::string(", afterwards"), 10);
    press(key::kEscape);
    static_cast<void>(session_->apply(Cancel{}));
  }
}

TEST_F(FrameTime, IsShortForAnybodyWhoTriesEverythingInNoOrder) {
  look_at(*read_scenario(REPLAN_SOURCE_DIR "/maps/everything-at-once.json"));
  plan();
  try_anything(100);
}

TEST_F(FrameTime, IsShortForAnybodyInAHugeWorld) {
  look_at(scenario_of("generator:caves?width=4096&height=4096&seed=3"));
  frames_of("the beginning of the search", 60);
  try_anything(300);
}

}  // namespace
}  // namespace replan::ui::frame_time_test
