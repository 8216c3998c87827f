// What a study leaves in a folder: its report, every run, diagrams, pictures, and the worlds that they show.
#pragma once

#include <string>

#include "core/study/study_html.hpp"

namespace replan::app {

/// Writes ID.md, .csv and .json; of each diagram ID-DIAGRAM.gp, and where gnuplot is installed .svg and .png; of each picture
/// ID-PICTURE.png with its planners side by side, ID-PICTURE-N.svg of each, and ID-PICTURE.json, which opens in the window.
/// What of it goes into a page for browsers is handed back.
Result<StudySection> write_study(const StudyInfo& info, StudyReport report, const std::string& folder);

}  // namespace replan::app
