// Studies as one page for a browser, with nothing from the network: tables, verdicts, diagrams and pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/study/study.hpp"

namespace replan {

/// One or several drawings in a row, below one caption.
struct StudyDrawing {
  std::string caption;
  struct Part {
    std::string title;  ///< may be empty
    std::string svg;    ///< a whole document
  };
  std::vector<Part> parts;
};

struct StudySection {
  const StudyInfo* info = nullptr;
  StudyReport report;
  std::vector<StudyDrawing> drawings;
  std::vector<std::string> notes;  ///< what is missing, and how to get it
};

/// The page; first of all what became of each claim.
std::string study_html(std::span<const StudySection> sections);

}  // namespace replan
