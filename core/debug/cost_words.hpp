// Costs of trees and populations, as what is offered and drawn has them.
#pragma once

#include <optional>
#include <string>

#include "core/debug/length_unit.hpp"

namespace replan {

/// A cost in cells that the best path could yet fall below, for a condition: a tenth less than it costs now, but no less than
/// half of what it has above `least`, the distance from the start to the goal, which no path is shorter than. Where it has
/// nothing above that, or before there is a path, a tenth above `least`: what a run from the beginning comes to.
std::string cost_to_fall_below(std::optional<double> best, double least);

/// "−0.4", "−0.4 m": what a rewiring saves, with as many decimals as it takes to be something, up to four.
std::string saving_text(const LengthUnit& lengths, Cost saves);

}  // namespace replan
