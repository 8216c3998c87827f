// How the cursor of a run moves by itself.
#pragma once

#include <algorithm>

#include "core/session/run.hpp"

namespace replan {

struct Playback {
  int direction = 0;  ///< 1 forwards, -1 backwards, 0 standing still
  double expansions_per_second = 240;
};

/// Whether a robot's step is shown for as long as it takes: it goes at a steady speed, or at its own pace.
bool is_smooth(const Run& run);

/// Plays a run: how far the cursor gets in a stretch of time, however many stops that is.
class Player {
 public:
  static constexpr double kFullSpeed = 1e6;      ///< from here on a frame shows as much as it can
  static constexpr double kMovesPerSecond = 15;  ///< the robot's pace while playing, if the speed allows
  /// At this speed a robot with Motion::smooth drives in real time; at others so much faster or slower, but
  /// no more than eight times.
  static constexpr double kRealTimeSpeed = 240;
  /// Up to this speed a repair can be followed, and waits so many seconds before its first expansion.
  static constexpr double kReadableSpeed = 1000, kRepairSeconds = 0.8;

  /// Where the cursor comes to, and how much of the robot's last step is shown: see Run::travel().
  struct Shown {
    std::size_t cursor = 0;
    double travel = 1;
  };

  [[nodiscard]] const Playback& state() const { return state_; }
  [[nodiscard]] bool plays() const { return state_.direction != 0; }
  [[nodiscard]] bool forwards() const { return state_.direction > 0; }
  /// It has come to where the robot can go no farther, and goes on once it can.
  [[nodiscard]] bool waits() const { return waits_; }
  /// 1 forwards, -1 backwards, 0 stops.
  void play(int direction) {
    state_.direction = direction;
    owed_ = 0;
    waits_ = false;
  }
  void stop() { play(0); }
  void wait() {
    stop();
    waits_ = true;
  }
  void set_speed(double expansions_per_second) {
    state_.expansions_per_second = std::clamp(expansions_per_second, 0.1, kFullSpeed);
  }
  /// Plays on from the run's cursor by `seconds`.
  [[nodiscard]] Shown advance(const Run& run, double seconds);

 private:
  [[nodiscard]] double seconds_of(const Run& run, std::size_t from, std::size_t to) const;

  Playback state_;
  double owed_ = 0;          // seconds of play not yet shown; negative: the last stop still lasts so long
  double step_seconds_ = 0;  // how long the last stop lasts in all
  bool waits_ = false;
};

}  // namespace replan
