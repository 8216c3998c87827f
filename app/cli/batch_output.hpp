// What batches print.
#pragma once

#include <span>
#include <string>

#include "core/experiment/batch_report.hpp"
#include "core/experiment/run_list.hpp"

namespace replan::cli {

/// A line for each planner, and below what the table cannot say.
std::string batch_table(std::span<const BatchReport> reports);
/// What the batch is: its files and how many runs they make.
std::string batch_title(const RunList& list, const std::string& source);
/// A line on stderr for each of the first mismatches.
void complain_of_mismatches(std::span<const BatchReport> reports);

}  // namespace replan::cli
