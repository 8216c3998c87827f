// Holds a planner's log against the planner's laws, step by step, as the log grows.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/debug/laws.hpp"
#include "core/debug/log_view.hpp"

namespace replan {

/// Reads a log once, forwards, and checks after every finished step what that step touched: before each event
/// that takes a vertex from the open list, and where a plan stands. In between a planner is at work and its
/// laws need not hold. The laws are those of ALGORITHMS: of rhs, local parents, U, keys and penalties where
/// PlannerInfo::values is `lookahead`, of g, parents and keys where it is `best_first`, of tags, keys and back-pointers
/// where its costs rise and fall in waves, and those of plans.
///
/// Memory goes with what the search touched, plus a few bytes for each cell of the map.
class LawChecker {
 public:
  /// So many breaches are kept; further ones are only counted.
  static constexpr std::size_t kMostKept = 1000;

  /// From the start of the log. Only the log itself has to outlive the checker.
  explicit LawChecker(const LogView& view);
  ~LawChecker();
  LawChecker(LawChecker&&) noexcept;
  LawChecker& operator=(LawChecker&&) noexcept;

  /// Reads at most `events` events on. False if it has come to the end of the log.
  bool advance(std::size_t events);
  /// For a log that was cut at `position`, where a plan stood: what was found behind it is forgotten.
  void rewind(std::size_t position);

  /// Events that were read.
  [[nodiscard]] std::size_t checked() const;
  /// By position, then by node; the first kMostKept.
  [[nodiscard]] std::span<const Breach> breaches() const;
  /// All of them.
  [[nodiscard]] std::size_t breach_count() const;
  /// Bytes held.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace replan
