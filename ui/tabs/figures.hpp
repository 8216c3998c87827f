// The Figures tab: what the first plans are worth, what all plans cost and how the robots drove, a column per pane, with
// ratios to the first and the best of each row marked where the panes can be compared.
#pragma once

#include <memory>
#include <vector>

#include "core/plan/figures.hpp"
#include "core/study/figures_table.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

class FiguresTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  /// How all panes stand at their cursors.
  std::vector<RunReport> now(const Session& session);

 private:
  /// Path figures of one pane's first plan, kept until it is another.
  struct Kept {
    std::shared_ptr<const Plan> plan;
    PathFigures figures;
  };
  const PathFigures& first_figures(const Run& run, std::size_t pane);

  std::vector<Kept> kept_;
};

}  // namespace replan::ui
