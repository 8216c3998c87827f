// Planners, stages and robots as JSON files have them: their settings by name, checked against what is declared. Only for
// readers and writers of files: it shows JSON types.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/lattice/box.hpp"
#include "core/plan/planner_choice.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/robot.hpp"

namespace replan {

/// Reads one setting. Errors are kept in the JsonReader; they name the range.
void read_setting(const JsonNode& value, std::span<const Parameter> parameters, std::string_view key,
                  Settings& settings);
/// Reads `{"KEY": VALUE, ...}`.
void read_settings(const JsonNode& node, std::span<const Parameter> parameters, Settings& settings);
/// Reads `[{"id": ..., "settings": {...}}, ...]`.
void read_stages(const JsonNode& node, std::vector<StageChoice>& stages);
/// Reads a robot that is to drive in that world; what the file does not say stays as it is in `robot`.
void read_robot_setup(const JsonNode& node, const Box& world, RobotSetup& robot);

/// What readers read back: `{"id": ..., "settings": {...}, "stages": [...]}`.
Json planner_json(const PlannerChoice& choice);
Json robot_json(const RobotSetup& robot);

}  // namespace replan
