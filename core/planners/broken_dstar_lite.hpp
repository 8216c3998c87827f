// D* Lite with a mistake in it, of the kinds that people make when they write it for the first time: an
// exercise for the debugger, and what shows in the tests that the debugger finds such mistakes.
//
// Koenig & Likhachev, "D* Lite", AAAI 2002, is not to blame. The sound planner is in dstar_lite.hpp.
#pragma once

#include "core/planners/dstar_lite.hpp"

namespace replan {

namespace parameters {

inline const Parameter kFault{
    .key = "fault",
    .label = "Mistake",
    .type = ParameterType::choice,
    .choices = {"forgotten-update", "greedy-parent", "key-without-km", "stale-queue"},
    .help =
        "What was done wrong: a raised vertex does not tell one of its neighbours, a vertex takes the first "
        "neighbour that leads on as its parent instead of the best one, keys are made without km, or a "
        "vertex "
        "that has become consistent stays in the open list."};

}  // namespace parameters

/// The mistakes, in the order of parameters::kFault.
class OneFault {
 public:
  static constexpr bool kAny = true;

  explicit OneFault(const Settings& settings)
      : which_(static_cast<Which>(static_cast<int>(settings.get(parameters::kFault)))) {}

  /// Line 60, for the predecessor that direction d leads to.
  [[nodiscard]] bool forgets_predecessor(int d) const { return which_ == Which::forgotten_update && d == 0; }
  /// Lines 20-22.
  [[nodiscard]] bool keeps_first_parent() const { return which_ == Which::greedy_parent; }
  /// Line 2.
  [[nodiscard]] bool forgets_km() const { return which_ == Which::key_without_km; }
  /// Line 28.
  [[nodiscard]] bool leaves_in_queue() const { return which_ == Which::stale_queue; }

 private:
  enum class Which : std::uint8_t { forgotten_update, greedy_parent, key_without_km, stale_queue };
  Which which_;
};

struct BrokenDStarLiteSwitches : DStarLiteSwitches {};

inline PlannerInfo describe(BrokenDStarLiteSwitches switches) {
  PlannerInfo info = describe(static_cast<DStarLiteSwitches>(switches));
  info.name = "D* Lite, broken";
  info.summary = "An exercise: D* Lite with a mistake in it. Find it with the debugger.";
  info.exercise = true;
  info.parameters.push_back(parameters::kFault);
  info.length_bound = [](const Settings&) { return std::numeric_limits<double>::infinity(); };
  return info;
}

template <Lattice L, Tracer T>
using BrokenDStarLite = DStarLite<L, T, OneFault>;

}  // namespace replan
