// What the sensor's cone holds, by brute force; which way a robot looks; and how that is drawn.
#include "core/scene/sonar.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"

namespace replan::sonar_test {
namespace {

using Real = long double;
constexpr Real kDegree = std::numbers::pi_v<Real> / 180;
constexpr double kAngles[] = {1, 10, 45, 54.7, 60, 70.5287793655093, 90, 120, 180, 200, 270, 359, 360};

/// The angle between two directions in degrees, by the C library in long double.
Real angle_of(const Course& a, const Course& b) {
  const Real ax = a.x, ay = a.y, az = a.z, bx = b.x, by = b.y, bz = b.z;
  const Real x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
  return std::atan2(std::sqrt(x * x + y * y + z * z), ax * bx + ay * by + az * bz) / kDegree;
}

/// Every direction to a cell at most so far away along each axis.
template <class Visit>
void each_direction(int flat, int up, Visit&& visit) {
  for (int z = -up; z <= up; ++z)
    for (int y = -flat; y <= flat; ++y)
      for (int x = -flat; x <= flat; ++x)
        if (x != 0 || y != 0 || z != 0)
          visit(Course{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
}

struct Counts {
  int inside = 0, outside = 0, on_the_rim = 0;
};

/// Of that cone, all directions against their angles; one on the rim is inside.
void hold(const Course& axis, double angle, const Course& direction, Counts& counts) {
  const bool holds = Cone(axis, angle).holds(direction);
  const Real off = angle_of(axis, direction) - angle / 2;
  const bool rim = std::abs(off) < 1e-10L;
  ASSERT_EQ(holds, angle >= 360 || off <= 0 || rim)
      << angle << "°: " << axis.x << ' ' << axis.y << ' ' << axis.z << " and " << direction.x << ' '
      << direction.y << ' ' << direction.z;
  ++(holds ? counts.inside : counts.outside);
  counts.on_the_rim += rim ? 1 : 0;
}

TEST(Cone, HoldsTheDirectionsThatAreAtMostHalfItsAngleAway) {
  Counts counts;
  for (const double angle : kAngles)
    each_direction(2, 2, [&](const Course& axis) {
      each_direction(4, 3, [&](const Course& direction) { hold(axis, angle, direction, counts); });
    });
  EXPECT_GT(counts.inside, 300'000);
  EXPECT_GT(counts.outside, 500'000);
  EXPECT_GT(counts.on_the_rim, 8'000) << "45, 90, 180 degrees and the cube's own angles must be met";
}

TEST(Cone, IsASectorInThePlane) {
  Counts counts;
  for (const double angle : kAngles)
    each_direction(3, 0, [&](const Course& axis) {
      each_direction(9, 0, [&](const Course& direction) { hold(axis, angle, direction, counts); });
    });
  EXPECT_GT(counts.on_the_rim, 500);
}

TEST(Cone, DoesNotDependOnHowLongItsAxisIs) {
  for (const double angle : kAngles)
    each_direction(2, 1, [&](const Course& axis) {
      const Course third{axis.x / 3, axis.y / 3, axis.z / 3};
      each_direction(3, 2, [&](const Course& direction) {
        EXPECT_EQ(Cone(axis, angle).holds(direction), Cone(third, angle).holds(direction));
      });
    });
  EXPECT_TRUE(Cone({}, 1).holds({0, 0, -1})) << "without a course it looks all round";
}

TEST(Course, AnglesBetweenTwoAreThoseOfTheCLibrary) {
  each_direction(2, 2, [](const Course& a) {
    each_direction(2, 2, [&](const Course& b) {
      EXPECT_NEAR(angle_between(a, b), static_cast<double>(angle_of(a, b) * kDegree), 1e-15);
    });
  });
  EXPECT_EQ(angle_between({1, 2, 3}, {1, 2, 3}), 0);
  EXPECT_EQ(angle_between({}, {1, 0, 0}), 0);
}

/// Of a small world, by brute force: felt, or within the radius and the cone.
bool expected_in_sight(const RobotSetup& setup, const Course& course, Cell robot, Cell cell) {
  const int x = cell.x - robot.x, y = cell.y - robot.y, z = cell.z - robot.z;
  if (std::abs(x) <= 1 && std::abs(y) <= 1 && std::abs(z) <= 1) return true;
  if (std::sqrt(static_cast<Real>(x * x + y * y + z * z)) > setup.sensor_radius) return false;
  const Course to{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  return setup.sensor_angle >= 360 || angle_of(course, to) <= setup.sensor_angle / 2 + 1e-10L;
}

void see_all_round(const Box& box) {
  const std::vector<std::uint8_t> nothing(box.node_count());
  int seen = 0, unseen = 0;
  for (const double angle : {30.0, 90.0, 200.0, 360.0})
    for (const double radius : {0.0, 2.0, 3.5, 100.0})
      for (NodeId robot = 0; robot < box.node_count(); robot += 7)
        each_direction(1, box.solid() ? 1 : 0, [&](const Course& course) {
          const RobotSetup setup{.sensor_radius = radius, .sensor_angle = angle};
          const Senses senses(box, nothing, nothing, setup, robot, course);
          for (NodeId node = 0; node < box.node_count(); ++node) {
            const bool expected = expected_in_sight(setup, course, box.position(robot), box.position(node));
            ++(expected ? seen : unseen);
            ASSERT_EQ(senses.in_sight(node), expected)
                << angle << ' ' << radius << ' ' << robot << ' ' << node;
          }
        });
  EXPECT_GT(seen, 1000);
  EXPECT_GT(unseen, 1000);
}

TEST(Senses, SeeTheCellsOfTheirConeFromEveryPlaceInEveryDirection) {
  see_all_round(Box(9, 8));
  see_all_round(Box(6, 5, 4));
}

TEST(Senses, FindInTheirConeWhatDiffersAndForgetWhatIsOutOfIt) {
  const Box box(9, 9);
  std::vector<std::uint8_t> known(81), truth(81);
  const NodeId robot = box.node({4, 4}), ahead = box.node({7, 4}), behind = box.node({1, 4});
  truth[ahead] = truth[behind] = kWallBit;
  const RobotSetup setup{.sensor_radius = 4, .sensor_angle = 90};
  const std::vector<CellEdit> seen = Senses(box, known, truth, setup, robot, {1, 0, 0}).sense();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].node, ahead);
  known[ahead] = known[behind] = 1;
  const Sightings sightings = {behind, ahead};
  const std::vector<CellEdit> lost =
      Senses(box, known, truth, setup, robot, {1, 0, 0}).out_of_sight(sightings);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].node, behind);
}

Scenario hall() {
  Scenario scenario;
  scenario.map = GridMap(16, 9);
  scenario.start = {1, 4};
  scenario.goal = {14, 2};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.sensor_radius = 5, .sensor_angle = 60};
  return scenario;
}

/// Where the robot stood at each of its decisions and where it looked.
std::vector<Decision> decisions_of(const Scenario& scenario) {
  const auto mission = make_mission(scenario, scenario.planners[0]);
  std::vector<Decision> decisions;
  while (mission->advance(1 << 20))
    if (mission->standing()) decisions.push_back(mission->now());
  return decisions;
}

TEST(Course, IsThatOfTheLastMoveAndBeforeTheFirstThatToTheGoal) {
  const std::vector<Decision> decisions = decisions_of(hall());
  EXPECT_EQ(decisions.front().course, (Course{13, -2, 0}));
  ASSERT_GT(decisions.size(), 10u);
  Course last = decisions.front().course;
  for (std::size_t i = 1; i < decisions.size(); ++i) {
    if (decisions[i].figures.moves != decisions[i - 1].figures.moves)
      last = course_towards(decisions[i - 1].at, decisions[i].at);
    EXPECT_EQ(decisions[i].course, last) << i;
  }
}

TEST(Course, OfARobotThatIsPutDownIsThatToItsGoal) {
  Scenario scenario = hall();
  Surprise lifted;
  lifted.at.move = 3;
  lifted.robot = Cell{14, 8};
  scenario.surprises = {lifted};
  bool put_down = false;
  for (const Decision& decision : decisions_of(scenario))
    if (decision.at == centre_of(Cell{14, 8})) {
      EXPECT_EQ(decision.course, (Course{0, -6, 0}));
      put_down = true;
      break;
    }
  EXPECT_TRUE(put_down);
}

TEST(Course, OfARobotOnWheelsIsItsHeading) {
  Scenario scenario = hall();
  scenario.map.resolution = 0.5;
  scenario.robot.kind = "dwa";
  scenario.robot.settings.set("heading", 90);
  const std::vector<Decision> decisions = decisions_of(scenario);
  EXPECT_NEAR(decisions.front().course.x, 0, 1e-15);
  EXPECT_EQ(decisions.front().course.y, -1) << "90 degrees is up, and y counts downwards";
  for (const Decision& decision : decisions) {
    if (!decision.drive.begun) continue;
    EXPECT_NEAR(decision.course.x, std::cos(decision.drive.state.pose.heading), 1e-12);
    EXPECT_NEAR(decision.course.y, std::sin(decision.drive.state.pose.heading), 1e-12);
  }
  EXPECT_TRUE(decisions.back().drive.begun);
}

/// A wall that comes up beside the robot's way is seen when it is ahead, and not from farther away than that.
TEST(Mission, LearnsOfWhatItsConeMeetsAlone) {
  Scenario scenario = hall();
  scenario.goal = {14, 4};
  Surprise walls;
  walls.at.move = 2;
  for (const Cell cell : {Cell{2, 1}, Cell{3, 8}, Cell{12, 4}, Cell{8, 1}})
    walls.cells.push_back({cell, true});
  scenario.surprises = {walls};
  const auto learnt = [&](double angle) {
    scenario.robot.sensor_angle = angle;
    Recorder recorder;
    const auto mission = make_mission(scenario, scenario.planners[0], &recorder);
    while (mission->advance(1 << 20)) {
    }
    EXPECT_EQ(mission->state(), MissionState::arrived);
    std::vector<NodeId> cells;
    for (const Event& event : recorder.take())
      if (event.kind == EventKind::sensed) cells.push_back(event.node);
    return cells.size();
  };
  EXPECT_EQ(learnt(360), 4u);
  EXPECT_EQ(learnt(20), 1u);
}

/// What is drawn in a plane against what the cone holds: just inside the outline it sees, just outside it does not.
TEST(SonarScene, TheOutlineInAPlaneIsTheRimOfWhatTheConeHolds) {
  int looked_at = 0;
  for (const double angle : {20.0, 60.0, 90.0, 140.0, 240.0, 330.0})
    each_direction(1, 1, [&](const Course& course) {
      for (const double off : {0.0, 1.5, -2.5, 6.0}) {
        const SonarReach reach{{10, 10, 10}, course, 5, angle};
        for (const Point& point : outline_in_plane(reach, off)) {
          const Course to = course_towards(reach.at, point);
          EXPECT_NEAR(to.z, off, 1e-12);
          const double length = std::hypot(to.x, to.y, to.z);
          EXPECT_LE(length, 5 + 1e-9);
          if (length < 1e-9) continue;
          EXPECT_LE(angle_of(course, to), angle / 2 + 1e-6) << angle << ' ' << off;
          ++looked_at;
        }
      }
    });
  EXPECT_GT(looked_at, 10'000);
  // A sector of 90 degrees to the right.
  const std::vector<Point> sector = outline_in_plane({{0, 0, 0}, {1, 0, 0}, 2, 90}, 0);
  double least = 10, most = -10;
  for (const Point& point : sector) {
    least = std::min(least, point.y);
    most = std::max(most, point.y);
  }
  EXPECT_NEAR(most, std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(least, -std::numbers::sqrt2, 1e-9);
  EXPECT_TRUE(outline_in_plane({{0, 0, 0}, {0, 0, 1}, 2, 90}, -1).empty()) << "it looks the other way";
}

/// On its goal a robot has no course, and sees all round, as Cone has it.
TEST(SonarScene, WithoutACourseTheOutlineIsARing) {
  const std::vector<Point> ring = outline_in_plane({{5, 5, 0.5}, {0, 0, 0}, 3, 90}, 0);
  ASSERT_GT(ring.size(), 20u);
  for (const Point& point : ring) EXPECT_NEAR(distance(point, {5, 5, 0.5}), 3, 1e-9);
}

TEST(SonarScene, TheWiresInSpaceLieOnTheCone) {
  each_direction(1, 1, [](const Course& course) {
    for (const std::vector<Point>& wire : wires_of({{1, 2, 3}, course, 4, 50}))
      for (const Point& point : wire) {
        const Course to = course_towards({1, 2, 3}, point);
        const double length = std::hypot(to.x, to.y, to.z);
        EXPECT_LE(length, 4 + 1e-9);
        if (length < 1e-9) continue;
        EXPECT_LE(angle_of(course, to), 25 + 1e-9);
      }
  });
  EXPECT_EQ(wires_of({{1, 2, 3}, {1, 0, 0}, 4, 360}).size(), 3u);
}

/// The outlines of the sensor in a scene, in the world's coordinates.
std::vector<Point> drawn_outline(const Run& run, const View& view, const Box& world) {
  std::vector<Point> points;
  const SeenBox seen(world, view.slice.along);
  for (const Shape& shape : build_scene(run, view, {640, 480}, {}).shapes)
    if (const auto* line = std::get_if<Polyline>(&shape); line != nullptr && line->dash > 0)
      for (const Point& point : line->points) points.push_back(seen.world(point));
  return points;
}

/// In slices across every axis the sensor's outline lies in the cone that the world has it in.
TEST(SonarScene, SlicesAcrossEveryAxisCutTheSameCone) {
  Scenario scenario;
  scenario.map = GridMap(13, 11, 9);
  scenario.start = {6, 5, 4};
  scenario.goal = {11, 8, 2};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.sensor_radius = 4, .sensor_angle = 100};
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  const Point robot = centre_of(scenario.start);
  const Course course = course_towards(robot, centre_of(scenario.goal));
  for (const Axis along : {Axis::x, Axis::y, Axis::z}) {
    std::size_t drawn = 0;
    for (int layer = 0; layer < SeenBox(scenario.map.box(), along).depth(); ++layer) {
      View view;
      view.overlays = {};
      view.overlays.set(Overlay::sensor, true);
      view.slice = {along, layer};
      for (const Point& point : drawn_outline(session.run(), view, scenario.map.box())) {
        const Course to = course_towards(robot, point);
        const double length = std::hypot(to.x, to.y, to.z);
        EXPECT_LE(length, 4 + 1e-9);
        if (length < 1e-9) continue;
        EXPECT_LE(angle_of(course, to), 50 + 1e-6) << static_cast<int>(along) << ' ' << layer;
        ++drawn;
      }
    }
    EXPECT_GT(drawn, 100u) << static_cast<int>(along);
  }
}

}  // namespace
}  // namespace replan::sonar_test
