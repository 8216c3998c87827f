// The fields that colour cells: how their values are read from a state, and between which ends they lie.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/stale_stretches.hpp"

namespace replan {

/// Reads a field's value out of the 64-bit word that a state holds for a node.
struct FieldReader {
  EventKind kind = EventKind::g;
  unsigned shift = 0;
  std::uint64_t mask = ~std::uint64_t{0};
  std::int64_t offset = 0;  ///< taken away from the shifted word
  std::int64_t none = -1;   ///< values up to this one stand for "no value"; so do infinite costs
  double unit = 1.0 / static_cast<double>(Cost::kScale);  ///< what a step of the word is worth

  static FieldReader of(Overlay field);
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();

  /// The value in units, or kNone.
  [[nodiscard]] std::int64_t read(std::uint64_t word) const {
    const std::int64_t value = static_cast<std::int64_t>(word >> shift & mask) - offset;
    return value <= none || value >= Cost::kInfinityRaw ? kNone : value;
  }
};

/// Whether the field leaves out what is in the open list. Of a planner with one value alone g is written there before it is
/// settled; of one with an rhs that is where such a value stands. So the same search looks the same with both.
bool shows_settled_alone(const Run& run, Overlay field);
/// The field's value in a cell at the run's cursor, as a view shows it; nothing where it shows none.
std::optional<double> field_value(const Run& run, Overlay field, Cell cell);

/// The least and the greatest value of a field over all cells, kept by stretches of them and brought up to
/// date from the log.
class RangeTracker {
 public:
  /// The range in `state`, which stands at `position` of the log numbered `log_id`. Where the time does not suffice, some of
  /// it is as it was before, or not counted yet.
  std::optional<FieldRange> follow(const FieldReader& reader, const Timeline& log, std::uint64_t log_id,
                                   const SearchState& state, std::size_t position, const Deadline& deadline);
  /// Whether some of it is not yet at the position: the next follow() goes on.
  [[nodiscard]] bool behind() const { return stale_.behind(); }
  /// How many stretches were looked at, all times together.
  [[nodiscard]] std::size_t scanned() const { return scanned_; }

 private:
  struct Ends {
    std::int64_t low = std::numeric_limits<std::int64_t>::max();
    std::int64_t high = FieldReader::kNone;
  };

  static Ends ends(const FieldReader& reader, const SearchState& state, std::size_t first, std::size_t end);

  StaleStretches stale_{4 * SearchState::kPage};
  std::vector<Ends> stretches_;
  std::size_t scanned_ = 0;
};

/// The ends of the colour map at the run's cursor: over the state there, and with FieldSpan::whole_run over the state
/// at the end of the log too.
class FieldRanges {
 public:
  /// What the deadline leaves out is there when it is asked for again.
  std::optional<FieldRange> at_cursor(const Run& run, Overlay field, FieldSpan span,
                                      const Deadline& deadline = Deadline::never());
  /// Whether the last answer has something left out.
  [[nodiscard]] bool behind() const { return behind_; }

 private:
  struct Pair {
    RangeTracker cursor, head;
  };
  std::map<Overlay, Pair> trackers_;
  bool behind_ = false;
};

}  // namespace replan
