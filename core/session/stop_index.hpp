// Where steps of the smallest units can stop, kept while a run is recorded: nobody reads a log to find its next stop.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/trace/event.hpp"

namespace replan {

/// A row of bits that grows at its end.
class BitRow {
 public:
  void add(bool bit);
  /// Forgets all bits from `size` on.
  void truncate(std::size_t size);
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The first bit that is set at `from` or behind it; size() if there is none.
  [[nodiscard]] std::size_t next(std::size_t from) const;
  /// The last bit that is set before `before`; 0 if there is none.
  [[nodiscard]] std::size_t previous(std::size_t before) const;

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_ = 0;
};

/// Positions in front of events that begin an iteration of the planner, or tell of something between searches; and of
/// those that begin a line of its code. Two bits an event.
class StopIndex {
 public:
  /// The next event of the log.
  void add(const Event& event, bool begins_iteration);
  /// Forgets all events from `size` on; the one before them was of that line.
  void truncate(std::size_t size, std::uint8_t line);

  [[nodiscard]] const BitRow& iterations() const { return iterations_; }
  [[nodiscard]] const BitRow& lines() const { return lines_; }

 private:
  BitRow iterations_, lines_;
  std::uint8_t line_ = 0;  // of the last event
};

}  // namespace replan
