// The machine that the program runs on, for readers of measured times.
#pragma once

#include <string>

namespace replan {

/// A sentence: its processor, how many of them, and whether other work kept it busy just now.
std::string machine_sentence();

}  // namespace replan
