// Reads two logs side by side until they part.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "core/debug/difference.hpp"
#include "core/debug/log_view.hpp"

namespace replan {

/// Compares two runs of one world from their starts, as far as their logs go. The logs may grow in between;
/// only they have to outlive the search.
class DifferenceSearch {
 public:
  enum class Outcome : unsigned char {
    more,    ///< there is more to read
    waits,   ///< one of the logs has to grow first
    differ,  ///< difference() says where
    alike,   ///< both have ended and were alike
  };

  DifferenceSearch(const LogView& a, const LogView& b, Compare what);
  ~DifferenceSearch();
  DifferenceSearch(DifferenceSearch&&) noexcept;
  DifferenceSearch& operator=(DifferenceSearch&&) noexcept;

  /// Reads at most `events` events of both together. `ended`: that log will not grow any more.
  Outcome advance(std::size_t events, std::array<bool, 2> ended);
  /// Its `panes` are left to the caller.
  [[nodiscard]] const std::optional<Difference>& difference() const;
  /// How many expansions (plans, moves, events) were alike: "214 expansions".
  [[nodiscard]] std::string alike() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Both logs as they are, from one end to the other; nothing if they are alike.
std::optional<Difference> first_difference(const LogView& a, const LogView& b, Compare what);

}  // namespace replan
