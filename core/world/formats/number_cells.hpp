// Cells that a file gives as numbers, and which of the numbers is the obstacle.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// The number that a word spells: 0, -1, 1.0e+00, True, false; nothing if it is none or not finite.
std::optional<double> cell_number(std::string_view word);

/// Gathers cells, most of them numbers. Which number is the obstacle is decided when all are there: the one
/// that is asked for; else 1, as numpy's comparisons have it; else, of 0 and another one, the other one.
class NumberCells {
 public:
  explicit NumberCells(std::optional<double> occupied) : occupied_(occupied) {}

  void add(double number);
  /// A cell that says itself what it is: kFree, kObstacle or kUnmapped.
  void add_known(std::uint8_t cell) { cells_.push_back(cell); }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  /// Whether there is a number but 0 and 1.
  [[nodiscard]] bool needs_words() const;
  /// The numbers so far, the smallest first; not more than 64 of them.
  [[nodiscard]] std::vector<double> numbers() const;

  /// The cells in order. What was taken for granted becomes a note. Where the numbers leave open which is the
  /// obstacle, the error lists them. `origin` begins both.
  Result<std::vector<std::uint8_t>> finish(const std::string& origin, std::vector<std::string>& notes);

 private:
  std::optional<double> occupied_;
  std::vector<std::uint8_t> cells_;  // known ones, or kFirstNumber + the index of the number
  std::vector<double> numbers_;
  std::uint8_t last_ = 0;  // index of the number added last
};

}  // namespace replan
