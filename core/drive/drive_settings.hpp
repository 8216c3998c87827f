// What a robot with two driven wheels can do, and how the dynamic window approach chooses for it: declared parameters
// in SI units.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/plan/parameters.hpp"

namespace replan {

/// What body and motors allow.
struct DriveLimits {
  double radius = 0;                ///< m, of the disc that the robot is taken for
  double v_min = 0, v_max = 0;      ///< m/s
  double w_max = 0;                 ///< rad/s, to either side
  double acceleration = 0;          ///< m/s^2
  double brake = 0;                 ///< m/s^2
  double angular_acceleration = 0;  ///< rad/s^2
  double angular_brake = 0;         ///< rad/s^2
};

/// The terms of the score, in the order of the paper's formula.
enum class ScoreTerm : std::uint8_t { heading, speed, known, unknown };
inline constexpr std::size_t kScoreTerms = 4;
using ScoreTerms = std::array<double, kScoreTerms>;
/// Its fixed name, in texts and conditions.
std::string_view score_term_name(ScoreTerm term);

/// What a term is divided by, so that terms of different units can be added.
enum class Normalise : std::uint8_t {
  limits,  ///< the largest value that it can have (Fox, Burgard & Thrun)
  range,  ///< the span from its least to its largest value among the admissible samples, counted from the least
  sum     ///< its sum over the admissible samples
};

/// All that a decision depends on besides where things are.
struct DriveSettings {
  DriveLimits limits;
  double period = 0;     ///< s, from one decision to the next
  double horizon = 0;    ///< s, how far ahead an arc is looked at
  int speeds = 0;        ///< samples of v
  int turns = 0;         ///< samples of w
  ScoreTerms weights{};  ///< alpha, beta, gamma, phi
  Normalise normalise = Normalise::limits;
  double reach = 0;   ///< m; an obstacle farther away than this from the robot's edge is as good as none
  double margin = 0;  ///< m, kept from obstacles by the robot's edge
};

/// The parameters of DriveSettings, with the defaults of the fusion paper's trial.
std::span<const Parameter> drive_parameters();
/// The settings that these values ask for.
DriveSettings drive_settings(const Settings& settings);

}  // namespace replan
