// How the paths of a planner that breeds them become fitter, generation by generation, as a small chart.
#pragma once

#include <string>
#include <vector>

#include "core/debug/fitness_curve.hpp"
#include "ui/shell/frame.hpp"

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
  struct Curve {
    std::uint64_t log_id = 0;
    std::size_t size = 0;  // of the log that was read
    std::vector<FitnessPoint> points;
  };
  const std::vector<FitnessPoint>& curve_of(const Run& run, std::size_t pane);

  std::vector<Curve> curves_;
};

}  // namespace replan::ui
