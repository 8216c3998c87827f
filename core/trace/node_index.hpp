// Where in a long log a node occurs: what makes the question for a cell's history fast.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/hash.hpp"

namespace replan {

/// A Bloom filter over the nodes of each block of a log: it names every block where a node occurs, and few
/// others. The filters of 64 blocks lie crosswise, the same bit of all of them in one word, so that three words
/// answer for 64 blocks. Takes a byte per event.
class NodeIndex {
 public:
  /// Events of one block.
  static constexpr std::size_t kBlock = 4096;

  /// The event at `position` is about `node`. Positions may come in any order, and again.
  void add(std::size_t position, NodeId node) {
    const std::size_t block = position / kBlock;
    while (groups_.size() <= block / kGroup) groups_.push_back(std::make_unique<Group>());
    Group& group = *groups_[block / kGroup];
    const std::uint64_t bit = std::uint64_t{1} << block % kGroup;
    const Places places(node);
    for (const std::size_t place : places.of) group[place] |= bit;
  }
  /// Forgets all blocks from `block` on.
  void truncate(std::size_t block);

  /// The last block before `before` where the node may occur, and the first from `from` on.
  [[nodiscard]] std::optional<std::size_t> last_block(NodeId node, std::size_t before) const;
  [[nodiscard]] std::optional<std::size_t> next_block(NodeId node, std::size_t from) const;

  [[nodiscard]] std::size_t bytes() const { return groups_.size() * sizeof(Group); }

 private:
  static constexpr std::size_t kGroup = 64;
  static constexpr std::size_t kBits = 32768;  // of one block's filter; about 1 in 200 of other nodes' blocks passes
  using Group = std::array<std::uint64_t, kBits>;

  /// The three bits that stand for a node.
  struct Places {
    explicit Places(NodeId node) {
      const std::uint64_t hash = mix64(node);
      const auto place = [](std::uint64_t bits) { return static_cast<std::size_t>(bits % kBits); };
      of = {place(hash), place(hash / kBits), place(hash / kBits / kBits)};
    }
    std::array<std::size_t, 3> of;
  };
  [[nodiscard]] std::uint64_t blocks_of(const Places& places, std::size_t group) const {
    const Group& words = *groups_[group];
    return words[places.of[0]] & words[places.of[1]] & words[places.of[2]];
  }

  std::vector<std::unique_ptr<Group>> groups_;
};

}  // namespace replan
