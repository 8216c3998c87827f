// The diagrams of a study, as scripts that gnuplot draws: in print quality, with their data inside, so that anybody can
// draw them anew in another size, font or language.
#pragma once

#include <string>
#include <string_view>

#include "core/study/study.hpp"

namespace replan {

/// Whether any run has the figure that a diagram shows.
bool can_be_drawn(const StudyReport& report, const StudyChart& chart);
/// A script that writes `stem`.svg and `stem`.png into the folder it is run in. A bar is the mean, of wall times the median
/// over the first planner's, with standard deviation or quartiles; what the paper reports is marked.
std::string chart_script(const StudyReport& report, const StudyChart& chart, std::string_view stem);

}  // namespace replan
