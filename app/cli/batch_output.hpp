// What batches print.
#pragma once

#include <span>
#include <string>

#include "core/experiment/batch_report.hpp"
#include "core/experiment/run_list.hpp"

namespace replan::cli {

/// What a batch's runs are called: the problems of a file, or the runs of an experiment.
enum class BatchKind : std::uint8_t { problems, experiment };

/// A line for each planner, and below what the table cannot say.
std::string batch_table(std::span<const BatchReport> reports, BatchKind kind);
/// What the batch is: its files and how many runs they make.
std::string batch_title(const RunList& list, const std::string& source);
/// A line on stderr for each of the first mismatches.
void complain_of_mismatches(std::span<const BatchReport> reports);

}  // namespace replan::cli
