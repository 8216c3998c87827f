// Watches of a session: quantities followed over the whole run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/debug/probe.hpp"

namespace replan {

class Run;

/// A value from a position of the log on.
struct WatchPoint {
  std::size_t position = 0;
  double value = 0;  ///< infinity where there is none yet
  friend bool operator==(const WatchPoint&, const WatchPoint&) = default;
};

/// Values along a log, thinned out to what a chart can show: of each of some hundred stretches the smallest,
/// the largest and the last one are kept, so that peaks survive.
class WatchSeries {
 public:
  static constexpr std::size_t kMostPoints = 2000;

  /// A further value, behind all others. Infinity where it is none.
  void add(WatchPoint point);
  /// Forgets what comes after `size`, rounded down to where a stretch begins: values have to be added anew
  /// from the returned position on.
  std::size_t truncate(std::size_t size);
  /// Ascending.
  [[nodiscard]] std::span<const WatchPoint> points() const;

 private:
  struct Stretch {
    std::size_t number;  // position / width_
    WatchPoint least, most, last;
  };
  void widen();

  std::size_t width_ = 1;  // events of a stretch
  std::vector<Stretch> stretches_;
  mutable std::vector<WatchPoint> points_;  // of all stretches, made when asked for
  mutable bool stale_ = false;
};

/// Read by panels; changed by the session's commands and update() alone.
class Watches {
 public:
  /// The expressions, as typed (core/debug/condition.hpp).
  [[nodiscard]] std::span<const std::string> list() const { return list_; }
  /// Why an expression cannot be followed on the world as it is now, as a sentence; empty if all is well.
  [[nodiscard]] const std::string& problem(std::size_t watch) const { return problems_[watch]; }
  /// The values of a watch over the log of a pane, ascending and thinned out to what a chart can show; as far
  /// as the log was looked through.
  [[nodiscard]] std::span<const WatchPoint> series(std::size_t pane, std::size_t watch) const;
  /// The value at the cursor of a pane, exactly; infinity if there is none.
  [[nodiscard]] double value(std::size_t pane, std::size_t watch) const;

  // For the session.

  using Runs = std::span<const std::unique_ptr<Run>>;
  void set_list(std::vector<std::string> list, const Box& world);
  Result<void> add(const std::string& expression, const Box& world);
  void remove(std::size_t index);
  /// The world has another size now.
  void read_again(const Box& world);
  /// Looks further through the logs, for at most that many milliseconds. True if there is more to show or
  /// to look through.
  bool look(Runs runs, double milliseconds);
  /// Takes over where the cursors stand. True if a value at one of them may be another now.
  bool read_cursors(Runs runs);

 private:
  /// What is known of a watch in a pane.
  struct Track {
    WatchSeries series;
    std::size_t looked = 0;
    std::optional<Probe> probe;  // at `looked`
    double last = 0;
    double at_cursor = 0;
  };
  struct Pane {
    std::uint64_t log_id = 0;  // of the log that was looked at
    std::size_t cursor = SIZE_MAX;
    std::vector<Track> tracks;  // one for each of the list
  };
  void meet(Runs runs);
  void forget(Pane& pane, std::size_t common);
  bool look(const Run& run, Pane& pane, std::size_t watch, std::size_t end);
  [[nodiscard]] Probe probe_at(const Run& run, std::size_t watch, std::size_t position) const;

  std::vector<std::string> list_;
  std::vector<std::optional<Condition>> read_;  // one for each of the list, as the problems
  std::vector<std::string> problems_;
  std::vector<Pane> panes_;
};

}  // namespace replan
