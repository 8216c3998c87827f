// The library: worlds that come with the program, or any folder of them.
#pragma once

#include <string>
#include <vector>

namespace replan {

/// The folder maps/ beside assets/, or the one that REPLAN_MAPS names.
std::string library_folder();
/// The scenarios and maps of a folder and those below it: first those that its order.txt names, a line each and in the
/// order of its lines, then the others by their path. A line that begins with - names one that is left out.
std::vector<std::string> library_files(const std::string& folder);

}  // namespace replan
