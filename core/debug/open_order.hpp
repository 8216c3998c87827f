// The open list at a moment of a log, in the order in which the planner takes from it.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/debug/log_view.hpp"

namespace replan {

/// A vertex of the open list with what it is ordered by; the least comes out first.
struct OpenEntry {
  Cost k1;  ///< as its queue value holds it; best-first searches: f
  Cost k2;  ///< as ListOrder makes it: min(g, rhs), or f - g, so that among equal f the larger g comes first
  Cost k3;  ///< zero unless keys have a third component
  NodeId node = kNoNode;
  friend auto operator<=>(const OpenEntry&, const OpenEntry&) = default;
};

/// The entry of a vertex that is in the list.
OpenEntry open_entry(const SearchState& state, const ListOrder& order, NodeId node);

/// Sorts as std::sort does; a million entries take a fraction of its time.
void sort_entries(std::vector<OpenEntry>& entries);

/// The whole list in order, kept up with a cursor that moves: a short way costs what changed on it, a long
/// way is sorted anew. In the middle of a step, while a value is written and its key is not yet, the order is
/// that of the values; before every `pop` the first entry is the vertex that is taken.
class OpenOrder {
 public:
  /// Goes to the cursor of the log. `log_id` is another one when the log is another one, or was cut.
  void follow(const LogView& view, std::uint64_t log_id);
  /// Whether follow() would sort anew: some 0.1 s for a million entries.
  [[nodiscard]] bool far(const LogView& view, std::uint64_t log_id) const;

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The entry that is taken after `rank` others; rank < size().
  [[nodiscard]] const OpenEntry& operator[](std::size_t rank) const;
  /// How many are taken before the entry; nothing if it is not in the list.
  [[nodiscard]] std::optional<std::size_t> rank_of(const OpenEntry& entry) const;
  /// The position of the log that it shows.
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  // Blocks of entries, each at least one: an entry is put in by moving a block's rest, not the list's.
  using Block = std::vector<OpenEntry>;
  static constexpr std::size_t kBlock = 512;

  void gather(const SearchState& state, const ListOrder& order);
  void take_over(const Timeline& log, const ListOrder& order);
  void insert(const OpenEntry& entry);
  void erase(const OpenEntry& entry);
  [[nodiscard]] std::size_t block_of(const OpenEntry& entry) const;
  void count();

  std::uint64_t log_id_ = 0;
  std::size_t position_ = 0;
  std::size_t size_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::size_t> starts_;  // rank of each block's first entry
};

}  // namespace replan
