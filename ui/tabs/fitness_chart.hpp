// How the paths of a planner that breeds them become fitter, generation by generation, as a small chart.
#pragma once

#include <string>
#include <vector>

#include "core/debug/fitness_curve.hpp"
#include "ui/shell/frame.hpp"
#include "ui/tabs/cost_chart.hpp"

namespace replan::ui {

/// Whether there is anything to show: a pane whose planner breeds paths.
bool has_generations(const Session& session);

class FitnessChart {
 public:
  /// Draws what the leading pane's fittest path and all of them on average cost, and the fittest of the other panes, on a
  /// logarithmic scale over the width that is left. A click goes to the generation.
  void draw(Frame& frame, float height);
  /// The leading pane's as CSV.
  [[nodiscard]] std::string csv(const Session& session);

 private:
  /// A pane's, read on by at most `most` generations.
  const FitnessCurve& curve_of(const Run& run, std::size_t pane, std::size_t most);

  std::vector<CurveKey> draw_curves(const Frame& frame, CostChart& chart) const;

  std::vector<FitnessCurve> curves_;
};

}  // namespace replan::ui
