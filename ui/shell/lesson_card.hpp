// The lesson that is under way, as a strip over the canvas: a step's sentences, and Back, Skip, Do it for me.
#pragma once

#include <optional>
#include <string_view>

#include "core/lesson/lesson_player.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

class LessonCard {
 public:
  void begin(Lesson lesson);
  void close() { player_.reset(); }
  [[nodiscard]] bool open() const { return player_.has_value(); }
  /// Whether the open lesson is about this world, or what was made of it.
  [[nodiscard]] bool is_about(const Scenario& scenario) const {
    return player_->lesson().scenario.name == scenario.name;
  }
  /// The lesson that is open; there must be one.
  [[nodiscard]] const LessonPlayer& player() const { return *player_; }

  /// What the learner has given, by its name.
  void note(std::string_view name);
  /// Looks whether the step is done now, and goes on if it was skipped. True if either has just come about.
  bool look(const Session& session);

  /// How high it is where it is that wide, in pixels: the same for all steps of a lesson, so that the world below stays
  /// where it is. There must be a lesson.
  [[nodiscard]] float height(const Look& look, float width) const;
  /// In the current ImGui window; there must be a lesson.
  void draw(Frame& frame);
  /// What a step begins with: its cell is pinned, and no tool is in hand that was taken for something else. Once a
  /// frame, behind the canvas, which forgets what was pinned in another world.
  void enter_step(Frame& frame);

 private:
  void draw_head(Frame& frame);
  void go_back(Frame& frame);
  void draw_buttons(Frame& frame);
  void draw_way_on(Frame& frame);
  bool do_it(Frame& frame);
  void skip(Frame& frame);

  std::optional<LessonPlayer> player_;
  /// A position of the leading log, as that was.
  struct Moment {
    std::uint64_t log_id = 0;
    std::size_t position = 0;
  };
  std::vector<Moment> began_;         // where each step began that was come to
  std::optional<std::size_t> shown_;  // the step that was entered
  bool skipping_ = false;             // the step is being done, and then left
  bool closing_ = false;
};

/// The lessons that there are, in their order, read once. What cannot be read is told in the Log.
const std::vector<Lesson>& lessons_of(PanelState& panels);
/// Asks for a lesson; `wish` and `panels` are a frame's.
void wish_for_lesson(Wish& wish, PanelState& panels, const std::string& id);
/// As a menu of its own.
void draw_lesson_menu(Frame& frame);

}  // namespace replan::ui
