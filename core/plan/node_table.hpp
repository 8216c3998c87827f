// A planner's records, one for each node, which forget a search at the cost of what it wrote.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/base/cell.hpp"

namespace replan {

/// Records in blocks that remember whether any of theirs was written to: a search that stays near its ends
/// leaves most of a large map as it was, and the next one need not fill it again. Who writes to a record says
/// so by mark() first.
template <class Record>
class NodeTable {
 public:
  explicit NodeTable(std::size_t count)
      : records_(count), marks_((count / kBlock / kMarks + 1) * kMarks, std::uint8_t{0}) {}

  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] Record& operator[](NodeId n) { return records_[n]; }
  [[nodiscard]] const Record& operator[](NodeId n) const { return records_[n]; }

  // Stored without looking: a branch would cost more.
  void mark(NodeId n) { marks_[n / kBlock] = 1; }

  /// All records back to what they were made as.
  void reset() {
    for (std::size_t first = 0; first < marks_.size(); first += kMarks) {
      std::uint64_t any = 0;
      std::memcpy(&any, &marks_[first], sizeof any);
      if (any == 0) continue;
      for (std::size_t block = first; block < first + kMarks; ++block)
        if (marks_[block] != 0) reset_block(block);
    }
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    return records_.capacity() * sizeof(Record) + marks_.capacity();
  }

  // What the open list asks for: where a node stands in it.
  [[nodiscard]] std::size_t get(NodeId n) const { return records_[n].slot; }
  void set(NodeId n, std::uint32_t slot) { records_[n].slot = slot & 0x7FFFFFFu; }

 private:
  static constexpr std::size_t kBlock = 64;  // records
  static constexpr std::size_t kMarks = 8;   // looked at together

  void reset_block(std::size_t block) {
    const auto first = records_.begin() + static_cast<std::ptrdiff_t>(block * kBlock);
    std::fill(first, first + static_cast<std::ptrdiff_t>(std::min(kBlock, records_.size() - block * kBlock)),
              Record{});
    marks_[block] = 0;
  }

  std::vector<Record> records_;
  std::vector<std::uint8_t> marks_;  // of blocks
};

}  // namespace replan
