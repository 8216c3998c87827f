#include "core/drive/braking.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace replan {
namespace {

/// Braking ends at a stand, and not at what roundings leave of a speed.
double settled(double speed) {
  return std::abs(speed) < 1e-12 ? 0 : speed;
}

/// The least and the greatest value within reach of `now`: rising from 0 at one rate, falling to 0 at another.
std::pair<double, double> within_reach(double now, double rise, double fall, double period) {
  const double up = now >= 0 ? now + rise * period : std::min(now + fall * period, rise * period);
  const double down = now <= 0 ? now - rise * period : std::max(now - fall * period, -rise * period);
  return {settled(down), settled(up)};
}

/// What the speed can fall by in a second if the turn rate falls in the same measure.
double common_brake(const Twist& motion, const DriveLimits& limits) {
  const double turn = std::abs(motion.w);
  if (turn * limits.brake <= motion.v * limits.angular_brake) return limits.brake;
  return motion.v * limits.angular_brake / turn;
}

}  // namespace

SpeedWindow dynamic_window(const Twist& now, const DriveSettings& settings) {
  const DriveLimits& limits = settings.limits;
  const auto [v_down, v_up] = within_reach(now.v, limits.acceleration, limits.brake, settings.period);
  const auto [w_down, w_up] =
      within_reach(now.w, limits.angular_acceleration, limits.angular_brake, settings.period);
  const double v_low = std::clamp(v_down, limits.v_min, limits.v_max);
  const double w_low = std::clamp(w_down, -limits.w_max, limits.w_max);
  return {v_low, std::clamp(v_up, v_low, limits.v_max), w_low, std::clamp(w_up, w_low, limits.w_max)};
}

double stopping_time(const Twist& motion, const DriveSettings& settings) {
  if (motion.v <= 0) return 0;
  return settings.period + motion.v / (2 * common_brake(motion, settings.limits));
}

Twist braked(const Twist& motion, const DriveSettings& settings) {
  if (motion.v <= 0) {
    const double less = std::max(std::abs(motion.w) - settings.limits.angular_brake * settings.period, 0.0);
    return {0, motion.w < 0 ? -less : less};
  }
  const double v = settled(std::max(motion.v - common_brake(motion, settings.limits) * settings.period, 0.0));
  return {v, motion.w * (v / motion.v)};
}

double time_to_contact(const Arc& arc, const LocalObstacles& obstacles, const DriveSettings& settings,
                       double most) {
  const double v = arc.motion().v;
  if (v <= 0) return most;
  const double radius = settings.limits.radius, far = radius + settings.reach + settings.margin;
  const double stopping = stopping_time(arc.motion(), settings), approach = v + 2 * obstacles.speed_of_moving;
  // What braking takes altogether, and at most until the robot is where the arc is after `time` (see the test).
  const double to_stand = 2 * stopping - settings.period;
  const auto braking = [&](double time) {
    return std::min(time + std::max(0.0, time - settings.period), to_stand);
  };
  constexpr double kLeastStep = 0.001;  // m
  double kept = settings.margin, last = 0;
  for (double time = 0; time < most;) {
    const Spot at = arc.spot(time);
    double gap = obstacles.to_still(at, far) - radius;
    if (!obstacles.moving.empty())
      gap = std::min(gap, obstacles.to_moving(at, arc.heading(time), braking(time), far) - radius);
    if (time == 0) kept = std::min(kept, gap - 1e-9);
    if (gap < kept) return last;
    last = time;
    time += std::max(gap - kept, kLeastStep) / approach;
  }
  return most;
}

}  // namespace replan
