// What a study leaves in a folder: its report, every run, diagrams, pictures, and the worlds that they show.
#pragma once

#include <functional>
#include <string>

#include "core/study/study_html.hpp"

namespace replan::app {

/// Draws a picture into files whose names begin with the stem: app/study_pictures.hpp.
using DrawPicture = std::function<Result<StudyDrawing>(const StudyPicture& picture, const std::string& stem)>;

/// Writes ID.md, .csv and .json; of each diagram ID-DIAGRAM.gp, and where gnuplot is installed .svg and .png; of each picture
/// ID-PICTURE.png with its planners side by side, ID-PICTURE-N.svg of each, and ID-PICTURE.json, which opens in the window.
/// Without `draw` the pictures are left out, which a note says. What of it goes into a page for browsers is handed back.
Result<StudySection> write_study(const StudyInfo& info, StudyReport report, const std::string& folder,
                                 const DrawPicture& draw);

}  // namespace replan::app
