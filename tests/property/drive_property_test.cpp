// Robots that drive by the dynamic window approach, along a global plan, among walls that they know, blocks that they do
// not know, and discs that wander about slower than they are. Whoever wanders waits rather than run into the robot; what
// the robot touches it has driven into.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/drive/dynamic_window.hpp"
#include "core/drive/sub_goals.hpp"
#include "core/lattice/segment.hpp"
#include "core/plan/navigator.hpp"

namespace replan::drive_property_test {
namespace {

constexpr int kSide = 40;  // cells
constexpr double kCell = 0.25, kSight = 2, kWanderer = 0.2, kPatience = 1;
constexpr int kParts = 8;  // of a period, in which things move by turns

const CellFrame kFrame{Box(kSide, kSide), kCell};
const ObstacleShape kSquare{kCell / 2, 0}, kDisc{0, kWanderer};

DriveSettings settings_of(Random& random) {
  Settings values;
  for (const char* key : {"acceleration", "brake"}) values.set(key, 0.5 + random.unit());
  for (const char* key : {"angular_acceleration", "angular_brake"}) values.set(key, 2 + 4 * random.unit());
  values.set("w_max", 1 + random.unit());
  values.set("period", 0.1);
  values.set("horizon", 1.5);
  values.set("reach", 0.5);
  values.set("speeds", 6);
  values.set("turns", 15);
  return drive_settings(values);
}

struct Wanderer {
  Spot at, a, b;
  double speed = 0, waited = 0;
};

using Cells = std::vector<std::uint8_t>;

/// The cells whose centre is nearer than `radius` to an obstacle cell's square.
Cells grown(const Cells& cells, double radius) {
  std::vector<Spot> centres;
  for (NodeId node = 0; node < cells.size(); ++node)
    if (cells[node] != 0) centres.push_back(kFrame.centre(kFrame.box.position(node)));
  const ObstacleSet set(kSquare, centres);
  Cells result(cells.size());
  for (NodeId node = 0; node < cells.size(); ++node)
    result[node] = set.distance(kFrame.centre(kFrame.box.position(node)), radius) < radius ? 1 : 0;
  return result;
}

enum class End { arrived, hit, late, pointless };

class Drive {
 public:
  explicit Drive(std::uint64_t seed) : random_(seed), settings_(settings_of(random_)) {}

  End go() {
    if (!build()) return End::pointless;
    for (double time = 0; time < 300; time += settings_.period) {
      look(time);
      const Spot sub_goal = next();
      const DriveDecision decision = decide(state_, obstacles_, sub_goal, settings_);
      EXPECT_EQ(decision.motion, explain(state_, obstacles_, sub_goal, settings_).decision.motion);
      state_.turned = decision.deed == DriveDeed::stuck ? 0 : decision.turned;
      if (!move(decision.motion)) return End::hit;
      if (distance(state_.pose.spot(), goal_) < 0.3) return End::arrived;
    }
    return End::late;
  }

 private:
  [[nodiscard]] double plan_radius() const { return settings_.limits.radius + 0.03; }

  Spot free_spot(const Cells& closed) {
    for (;;) {
      const int x = random_.between(1, kSide - 2), y = random_.between(1, kSide - 2);
      if (closed[kFrame.box.node({x, y})] == 0) return kFrame.centre({x, y});
    }
  }

  bool build() {
    known_.assign(kFrame.box.node_count(), 0);
    for (int wall = 0; wall < 12; ++wall) {
      const int x = random_.between(0, kSide - 1), y = random_.between(0, kSide - 1),
                length = random_.between(1, 9);
      const bool down = random_.chance(0.5);
      for (int i = 0; i < length; ++i)
        if (const Cell cell = down ? Cell{x, y + i} : Cell{x + i, y}; kFrame.box.contains(cell))
          known_[kFrame.box.node(cell)] = 1;
    }
    truth_ = known_;
    for (int block = 0; block < 10; ++block) {
      const int x = random_.between(0, kSide - 2), y = random_.between(0, kSide - 2);
      for (const Cell cell : {Cell{x, y}, Cell{x + 1, y}, Cell{x, y + 1}}) truth_[kFrame.box.node(cell)] = 1;
    }
    const Cells closed = grown(truth_, plan_radius());
    const Spot start = free_spot(closed);
    goal_ = free_spot(closed);
    if (distance(start, goal_) < 3) return false;
    state_.pose = {start.x, start.y, 6 * random_.unit() - 3};
    for (int i = random_.between(1, 4); i > 0; --i) {
      Wanderer wanderer{free_spot(closed), free_spot(closed), free_spot(closed), 0.05 + 0.2 * random_.unit(),
                        0};
      if (distance(wanderer.at, start) > 1) wanderers_.push_back(wanderer);
    }
    const auto navigator = plan_on(closed, start);
    return navigator->status() == PlanStatus::found;
  }

  std::unique_ptr<Navigator> plan_on(const Cells& closed, Spot from) const {
    auto navigator =
        make_navigator({"adaptive-astar", {}, {{"floyd", {}}}}, kFrame.box, SharedBytes(closed), 0);
    navigator->begin(centre_of(kFrame.cell(from)), centre_of(kFrame.cell(goal_)));
    finish(*navigator);
    return navigator;
  }

  /// What is in sight; the plan takes in what does not move, once a second.
  void look(double time) {
    const Spot robot = state_.pose.spot();
    seen_.resize(truth_.size());
    for (NodeId node = 0; node < truth_.size(); ++node)
      if (distance(kFrame.centre(kFrame.box.position(node)), robot) < kSight) seen_[node] = truth_[node];
    if (time >= planned_at_ + 1 || turns_.empty()) plan(time);
    const double reach = settings_.limits.v_max * 3 + settings_.limits.radius;
    const auto around = [&](bool planned) {
      return cells_around(kFrame, robot, reach, planned, [&](NodeId node) {
        const bool is_planned = planned_[node] != 0;
        return planned ? is_planned : !is_planned && seen_[node] != 0;
      });
    };
    std::vector<Spot> moving;
    for (const Wanderer& wanderer : wanderers_)
      if (distance(wanderer.at, robot) < kSight) moving.push_back(wanderer.at);
    obstacles_.known = ObstacleSet(kSquare, around(true));
    obstacles_.unknown = ObstacleSet(kSquare, around(false));
    obstacles_.moving = ObstacleSet(kDisc, moving);
    obstacles_.speed_of_moving = 0.25;
  }

  void plan(double time) {
    planned_ = known_;
    for (NodeId node = 0; node < seen_.size(); ++node) planned_[node] |= seen_[node];
    closed_ = grown(planned_, plan_radius());
    Spot from = state_.pose.spot();
    double nearest = 9;
    for (NodeId node = 0; node < closed_.size(); ++node) {
      const Spot centre = kFrame.centre(kFrame.box.position(node));
      if (closed_[node] == 0 && distance(centre, state_.pose.spot()) < nearest) {
        nearest = distance(centre, state_.pose.spot());
        from = centre;
      }
    }
    const Path path = plan_on(closed_, from)->path();
    turns_.clear();
    for (std::size_t i = 0; i < path.size(); ++i)
      turns_.push_back({path.point(i).x * kCell, path.point(i).y * kCell});
    at_ = 0;
    planned_at_ = time;
  }

  Spot next() {
    if (turns_.empty()) return goal_;
    const auto point = [](Spot spot) { return Point{spot.x / kCell, spot.y / kCell, 0.5}; };
    at_ = next_sub_goal(turns_, at_, state_.pose.spot(), 0.2, [&](Spot turn) {
      return walk_segment(kFrame.box, point(state_.pose.spot()), point(turn),
                          [this](NodeId node) { return closed_[node] == 0; });
    });
    return turns_[at_];
  }

  /// False if the robot drives into something.
  bool move(const Twist& motion) {
    const Arc arc(state_.pose, motion);
    const double part = settings_.period / kParts, radius = settings_.limits.radius;
    std::vector<Spot> blocks;
    for (NodeId node = 0; node < truth_.size(); ++node)
      if (truth_[node] != 0) blocks.push_back(kFrame.centre(kFrame.box.position(node)));
    const ObstacleSet walls(kSquare, blocks);
    for (int i = 1; i <= kParts; ++i) {
      const Spot robot = arc.spot(part * i);
      if (walls.distance(robot, 1) < radius) return false;
      for (Wanderer& wanderer : wanderers_) {
        if (distance(robot, wanderer.at) < radius + kWanderer) return false;
        wander(wanderer, robot, part);
      }
    }
    state_.pose = arc.pose(settings_.period);
    state_.motion = motion;
    return true;
  }

  void wander(Wanderer& wanderer, Spot robot, double time) const {
    const double left = distance(wanderer.at, wanderer.b), step = wanderer.speed * time;
    if (left <= step || wanderer.waited > kPatience) {
      std::swap(wanderer.a, wanderer.b);
      wanderer.waited = 0;
      return;
    }
    const Spot to = {wanderer.at.x + (wanderer.b.x - wanderer.at.x) * step / left,
                     wanderer.at.y + (wanderer.b.y - wanderer.at.y) * step / left};
    if (distance(to, robot) < settings_.limits.radius + kWanderer + 0.001)
      wanderer.waited += time;
    else
      wanderer.at = to;
  }

  Random random_;
  DriveSettings settings_;
  Cells known_, truth_, seen_, planned_, closed_;
  std::vector<Wanderer> wanderers_;
  DriveState state_;
  Spot goal_;
  LocalObstacles obstacles_;
  std::vector<Spot> turns_;
  std::size_t at_ = 0;
  double planned_at_ = 0;
};

void drive(int missions) {
  int arrived = 0, late = 0, driven = 0;
  for (std::uint64_t seed = 1; driven < missions; ++seed) {
    const End end = Drive(seed).go();
    if (end == End::pointless) continue;
    ++driven;
    EXPECT_NE(end, End::hit) << "seed " << seed;
    arrived += end == End::arrived ? 1 : 0;
    late += end == End::late ? 1 : 0;
    if (end == End::late) std::printf("seed %d is late\n", static_cast<int>(seed));
  }
  std::printf("%d missions: %d arrived, %d were late\n", driven, arrived, late);
  EXPECT_GE(arrived, 0.95 * driven);
}

TEST(DriveMissions, HitNothingAndArrive) {
  drive(150);
}
TEST(DriveMissions, HugeWorldOfFiveThousand) {
  drive(5000);
}

}  // namespace
}  // namespace replan::drive_property_test
