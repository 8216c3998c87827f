// Why the child that is in hand is as it is, in sentences.
#pragma once

#include <string>
#include <vector>

#include "core/debug/child_in_hand.hpp"

namespace replan {

/// One sentence for each thing that was decided so far: its mother, its father, where they were crossed, what mutation took
/// and why, and what became of it.
std::vector<std::string> child_words(const LogView& view, const ChildInHand& hand);

}  // namespace replan
