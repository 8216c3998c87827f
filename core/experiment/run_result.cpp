#include "core/experiment/run_result.hpp"

#include <algorithm>
#include <string>

#include "core/experiment/result_json.hpp"

namespace replan {
namespace {

using enum Better;

constexpr ResultColumn kColumns[] = {
    {"nodes", "nodes", lower},
    {"length", "length_cells", lower},
    {"turns", "turns", lower},
    {"turning_angle_deg", "turning_deg", lower},
    {"greatest_curvature", "greatest_curvature_per_cell", lower},
    {"min_clearance", "min_clearance_cells", higher},
    {"mean_clearance", "mean_clearance_cells", higher},
    {"min_edge_clearance", "min_edge_clearance_cells", higher},
    {"mean_edge_clearance", "mean_edge_clearance_cells", higher},
    {"expansions", "expansions", lower},
    {"queue_operations", "queue_operations", lower},
    {"sight_checks", "sight_checks", neither},
    {"replans", "replans", neither},
    {"moves", "moves", neither},
    {"travelled", "travelled_cells", lower},
    {"seconds", "drive_s", lower},
    {"collisions", "collisions", lower},
    {"mean_speed", "mean_speed_m_per_s", neither},
    {"top_speed", "top_speed_m_per_s", neither},
    {"mean_curvature", "mean_curvature_per_m", lower},
    {"turned_deg", "turned_deg", lower},
    {"mean_off_plan", "mean_off_plan_m", neither},
    {"max_off_plan", "max_off_plan_m", neither},
    {"stops", "stops", lower},
    {"turning_seconds", "turning_s", lower},
    {"course_turned_deg", "course_turned_deg", lower},
    {"way_min_clearance", "way_min_clearance_cells", higher},
    {.figure = "surprises_noticed", .name = "surprises_noticed", .newer = true},
};

}  // namespace

std::span<const ResultColumn> result_columns() {
  return kColumns;
}

std::optional<double> RunResult::figure(std::string_view column) const {
  const auto columns = result_columns();
  for (std::size_t i = 0; i < std::min(columns.size(), figures.size()); ++i)
    if (columns[i].name == column) return figures[i];
  return std::nullopt;
}

std::optional<double> RunResult::length() const {
  if (!succeeded) return std::nullopt;
  const auto travelled = figure("travelled_cells");
  return travelled ? travelled : figure("length_cells");
}

std::optional<double> RunResult::ratio() const {
  const auto found = length();
  if (!found || !expected || *expected == 0) return std::nullopt;
  return *found / *expected;
}

std::string result_line(const RunResult& result) {
  Json json = result_json(result);
  json["printed"] = result.printed;
  json["plan_ms"] = result.plan_ms;
  json["replan_ms"] = result.replan_ms;
  json["memory_bytes"] = result.memory_bytes;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<RunResult> parse_result_line(const std::string& line, const std::string& origin) {
  JsonReader reader(origin);
  if (!reader.parse(line)) return Error{reader.error()};
  const JsonNode root = reader.root();
  RunResult result = read_result(root);
  if (const auto node = root.require("printed")) result.printed = node->text();
  const auto times = [&](const char* key, std::vector<double>& values) {
    if (const auto node = root.require(key))
      for (const JsonNode& item : node->items(0, kMostPlanned, "a list of times"))
        values.push_back(item.number(0, 1e15));
  };
  times("plan_ms", result.plan_ms);
  times("replan_ms", result.replan_ms);
  if (const auto node = root.require("memory_bytes")) result.memory_bytes = node->whole(0, INT64_MAX);
  if (!reader.ok()) return Error{reader.error()};
  return result;
}

}  // namespace replan
