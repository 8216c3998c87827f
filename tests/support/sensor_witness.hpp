// Holds a mission's sensor and its limits to what they promise, by angles and distances in long double: the robot knows all
// that its sensor reaches, learns of nothing else by itself, and turns, climbs and goes no faster than it can.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"

namespace replan::test {

class SensorWitness {
 public:
  explicit SensorWitness(const Scenario& scenario) : robot_(scenario.robot), box_(scenario.map.box()) {}

  /// Before the mission takes its next step: where the robot looks, and when that is.
  void look(const Decision& now) {
    before_ = now;
    told_ = false;
  }
  /// A surprise tells the robot of cells, wherever they are, until the next look().
  void is_told() { told_ = true; }

  /// On learning of a cell.
  [[nodiscard]] std::string sensed_fault(NodeId robot, NodeId cell) const {
    const bool within = near(robot, cell, 1 + std::ceil(robot_.radius)) || reaches(robot, cell, kHair);
    return told_ || within ? "" : "the robot sees farther than its sensor, at cell " + std::to_string(cell);
  }
  /// Before a move, or in the end: what the sensor reaches is on the map as it is.
  [[nodiscard]] std::string sight_fault(const SearchState& state, NodeId robot, const Course& course) const {
    for (NodeId n = 0; n < box_.node_count(); ++n) {
      if (n == robot || state.known_blocked(n) == state.truly_blocked(n)) continue;
      const bool hidden = robot_.sensor_blocked && !near(robot, n, 1);
      if (!hidden && reaches(robot, n, -kHair, &course))
        return "the robot does not see cell " + std::to_string(n);
    }
    return "";
  }
  [[nodiscard]] std::string sight_fault(const SearchState& state, NodeId robot) const {
    return sight_fault(state, robot, before_.course);
  }
  /// Its latest step with all corners that its path has on the way.
  [[nodiscard]] std::vector<Point> way_of(const Decision& now) const {
    std::vector<Point> way = {now.before};
    Real walked = 0;
    for (std::size_t i = 1; i < now.plan->path->size(); ++i) {
      walked += distance(now.plan->path->point(i - 1), now.plan->path->point(i));
      if (walked > before_.along_plan + kHair && walked < now.along_plan - kHair)
        way.push_back(now.plan->path->point(i));
    }
    way.push_back(now.at);
    return way;
  }
  /// After a step of a robot that has such limits.
  [[nodiscard]] std::string limit_fault(const Decision& now) const {
    if (!now.figures.kept || now.clock == before_.clock || now.figures.moves == before_.figures.moves)
      return turn_fault(now);
    const auto setting = [&](const char* key, double usual) { return robot_.settings.get(key, usual); };
    Real curves = 0, stops = 0, way = 0, climbed = 0;
    Course course = before_.course;
    for (const Piece& piece : driven(now)) {
      const Real angle = angle_of(course, piece.course);
      (angle > setting("corner", 30) + kHair ? stops : curves) += angle;
      way += piece.length;
      climbed += piece.length * std::abs(Real(piece.course.z)) /
                 std::hypot(Real(piece.course.x), Real(piece.course.y), Real(piece.course.z));
      course = piece.course;
    }
    if (angle_of(course, now.course) > kHair) return "it looks elsewhere than along its path";
    const Real least =
        stops / setting("turn_rate", 45) +
        std::max({curves / setting("turn_rate", 45), way / robot_.speed, climbed / setting("climb_rate", 2)});
    return std::abs(seconds(now) - least) <= kTick ? "" : "it moves faster or slower than it can";
  }

 private:
  using Real = long double;
  static constexpr Real kHair = 1e-9L, kTick = 5e-6L;

  static Real angle_of(const Course& a, const Course& b) {
    const Real ax = a.x, ay = a.y, az = a.z, bx = b.x, by = b.y, bz = b.z;
    const Real x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
    return std::atan2(std::sqrt(x * x + y * y + z * z), ax * bx + ay * by + az * bz) * 180 /
           std::numbers::pi_v<Real>;
  }
  [[nodiscard]] Real seconds(const Decision& now) const {
    return static_cast<Real>(now.time - before_.time) / static_cast<Real>(kSecond);
  }
  /// A straight part of its latest step along its path, and its length.
  struct Piece {
    Course course;
    Real length;
  };
  [[nodiscard]] std::vector<Piece> driven(const Decision& now) const {
    std::vector<Piece> pieces;
    const Path& path = *now.plan->path;
    Real begin = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Real end = begin + distance(path.point(i - 1), path.point(i));
      const Real part = std::min<Real>(end, now.along_plan) - std::max<Real>(begin, before_.along_plan);
      if (part > kHair) pieces.push_back({course_towards(path.point(i - 1), path.point(i)), part});
      begin = end;
    }
    return pieces;
  }
  /// It has turned on the spot, or not at all.
  [[nodiscard]] std::string turn_fault(const Decision& now) const {
    if (!now.figures.kept || now.figures.kept->stops == before_.figures.kept->stops) return "";
    const Real least = angle_of(before_.course, now.course) / robot_.settings.get("turn_rate", 45);
    if (now.figures.moves != before_.figures.moves) return "it turns on the spot and moves in one step";
    return std::abs(seconds(now) - least) <= kTick ? "" : "it turns faster or slower than it can";
  }
  [[nodiscard]] bool near(NodeId a, NodeId b, double reach) const {
    const Cell from = box_.position(a), to = box_.position(b);
    return std::abs(from.x - to.x) <= reach && std::abs(from.y - to.y) <= reach &&
           std::abs(from.z - to.z) <= reach;
  }
  /// Whether the sensor reaches the cell, with so much to spare.
  [[nodiscard]] bool reaches(NodeId robot, NodeId cell, Real more, const Course* course = nullptr) const {
    if (near(robot, cell, 1)) return true;
    const Cell a = box_.position(robot), b = box_.position(cell);
    const Course to{double(b.x - a.x), double(b.y - a.y), double(b.z - a.z)};
    if (std::hypot(Real(to.x), Real(to.y), Real(to.z)) > robot_.sensor_radius + more) return false;
    const Course& axis = course != nullptr ? *course : before_.course;
    return robot_.sensor_angle >= 360 || axis.none() || angle_of(axis, to) <= robot_.sensor_angle / 2 + more;
  }

  const RobotSetup& robot_;
  Box box_;
  Decision before_;
  bool told_ = false;
};

}  // namespace replan::test
