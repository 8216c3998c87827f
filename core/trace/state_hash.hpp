// The hash of a state, worked out a stretch at a time: that of 4096 x 4096 nodes takes the better part of a second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/deadline.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

/// SearchState::hash() of a state as it is now, whatever becomes of it. On the thread of the state, as its copies are.
class StateHash {
 public:
  explicit StateHash(SearchState state) : state_(std::move(state)), hash_(state_.node_count()) {}

  /// Reads at most so many values on. Whether it has come to the end.
  bool advance(std::size_t values);
  /// The same until the deadline.
  bool advance(const Deadline& deadline);
  /// How much of the state was read, 0 to 1.
  [[nodiscard]] double share() const;
  /// Once advance() has come to the end.
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  [[nodiscard]] std::size_t fields() const { return state_.declared().size() + state_.narrow_.size(); }
  template <class T>
  void read(const PagedArray<T>& field, std::size_t count, std::uint64_t end_mark);
  void read_scalars();

  SearchState state_;
  std::uint64_t hash_;
  std::size_t field_ = 0;  // the one that is being read; behind the last: done
  std::size_t node_ = 0;   // in it
};

}  // namespace replan
