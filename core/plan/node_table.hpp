// A planner's records, one for each node, and two ways to forget what a search wrote into them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/base/cell.hpp"

namespace replan {

/// What both tables are: records, each with a `slot` of 27 bits, its node's place in the open list + 1.
template <class R>
class NodeRecords {
 public:
  using Record = R;

  [[nodiscard]] std::size_t size() const { return records_.size(); }
  /// The record of a node that this search has written to, to write more.
  [[nodiscard]] Record& held(NodeId n) { return records_[n]; }

  // What the open list asks for; kMaxCells fits.
  [[nodiscard]] std::size_t get(NodeId n) const { return records_[n].slot; }
  void set(NodeId n, std::uint32_t slot) { records_[n].slot = slot & 0x7FFFFFFu; }

 protected:
  explicit NodeRecords(std::size_t count) : records_(count) {}

  std::vector<Record> records_;
};

/// Records in blocks that remember whether any of theirs was written to: a search that stays near its ends
/// leaves most of a large map as it was, and the next one need not fill it again. Reading costs nothing.
template <class R>
class NodeTable : public NodeRecords<R> {
 public:
  using Record = R;

  explicit NodeTable(std::size_t count)
      : NodeRecords<R>(count), marks_((count / kBlock / kMarks + 1) * kMarks, std::uint8_t{0}) {}

  [[nodiscard]] const Record& operator[](NodeId n) const { return records_[n]; }

  /// The record, to be written for the first time. Stored without looking: a branch would cost more.
  Record& write(NodeId n) {
    marks_[n / kBlock] = 1;
    return records_[n];
  }

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

 private:
  using NodeRecords<R>::records_;
  static constexpr std::size_t kBlock = 64;  // records
  static constexpr std::size_t kMarks = 8;   // looked at together

  void reset_block(std::size_t block) {
    const auto first = records_.begin() + static_cast<std::ptrdiff_t>(block * kBlock);
    std::fill(first, first + static_cast<std::ptrdiff_t>(std::min(kBlock, records_.size() - block * kBlock)),
              Record{});
    marks_[block] = 0;
  }

  std::vector<std::uint8_t> marks_;  // of blocks
};

/// Records that carry the number of the `search` that wrote them, where they have room for it: forgetting is
/// another number, for planners that start afresh at every change; each reading looks at it.
template <class R>
class NumberedTable : public NodeRecords<R> {
 public:
  using Record = R;

  explicit NumberedTable(std::size_t count) : NodeRecords<R>(count) {}

  [[nodiscard]] const Record& operator[](NodeId n) const {
    const Record& record = records_[n];
    return record.search == search_ ? record : kBlank;
  }

  /// The record, to be written, for the first time or not.
  Record& write(NodeId n) {
    Record& record = records_[n];
    if (record.search != search_) {
      record = {};
      record.search = search_;
    }
    return record;
  }

  /// All records back to what they were made as, but for their slots, which the open list has set to zero.
  void reset() { ++search_; }

  [[nodiscard]] std::size_t memory_bytes() const { return records_.capacity() * sizeof(Record); }

 private:
  using NodeRecords<R>::records_;
  static constexpr Record kBlank{};

  std::uint32_t search_ = 1;  // records are made as of none
};

}  // namespace replan
