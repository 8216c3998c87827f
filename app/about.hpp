// What the program is made of, for the dialog about it.
#pragma once

#include <vector>

#include "ui/shell/frame.hpp"

namespace replan::app {

/// The program's own version, then those of its libraries.
std::vector<ui::AboutLine> about_lines();

}  // namespace replan::app
