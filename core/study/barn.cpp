#include "core/study/barn.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "core/base/threads.hpp"
#include "core/drive/sub_goals.hpp"
#include "core/plan/navigator.hpp"
#include "core/study/barn_map.hpp"

namespace replan {
namespace {

/// The global plan of a robot in a BARN world, on its map grown by one radius.
class Guide {
 public:
  Guide(const BarnWorld& world, const BarnSettings& settings, double radius)
      : world_(world), settings_(settings), map_(world, settings.cell, radius) {}

  [[nodiscard]] const BarnMap& map() const { return map_; }
  [[nodiscard]] const std::vector<Spot>& turns() const { return turns_; }
  [[nodiscard]] bool found() const { return !turns_.empty(); }

  void mark(const std::vector<Spot>& hits) { map_.mark(hits, pending_); }
  /// Whether the way that is left of the plan has been closed.
  [[nodiscard]] bool blocked(Spot robot, std::size_t at) const;
  /// Plans from there.
  void plan(Spot robot);

 private:
  [[nodiscard]] std::optional<Cell> free_cell_near(Spot at, double most) const;

  const BarnWorld& world_;
  const BarnSettings& settings_;
  BarnMap map_;
  std::vector<CellEdit> pending_;
  std::unique_ptr<Navigator> navigator_;
  std::vector<Spot> turns_;
};

bool Guide::blocked(Spot robot, std::size_t at) const {
  const auto seen = [this](Spot a, Spot b) { return map_.sees(a, b); };
  if (map_.inflated(map_.frame().box.node(map_.frame().cell(robot)))) return false;
  for (std::size_t i = at; i + 1 < turns_.size(); ++i)
    if (!seen(turns_[i], turns_[i + 1])) return true;
  return false;
}

/// The cell nearest to a robot from which a plan can begin: its own may be closed, as the map is coarser than the world.
std::optional<Cell> Guide::free_cell_near(Spot at, double most) const {
  const CellFrame& frame = map_.frame();
  std::optional<Cell> best;
  double least = most;
  frame.box.each_cell_around(frame.cell(at), static_cast<int>(most / frame.side) + 1, [&](NodeId node) {
    const Cell cell = frame.box.position(node);
    const double far = distance(frame.centre(cell), at);
    if (map_.inflated(node) || far >= least) return;
    best = cell;
    least = far;
  });
  return best;
}

void Guide::plan(Spot robot) {
  const CellFrame& frame = map_.frame();
  turns_.clear();
  const auto start = free_cell_near(robot, 2 * settings_.drive.limits.radius);
  if (!start) return;
  if (!navigator_) {
    navigator_ = make_navigator(settings_.global, frame.box, SharedBytes(map_.closed()), 0);
    navigator_->begin(centre_of(*start), centre_of(frame.cell(world_.goal)));
  } else {
    navigator_->learn(pending_);
    navigator_->update(centre_of(*start));
  }
  pending_.clear();
  if (finish(*navigator_) != PlanStatus::found) return;
  const Path path = navigator_->path();
  for (std::size_t i = 0; i < path.size(); ++i)
    turns_.push_back({path.point(i).x * frame.side, path.point(i).y * frame.side});
}

/// One robot on its way.
class BarnRun {
 public:
  BarnRun(const BarnWorld& world, const BarnSettings& settings)
      : world_(world),
        settings_(settings),
        laser_(world, settings),
        wide_(world, settings, settings.drive.limits.radius + settings.clearance),
        narrow_(world, settings, settings.drive.limits.radius),
        truth_({0, world.disc_radius}, world.discs) {
    state_.pose = world.start;
    drive_.world = world.number;
    planned_.resize(wide_.map().cells().size());
  }
  BarnDrive drive();

 private:
  [[nodiscard]] bool guided() const { return !settings_.global.id.empty(); }
  [[nodiscard]] Guide& guide() { return wide_.found() || !narrow_.found() ? wide_ : narrow_; }
  void look();
  void replan();
  void keep_plan_fresh();
  [[nodiscard]] Spot sub_goal();
  [[nodiscard]] LocalObstacles obstacles() const;
  [[nodiscard]] bool move(const Twist& motion);
  void count(const DriveDecision& decision);

  const BarnWorld& world_;
  const BarnSettings& settings_;
  BarnLaser laser_;
  Guide wide_, narrow_;
  ObstacleSet truth_;
  std::vector<std::uint8_t> planned_;  // what was marked when the plan was made
  std::size_t turn_ = 0;
  double planned_at_ = -1e9;
  bool must_replan_ = true;
  DriveState state_;
  BarnDrive drive_;
};

void BarnRun::look() {
  const std::vector<Spot> hits = laser_.scan(state_.pose);
  wide_.mark(hits);
  narrow_.mark(hits);
}

void BarnRun::replan() {
  ++drive_.replans;
  wide_.plan(state_.pose.spot());
  if (!wide_.found()) narrow_.plan(state_.pose.spot());
  if (!guide().found()) ++drive_.no_path;
  planned_ = wide_.map().cells();
  planned_at_ = drive_.time;
  turn_ = 0;
  must_replan_ = false;
}

void BarnRun::keep_plan_fresh() {
  const bool due = drive_.time - planned_at_ >= settings_.replan_every - 1e-9;
  if (must_replan_ || due || guide().blocked(state_.pose.spot(), turn_)) replan();
}

Spot BarnRun::sub_goal() {
  if (!guided() || !guide().found()) return world_.goal;
  const Guide& guide = this->guide();
  const Spot robot = state_.pose.spot();
  turn_ = next_sub_goal(guide.turns(), turn_, robot, settings_.next_turn,
                        [&](Spot turn) { return guide.map().sees(robot, turn); });
  return guide.turns()[turn_];
}

LocalObstacles BarnRun::obstacles() const {
  const DriveSettings& drive = settings_.drive;
  const double reach = drive.limits.v_max * drive.horizon + drive.limits.radius + drive.reach;
  const auto& marked = wide_.map().cells();
  const auto around = [&](bool planned) {
    return cells_around(wide_.map().frame(), state_.pose.spot(), reach, false,
                        [&](NodeId node) { return marked[node] != 0 && (planned_[node] != 0) == planned; });
  };
  const ObstacleShape cell{settings_.cell / 2, 0};
  LocalObstacles obstacles;
  obstacles.known = ObstacleSet(cell, around(true));
  obstacles.unknown = ObstacleSet(cell, around(false));
  return obstacles;
}

/// False if the robot hits something. It is looked at every few millimetres of its way.
bool BarnRun::move(const Twist& motion) {
  const double period = settings_.drive.period;
  const Arc arc(state_.pose, motion);
  constexpr int kParts = 10;
  for (int i = 1; i <= kParts; ++i) {
    const double gap = truth_.distance(arc.spot(period * i / kParts), 10) - settings_.drive.limits.radius;
    drive_.least_gap = std::min(drive_.least_gap, gap);
  }
  state_.pose = arc.pose(period);
  state_.motion = motion;
  drive_.way += motion.v * period;
  drive_.time += period;
  drive_.track.push_back(state_.pose);
  return drive_.least_gap >= 0;
}

void BarnRun::count(const DriveDecision& decision) {
  drive_.brakes += decision.deed == DriveDeed::brake ? 1 : 0;
  drive_.turns += decision.deed == DriveDeed::turn ? 1 : 0;
  if (decision.deed != DriveDeed::stuck) return;
  ++drive_.stuck;
  must_replan_ = true;
  state_.turned = 0;
}

BarnDrive BarnRun::drive() {
  drive_.least_gap = world_.width;
  const auto to_goal = [this] { return distance(state_.pose.spot(), world_.goal); };
  drive_.end = BarnEnd::timeout;
  while (drive_.time < world_.timeout - 1e-9) {
    look();
    if (guided()) keep_plan_fresh();
    const DriveDecision decision = decide(state_, obstacles(), sub_goal(), settings_.drive);
    state_.turned = decision.turned;
    count(decision);
    if (!move(decision.motion)) {
      drive_.end = BarnEnd::collision;
      break;
    }
    if (to_goal() <= world_.tolerance) {
      drive_.end = BarnEnd::success;
      break;
    }
  }
  drive_.to_goal = to_goal();
  const double best = world_.optimal_time;
  if (drive_.end == BarnEnd::success) drive_.score = best / std::clamp(drive_.time, 2 * best, 8 * best);
  return std::move(drive_);
}

}  // namespace

BarnDrive drive_barn(const BarnWorld& world, const BarnSettings& settings) {
  return BarnRun(world, settings).drive();
}

Settings barn_drive() {
  Settings settings;
  const auto set = [&settings](std::string_view key, double value) { settings.set(key, value); };
  set("radius", 0.267);
  set("w_max", 1.57);
  for (const char* key : {"acceleration", "brake"}) set(key, 10);
  for (const char* key : {"angular_acceleration", "angular_brake"}) set(key, 20);
  set("period", 0.05);
  set("horizon", 1);
  set("reach", 0.3);
  return settings;
}

BarnSettings barn_settings(const Settings& drive, const std::string& global) {
  Settings all = barn_drive();
  for (const auto& [key, value] : drive.values()) all.set(key, value);
  BarnSettings settings;
  settings.drive = drive_settings(all);
  settings.global.id = global;
  settings.global.stages = {{"floyd", {}}};
  return settings;
}

std::vector<BarnDrive> drive_barn(const std::vector<BarnWorld>& worlds, const BarnSettings& settings) {
  std::vector<BarnDrive> drives(worlds.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < worlds.size(); i = next++) drives[i] = drive_barn(worlds[i], settings);
  };
  work_on_threads(processor_count(), work);
  return drives;
}

}  // namespace replan
