// What happened to the values of one cell over a whole log.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/trace/timeline.hpp"

namespace replan {

/// An event that wrote a value of the cell, or an epoch that forgot it.
struct ValueChange {
  std::size_t event = 0;  ///< its index in the log
  EventKind kind = EventKind::g;
  std::uint8_t line = 0;
  std::uint64_t before = 0, after = 0;  ///< as events hold them
};

/// The changes of a cell, the newest first, read out of the log in slices, from its end backwards.
class CellHistory {
 public:
  /// Reads on by at most `most` changes; starts over for another cell, other kinds or another log (`log_id`).
  /// Kinds that change no value of a node are passed over.
  void follow(const Timeline& log, std::uint64_t log_id, NodeId node, KindSet kinds, std::size_t most);

  /// True once the beginning of the log was reached.
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] std::size_t size() const { return newer_.size() + older_.size(); }
  /// The newest is 0.
  [[nodiscard]] const ValueChange& operator[](std::size_t index) const {
    return index < newer_.size() ? newer_[newer_.size() - 1 - index] : older_[index - newer_.size()];
  }
  /// How many of those that were read were written at or behind a position of the log.
  [[nodiscard]] std::size_t after(std::size_t position) const;

 private:
  using Values = std::array<std::uint64_t, kWideSlots + kNarrowFields>;  // by place()

  void start(const Timeline& log);
  [[nodiscard]] static std::size_t place(EventKind kind);
  template <class Each>
  void for_forgotten(const Timeline& log, Each&& each) const;
  void take_epoch(const Timeline& log, const Event& epoch, std::size_t index);
  void take_epoch_back(const Timeline& log, const Event& epoch, std::size_t index);

  std::uint64_t log_id_ = 0;
  NodeId node_ = kNoNode;
  KindSet kinds_;
  bool complete_ = false;
  std::size_t begin_ = 0, end_ = 0;  // the stretch of the log that was read
  Values first_{}, last_{};          // the values at its ends
  std::vector<ValueChange> older_;   // falling, read backwards
  std::vector<ValueChange> newer_;   // rising: what the log has grown by since
};

}  // namespace replan
