// What a robot with two driven wheels can do at once, and whether it can stop in time.
#pragma once

#include "core/drive/drive_settings.hpp"
#include "core/drive/local_obstacles.hpp"
#include "core/drive/motion.hpp"

namespace replan {

/// The motions within reach.
struct SpeedWindow {
  double v_low = 0, v_high = 0;
  double w_low = 0, w_high = 0;
  [[nodiscard]] bool contains(const Twist& motion) const {
    return motion.v >= v_low && motion.v <= v_high && motion.w >= w_low && motion.w <= w_high;
  }
};

/// The speed limits, cut down to what can be reached from this motion within a period.
SpeedWindow dynamic_window(const Twist& now, const DriveSettings& settings);

/// The way that it needs to stop in after a period at that motion, as the time that the motion itself would take for
/// it.
double stopping_time(const Twist& motion, const DriveSettings& settings);
/// How long the robot can drive along an arc before it touches something, at most `most` seconds; at most a millimetre
/// of its way too short. What moves comes nearer while a robot on that arc brakes.
double time_to_contact(const Arc& arc, const LocalObstacles& obstacles, const DriveSettings& settings,
                       double most);
/// The motion after a period of braking.
Twist braked(const Twist& motion, const DriveSettings& settings);

}  // namespace replan
