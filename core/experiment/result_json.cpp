#include "core/experiment/result_json.hpp"

namespace replan {
namespace {

/// A number as it reads: counts without a point.
Json figure_json(const std::optional<double>& value) {
  return value ? plain_number(*value) : Json();
}

std::optional<JsonNode> given(const JsonNode& node, std::string_view key) {
  auto child = node.require(key);
  if (child && child->value().is_null()) child.reset();
  return child;
}

std::string text_of(const JsonNode& node, std::string_view key) {
  const auto child = node.require(key);
  return child ? child->text() : std::string();
}

std::optional<double> number_of(const JsonNode& node, std::string_view key) {
  constexpr double kMost = 1e300;
  const auto child = given(node, key);
  return child ? std::optional(child->number(-kMost, kMost)) : std::nullopt;
}

}  // namespace

Json result_json(const RunResult& result) {
  const RunName& name = result.name;
  Json json = {{"run", result.run},
               {"world", name.world},
               {"problem_line", name.line},
               {"start", name.start},
               {"goal", name.goal},
               {"planner", name.planner},
               {"settings", name.settings},
               {"stages", name.stages},
               {"robot", name.robot},
               {"surprises", name.surprises},
               {"seed", name.seed},
               {"status", result.status},
               {"plan_status", result.plan_status},
               {"succeeded", result.succeeded ? 1 : 0},
               {"expected_length_cells", figure_json(result.expected)},
               {"length_ratio", figure_json(result.ratio())},
               {"mismatch", result.mismatch ? Json(*result.mismatch ? 1 : 0) : Json()},
               {"metres_per_cell", figure_json(result.metres_per_cell)}};
  const auto columns = result_columns();
  for (std::size_t i = 0; i < columns.size(); ++i)
    json[std::string(columns[i].name)] =
        figure_json(i < result.figures.size() ? result.figures[i] : std::nullopt);
  return json;
}

RunResult read_result(const JsonNode& node) {
  RunResult result;
  if (const auto run = node.require("run")) result.run = run->whole(0, kMostRuns);
  RunName& name = result.name;
  name.world = text_of(node, "world");
  if (const auto line = node.require("problem_line")) name.line = static_cast<int>(line->whole(0, INT32_MAX));
  name.start = text_of(node, "start");
  name.goal = text_of(node, "goal");
  name.planner = text_of(node, "planner");
  name.settings = text_of(node, "settings");
  name.stages = text_of(node, "stages");
  name.robot = text_of(node, "robot");
  name.surprises = text_of(node, "surprises");
  if (const auto seed = node.require("seed"))
    name.seed = static_cast<std::uint64_t>(seed->whole(0, INT64_MAX));
  result.status = text_of(node, "status");
  result.plan_status = text_of(node, "plan_status");
  if (const auto succeeded = node.require("succeeded")) result.succeeded = succeeded->whole(0, 1) != 0;
  result.expected = number_of(node, "expected_length_cells");
  if (const auto mismatch = given(node, "mismatch")) result.mismatch = mismatch->whole(0, 1) != 0;
  result.metres_per_cell = number_of(node, "metres_per_cell");
  for (const ResultColumn& column : result_columns()) {
    const bool lacks = column.newer && !node.find(column.name);
    result.figures.push_back(lacks ? std::nullopt : number_of(node, column.name));
  }
  return result;
}

}  // namespace replan
