// Arcs, distances to what stands near, and what the dynamic window approach decides by.
#include <bit>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/base/random.hpp"
#include "core/drive/dynamic_window.hpp"
#include "core/drive/sub_goals.hpp"

namespace replan::drive_test {
namespace {

double between(Random& random, double low, double high) {
  return low + (high - low) * random.unit();
}

Spot any_spot(Random& random, double side) {
  const double x = random.unit() * side;
  return {x, random.unit() * side};
}

/// Squares of 0.1 m and discs on a ground of 6 x 6 m.
LocalObstacles any_obstacles(Random& random, int squares, int discs) {
  std::vector<Spot> known, unknown;
  for (int i = 0; i < squares; ++i) known.push_back(any_spot(random, 6));
  for (int i = 0; i < discs; ++i) unknown.push_back(any_spot(random, 6));
  LocalObstacles made;
  made.known = ObstacleSet({0.05, 0}, known);
  made.unknown = ObstacleSet({0, 0.075}, unknown);
  return made;
}

DriveSettings nimble() {
  Settings values;
  values.set("w_max", 1.5);
  values.set("angular_acceleration", 4);
  values.set("angular_brake", 4);
  return drive_settings(values);
}

TEST(Drive, GoesAlongTheCircleThatItsFormulaSays) {
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const Pose from{between(random, -9, 9), between(random, -9, 9), between(random, -3, 3)};
    const Twist motion{between(random, 0, 2), between(random, 0.05, 3) * (random.chance(0.5) ? 1 : -1)};
    const double time = between(random, 0, 5), radius = motion.v / motion.w;
    const Pose at = driven(from, motion, time);
    const double heading = from.heading + motion.w * time;
    EXPECT_NEAR(at.x, from.x + radius * (std::sin(heading) - std::sin(from.heading)), 1e-12);
    EXPECT_NEAR(at.y, from.y - radius * (std::cos(heading) - std::cos(from.heading)), 1e-12);
    EXPECT_NEAR(std::remainder(at.heading - heading, 2 * kPi), 0, 1e-14);
    const auto [sine, cosine] = Arc(from, motion).heading(time);
    EXPECT_NEAR(sine, std::sin(heading), 1e-14);
    EXPECT_NEAR(cosine, std::cos(heading), 1e-14);
  }
}

TEST(Drive, GoesStraightOnAndAlmostStraightOn) {
  const Pose from{1, 2, 0.5};
  for (const double w : {0.0, 1e-300, 1e-12, 1e-9, -1e-7}) {
    const Pose at = driven(from, {2, w}, 3);
    EXPECT_NEAR(at.x, 1 + 6 * std::cos(0.5), 1e-5 * std::abs(w) * 1e7 + 1e-14) << w;
    EXPECT_NEAR(at.y, 2 + 6 * std::sin(0.5), 1e-5 * std::abs(w) * 1e7 + 1e-14) << w;
  }
  const Pose turned = driven(from, {0, 1}, 2);
  EXPECT_EQ(turned.spot(), from.spot());
  EXPECT_EQ(turned.heading, 2.5);
}

TEST(Drive, IsASumOfShortDrives) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Twist motion{between(random, 0, 1), between(random, -2, 2)};
    Pose exact{0, 0, between(random, -3, 3)}, rough = exact;
    const Pose at = driven(exact, motion, 2);
    for (int step = 0; step < 2000; ++step) {
      exact = driven(exact, motion, 0.001);
      rough = euler_step(rough, motion, 0.001);
    }
    EXPECT_LT(distance(exact.spot(), at.spot()), 1e-12);
    EXPECT_LT(distance(rough.spot(), at.spot()), 0.003);  // the printed formula comes near with short steps
  }
}

TEST(LocalObstacles, TellTheDistanceThatAllOfThemTell) {
  Random random(3);
  for (int world = 0; world < 400; ++world) {
    const ObstacleShape shape{random.chance(0.5) ? between(random, 0, 0.6) : 0,
                              random.chance(0.5) ? between(random, 0, 0.4) : 0};
    std::vector<Spot> centres;
    const double side = world % 10 == 0 ? 200 : 6;
    for (int i = random.between(0, 300); i > 0; --i) centres.push_back(any_spot(random, side));
    const ObstacleSet set(shape, centres);
    EXPECT_EQ(set.centres().size(), centres.size());
    for (int i = 0; i < 100; ++i) {
      const Spot at = {between(random, -2, side + 2), between(random, -2, side + 2)};
      const double most = between(random, 0, world % 3 == 0 ? 500 : 2);
      double least = most;
      for (const Spot& centre : centres) {
        const double x = std::max(std::abs(at.x - centre.x) - shape.half, 0.0);
        const double y = std::max(std::abs(at.y - centre.y) - shape.half, 0.0);
        least = std::min(least, std::sqrt(x * x + y * y) - shape.radius);
      }
      EXPECT_NEAR(set.distance(at, most), least, 1e-12);
    }
  }
}

TEST(LocalObstacles, TakeOnlyCellsThatCanBeMet) {
  const CellFrame frame{Box(20, 20), 0.5};
  const auto block = [&](NodeId node) {
    const Cell cell = frame.box.position(node);
    return cell.x >= 5 && cell.x < 10 && cell.y >= 5 && cell.y < 10;
  };
  EXPECT_EQ(cells_around(frame, {5, 5}, 5, false, block).size(), 16u);        // the block's rim
  EXPECT_EQ(cells_around(frame, {5, 5}, 20, true, block).size(), 16u + 80u);  // and the border's inside
  EXPECT_EQ(cells_around(frame, {0.6, 0.6}, 1, false, block).size(), 0u);
}

/// By small steps along the arc.
double contact_by_steps(const Arc& arc, const LocalObstacles& obstacles, const DriveSettings& settings,
                        double most) {
  for (double time = 0; time < most; time += 0.0005)
    if (obstacles.to_still(arc.spot(time), 10) - settings.limits.radius < settings.margin) return time;
  return most;
}

TEST(DynamicWindow, FindsWhereAnArcMeetsSomething) {
  Random random(4);
  const DriveSettings settings = nimble();
  int met = 0;
  for (int i = 0; i < 800; ++i) {
    const LocalObstacles obstacles = any_obstacles(random, 40, 20);
    const Pose from{between(random, 1, 5), between(random, 1, 5), between(random, -3, 3)};
    if (obstacles.to_still(from.spot(), 10) < settings.limits.radius + settings.margin) continue;
    const Arc arc(from, {between(random, 0.05, 0.5), between(random, -1.5, 1.5)});
    const double found = time_to_contact(arc, obstacles, settings, 3);
    EXPECT_NEAR(found, contact_by_steps(arc, obstacles, settings, 3), 0.03);
    for (double time = 0; time < found; time += 0.01)
      EXPECT_GT(obstacles.to_still(arc.spot(time), 10), settings.limits.radius + settings.margin - 1e-5);
    met += found < 3 ? 1 : 0;
  }
  EXPECT_GT(met, 100);
}

TEST(DynamicWindow, IsWhatTheMotorsReach) {
  DriveSettings settings = nimble();
  settings.limits.brake = 1;
  const SpeedWindow window = dynamic_window({0.3, -0.2}, settings);
  EXPECT_DOUBLE_EQ(window.v_low, 0.1);
  EXPECT_DOUBLE_EQ(window.v_high, 0.4);
  EXPECT_DOUBLE_EQ(window.w_low, -1.0);
  EXPECT_DOUBLE_EQ(window.w_high, 0.6);
  const SpeedWindow fast = dynamic_window({0.5, 1.5}, settings);
  EXPECT_DOUBLE_EQ(fast.v_high, 0.5);
  EXPECT_DOUBLE_EQ(fast.w_high, 1.5);
  EXPECT_TRUE(window.contains({0.2, 0}));
  EXPECT_FALSE(window.contains({0.5, 0}));
}

/// Whatever it decides, a robot that brakes from then on comes to a stand before it touches anything.
TEST(DynamicWindow, LeavesRoomToStop) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    DriveSettings settings = nimble();
    settings.limits.brake = between(random, 0.1, 2);
    settings.limits.angular_brake = between(random, 0.1, 5);
    settings.period = between(random, 0.02, 0.4);
    const LocalObstacles obstacles = any_obstacles(random, 60, 30);
    DriveState state{{between(random, 1, 5), between(random, 1, 5), between(random, -3, 3)}, {}, 0};
    if (obstacles.to_still(state.pose.spot(), 10) < settings.limits.radius + settings.margin) continue;
    for (DriveSample& sample : explain(state, obstacles, {5, 5}, settings).samples) {
      if (!sample.admissible()) continue;
      Twist motion = sample.motion;
      for (Pose pose = state.pose; motion.v > 0; motion = braked(motion, settings)) {
        const Arc arc(pose, motion);
        for (int part = 0; part <= 4; ++part)
          ASSERT_GT(obstacles.to_still(arc.spot(settings.period * part / 4), 10), settings.limits.radius);
        pose = arc.pose(settings.period);
        const Twist slower = braked(motion, settings);
        ASSERT_GE(slower.v, motion.v - settings.limits.brake * settings.period - 1e-12);
        ASSERT_LE(std::abs(motion.w - slower.w), settings.limits.angular_brake * settings.period + 1e-12);
      }
    }
  }
}

TEST(DynamicWindow, KeepsEveryTermAndItsReason) {
  DriveSettings settings = nimble();
  settings.limits.acceleration = settings.limits.brake = 0.4;
  LocalObstacles obstacles;
  obstacles.known = ObstacleSet({0.05, 0}, std::vector<Spot>{{0.36, 0}});
  const DriveState state{{0, 0, 0}, {0.2, 0}, 0};
  const Explanation why = explain(state, obstacles, {3, 0}, settings);
  ASSERT_TRUE(why.decision.winner && why.runner_up);
  ASSERT_EQ(why.samples.size(), 200u);
  int too_fast = 0;
  for (const DriveSample& sample : why.samples) {
    too_fast += sample.rejection == Rejection::too_fast ? 1 : 0;
    EXPECT_TRUE(why.window.contains(sample.motion));
    double sum = 0;
    for (std::size_t i = 0; i < kScoreTerms; ++i) {
      EXPECT_EQ(sample.weighted[i], settings.weights[i] * sample.normalised[i]);
      sum += sample.weighted[i];
    }
    EXPECT_EQ(sample.score, sum);
    if (sample.admissible()) {
      EXPECT_LE(sample.score, why.decision.score);
      EXPECT_GE(sample.time, std::min(sample.stopping, settings.horizon));
    }
  }
  EXPECT_GT(too_fast, 0);
  const DriveSample &winner = why.samples[*why.decision.winner], &other = why.samples[*why.runner_up];
  const auto lost = static_cast<std::size_t>(why.lost_by);
  for (std::size_t i = 0; i < kScoreTerms; ++i)
    EXPECT_GE(winner.weighted[lost] - other.weighted[lost], winner.weighted[i] - other.weighted[i]);
  EXPECT_EQ(assess(state, obstacles, {3, 0}, settings, {0.5, 0}).rejection, Rejection::outside);
  const DriveSample ahead = assess(state, obstacles, {3, 0}, settings, {0.28, 0});
  EXPECT_EQ(ahead.rejection, Rejection::too_fast);
  EXPECT_TRUE(ahead.hits);
  EXPECT_NEAR(ahead.time * 0.28, 0.31 - settings.limits.radius - settings.margin, 0.002);
}

TEST(DynamicWindow, NormalisesTheThreeWaysThatItSays) {
  Random random(6);
  const LocalObstacles obstacles = any_obstacles(random, 30, 10);
  const DriveState state{{3, 3, 1}, {0, 0}, 0};
  for (const Normalise how : {Normalise::limits, Normalise::range, Normalise::sum}) {
    DriveSettings settings = nimble();
    settings.normalise = how;
    ScoreTerms least, most{}, sum{};
    least.fill(2);
    const Explanation why = explain(state, obstacles, {5, 5}, settings);
    for (const DriveSample& sample : why.samples)
      for (std::size_t i = 0; i < kScoreTerms && sample.admissible(); ++i) {
        least[i] = std::min(least[i], sample.normalised[i]);
        most[i] = std::max(most[i], sample.normalised[i]);
        sum[i] += sample.normalised[i];
      }
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_GE(least[i], 0);
      EXPECT_LE(most[i], 1);
      EXPECT_TRUE(how != Normalise::range || (least[i] == 0 && most[i] == 1));
      EXPECT_TRUE(how != Normalise::sum || std::abs(sum[i] - 1) < 1e-12);
    }
  }
}

TEST(DynamicWindow, DecidesAsItExplainsAndTheSameEverywhere) {
  Random random(7);
  std::uint64_t hash = 0;
  for (int i = 0; i < 300; ++i) {
    DriveSettings settings = nimble();
    settings.normalise = static_cast<Normalise>(i % 3);
    const LocalObstacles obstacles = any_obstacles(random, 80, 40);
    DriveState state;
    state.pose = {between(random, 0, 6), between(random, 0, 6), between(random, -3, 3)};
    state.motion.v = between(random, 0, 0.5);
    state.motion.w = between(random, -1.5, 1.5);
    const Spot goal = any_spot(random, 6);
    const DriveDecision decision = decide(state, obstacles, goal, settings);
    const Explanation why = explain(state, obstacles, goal, settings);
    EXPECT_EQ(decision, why.decision);
    for (const double value : {decision.motion.v, decision.motion.w, decision.score, decision.turned})
      hash = hash_combine(hash, std::bit_cast<std::uint64_t>(value));
    for (const DriveSample& sample : why.samples)
      hash = hash_combine(hash, std::bit_cast<std::uint64_t>(sample.score));
  }
  EXPECT_EQ(hash, 0xd8fe42a4d196985du);
}

TEST(DynamicWindow, BrakesThenTurnsThenSaysThatItIsStuck) {
  const DriveSettings settings = nimble();
  std::vector<Spot> ring;  // round the robot, too near to drive anywhere
  for (int i = 0; i < 60; ++i) ring.push_back({std::cos(i * kPi / 30), std::sin(i * kPi / 30)});
  LocalObstacles obstacles;
  obstacles.known = ObstacleSet({0, 0.814}, ring);
  DriveState state{{0, 0, 0}, {0.4, 0}, 0};
  std::string deeds;
  for (int tick = 0; tick < 60; ++tick) {
    const DriveDecision decision = decide(state, obstacles, {3, 1}, settings);
    const std::string deed(drive_deed_name(decision.deed));
    if (!deeds.ends_with(deed)) deeds += " " + deed;
    state = {driven(state.pose, {0, decision.motion.w}, settings.period), decision.motion, decision.turned};
  }
  EXPECT_EQ(deeds, " brake turn stuck");
  EXPECT_EQ(state.motion, (Twist{0, 0}));
  EXPECT_GE(state.turned, 2 * kPi);  // towards the goal's side
}

TEST(DynamicWindow, TurnsTowardsTheSideThatIsFree) {
  const DriveSettings settings = nimble();
  std::vector<Spot> wall;  // ahead and to the side of the goal
  for (int i = 0; i < 40; ++i) wall.push_back({0.236, 1.2 - 0.05 * i});
  for (int i = 0; i < 40; ++i) wall.push_back({0.236 - 0.05 * i, 0.236});
  LocalObstacles obstacles;
  obstacles.known = ObstacleSet({0.05, 0}, wall);
  const DriveDecision decision = decide({{0, 0, 0.6}, {0, 0}, 0}, obstacles, {0.5, 3}, settings);
  EXPECT_EQ(decision.deed, DriveDeed::turn);
  EXPECT_LT(decision.motion.w, 0);
}

TEST(SubGoals, AreTakenInOrder) {
  const std::vector<Spot> turns = {{0, 0}, {1, 0}, {1, 1}, {3, 1}};
  const auto blind = [](Spot) { return false; };
  EXPECT_EQ(next_sub_goal(turns, 0, {0, 0}, 0.2, blind), 1u);
  EXPECT_EQ(next_sub_goal(turns, 1, {0.5, 0}, 0.2, blind), 1u);
  EXPECT_EQ(next_sub_goal(turns, 1, {0.9, 0}, 0.2, blind), 2u);
  EXPECT_EQ(next_sub_goal(turns, 1, {0.5, 0}, 0.2, [](Spot spot) { return spot.y < 2; }), 3u);
  EXPECT_EQ(next_sub_goal(turns, 1, {0.5, 0}, 0.2, [](Spot spot) { return spot.x < 2; }), 2u);
  EXPECT_EQ(next_sub_goal(turns, 3, {3, 1}, 0.2, blind), 3u);
}

}  // namespace
}  // namespace replan::drive_test
