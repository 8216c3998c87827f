// The open list: a 4-ary heap that knows where each node stands, so that keys can change and nodes can leave.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/cost.hpp"

namespace replan {

/// D* Lite's key [k1; k2], compared lexicographically. Nodes with equal keys come out by index, so that the
/// order does not depend on how the heap happens to be laid out, and a search can be taken up from its values
/// alone.
struct Key {
  Cost k1 = Cost::infinity();
  Cost k2 = Cost::infinity();
  friend constexpr auto operator<=>(const Key&, const Key&) = default;
};

/// A priority queue of nodes. `Slots` holds one number per node for it: `get(node)` and `set(node, slot)`,
/// zero = not in the list; it is passed in by each call, since it lives in the planner's own node records.
template <class K>
class OpenList {
 public:
  struct Entry {
    K key;
    NodeId node;
    // Without branches: which of two entries comes first is a coin toss, and a mispredicted one costs more
    // than both comparisons.
    friend constexpr bool operator<(const Entry& a, const Entry& b) {
      const int second = int{a.key.k2 < b.key.k2} | (int{a.key.k2 == b.key.k2} & int{a.node < b.node});
      return (int{a.key.k1 < b.key.k1} | (int{a.key.k1 == b.key.k1} & second)) != 0;
    }
  };

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] const Entry& top() const { return entries_.front(); }
  /// In heap order.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] std::size_t peak_bytes() const { return entries_.capacity() * sizeof(Entry); }

  // Inline in every search: each vertex is put in once, and whether that costs a call shall not depend on
  // what else a planner has in it.
  template <class Slots>
  [[gnu::always_inline]] void push(Slots& slots, const K& key, NodeId node) {
    entries_.push_back({key, node});
    rise(slots, entries_.size() - 1, {key, node});
  }
  /// Gives a node of the list another key.
  template <class Slots>
  void update(Slots& slots, const K& key, NodeId node) {
    place(slots, slots.get(node) - 1, {key, node});
  }
  template <class Slots>
  void remove(Slots& slots, NodeId node) {
    const std::size_t hole = slots.get(node) - 1;
    slots.set(node, 0);
    const Entry last = entries_.back();
    entries_.pop_back();
    if (hole < entries_.size()) place(slots, hole, last);
  }
  template <class Slots>
  void pop(Slots& slots) {
    slots.set(entries_.front().node, 0);
    const Entry last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) sink(slots, 0, last);
  }
  template <class Slots>
  void clear(Slots& slots) {
    for (const Entry& entry : entries_) slots.set(entry.node, 0);
    entries_.clear();
  }

 private:
  static constexpr std::size_t kArity = 4;

  template <class Slots>
  void place(Slots& slots, std::size_t hole, const Entry& entry) {
    if (hole > 0 && entry < entries_[(hole - 1) / kArity])
      rise(slots, hole, entry);
    else
      sink(slots, hole, entry);
  }
  template <class Slots>
  void settle(Slots& slots, std::size_t hole, const Entry& entry) {
    entries_[hole] = entry;
    slots.set(entry.node, static_cast<std::uint32_t>(hole + 1));
  }
  template <class Slots>
  void rise(Slots& slots, std::size_t hole, const Entry entry) {
    while (hole > 0) {
      const std::size_t parent = (hole - 1) / kArity;
      if (!(entry < entries_[parent])) break;
      settle(slots, hole, entries_[parent]);
      hole = parent;
    }
    settle(slots, hole, entry);
  }
  template <class Slots>
  void sink(Slots& slots, std::size_t hole, const Entry entry) {
    const std::size_t count = entries_.size();
    for (std::size_t child = hole * kArity + 1; child < count; child = hole * kArity + 1) {
      std::size_t least = child;
      const std::size_t end = std::min(child + kArity, count);
      for (std::size_t other = child + 1; other < end; ++other)
        if (entries_[other] < entries_[least]) least = other;
      if (!(entries_[least] < entry)) break;
      settle(slots, hole, entries_[least]);
      hole = least;
    }
    settle(slots, hole, entry);
  }

  std::vector<Entry> entries_;
};

}  // namespace replan
