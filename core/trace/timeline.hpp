// The log of a run and a cursor in it: any moment can be gone to, in either direction.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/trace/event.hpp"
#include "core/trace/event_store.hpp"
#include "core/trace/node_index.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

struct Checkpoint;

/// What the log of a run may take: 16 bytes for an event that lies open, which an eighth of the limit is for, and less
/// than half of that for a packed one; a byte each for the index; and key frames for at most 7 (but always 64 MiB
/// if there is room for them).
struct LogLimits {
  /// Bytes of events, index and key frames; the states at the cursor and at the end are not counted. Beyond
  /// it events are dropped and worked out again when they are asked for, if there is somebody to do that.
  std::size_t bytes = std::size_t{1} << 30;
  /// Events that are dropped together: a power of two.
  std::size_t chunk_events = std::size_t{1} << 16;
  /// Events between two key frames at first. When the frames take too much, some go, and others come half as
  /// often.
  std::size_t frame_interval = std::size_t{1} << 17;
};

/// A moment of the log whose state is kept.
struct KeyFrame {
  SearchState state;
  /// What the run needs besides to be taken up there; nullptr where it cannot be taken up.
  std::shared_ptr<const Checkpoint> checkpoint;
};

/// Position n is the state after the first n events. Seeking starts from the nearest of the cursor, the end
/// and the key frames, and walks from there. For one thread: reading may bring dropped events back.
class Timeline {
 public:
  /// Works out the events [from, to) of the log again, from `frame` on, which stands at `position` <= from
  /// and has a checkpoint, or stands at 0.
  using Source = std::function<std::vector<Event>(std::size_t position, const KeyFrame& frame,
                                                  std::size_t from, std::size_t to)>;

  explicit Timeline(SearchState initial = {}, const LogLimits& limits = {});

  /// Who can work out dropped events; without it none is dropped, whatever the limit.
  void set_source(Source source) { source_ = std::move(source); }

  /// Adds events at the end. The cursor stays where it is. `checkpoint` is for the run after the last of
  /// them, nullptr if it cannot be taken up there.
  void append(std::span<const Event> events, const std::shared_ptr<const Checkpoint>& checkpoint = nullptr);
  /// Forgets all events from position `size` on; a cursor beyond it goes there. The source is still asked for
  /// the log as it was. States that are no longer needed are let go of by tidy().
  void truncate(std::size_t size);
  /// Lets go of one of them. False if there is none left.
  bool tidy();
  /// Forgets everything: the events at once, the states by and by.
  void retire();
  /// Whether nobody else has a copy of one of its states. Only then may another thread destroy it.
  [[nodiscard]] bool owns_its_states() const;
  /// The state at the end of the log, for another thread to read while this one goes on, until the next call
  /// or take_back(). The other one must not copy it, and the timeline must outlive its reading.
  const SearchState& lend_head() { return lent_.emplace(head_); }
  void take_back() { lent_.reset(); }

  [[nodiscard]] std::size_t size() const { return events_.size(); }
  [[nodiscard]] Event event(std::size_t index) const {
    const Event* held = events_.find(index);
    return held != nullptr ? *held : fetch(index);
  }
  /// Some of the events from `from` on, at least one and none from `to` on, for a look at a few of them: what is packed
  /// stays so. Valid until others are read.
  [[nodiscard]] std::span<const Event> peek(std::size_t from, std::size_t to) const;
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
  /// `from` on. `node` is the Scalar for EventKind::scalar. Epochs are about every node, where they forget
  /// one of the kinds. Fast where the node is rare: only stretches of the log where it occurs are looked at.
  [[nodiscard]] std::optional<std::size_t> last_event(NodeId node, KindSet kinds, std::size_t before) const;
  [[nodiscard]] std::optional<std::size_t> next_event(NodeId node, KindSet kinds, std::size_t from) const;
  /// Whether an event makes a value of the node another one: one that last_event() or next_event() named.
  [[nodiscard]] bool changes(std::size_t index, NodeId node, EventKind kind) const;
  /// The epochs: where searches were forgotten, by index in the log.
  [[nodiscard]] std::span<const std::size_t> epochs() const { return epochs_; }
  /// Whether a state can be walked back from a position to an earlier one: no epoch lies in between.
  [[nodiscard]] bool reversible(std::size_t to, std::size_t from) const;

  /// A hash over all events of the log: equal runs have equal hashes.
  [[nodiscard]] std::uint64_t log_hash() const;

  [[nodiscard]] std::size_t key_frames() const { return frames_.size(); }
  /// Bytes of the events that are held and of the index.
  [[nodiscard]] std::size_t log_bytes() const { return events_.bytes() + index_.bytes(); }
  /// Bytes that the key frames (and the cursor) take beyond the state at the end, whose pages they share.
  [[nodiscard]] std::size_t frame_bytes() const;
  /// True if some events were dropped to keep to the limit.
  [[nodiscard]] bool dropped() const { return events_.dropped(); }

 private:
  /// What was answered to last_of_node(): asked again farther on, only what lies between has to be looked at.
  struct Answer {
    NodeId node = kNoNode;
    KindSet kinds;
    std::size_t before = 0;
    std::optional<std::size_t> found;
  };

  void append_search(std::span<const Event> events);
  void take(std::span<const Event> events);
  void take_epoch(const Event& epoch);
  void capture(const std::shared_ptr<const Checkpoint>& checkpoint);
  bool drop_frame();
  void shrink(std::size_t keep) const;
  [[nodiscard]] std::optional<std::size_t> last_of_node(NodeId node, KindSet kinds, std::size_t before) const;
  [[nodiscard]] Answer& last_answer(NodeId node, KindSet kinds) const;
  [[nodiscard]] std::optional<std::size_t> next_of_node(NodeId node, KindSet kinds, std::size_t from) const;
  [[nodiscard]] std::size_t last_frame() const { return frames_.rbegin()->first; }
  [[nodiscard]] std::size_t frame_allowance() const;
  [[nodiscard]] std::size_t event_allowance() const;
  [[nodiscard]] Event fetch(std::size_t index) const;
  /// The held state nearest to a position, and where it stands.
  [[nodiscard]] std::pair<std::size_t, const SearchState*> nearest(std::size_t position) const;
  [[nodiscard]] std::span<const Event> events(std::size_t from, std::size_t to) const;
  [[nodiscard]] std::optional<std::size_t> last_in(std::size_t from, std::size_t to, NodeId node,
                                                   KindSet kinds) const;
  [[nodiscard]] std::optional<std::size_t> first_in(std::size_t from, std::size_t to, NodeId node,
                                                    KindSet kinds) const;
  void apply(SearchState& state, std::span<const Event> events) const;
  void walk(SearchState& state, std::size_t from, std::size_t to) const;

  LogLimits limits_;
  Source source_;
  mutable EventStore events_;  // what was dropped comes back when it is read
  NodeIndex index_;
  std::vector<std::size_t> epochs_;
  mutable PageOrder order_;  // only memory to work in
  mutable std::array<Answer, 8> answers_;
  mutable std::size_t next_answer_ = 0;  // the one to be forgotten next
  std::size_t cursor_ = 0;
  SearchState state_;
  SearchState head_;
  std::map<std::size_t, KeyFrame> frames_;  // by position
  std::vector<SearchState> untidy_;         // no longer needed
  std::optional<SearchState> lent_;
  std::size_t frame_interval_;
  std::size_t last_checkpoint_ = 0;  // the latest frame at which the run can be taken up
};

}  // namespace replan
