#include "core/study/figures_table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "core/plan/nth_name.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

using enum FigureGroup;
using enum Better;

constexpr FigureInfo kFigures[] = {
    {"nodes", first_plan, "nodes", "", lower, 0, false, "Corners of the path's polyline, both ends counted."},
    {"length", first_plan, "length", "cells", lower, 3, false, "Along the straight segments."},
    {"turns", first_plan, "turns", "", lower, 0, false, "Inner corners where the heading changes."},
    {"turning_angle_deg", first_plan, "turning", "°", lower, 1, false, "The sum of all changes of heading."},
    {"greatest_curvature", first_plan, "top curvature", "1/cells", lower, 3, false,
     "How sharply the path bends at most: 1 is a circle with a radius of one cell, pi a corner of a right "
     "angle. At every "
     "place of the path the heading's change over half a cell to either side is taken."},
    {"min_clearance", first_plan, "least clearance", "cells", higher, 3, false,
     "From the path to the nearest obstacle's edge, at the narrowest place."},
    {"mean_clearance", first_plan, "mean clearance", "cells", higher, 3, false,
     "The mean over the whole path, sampled every tenth of a cell."},
    {"min_edge_clearance", first_plan, "least clearance of the edge", "cells", higher, 3, false,
     "The same from the edge of a robot with a size; negative where it drives out from too near an "
     "obstacle."},
    {"mean_edge_clearance", first_plan, "mean clearance of the edge", "cells", higher, 3, false,
     "The mean of that over the whole path."},
    {"last_expansions", latest_plan, "expansions", "", lower, 0, false,
     "Cells that the latest plan or replan took from the open list and settled or raised; samples that it "
     "drew, or children that it bred, where the planner does so."},
    {"last_queue_operations", latest_plan, "queue operations", "", lower, 0, false,
     "Inserts, removals, changes of key and pops."},
    {"last_sight_checks", latest_plan, "sight checks", "", neither, 0, false,
     "Lines of sight that were looked along. Fewer is not better in itself: planners without them ask none."},
    // One timing says nothing of its scatter: no time is the best.
    {"plan_ms", run, "first plan", "ms", neither, 3, true, "Wall time of the first plan, measured once."},
    {"replan_ms", run, "replans", "ms", neither, 3, true,
     "Wall time of all replans together, measured once."},
    {"replans", run, "replans", "", neither, 0, false, "How often the plan was repaired or made anew."},
    {"expansions", run, "expansions", "", lower, 0, false, "Of all plans so far together."},
    {"queue_operations", run, "queue operations", "", lower, 0, false, "Of all plans so far together."},
    {"sight_checks", run, "sight checks", "", neither, 0, false, "Of all plans so far together."},
    {"memory_bytes", run, "planner's memory", "kB", lower, 0, false,
     "The most that the planner alone held at once: not the map, the log or the program."},
    {"moves", robot, "moves", "", neither, 0, false,
     "Cells that the robot has entered; of a robot on wheels, the periods that it has driven."},
    {"travelled", robot, "travelled", "cells", lower, 3, false,
     "The way that the robot has gone, along its paths. Drives are compared once all robots have arrived."},
    {"seconds", robot, "time", "s", lower, 1, false,
     "Of the world's own time since the robot set out, waiting counted."},
    {"way_min_clearance", robot, "least clearance on its way", "cells", higher, 3, false,
     "From the vehicle's centre, anywhere on its way, to the nearest edge of what stood in the world as it "
     "set out on "
     "that step, known to it or not; 8 if it came no nearer than that."},
    {"stops", robot, "stops to turn", "", lower, 0, false,
     "Corners that were too sharp for the vehicle: it stopped there and turned on the spot."},
    {"turning_seconds", robot, "time turning on the spot", "s", lower, 1, false,
     "Of its time. A path without sharp corners needs none."},
    {"course_turned_deg", robot, "course turned", "°", lower, 1, false,
     "The sum of all changes of the vehicle's course, under way and on the spot."},
    {"mean_speed", robot, "mean speed", "m/s", neither, 3, false,
     "Of a robot that drives: its way by its time under way, waiting not counted."},
    {"top_speed", robot, "top speed", "m/s", neither, 3, false, "The fastest that it has driven."},
    {"mean_curvature", robot, "mean curvature", "1/m", lower, 3, false,
     "How much its way bends: what it turned while it drove, for each metre. 0 is a straight line; 1 is a "
     "circle of one "
     "metre's radius."},
    {"turned_deg", robot, "turned", "°", lower, 1, false,
     "The sum of all changes of its heading, those on the spot too."},
    {"mean_off_plan", robot, "mean distance to the first plan", "m", neither, 3, false,
     "How far its way keeps from the path of the plan that it set out with."},
    {"max_off_plan", robot, "greatest distance to the first plan", "m", neither, 3, false,
     "The same where it is farthest from it."},
    {"collisions", robot, "collisions", "", lower, 0, false,
     "Times that a plan led into an obstacle. Only with remote parents as printed."},
};

constexpr const char* kNone = "–";
constexpr std::string_view kCells = "cells", kPerCell = "1/cells";  // of lengths, and of curvatures

/// All figures of a run under the keys of kFigures.
std::vector<NamedFigure> all_figures(const RunReport& report) {
  std::vector<NamedFigure> figures = named_figures(report);
  if (const auto& last = report.last_plan) {
    figures.push_back({"last_expansions", static_cast<double>(last->expansions), true});
    figures.push_back({"last_queue_operations", static_cast<double>(last->queue_operations), true});
    figures.push_back({"last_sight_checks", static_cast<double>(last->sight_checks), true});
  }
  if (!report.robot) return figures;
  for (const NamedFigure& figure : named_figures(*report.robot))
    if (figure.key != "replans") figures.push_back(figure);
  for (const auto& more : {drive_figures(*report.robot), kept_figures(*report.robot)})
    figures.insert(figures.end(), more.begin(), more.end());
  return figures;
}

std::optional<double> value_of(std::span<const NamedFigure> figures, std::string_view key) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const NamedFigure& f) { return f.key == key; });
  return found == figures.end() ? std::nullopt : found->value;
}

/// The value as it is printed.
double printed(const FigureInfo& info, double value) {
  return std::strtod(figure_text(info, value).c_str(), nullptr);
}

/// Whether only a robot with a size has it.
bool of_size(const FigureInfo& info) {
  return info.key == "min_edge_clearance" || info.key == "mean_edge_clearance";
}

/// How far the runs have come.
enum class Progress : std::uint8_t { unplanned, first_plans, under_way, whole_drives };

Progress progress_of(std::span<const RunReport> reports) {
  const auto all = [&](auto&& condition) { return std::all_of(reports.begin(), reports.end(), condition); };
  if (!all([](const RunReport& each) { return each.status != status_name(PlanStatus::searching); }))
    return Progress::unplanned;
  if (all([](const RunReport& each) {
        return !each.robot || (!each.robot->reached() && each.robot->moves == 0 && each.replans == 0);
      }))
    return Progress::first_plans;
  const bool ended = all([](const RunReport& each) {
    return each.robot && each.robot->ending != MissionState::planning &&
           each.robot->ending != MissionState::driving;
  });
  return ended ? Progress::whole_drives : Progress::under_way;
}

/// Whether all robots move alike: on wheels, or from cell to cell.
bool move_alike(std::span<const RunReport> reports) {
  const auto drives = [](const RunReport& each) { return each.robot && each.robot->drive.has_value(); };
  return std::all_of(reports.begin(), reports.end(), drives) ||
         std::none_of(reports.begin(), reports.end(), drives);
}

/// FigureRow::competes of a run.
bool can_be_compared(const RunReport& report, FigureGroup group, Progress progress) {
  const bool planned = report.status == status_name(PlanStatus::found);
  if (progress == Progress::unplanned || !planned || (report.blind && group != robot)) return false;
  if (group == first_plan) return true;
  if (progress == Progress::first_plans) return group != robot;
  return progress == Progress::whole_drives && group != latest_plan && report.succeeded();
}

std::vector<std::string> names_of(std::span<const RunReport> reports) {
  std::vector<std::string> names;
  for (const RunReport& report : reports) {
    const PlannerInfo* info = find_choice(report.planner);
    names.push_back(info == nullptr ? report.planner : std::string(info->name));
  }
  return told_apart(names);
}

}  // namespace

const char* figure_group_title(FigureGroup group) {
  constexpr std::array kTitles = {"The first plan", "Work for the latest plan", "Work for all plans",
                                  "The robot's drive"};
  return kTitles[static_cast<std::size_t>(group)];
}

std::optional<double> FigureRow::ratio(std::size_t run) const {
  if (run == 0 || !values[run] || !values.front() || *values.front() == 0) return std::nullopt;
  return *values[run] / *values.front();
}

bool FigureRow::best(std::size_t run) const {
  if (info->better == Better::neither || !values[run] || !competes[run]) return false;
  const double own = printed(*info, *values[run]);
  bool differs = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i] || !competes[i]) continue;
    const double other = printed(*info, *values[i]);
    if (info->better == Better::lower ? other < own : other > own) return false;
    differs |= other != own;
  }
  return differs;
}

FiguresTable figures_table(std::span<const RunReport> reports) {
  FiguresTable table{names_of(reports), {}};
  const Progress progress = progress_of(reports);
  std::vector<std::vector<NamedFigure>> figures;
  for (const RunReport& report : reports) figures.push_back(all_figures(report));
  const bool alike = move_alike(reports);
  const bool metric =
      std::all_of(reports.begin(), reports.end(), [](const auto& each) { return each.frame.has_value(); });
  for (const FigureInfo& info : kFigures) {
    const bool in_metres = metric && info.unit == kCells, per_metre = metric && info.unit == kPerCell;
    FigureRow row{&info, in_metres ? "m" : per_metre ? "1/m" : info.unit, {}, {}};
    for (const RunReport& report : reports)
      row.competes.push_back(can_be_compared(report, info.group, progress) && (info.group != robot || alike));
    bool any = false;
    for (std::size_t i = 0; i < reports.size(); ++i) {
      row.values.push_back(value_of(figures[i], info.key));
      if (auto& value = row.values.back(); value && in_metres) value = reports[i].frame->metres(*value);
      if (auto& value = row.values.back(); value && per_metre) value = *value / reports[i].frame->metres(1);
      // A figure that a run could have stays in the table, so that its rows do not come and go.
      any |= row.values.back().has_value() ||
             ((info.group == first_plan || info.group == FigureGroup::run) && !of_size(info));
    }
    for (const RunReport& report : reports) any |= of_size(info) && report.radius > 0;
    if (any) table.rows.push_back(std::move(row));
  }
  return table;
}

std::string figure_text(const FigureInfo& info, std::optional<double> value) {
  if (!value) return kNone;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", info.decimals, info.unit == "kB" ? *value / 1000 : *value);
  return text;
}

std::string ratio_text(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "×%.2f", ratio);
  return text;
}

}  // namespace replan
