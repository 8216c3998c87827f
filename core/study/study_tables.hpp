// The tables of a study, whatever they are written as.
#pragma once

#include <string>
#include <vector>

#include "core/study/study.hpp"

namespace replan {

struct StudyTable {
  std::string heading;                          ///< may be empty
  std::vector<std::vector<std::string>> lines;  ///< the first names the columns; all are as long
  std::size_t words = 1;  ///< so many columns from the left are words; the others are numbers
};

/// Each planner's figures beside the paper's, in each world or in all taken together.
std::vector<StudyTable> figure_tables(const StudyReport& report);
/// The paper's claims, what came out, and the verdicts.
StudyTable claim_table(const StudyReport& report);
/// What the tables' numbers are.
std::string table_words(const StudyReport& report);
/// With how many seeds it was run, of how many that it is meant to have, and the command that does so again.
std::string seeds_words(const StudyInfo& info, const StudyReport& report);

}  // namespace replan
