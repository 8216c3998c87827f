// The Drive tab: why a robot that drives takes the arc that it takes.
#pragma once

#include <optional>

#include "core/scene/arcs.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

class DriveTab final : public SideTab {
 public:
  void draw(Frame& frame) override;

 private:
  /// What the reasons were worked out for.
  struct Moment {
    std::uint64_t revision = 0, log_id = 0;
    std::size_t cursor = 0;
    friend bool operator==(const Moment&, const Moment&) = default;
  };

  void follow(const Frame& frame);

  std::optional<Moment> moment_;
  std::optional<DriveWhy> why_;
};

/// Shows the tab.
void show_drive(ViewState& view);

}  // namespace replan::ui
