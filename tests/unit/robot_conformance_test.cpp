// What holds for every kind of robot: it arrives without a collision, the same way each time, and can be taken up at
// any moment of its run.
#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/plan/registry.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"
#include "core/world/choices.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::robot_conformance_test {
namespace {

struct Moment {
  Checkpoint checkpoint;
  SearchState state;
  std::size_t event = 0;
};

/// A whole mission: its log, and moments of it.
struct Drive {
  std::vector<Event> log;
  std::vector<Moment> moments;
  MissionState ending = MissionState::planning;
  MissionFigures figures;
};

Scenario with_robot(Scenario scenario, const RobotInfo& robot) {
  scenario.robot.kind = robot.id;
  scenario.robot.settings = {};
  return scenario;
}

void go_on(Mission& mission, Recorder& recorder, Drive& drive) {
  const std::span<const Event> events = recorder.buffer();
  drive.log.insert(drive.log.end(), events.begin(), events.end());
  recorder.clear();
  drive.ending = mission.state();
  drive.figures = mission.now().figures;
}

Drive driven(const Scenario& scenario, const PlannerChoice& choice) {
  Drive drive;
  Recorder recorder;
  const auto mission = make_mission(scenario, choice, &recorder);
  SearchState state = initial_state(scenario, choice);
  for (bool more = true; more;) {
    more = mission->advance(200);
    for (const Event& event : recorder.buffer()) state.apply(event);
    go_on(*mission, recorder, drive);
    if (drive.moments.size() < 40) {
      drive.moments.push_back({mission->checkpoint(), state, drive.log.size()});
      drive.moments.back().checkpoint.line = recorder.current_line();
    }
  }
  return drive;
}

/// The shipped scenarios whose planners are sound: with surprises, moving obstacles, goals that move.
std::vector<Scenario> worlds() {
  std::vector<Scenario> result;
  for (const auto& file : test::files_below(REPLAN_SOURCE_DIR "/maps", ".json")) {
    Scenario scenario = std::move(read_scenario(file.string()).value());
    std::erase_if(scenario.planners, [](const PlannerChoice& choice) {
      return find_choice(choice.id)->exercise || choice.settings.get("remote_parents", 0) == 1;
    });
    if (!scenario.planners.empty() && scenario.map.box().node_count() < 20'000)
      result.push_back(std::move(scenario));
  }
  return result;
}

bool drives_in(const RobotInfo& robot, const Scenario& world) {
  return !robot.planar || !world.map.box().solid();
}

/// A robot whose steps are short finds what is scripted by steps elsewhere on its way than the world's author meant, and
/// a passage closed that others have gone through.
bool is_scripted_by_steps(const Scenario& world) {
  return std::any_of(world.surprises.begin(), world.surprises.end(),
                     [](const Surprise& each) { return each.at.move.has_value(); });
}

TEST(Robots, HaveAnIdANameAndASummary) {
  ASSERT_FALSE(robots().empty());
  EXPECT_EQ(RobotSetup{}.kind, robots().front().id) << "the usual one comes first";
  for (const RobotInfo& robot : robots()) {
    EXPECT_EQ(find_robot(robot.id), &robot);
    EXPECT_FALSE(robot.name.empty() || robot.summary.empty()) << robot.id;
  }
}

TEST(Robots, ArriveWithoutACollisionAndTheSameWayEachTime) {
  for (const Scenario& world : worlds())
    for (const RobotInfo& robot : robots()) {
      if (!drives_in(robot, world)) continue;
      const Scenario scenario = with_robot(world, robot);
      const PlannerChoice& choice = scenario.planners.front();
      const Drive drive = driven(scenario, choice);
      const bool usual = &robot == &robots().front();
      const bool may_be_cut_off = !usual && is_scripted_by_steps(world);
      EXPECT_TRUE(drive.ending == MissionState::arrived ||
                  (may_be_cut_off && drive.ending == MissionState::no_path))
          << scenario.name << ", " << robot.id;
      EXPECT_EQ(drive.figures.collisions, 0) << scenario.name << ", " << robot.id;
      EXPECT_TRUE(drive.log == driven(scenario, choice).log) << scenario.name << ", " << robot.id;
    }
}

/// From every seventh moment that was kept.
void goes_on_from_any_moment(const Scenario& scenario, const PlannerChoice& choice, std::string_view who) {
  const Drive whole = driven(scenario, choice);
  for (std::size_t i = 0; i < whole.moments.size(); i += 7) {
    const Moment& moment = whole.moments[i];
    Recorder recorder;
    const auto mission = make_mission(scenario, choice, &recorder);
    mission->restore(moment.checkpoint, moment.state);
    recorder.line(moment.checkpoint.line);
    Drive rest;
    for (bool more = true; more;) {
      more = mission->advance(200);
      go_on(*mission, recorder, rest);
    }
    ASSERT_TRUE(std::equal(rest.log.begin(), rest.log.end(),
                           whole.log.begin() + static_cast<std::ptrdiff_t>(moment.event), whole.log.end()))
        << scenario.name << ", " << who << ", from event " << moment.event;
    ASSERT_EQ(rest.figures.travelled, whole.figures.travelled) << scenario.name << ", " << who;
    ASSERT_EQ(rest.figures.drive, whole.figures.drive) << scenario.name << ", " << who;
  }
}

TEST(Robots, GoOnFromAnyMomentAsIfTheyHadNeverStopped) {
  for (const Scenario& world : worlds())
    for (const RobotInfo& robot : robots()) {
      if (!drives_in(robot, world)) continue;
      const Scenario scenario = with_robot(world, robot);
      goes_on_from_any_moment(scenario, scenario.planners.back(), robot.id);
    }
}

TEST(Robots, OfPilotsDriveTheSameWayEachTimeTouchNothingAndGoOnFromAnyMoment) {
  for (const Scenario& world : worlds())
    for (const Pilot& pilot : pilots()) {
      const PlannerChoice choice{std::string(pilot.info.id), {}};
      // Their steps are many and small: the smaller worlds will do.
      if (!fits(pilot.info, world.map.box(), 0) || world.map.box().node_count() > 1'000) continue;
      const Drive drive = driven(world, choice);
      EXPECT_TRUE(drive.log == driven(world, choice).log) << world.name << ", " << pilot.info.id;
      EXPECT_EQ(drive.figures.collisions, 0) << world.name << ", " << pilot.info.id;
      EXPECT_NE(drive.ending, MissionState::endless) << world.name << ", " << pilot.info.id;
      goes_on_from_any_moment(world, choice, pilot.info.id);
    }
}

}  // namespace
}  // namespace replan::robot_conformance_test
