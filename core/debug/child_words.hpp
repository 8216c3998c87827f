// Why the child that is in hand is as it is, in sentences.
#pragma once

#include <string>
#include <vector>

#include "core/debug/child_in_hand.hpp"
#include "core/debug/length_unit.hpp"

namespace replan {

/// One sentence for each thing that was decided so far: its mother, its father, where they were crossed, what mutation took
/// and why, and what became of it. Paths are named by their rank among those of the population, "#1" the fittest: their
/// numbers in the log are those of the room that they take, which others take after them.
std::vector<std::string> child_words(const LogView& view, const ChildInHand& hand, LengthUnit lengths = {});

}  // namespace replan
