// The Log tab: what happened in the run; what was done in this session and went wrong; and all edits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// What happened in a run, but for the robot's moves.
class RunStory {
 public:
  /// Takes over what the run has come to since.
  void follow(const Run& run);
  /// Which of its milestones.
  [[nodiscard]] std::span<const std::size_t> milestones() const { return milestones_; }

 private:
  std::uint64_t log_id_ = 0;
  std::size_t read_ = 0;  // milestones of the run
  std::vector<std::size_t> milestones_;
};

class LogTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  void show_edits() { part_ = Part::edits; }

 private:
  enum class Part : std::uint8_t { run, session, edits };

  void draw_story(Frame& frame);
  void draw_lines(Frame& frame);

  Part part_ = Part::run;
  RunStory story_;
  RowScroll story_rows_;
  std::size_t lines_ = 0;  // how many of the session's it showed: it follows their end
};

/// Shows the tab with all edits.
void show_edits(ViewState& view, PanelState& panels);

}  // namespace replan::ui
