// Some cells of a run's world, as one thing to be shown.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/cost.hpp"
#include "core/trace/event.hpp"

namespace replan {

/// A bit for each node of the world, so that 16 million cells take 2 MB and are asked one by one in no time.
class CellSet {
 public:
  CellSet() = default;
  /// Empty, for a world of so many nodes. `log_id` is that of the run that the cells are of.
  CellSet(std::size_t nodes, std::uint64_t log_id) : log_id_(log_id), words_((nodes + 63) / 64) {}

  void add(NodeId node) {
    std::uint64_t& word = words_[node / 64];
    const std::uint64_t bit = std::uint64_t{1} << node % 64;
    size_ += (word & bit) == 0 ? 1 : 0;
    word |= bit;
  }
  [[nodiscard]] bool has(NodeId node) const {
    return node / 64 < words_.size() && (words_[node / 64] >> node % 64 & 1) != 0;
  }
  /// The 64 nodes from a multiple of 64 on, the first one lowest.
  [[nodiscard]] std::uint64_t word_of(NodeId node) const {
    return node / 64 < words_.size() ? words_[node / 64] : 0;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint64_t log_id() const { return log_id_; }
  /// Calls `visit(node)` for each, in the order of their nodes.
  template <class Visit>
  void each(Visit&& visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      for (std::uint64_t rest = words_[i]; rest != 0; rest &= rest - 1)
        visit(static_cast<NodeId>(i * 64 + static_cast<std::size_t>(std::countr_zero(rest))));
  }

 private:
  std::uint64_t log_id_ = 0;
  std::size_t size_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace replan
