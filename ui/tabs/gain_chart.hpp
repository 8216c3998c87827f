// How the best path of planners that draw samples becomes shorter, over the samples of a plan, as a small chart.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/background.hpp"
#include "core/debug/path_gains.hpp"
#include "ui/shell/frame.hpp"
#include "ui/tabs/cost_chart.hpp"

namespace replan::ui {

/// Whether there is anything to show: a pane whose planner draws samples.
bool has_gains(const Session& session);
/// The pane whose curve is the strong one: the leading one, or the first one that draws samples where that does not.
std::size_t gains_pane(const Session& session);

/// The plan that each pane's cursor stands in.
class GainChart {
 public:
  /// Draws the curve of every pane that draws samples with its key, that of gains_pane() strong, its first path and the shortest of all marked, over the
  /// width that is left. A click goes to the gain.
  void draw(Frame& frame, float height);

 private:
  /// One pane's plan: its events, and what happened in them.
  struct Curve {
    std::uint64_t log_id = 0;
    std::size_t begin = 0, end = 0;
    PathGains read;
    std::int64_t samples = 0;
    [[nodiscard]] std::span<const PathGain> gains() const { return read.gains(); }
  };
  /// What the leading pane's plan could come to at best, kept until it is another plan.
  struct Optimum {
    std::uint64_t log_id = 0;
    std::size_t begin = 0, at = 0;  // of the plan, and where its state was asked
    bool has_ends = false;          // a start and a goal, there
    std::optional<double> length;
    Background<std::optional<double>> job;

    explicit Optimum(const WorkPlace& place) : job(place) {}
  };
  const Curve& curve_of(Frame& frame, std::size_t pane);
  std::optional<double> optimum_of(Frame& frame, const Run& run, const Curve& curve);
  std::vector<CurveKey> draw_curves(const Frame& frame, CostChart& chart,
                                    std::optional<double> optimum) const;
  void tell_gain(Frame& frame, const CostChart& chart, std::optional<double> optimum);
  void begin_optimum(const Frame& frame, const Run& run, const Curve& curve, std::size_t at);

  std::vector<Curve> curves_;
  std::unique_ptr<Optimum> optimum_;
};

}  // namespace replan::ui
