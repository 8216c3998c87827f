// How a planner's best path becomes shorter while it searches: against the samples that it has drawn, and against time.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/stop.hpp"
#include "core/plan/navigator.hpp"
#include "core/plan/planner.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// A shorter path than there was before, the first one too.
struct Gain {
  std::int64_t samples = 0;  ///< that were drawn by then
  double ms = 0;             ///< of wall time since the plan began
  double length = 0;         ///< of the best path from then on, in cells
};

/// What has ended a plan.
enum class AnytimeEnd : std::uint8_t {
  planner,  ///< its own rule: samples, or samples without a gain; or there was nothing to search
  time,     ///< the clock
  stopped,  ///< whoever asked
};

/// One plan.
struct AnytimeRun {
  std::string planner;  ///< registry id; of a second one of the same id, with other settings, "rrt-star#2"
  std::int64_t seed = 0;
  std::vector<Gain> gains;  ///< ascending in samples and time, falling in length; empty: no path was found
  std::int64_t samples = 0;
  double ms = 0;
  PlanStatus status = PlanStatus::searching;
  AnytimeEnd end = AnytimeEnd::planner;

  [[nodiscard]] bool found() const { return !gains.empty(); }
};

/// Milliseconds of wall time, from any moment on.
double wall_ms();

/// Plans once with a planner that betters its path as it goes (PlannerInfo::can_miss). `most_ms` ends it with the best path
/// by then: such a plan is another one each time, while samples repeat.
/// `clock` tells milliseconds: those of wall time, or of the thread (core/base/cpu_time.hpp).
AnytimeRun plan_anytime(const GridMap& map, Cell start, Cell goal, const PlannerChoice& choice, double radius,
                        double most_ms = std::numeric_limits<double>::infinity(), const StopToken& stop = {},
                        double (*clock)() = wall_ms);

/// How long the shortest of all ways is by the planner's corner rule; nothing where that is not known: in space, for a robot
/// with a size, without a way, or if it was asked to stop or took longer than `most_ms`.
std::optional<double> shortest_of_all(const Box& box, const SharedBytes& known, Cell start, Cell goal,
                                      const PlannerChoice& choice, double radius,
                                      double most_ms = std::numeric_limits<double>::infinity(),
                                      const StopToken& stop = {});
/// The same a slice at a time. Setting it up is the first one, as long as the map is large.
class ShortestSearch {
 public:
  ShortestSearch(const Box& box, const SharedBytes& known, Cell start, Cell goal, const PlannerChoice& choice,
                 double radius);

  /// One slice. What is known of the length, once that is clear.
  std::optional<std::optional<double>> advance();

 private:
  std::function<std::unique_ptr<Navigator>()> make_;  // nothing: nobody knows
  std::unique_ptr<Navigator> navigator_;
};

/// The planners in the order in which they come, with their plans.
std::vector<std::span<const AnytimeRun>> by_planner(std::span<const AnytimeRun> runs);

/// Which number of a gain a curve is drawn against.
enum class AnytimeAxis : std::uint8_t { samples, time };

/// A place of a curve that goes in steps: from `at` on, samples or milliseconds, the length.
struct CurvePoint {
  double at = 0, length = 0;
};
/// The median over plans of one planner (the lower one of an even number): from where half of them have a path.
std::vector<CurvePoint> median_curve(std::span<const AnytimeRun> runs, AnytimeAxis axis);

/// The median of what half of all come to; infinite where they do not.
double lower_median(std::vector<double> values);

/// A line for each gain, and one for each plan's end: planner, seed, samples, ms, length, end.
std::string anytime_csv(std::span<const AnytimeRun> runs);
/// Two diagrams side by side, over samples and over time, both logarithmic: each plan thin, each planner's median bold, its
/// first path marked; and a line for each optimum: there are several where the planners' corner rules differ.
std::string anytime_svg(std::span<const AnytimeRun> runs, std::span<const double> optima);

}  // namespace replan
