// The Figures tab: what the plans that stand are worth and what they cost, a column per pane, with ratios to the first
// and the best of each row marked.
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
  /// Path figures of one pane, kept until another plan stands.
  struct Kept {
    std::shared_ptr<const Plan> plan;
    PathFigures figures;
  };
  const PathFigures& figures_of(const Run& run, std::size_t pane, const Decision& decision);

  std::vector<Kept> kept_;
};

}  // namespace replan::ui
