#include "core/experiment/results_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/csv.hpp"
#include "core/base/statistics.hpp"
#include "core/experiment/result_json.hpp"

namespace replan {
namespace {

/// A value as a field of CSV.
std::string field_of(const Json& value) {
  if (value.is_null()) return {};
  return value.is_string() ? csv_field(value.get_ref<const std::string&>()) : value.dump();
}

/// To the nanosecond, which is as much as a clock says: digits behind that are of the interpolation.
Json time_json(double milliseconds) {
  return plain_number(std::round(milliseconds * 1e6) / 1e6);
}

/// ",median,lower quartile,upper quartile"; three empty fields of no times.
std::string spread_fields(std::vector<double> values) {
  if (values.empty()) return ",,,";
  std::sort(values.begin(), values.end());
  std::string fields;
  for (const double p : {0.5, 0.25, 0.75}) fields += "," + time_json(quantile(values, p)).dump();
  return fields;
}

}  // namespace

ResultsHead results_head(const RunList& list) {
  return {.name = list.experiment().name,
          .digest = list.digest(),
          .runs = list.count(),
          .repeats = list.experiment().repeats()};
}

std::string results_csv_head() {
  std::string text;
  const Json names = result_json({});
  for (auto name = names.begin(); name != names.end(); ++name) text += (text.empty() ? "" : ",") + name.key();
  return text + '\n';
}

std::string results_csv_row(const RunResult& result) {
  std::string line;
  for (const Json& value : result_json(result)) line += (line.empty() ? "" : ",") + field_of(value);
  return line + '\n';
}

std::string results_csv(std::span<const RunResult> results) {
  std::string text = results_csv_head();
  for (const RunResult& result : results) text += results_csv_row(result);
  return text;
}

std::string results_json_head(const ResultsHead& head) {
  const Json document = {{"format", "replan results"}, {"version", 1},
                         {"name", head.name},          {"digest", head.digest},
                         {"runs_in_all", head.runs},   {"repeats", head.repeats}};
  std::string text = document.dump();
  text.back() = ',';
  return text + "\n\"runs\": [";
}

std::string results_json_row(const RunResult& result) {
  return result_json(result).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string times_csv_head() {
  return "run,times,plan_ms,plan_ms_lower_quartile,plan_ms_upper_quartile,replan_ms,replan_ms_lower_quartile,"
         "replan_ms_upper_quartile,memory_bytes\n";
}

std::string times_csv_row(const RunResult& result) {
  return std::to_string(result.run) + "," + std::to_string(result.plan_ms.size()) +
         spread_fields(result.plan_ms) + spread_fields(result.replan_ms) + "," +
         std::to_string(result.memory_bytes) + "\n";
}

Result<ReadResults> parse_results(const std::string& text, const std::string& origin) {
  JsonReader reader(origin);
  if (!reader.parse(text)) return Error{reader.error()};
  const JsonNode root = reader.root();
  if (const auto format = root.find("format"); !format || format->value() != "replan results")
    return Error{origin +
                 ": not results of a batch: the key \"format\" with the value \"replan results\" is missing"};
  ReadResults read;
  if (const auto name = root.require("name")) read.head.name = name->text();
  if (const auto digest = root.require("digest")) read.head.digest = digest->text();
  if (const auto runs = root.require("runs_in_all")) read.head.runs = runs->whole(0, kMostRuns);
  if (const auto repeats = root.require("repeats")) read.head.repeats = repeats->toggle();
  if (const auto runs = root.require("runs"))
    for (const JsonNode& run : runs->items(0, static_cast<std::size_t>(kMostRuns), "a list of runs"))
      read.results.push_back(read_result(run));
  if (!reader.ok()) return Error{reader.error()};
  return read;
}

}  // namespace replan
