// The Figures tab: what the first plans are worth, what all plans cost and how the robots drove, a column per pane, with
// ratios to the first and the best of each row marked where the panes can be compared.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/background.hpp"
#include "core/plan/figures.hpp"
#include "core/study/figures_table.hpp"
#include "ui/shell/frame.hpp"
#include "ui/tabs/fitness_chart.hpp"
#include "ui/tabs/gain_chart.hpp"

namespace replan::ui {

class FiguresTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  /// How all panes stand at their cursors, waiting for what is being worked out.
  std::vector<RunReport> now(const Session& session, const ViewState& view);

 private:
  /// Path figures of one pane's first plan, kept until it is another. Those on a large map are worked out beside the
  /// window.
  struct Kept {
    std::shared_ptr<const Plan> plan;
    std::optional<PathFigures> figures;
    Background<PathFigures> job;

    explicit Kept(const WorkPlace& place) : job(place) {}
  };
  Kept& kept(const Session& session, std::size_t pane);
  [[nodiscard]] std::vector<RunReport> as_known(const Session& session, const ViewState& view);

  std::vector<std::unique_ptr<Kept>> kept_;
  void draw_fitness(Frame& frame);

  GainChart gains_;
  FitnessChart fitness_;
};

}  // namespace replan::ui
