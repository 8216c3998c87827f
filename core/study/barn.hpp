// The BARN benchmark: a robot of the Jackal's size through worlds of cylinders that it sees with a laser alone.
//
//  Perille D., Truong A., Xiao X. & Stone P., "Benchmarking metric ground navigation", IEEE SSRR 2020, arXiv 2008.13315
//
// The robot starts with an empty map. What its laser hits it marks in a map of finer cells; the global plan is made on
// those, grown by the robot's radius, and the drive keeps away from them. The true obstacles are discs, and what
// collides is the robot's disc with them, on its exact way. It is the disc about the Jackal's rectangle of 0.42 x 0.33
// m: what it misses the rectangle misses too, however it is turned. Odometry is exact.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/drive/dynamic_window.hpp"
#include "core/plan/planner_choice.hpp"

namespace replan {

/// One world of the benchmark, in metres.
struct BarnWorld {
  int number = 0;
  double width = 0, height = 0;
  double cell = 0;          ///< side of the cells that cylinders stand in the middle of
  double disc_radius = 0;   ///< of a cylinder
  std::vector<Spot> discs;  ///< their centres
  Pose start;
  Spot goal;
  double tolerance = 0;     ///< how near the goal is near enough
  double timeout = 0;       ///< s
  double optimal_time = 0;  ///< s, as the benchmark has it: its own path at 2 m/s
};

/// The worlds that a folder's index.json lists, in its order.
Result<std::vector<BarnWorld>> read_barn(const std::string& folder);

/// How the robot sees and plans.
struct BarnSettings {
  DriveSettings drive;
  PlannerChoice global;        ///< with an empty id there is no plan: the robot heads for the goal itself
  double range = 2.5;          ///< m, of the laser
  double field_of_view = 270;  ///< degrees, straight ahead in the middle
  int rays = 720;
  double cell = 0.05;         ///< m, side of the robot's map's cells
  double clearance = 0.03;    ///< m, that a plan keeps besides the radius, where it can
  double replan_every = 0.5;  ///< s, at most that often; at once where the plan is blocked
  double next_turn = 0.3;     ///< m; so near a sub-goal the next one follows
};

/// The drive's parameters for this benchmark: the Jackal's published limits, 20 decisions a second, a horizon of 1 s and
/// obstacles that count within 0.3 m, since its passages are narrow; the fusion paper's weights.
Settings barn_drive();
/// With these on top of barn_drive(), and Floyd's smoothing behind the global planner, if there is one.
BarnSettings barn_settings(const Settings& drive, const std::string& global);

/// How a drive ended.
enum class BarnEnd : std::uint8_t { success, collision, timeout };
std::string_view barn_end_name(BarnEnd end);

/// What one drive came to.
struct BarnDrive {
  int world = 0;
  BarnEnd end = BarnEnd::timeout;
  double time = 0;       ///< s
  double score = 0;      ///< of the BARN Challenge, at most 0.5
  double way = 0;        ///< m
  double least_gap = 0;  ///< m, from the robot's edge to a disc
  double to_goal = 0;    ///< m, in the end
  int replans = 0;
  int brakes = 0;           ///< ticks without an admissible sample
  int turns = 0;            ///< ticks that it turned to find a free side
  int stuck = 0;            ///< times that it turned all the way round in vain
  int no_path = 0;          ///< plans that found no way
  std::vector<Pose> track;  ///< tick by tick
};

BarnDrive drive_barn(const BarnWorld& world, const BarnSettings& settings);

/// All worlds, as many at a time as the machine has processors.
std::vector<BarnDrive> drive_barn(const std::vector<BarnWorld>& worlds, const BarnSettings& settings);

/// Figures over worlds.
struct BarnSummary {
  std::string name;
  std::size_t worlds = 0;
  double success = 0, collision = 0, timeout = 0;  ///< shares
  double time = 0;                                 ///< s, mean of the successful
  double score = 0;                                ///< mean of all
  double least_gap = 0;                            ///< m, over all
};
BarnSummary summary_of(const std::string& name, const std::vector<BarnDrive>& drives);

/// A Markdown table of them below the figures that the benchmark's authors publish for DWA.
std::string barn_table(const std::vector<BarnSummary>& summaries);
/// Why drives failed, a sentence each: how far from the goal it ended, since when it had not left a place of two metres,
/// and what stands in the straight way from there for a robot of that radius. Empty if all arrived.
std::string barn_failures(const std::string& name, const std::vector<BarnWorld>& worlds,
                          const std::vector<BarnDrive>& drives, const BarnSettings& settings);
/// World by world: the heading with `name` empty, else its lines.
std::string barn_csv(const std::string& name, const std::vector<BarnDrive>& drives);

}  // namespace replan
