// The log of a run and a cursor in it: any moment can be gone to, in either direction.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "core/trace/event.hpp"
#include "core/trace/node_index.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

/// Position n is the state after the first n events. Seeking starts from the nearest of the cursor, the end
/// and the key frames, and walks from there.
class Timeline {
 public:
  /// Bytes that key frames may take; beyond it they stand farther apart.
  static constexpr std::size_t kDefaultFrameBudget = std::size_t{512} << 20;

  Timeline() = default;
  explicit Timeline(SearchState initial, std::size_t frame_budget = kDefaultFrameBudget);

  /// Adds events at the end. The cursor stays where it is.
  void append(const std::vector<Event>& events);
  /// Forgets all events from position `size` on; a cursor beyond it goes there.
  void truncate(std::size_t size);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Event event(std::size_t index) const { return chunks_[index / kChunk][index % kChunk]; }
  [[nodiscard]] std::size_t cursor() const { return cursor_; }
  /// The state at the cursor.
  [[nodiscard]] const SearchState& state() const { return state_; }
  /// The state at the end of the log.
  [[nodiscard]] const SearchState& head() const { return head_; }
  /// Moves the cursor to a position, at most size().
  void seek(std::size_t position);

  /// The state at any position, without moving the cursor.
  [[nodiscard]] SearchState state_at(std::size_t position) const;
  /// The latest event before `before` that is about the node and of one of the kinds, and the first from
  /// `from` on. `node` is the Scalar for EventKind::scalar. Fast where the node is rare: only stretches of
  /// the log where it occurs are looked at.
  [[nodiscard]] std::optional<std::size_t> last_event(NodeId node, KindSet kinds, std::size_t before) const;
  [[nodiscard]] std::optional<std::size_t> next_event(NodeId node, KindSet kinds, std::size_t from) const;

  /// A hash over all events of the log: equal runs have equal hashes.
  [[nodiscard]] std::uint64_t log_hash() const;

  [[nodiscard]] std::size_t key_frames() const { return frames_.size(); }
  /// Bytes held: the log, and the key frames' pages (an upper bound).
  [[nodiscard]] std::size_t log_bytes() const { return chunks_.size() * kChunk * sizeof(Event); }
  [[nodiscard]] std::size_t frame_bytes() const { return frame_bytes_; }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 16;

  void capture();
  void thin_out();

  std::vector<std::vector<Event>> chunks_;
  NodeIndex index_;
  std::size_t size_ = 0;
  std::size_t cursor_ = 0;
  SearchState state_;
  SearchState head_;
  std::map<std::size_t, SearchState> frames_;  // by position
  std::size_t frame_interval_ = std::size_t{1} << 17;
  std::size_t frame_budget_ = kDefaultFrameBudget;
  std::size_t frame_bytes_ = 0;
};

}  // namespace replan
