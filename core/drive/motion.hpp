// How a robot with two driven wheels moves: along arcs. In metres, radians and seconds; headings turn from the x axis
// towards the y axis, whichever way y points on a screen.
#pragma once

#include <cmath>

#include "core/base/trigonometry.hpp"

namespace replan {

/// A place in the plane, in metres.
struct Spot {
  double x = 0, y = 0;
  friend bool operator==(const Spot&, const Spot&) = default;
};

/// Where a robot is and which way it looks.
struct Pose {
  double x = 0, y = 0;
  double heading = 0;  ///< radians
  [[nodiscard]] Spot spot() const { return {x, y}; }
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// How fast it goes, and how fast it turns.
struct Twist {
  double v = 0;  ///< m/s, forwards
  double w = 0;  ///< rad/s, from x towards y
  friend bool operator==(const Twist&, const Twist&) = default;
};

inline double distance(Spot a, Spot b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

/// The way of a robot whose motion stays as it is: a circle, or a straight line if it does not turn.
///
/// After the time t it has turned by w t, and its way's chord has the direction halfway between its two headings and
/// the length v t sin(w t / 2) / (w t / 2), which holds for a straight line too.
class Arc {
 public:
  Arc(const Pose& from, const Twist& motion)
      : from_(from), motion_(motion), towards_(sine_cosine(from.heading)) {}

  [[nodiscard]] const Twist& motion() const { return motion_; }
  /// Where it is after so many seconds.
  [[nodiscard]] Spot spot(double time) const { return spot_at(time, half_turn(time)); }
  [[nodiscard]] Pose pose(double time) const {
    const Spot at = spot(time);
    return {at.x, at.y, wrapped_angle(from_.heading + motion_.w * time)};
  }
  /// The direction that it looks in, as its sine and cosine.
  [[nodiscard]] SineCosine heading(double time) const {
    const auto [sine, cosine] = half_turn(time);
    return turned({2 * sine * cosine, cosine * cosine - sine * sine});
  }

 private:
  [[nodiscard]] SineCosine half_turn(double time) const { return sine_cosine(motion_.w * time / 2); }
  [[nodiscard]] SineCosine turned(const SineCosine& by) const {
    return {towards_.sine * by.cosine + towards_.cosine * by.sine,
            towards_.cosine * by.cosine - towards_.sine * by.sine};
  }
  [[nodiscard]] Spot spot_at(double time, const SineCosine& half) const {
    const double angle = motion_.w * time / 2;
    const double chord = motion_.v * time * (std::abs(angle) < 1e-8 ? 1 : half.sine / angle);
    const SineCosine way = turned(half);
    return {from_.x + chord * way.cosine, from_.y + chord * way.sine};
  }

  Pose from_;
  Twist motion_;
  SineCosine towards_;
};

/// Where a robot comes to in `time` seconds, exactly.
inline Pose driven(const Pose& from, const Twist& motion, double time) {
  return Arc(from, motion).pose(time);
}

/// The same by the formula that papers print, x += v cos(heading) t and so on: right only in the limit of short times.
inline Pose euler_step(const Pose& from, const Twist& motion, double time) {
  const auto [sine, cosine] = sine_cosine(from.heading);
  return {from.x + motion.v * cosine * time, from.y + motion.v * sine * time,
          wrapped_angle(from.heading + motion.w * time)};
}

}  // namespace replan
