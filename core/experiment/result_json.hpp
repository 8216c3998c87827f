// A result as a JSON object, what of it repeats. Only for source files: it shows JSON types.
#pragma once

#include "core/experiment/run_result.hpp"
#include "core/world/json_reader.hpp"

namespace replan {

/// Everything but times and memory, under the names of the columns of results.csv. What a run has not is null.
Json result_json(const RunResult& result);
/// Reads it back; keys that are not of it are passed over. Errors are kept in the JsonReader.
RunResult read_result(const JsonNode& node);

}  // namespace replan
