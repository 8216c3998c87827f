// Breakpoints of a session: conditions at which the playhead stops by itself.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/session/stop_search.hpp"
#include "core/world/scenario.hpp"

namespace replan {

class Run;

/// A search for a breakpoint or a change that goes on over several updates.
struct Hunt {
  int direction = 1;     ///< 1 forwards, -1 backwards
  double fraction = -1;  ///< of the way; below 0: not known
};

/// What checkers have said of the leading run, and how far they have come. Beyond that event(invariant) and
/// event(oracle) are not looked for yet.
struct CheckedLog {
  std::vector<std::size_t> breaches, disagreements;  ///< positions, ascending
  bool laws_on = false, oracle_on = false;
  std::size_t laws = SIZE_MAX;    ///< events that were held against the laws
  std::size_t oracle = SIZE_MAX;  ///< events up to which the oracle was asked

  [[nodiscard]] Verdicts verdicts() const { return {breaches, disagreements}; }
};

/// Read by panels; changed by the session's commands and update() alone.
class Breakpoints {
 public:
  /// Positions of hits that are kept.
  static constexpr std::size_t kMostHits = 10'000;

  [[nodiscard]] std::span<const Breakpoint> list() const { return list_; }
  /// Why a breakpoint of the list cannot be looked for, as a sentence: its condition makes no sense on the
  /// world as it is now. Empty if all is well.
  [[nodiscard]] const std::string& problem(std::size_t index) const { return read_[index].problem; }
  /// Where the leading run stops, as far as it was looked through; ascending.
  [[nodiscard]] std::span<const Hit> hits() const { return hits_; }
  /// How far it was looked through, in events: hits() are all there are until then.
  [[nodiscard]] std::size_t looked_through() const { return looked_; }
  /// Why the cursor stands where it does, as a sentence; empty unless it was stopped there.
  [[nodiscard]] const std::string& stopped() const { return stopped_; }
  /// The search that is under way.
  [[nodiscard]] const std::optional<Hunt>& hunt() const { return hunt_; }

  // For the session.

  /// Takes over a list. What cannot be read on this world stays in it, with its problem.
  void set_list(std::vector<Breakpoint> list, const Box& world);
  Result<void> add(const std::string& condition, const Box& world);
  void enable(std::size_t index, bool enabled);
  void remove(std::size_t index);
  /// The world has another size now.
  void read_again(const Box& world);
  /// A search for all that is wanted, standing at a position of the run.
  [[nodiscard]] StopSearch search(const Run& run, const CheckedLog& checked, std::size_t position);
  [[nodiscard]] bool wants_any() const;
  [[nodiscard]] const Condition& condition(std::size_t index) const { return *read_[index].condition; }
  /// How far a log can be looked through: checkers that are asked for may be behind.
  [[nodiscard]] std::size_t can_look_to(const CheckedLog& checked, std::size_t size) const;

  /// Looks further through the run's log, for at most that many milliseconds. True if it got on: there may be
  /// more to do, and what is shown of it is another.
  bool look(const Run& run, const CheckedLog& checked, double milliseconds);
  /// The first hit after a position, the last one before it, if it is among those that are known.
  [[nodiscard]] const Hit* known_after(std::size_t position) const;
  [[nodiscard]] const Hit* known_before(std::size_t position) const;

  void set_stopped(std::string words) { stopped_ = std::move(words); }
  void set_hunt(std::optional<Hunt> hunt) { hunt_ = hunt; }

 private:
  struct Reading {
    std::optional<Condition> condition;
    std::string problem;
  };
  [[nodiscard]] static Reading read(const std::string& condition, const Box& world);
  [[nodiscard]] bool is_wanted(std::size_t index) const {
    return list_[index].enabled && read_[index].condition;
  }
  void look_again();
  void follow_log(const Run& run);
  void follow_checkers(const CheckedLog& checked);

  std::vector<Breakpoint> list_;
  std::vector<Reading> read_;  // one for each of the list
  std::vector<Hit> hits_;
  std::size_t looked_ = 0;
  std::uint64_t log_id_ = 0;          // of the log that was looked at
  std::optional<StopSearch> search_;  // at looked_
  bool laws_on_ = false, oracle_on_ = false;
  std::string stopped_;
  std::optional<Hunt> hunt_;
};

}  // namespace replan
