// The pictures of studies: their planners side by side, and each by itself.
#pragma once

#include <string>

#include "core/study/study_html.hpp"

namespace replan::app {

/// Writes STEM.png with all planners and STEM-N.svg of each, and hands back what goes into a page for browsers.
Result<StudyDrawing> draw_study_picture(const StudyPicture& picture, const std::string& stem);

}  // namespace replan::app
