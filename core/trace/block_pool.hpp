// Memory for many small blocks of one size that are shared: what the pages of states lie in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

namespace replan {

/// Names a block of a pool; 0 names none. Half as long as a pointer, which matters where most of what is
/// stored is names of blocks.
using BlockHandle = std::uint32_t;

/// Blocks that count who holds them. The counts lie together and apart from the blocks, so that to share a
/// block, or to let go of it, its own memory need not be fetched. Memory that was taken once is used again,
/// and given back with the pool. For one thread: counts that several may change cost more than all the rest.
/// But another one may read blocks that stay as they are, while they are held for it: blocks never move, nor
/// does what leads to them.
template <class Block>
class BlockPool {
 public:
  BlockPool() { chunks_.reserve(kMostBlocks / kChunk); }  // address space, not memory
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;

  /// A block with one holder, and whatever was in that memory before.
  [[nodiscard]] BlockHandle make() {
    BlockHandle handle = free_;
    if (handle != 0)
      free_ = holders_[handle];
    else
      handle = fresh();
    holders_[handle] = 1;
    ++used_;
    return handle;
  }
  void hold(BlockHandle handle) { ++holders_[handle]; }
  [[nodiscard]] bool shared(BlockHandle handle) const { return holders_[handle] > 1; }
  /// True if nobody is left: the block is the caller's, to empty it and to give it back.
  [[nodiscard]] bool let_go(BlockHandle handle) { return --holders_[handle] == 0; }
  void give_back(BlockHandle handle) {
    holders_[handle] = free_;
    free_ = handle;
    --used_;
  }

  [[nodiscard]] Block& operator[](BlockHandle handle) const {
    return chunks_[handle / kChunk][handle % kChunk];
  }
  /// Has the block brought into the cache.
  void fetch(BlockHandle handle) const {
    const auto* block = reinterpret_cast<const std::byte*>(&(*this)[handle]);
    for (std::size_t at = 0; at < sizeof(Block); at += 64) __builtin_prefetch(block + at);
  }
  /// Bytes of the blocks that somebody holds.
  [[nodiscard]] std::size_t bytes() const { return used_ * kBlockBytes; }
  static constexpr std::size_t kBlockBytes = sizeof(Block) + sizeof(BlockHandle);

 private:
  static constexpr std::size_t kChunk = 1024;
  static constexpr std::size_t kMostBlocks = std::size_t{1} << 28;

  /// A block that was never used.
  BlockHandle fresh() {
    if (holders_.size() % kChunk == 0) {
      if (holders_.size() + kChunk > kMostBlocks) throw std::bad_alloc();
      chunks_.emplace_back(new Block[kChunk]);
      if (holders_.empty()) holders_.push_back(0);  // of no block
    }
    holders_.push_back(0);
    return static_cast<BlockHandle>(holders_.size() - 1);
  }

  std::vector<std::unique_ptr<Block[]>> chunks_;
  std::vector<BlockHandle> holders_;  // of each block how many; of one that nobody holds the next such
  BlockHandle free_ = 0;
  std::size_t used_ = 0;
};

}  // namespace replan
