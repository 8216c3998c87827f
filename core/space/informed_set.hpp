// The places that a path shorter than the best one could lead over: an ellipse, in space an ellipsoid, with the foci
// start and goal.
//
//  Gammell J. D., Srinivasa S. S. & Barfoot T. D., "Informed RRT*: optimal sampling-based path planning focused via
//  direct sampling of an admissible ellipsoidal heuristic", IROS 2014, doi 10.1109/IROS.2014.6942976, algorithm 2
//
// Its axis along the foci is c_best long, all others sqrt(c_best^2 - c_min^2), where c_min is the way between the foci.
// Drawn is from the unit ball (in its cube until one lies in it), which is then stretched, turned and moved: by
// + - * / and roots alone, so that every machine draws the same.
#pragma once

#include <array>
#include <cmath>

#include "core/base/random.hpp"
#include "core/space/place.hpp"

namespace replan {

template <int D>
class InformedSet {
 public:
  using Vector = std::array<double, 3>;  // units

  /// Of the ways between two places that are no longer than `best`.
  InformedSet(const Place& start, const Place& goal, Cost best) {
    const double least = std::sqrt(static_cast<double>(squared_between(start, goal)));
    const double longest = std::max(least, best.to_double() * kPlaceUnits);
    along_ = longest / 2;
    across_ = std::sqrt(std::max(0.0, longest * longest - least * least)) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      centre_[i] = static_cast<double>(start[i] + goal[i]) / 2;
      axes_[0][i] = least > 0 ? static_cast<double>(goal[i] - start[i]) / least : i == 0 ? 1 : 0;
    }
    turn_axes();
  }

  [[nodiscard]] Place draw(Random& random) const {
    const Vector ball = in_unit_ball(random);
    Place place{};
    for (std::size_t i = 0; i < 3; ++i) {
      double at = centre_[i] + ball[0] * along_ * axes_[0][i];
      for (std::size_t k = 1; k < D; ++k) at += ball[k] * across_ * axes_[k][i];
      place[i] = static_cast<std::int64_t>(std::floor(at));
    }
    if constexpr (D == 2) place[2] = kPlaceUnits / 2;
    return place;
  }

  /// Half of its axes, in units, and their directions, each of length 1; the first leads from start to goal.
  [[nodiscard]] double along() const { return along_; }
  [[nodiscard]] double across() const { return across_; }
  [[nodiscard]] const Vector& centre() const { return centre_; }
  [[nodiscard]] const Vector& axis(std::size_t i) const { return axes_[i]; }
  /// A direction that stands upright on the first axis: in space any, else the one in the plane.
  [[nodiscard]] Vector upright(bool in_space) const {
    return in_space ? axes_[1] : Vector{-axes_[0][1], axes_[0][0], 0};
  }

 private:
  static Vector in_unit_ball(Random& random) {
    for (;;) {
      Vector at{};
      double squared = 0;
      for (std::size_t i = 0; i < D; ++i) {
        at[i] = 2 * random.unit() - 1;
        squared += at[i] * at[i];
      }
      if (squared <= 1) return at;
    }
  }
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  /// The axes across the first one: any that stand upright on it and on each other.
  void turn_axes() {
    const Vector& first = axes_[0];
    if constexpr (D == 2) {
      axes_[1] = {-first[1], first[0], 0};
    } else {
      // The world's axis that it leans to least.
      std::size_t least = 0;
      for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(first[i]) < std::abs(first[least])) least = i;
      Vector upright{};
      upright[least] = 1;
      Vector second = cross(first, upright);
      const double length = std::sqrt(second[0] * second[0] + second[1] * second[1] + second[2] * second[2]);
      for (double& part : second) part /= length;
      axes_[1] = second;
      axes_[2] = cross(first, second);
    }
  }

  double along_ = 0, across_ = 0;
  Vector centre_{};
  std::array<Vector, 3> axes_{};
};

}  // namespace replan
