// The dynamic window approach: of the motions that a robot can take up at once and still stop in time, the one whose
// arc scores best.
//
//  Fox D., Burgard W. & Thrun S., "The dynamic window approach to collision avoidance", IEEE Robotics & Automation
//  Magazine 4(1), 1997, doi 10.1109/100.580977
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (Henan
//  University of Technology): obstacles that the plan knows and others have terms of their own
//
// Settled here:
// - Between two decisions the motion stays as it is, and the robot drives along an exact arc.
// - A motion is admissible if the robot, having kept it for a period, can brake to a stand on its own arc before it
//   touches anything. Speed and turn rate then fall in the same measure, so the slower of the two brakes counts. So a
//   robot that has decided once can always stop, and one that stands and turns hits nothing: it is a disc.
// - What may move comes nearer by its top speed during all of that time.
// - A robot nearer to an obstacle than its margin may go anywhere that is no nearer.
// - A term is taken at the end of the arc: at the horizon, or where the arc meets an obstacle or is as long as the goal
//   is far.
// - What may move and is wholly behind the robot is not in its way: it may be run into, but does not run into anything.
// - The circle through the goal that the robot's heading touches has the radius d / (2 sin e), with d the goal's
//   distance and e the bearing's error, at least d / 2. A speed for which that is too tight a turn is not chosen while
//   there is a lower one: the speed's term would let the robot circle round its goal for ever.
// - Of the turn rates tried the one nearest to 0 is 0. Standing still is no choice; turning in place is, unless the
//   robot faces its goal: near obstacles a slow start would always score less.
//
// A decision is a function of its arguments alone: who keeps pose and motion of a moment can ask for its reasons later.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/drive/braking.hpp"
#include "core/drive/drive_settings.hpp"
#include "core/drive/local_obstacles.hpp"
#include "core/drive/motion.hpp"

namespace replan {

/// How a robot stands when it decides.
struct DriveState {
  Pose pose;
  Twist motion;       ///< up to now
  double turned = 0;  ///< rad that it has turned in place since it last drove; below 0 from y towards x
  friend bool operator==(const DriveState&, const DriveState&) = default;
};

/// Why a motion is not to be chosen.
enum class Rejection : std::uint8_t {
  none,
  outside,         ///< it cannot be taken up within a period
  too_fast,        ///< it could not stop before it touches something
  turns_too_fast,  ///< as too_fast, but its turn rate alone is what falls too slowly
  circles,         ///< at that speed it cannot turn in on the goal, but would circle round it
  stands           ///< it does not drive, nor turn to face a goal that it does not face
};
/// As its fixed name in texts and conditions.
std::string_view rejection_name(Rejection rejection);

/// One motion that was tried.
struct DriveSample {
  Twist motion;
  Rejection rejection = Rejection::none;
  bool hits = false;  ///< its arc meets an obstacle before the horizon
  double time = 0;    ///< s until then, or the horizon
  double contact =
      0;  ///< s until it meets one, as far as it was looked at: `time` or `stopping`, if that is more
  double stopping = 0;      ///< s that this has to be at least
  Pose end;                 ///< where it is then
  ScoreTerms raw{};         ///< rad, m/s, m, m: larger is better
  ScoreTerms normalised{};  ///< of an admissible sample, 0 .. 1
  ScoreTerms weighted{};    ///< times its weight
  double score = 0;         ///< the sum of these

  [[nodiscard]] bool admissible() const { return rejection == Rejection::none; }
};

/// What a robot does for the next period.
enum class DriveDeed : std::uint8_t {
  drive,  ///< it takes the best sample's motion
  brake,  ///< no sample is admissible
  turn,   ///< it stands and could drive nowhere: it turns towards the nearer free side
  stuck   ///< it has turned all the way round like that: it stands, and needs another plan
};
/// As its fixed name in texts and conditions.
std::string_view drive_deed_name(DriveDeed deed);

struct DriveDecision {
  DriveDeed deed = DriveDeed::brake;
  Twist motion;
  std::optional<std::size_t> winner;  ///< the sample whose motion it is
  double score = 0;                   ///< of the winner
  double turned = 0;                  ///< DriveState::turned after the period
  std::size_t admissible = 0;         ///< how many samples are
  friend bool operator==(const DriveDecision&, const DriveDecision&) = default;
};

/// A decision with all that it came from.
struct Explanation {
  DriveDecision decision;
  SpeedWindow window;
  std::vector<DriveSample> samples;  ///< speed by speed from the lowest, each from the lowest turn rate on
  std::optional<std::size_t> runner_up;    ///< the next best sample
  ScoreTerm lost_by = ScoreTerm::heading;  ///< the term that put the winner before it, by most
};

/// What a robot with these obstacles about it does on its way to `goal`.
DriveDecision decide(const DriveState& state, const LocalObstacles& obstacles, Spot goal,
                     const DriveSettings& settings);
/// The same decision and why.
Explanation explain(const DriveState& state, const LocalObstacles& obstacles, Spot goal,
                    const DriveSettings& settings);
/// The term by which an admissible sample leads another by most.
ScoreTerm largest_lead(const DriveSample& winner, const DriveSample& other);
/// Any motion as if it had been among the samples, its normalised terms and score left out.
DriveSample assess(const DriveState& state, const LocalObstacles& obstacles, Spot goal,
                   const DriveSettings& settings, const Twist& motion);

}  // namespace replan
