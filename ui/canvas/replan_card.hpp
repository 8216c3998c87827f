// The card over the canvas after a replan: what made the robot plan again, and what the repair cost against
// a plan from scratch.
#pragma once

#include "core/scene/scene.hpp"
#include "core/session/fresh_plan.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// What a card tells. `fresh` comes later: it is worked out in the background.
struct ReplanReport {
  const PlannerInfo* info;
  RepairFigures repair;
  std::optional<FreshPlan> fresh;
  bool times = true;    ///< off in pictures, which are to be the same each time
  bool repairs = true;  ///< off where the planner begins from scratch each time
};

/// One sentence: "The robot saw 6 cells blocked and 2 free."
std::string cause_sentence(const ReplanCause& cause);

/// Whether a pane's card is whole or one line: whole for a while after each replan, where it hides little of the world,
/// and while the user wants it so; never by itself once the user has closed it.
class CardFold {
 public:
  /// The replan that the card tells of at a time, in seconds.
  void see(std::int64_t replan, double now);
  [[nodiscard]] bool whole(double now, bool roomy) const {
    return opened_ || (roomy && !closed_ && now < until_);
  }
  void open() {
    opened_ = true;
    closed_ = false;
  }
  void close() {
    opened_ = false;
    closed_ = true;
  }

 private:
  std::int64_t replan_ = 0;
  double until_ = 0;
  bool opened_ = false, closed_ = false;
};

/// What a click on a card asks for.
enum class CardAnswer : std::uint8_t { none, repair, close, open };

enum class CardForm : std::uint8_t {
  whole,
  line,        ///< the replan, what it touched, and what a plan from scratch does
  comparison,  ///< without the replan's number
  touched,     ///< without the plan from scratch
  least        ///< and without the replan's number
};

ImVec2 replan_card_size(const Look& look, const ReplanReport& report, CardForm form);

/// The card with its upper left corner at `pos`, in a window of its own: what is clicked on it is not clicked on the world
/// under it. Within the ID of its pane.
CardAnswer draw_replan_card(const Look& look, ImVec2 pos, const ReplanReport& report, CardForm form);

}  // namespace replan::ui
