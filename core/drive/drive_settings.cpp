#include "core/drive/drive_settings.hpp"

#include <algorithm>
#include <vector>

namespace replan {
namespace {

Parameter real(std::string_view key, std::string_view label, double initial, double low, double high,
               std::string_view unit, std::string_view help) {
  return {.key = key,
          .label = label,
          .type = ParameterType::real,
          .initial = initial,
          .low = low,
          .high = high,
          .unit = unit,
          .choices = {},
          .help = help};
}

Parameter whole(std::string_view key, std::string_view label, double initial, double low, double high,
                std::string_view help) {
  Parameter made = real(key, label, initial, low, high, {}, help);
  made.type = ParameterType::whole;
  return made;
}

const Parameter kRadius =
    real("radius", "Radius", 0.18, 0, 100, "m", "Of the disc that the robot is taken for.");
const Parameter kSlowest = real("v_min", "Least speed", 0, 0, 100, "m/s",
                                "The slowest that it drives, at most its top speed; 0: it can stand.");
const Parameter kFastest = real("v_max", "Top speed", 0.5, 0.001, 100, "m/s", "The fastest that it drives.");
const Parameter kTurn =
    real("w_max", "Top turn rate", 0.25, 0.001, 100, "rad/s", "The fastest that it turns, either way.");
const Parameter kAcceleration =
    real("acceleration", "Acceleration", 0.5, 0.001, 100, "m/s\u00b2", "How fast its speed can grow.");
const Parameter kBrake =
    real("brake", "Braking", 0.5, 0.001, 100, "m/s\u00b2",
         "How fast its speed can fall. No arc is chosen that it could not stop on in time.");
const Parameter kAngularAcceleration = real("angular_acceleration", "Angular acceleration", 1, 0.001, 1000,
                                            "rad/s\u00b2", "How fast its turn rate can grow.");
const Parameter kAngularBrake = real("angular_brake", "Angular braking", 1, 0.001, 1000, "rad/s\u00b2",
                                     "How fast its turn rate can fall.");
const Parameter kPeriod = real("period", "Period", 0.2, 0.001, 10, "s",
                               "From one decision to the next; between them its speed and turn rate stay.");
const Parameter kHorizon =
    real("horizon", "Horizon", 3, 0.01, 60, "s", "How far ahead the arc of a sample is looked at.");
const Parameter kSpeeds =
    whole("speeds", "Samples of speed", 10, 2, 200, "So many speeds are tried each time.");
const Parameter kTurns =
    whole("turns", "Samples of turn rate", 20, 2, 400, "So many turn rates are tried with each.");
const Parameter kHeading = real("alpha", "Weight of heading", 0.3, 0, 10, {},
                                "What it counts that the arc's end looks towards the sub-goal.");
const Parameter kSpeed = real("beta", "Weight of speed", 0.4, 0, 10, {}, "What speed counts.");
const Parameter kKnown = real("gamma", "Weight of known obstacles", 0.2, 0, 10, {},
                              "What it counts that the arc ends far from obstacles that the plan knows.");
const Parameter kUnknown =
    real("phi", "Weight of unknown obstacles", 0.2, 0, 10, {},
         "What it counts that the arc ends far from obstacles that the plan does not know.");
const Parameter kNormalise{
    .key = "normalise",
    .label = "Normalised by",
    .type = ParameterType::choice,
    .choices = {"limits", "range", "sum"},
    .help =
        "What each term is divided by before it is weighted: the most that it can be (Fox et "
        "al.), its span among the samples, or its sum over them."};
const Parameter kReach = real("reach", "Reach of obstacles", 1, 0.001, 100, "m",
                              "An obstacle farther away than this from the robot's edge counts as this far.");
const Parameter kMargin =
    real("margin", "Margin", 0.005, 0, 10, "m", "What the robot's edge keeps from every obstacle.");

}  // namespace

std::string_view score_term_name(ScoreTerm term) {
  constexpr std::array<std::string_view, kScoreTerms> kNames = {"heading", "speed", "known", "unknown"};
  return kNames[static_cast<std::size_t>(term)];
}

std::span<const Parameter> drive_parameters() {
  static const std::vector<Parameter> all = {
      kRadius,       kSlowest, kFastest,   kTurn,   kAcceleration, kBrake,   kAngularAcceleration,
      kAngularBrake, kPeriod,  kHorizon,   kSpeeds, kTurns,        kHeading, kSpeed,
      kKnown,        kUnknown, kNormalise, kReach,  kMargin};
  return all;
}

DriveSettings drive_settings(const Settings& settings) {
  const auto number = [&settings](const Parameter& parameter) { return settings.get(parameter); };
  return {.limits = {.radius = number(kRadius),
                     .v_min = std::min(number(kSlowest), number(kFastest)),
                     .v_max = number(kFastest),
                     .w_max = number(kTurn),
                     .acceleration = number(kAcceleration),
                     .brake = number(kBrake),
                     .angular_acceleration = number(kAngularAcceleration),
                     .angular_brake = number(kAngularBrake)},
          .period = number(kPeriod),
          .horizon = number(kHorizon),
          .speeds = static_cast<int>(number(kSpeeds)),
          .turns = static_cast<int>(number(kTurns)),
          .weights = {number(kHeading), number(kSpeed), number(kKnown), number(kUnknown)},
          .normalise = static_cast<Normalise>(static_cast<int>(number(kNormalise))),
          .reach = number(kReach),
          .margin = number(kMargin)};
}

}  // namespace replan
