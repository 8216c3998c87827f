// What stands in a cell, in words.
#pragma once

#include <string>

#include "core/session/run.hpp"

namespace replan::ui {

/// "obstacle · not seen yet"
std::string cell_words(const Run& run, Cell cell);

}  // namespace replan::ui
