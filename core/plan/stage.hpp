// What can be done to a path once it is found. Menus, settings, command line and help are made from
// stages/stages.def; nothing else names a stage.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/lattice/box_lattice.hpp"
#include "core/plan/path.hpp"
#include "core/plan/planner_choice.hpp"

namespace replan {

/// What can be said of a stage without running it, and how it is run: a path in, on the map that the robot
/// knows, and a path out that has the same ends and is no less free.
struct StageInfo {
  std::string_view id = {};       ///< as on the command line: "collinear"
  std::string_view name = {};     ///< as in the window
  std::string_view summary = {};  ///< one sentence
  std::string_view source = {};   ///< authors, year, DOI; empty if there is none
  std::vector<Parameter> parameters = {};
  Path (*in_plane)(const Grid2& known, Path path, const Settings& settings) = nullptr;
  Path (*in_space)(const Voxel3& known, Path path, const Settings& settings) = nullptr;
};

/// All stages, in the order of stages.def.
std::span<const StageInfo> stages();
/// The stage of that id, or nullptr.
const StageInfo* find_stage(std::string_view id);
/// As find_stage(), with an error that suggests the nearest id.
Result<const StageInfo*> require_stage(std::string_view id);

/// The path after all these stages, in their order; each must be in the registry.
Path through_stages(const Grid2& known, Path path, std::span<const StageChoice> stages);
Path through_stages(const Voxel3& known, Path path, std::span<const StageChoice> stages);

}  // namespace replan
