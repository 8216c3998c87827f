// What a replan kept of a tree or a population, in words.
#pragma once

#include <string>

#include "core/debug/kept.hpp"

namespace replan::ui {

/// "The tree kept 203 of its 240 vertices, and 37 were cut off."
std::string kept_sentence(const SearchValues& values, const KeptCounts& counts);
/// "203 kept, 37 cut off"
std::string kept_brief(const SearchValues& values, const KeptCounts& counts);

}  // namespace replan::ui
