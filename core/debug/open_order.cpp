#include "core/debug/open_order.hpp"

#include <algorithm>
#include <array>

namespace replan {
namespace {

constexpr std::size_t kPage = SearchState::kPage;

/// The values that an entry is made of, as events hold them: the queue's, and those that the list's order reads.
struct RawEntry {
  std::uint64_t queue = 0;
  std::array<std::uint64_t, 2> read{};
};

OpenEntry entry_of(const RawEntry& raw, const ListOrder& order, NodeId node) {
  const auto cost = [](std::uint64_t value) { return Cost{static_cast<std::int64_t>(value)}; };
  const Cost first = cost(raw.queue - 1);
  const Cost third = order.third.empty() ? Cost{} : cost(raw.read[1]);
  return {first, order.of(first, cost(raw.read[0]), cost(raw.read[1])), third, node};
}

RawEntry raw_entry(const SearchState& state, const ListOrder& order, NodeId node) {
  return {state.value(EventKind::queue, node),
          {state.value(order.reads[0], node), state.value(order.reads[1], node)}};
}

/// What the events of a stretch do to one vertex, taken together.
struct Change {
  NodeId node;
  RawEntry delta;

  void add(const Event& event, const ListOrder& order) {
    if (event.kind == EventKind::queue) delta.queue ^= event.delta;
    for (std::size_t i = 0; i < order.reads.size(); ++i)
      if (event.kind == order.reads[i]) delta.read[i] ^= event.delta;
  }
};

/// The vertices whose entries may have changed between two positions, each once.
std::vector<Change> changes_between(const Timeline& log, const ListOrder& order, std::size_t from,
                                    std::size_t to) {
  const KindSet kinds{EventKind::queue, order.reads[0], order.reads[1]};
  std::vector<Event> events;
  for (std::size_t i = from; i < to; ++i)
    if (const Event& event = log.event(i); kinds.has(event.kind)) events.push_back(event);
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.node < b.node; });
  std::vector<Change> changes;
  for (const Event& event : events) {
    if (changes.empty() || changes.back().node != event.node) changes.push_back({event.node, {}});
    changes.back().add(event, order);
  }
  return changes;
}

}  // namespace

OpenEntry open_entry(const SearchState& state, const ListOrder& order, NodeId node) {
  return entry_of(raw_entry(state, order, node), order, node);
}

// Keys lie close together, so about where an entry belongs can be told from its k1 alone: the entries are
// spread over buckets that fit into a cache, and only what shares a bucket is compared.
void sort_entries(std::vector<OpenEntry>& entries) {
  constexpr std::size_t kWorthIt = 4096, kPerBucket = 128;
  const auto [least, most] = std::minmax_element(
      entries.begin(), entries.end(), [](const OpenEntry& a, const OpenEntry& b) { return a.k1 < b.k1; });
  if (entries.size() < kWorthIt || least->k1 == most->k1) {
    std::sort(entries.begin(), entries.end());
    return;
  }
  const std::size_t buckets = entries.size() / kPerBucket;
  const std::int64_t low = least->k1.raw;
  const double scale = static_cast<double>(buckets - 1) / static_cast<double>(most->k1.raw - low);
  const auto bucket_of = [&](const OpenEntry& entry) {
    return static_cast<std::size_t>(static_cast<double>(entry.k1.raw - low) * scale);
  };
  std::vector<std::size_t> begins(buckets + 2);
  for (const OpenEntry& entry : entries) ++begins[bucket_of(entry) + 2];
  for (std::size_t i = 2; i < begins.size(); ++i) begins[i] += begins[i - 1];
  std::vector<OpenEntry> spread(entries.size());
  for (const OpenEntry& entry : entries) spread[begins[bucket_of(entry) + 1]++] = entry;
  for (std::size_t i = 0; i + 1 < begins.size(); ++i)
    std::sort(spread.begin() + static_cast<std::ptrdiff_t>(begins[i]),
              spread.begin() + static_cast<std::ptrdiff_t>(begins[i + 1]));
  entries.swap(spread);
}

bool OpenOrder::far(const LogView& view, std::uint64_t log_id) const {
  // Where putting in and taking out one by one costs as much as sorting.
  const std::size_t worth_it = 1024 + size_ / 16;
  const std::size_t cursor = view.log.cursor();
  const std::size_t low = std::min(cursor, position_), high = std::max(cursor, position_);
  return log_id != log_id_ || high - low > worth_it || !view.log.reversible(low, high);
}

void OpenOrder::follow(const LogView& view, std::uint64_t log_id) {
  const bool anew = far(view, log_id);
  if (!anew && position_ == view.log.cursor()) return;
  if (anew)
    gather(view.log.state(), view.info.values.order);
  else
    take_over(view.log, view.info.values.order);
  log_id_ = log_id;
  position_ = view.log.cursor();
  count();
}

void OpenOrder::gather(const SearchState& state, const ListOrder& order) {
  std::vector<OpenEntry> entries;
  entries.reserve(std::max(size_, kPage));
  for (std::size_t first = 0; first < state.node_count(); first += kPage) {
    const auto base = static_cast<NodeId>(first);
    const std::uint64_t* queue = state.page(EventKind::queue, base);
    if (queue == nullptr) continue;
    const std::size_t count = std::min(kPage, state.node_count() - first);
    for (std::size_t i = 0; i < count; ++i)
      if (queue[i] != 0) entries.push_back(open_entry(state, order, static_cast<NodeId>(first + i)));
  }
  sort_entries(entries);
  blocks_.clear();
  for (std::size_t first = 0; first < entries.size(); first += kBlock) {
    const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = entries.begin() + static_cast<std::ptrdiff_t>(std::min(first + kBlock, entries.size()));
    blocks_.emplace_back(begin, end);
  }
}

// An entry's old key is its new one with the stretch undone: events hold before XOR after.
void OpenOrder::take_over(const Timeline& log, const ListOrder& order) {
  const std::size_t cursor = log.cursor();
  const std::vector<Change> changes =
      changes_between(log, order, std::min(cursor, position_), std::max(cursor, position_));
  const SearchState& state = log.state();
  for (const Change& change : changes) {
    const RawEntry now = raw_entry(state, order, change.node);
    const RawEntry before{now.queue ^ change.delta.queue,
                          {now.read[0] ^ change.delta.read[0], now.read[1] ^ change.delta.read[1]}};
    if (before.queue != 0) erase(entry_of(before, order, change.node));
    if (now.queue != 0) insert(entry_of(now, order, change.node));
  }
}

/// The last block whose first entry is not behind it; the first one if all are.
std::size_t OpenOrder::block_of(const OpenEntry& entry) const {
  const auto after =
      std::upper_bound(blocks_.begin(), blocks_.end(), entry,
                       [](const OpenEntry& e, const Block& block) { return e < block.front(); });
  return after == blocks_.begin() ? 0 : static_cast<std::size_t>(after - blocks_.begin()) - 1;
}

void OpenOrder::insert(const OpenEntry& entry) {
  if (blocks_.empty()) {
    blocks_.push_back({entry});
    return;
  }
  const std::size_t at = block_of(entry);
  Block& block = blocks_[at];
  block.insert(std::lower_bound(block.begin(), block.end(), entry), entry);
  if (block.size() < 2 * kBlock) return;
  Block half(block.begin() + kBlock, block.end());
  block.resize(kBlock);
  blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::move(half));
}

void OpenOrder::erase(const OpenEntry& entry) {
  if (blocks_.empty()) return;
  const std::size_t at = block_of(entry);
  Block& block = blocks_[at];
  const auto found = std::lower_bound(block.begin(), block.end(), entry);
  if (found == block.end() || *found != entry) return;
  block.erase(found);
  if (block.empty()) blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(at));
}

void OpenOrder::count() {
  starts_.clear();
  size_ = 0;
  for (const Block& block : blocks_) {
    starts_.push_back(size_);
    size_ += block.size();
  }
}

const OpenEntry& OpenOrder::operator[](std::size_t rank) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), rank);
  const auto at = static_cast<std::size_t>(after - starts_.begin()) - 1;
  return blocks_[at][rank - starts_[at]];
}

std::optional<std::size_t> OpenOrder::rank_of(const OpenEntry& entry) const {
  if (blocks_.empty()) return std::nullopt;
  const std::size_t at = block_of(entry);
  const Block& block = blocks_[at];
  const auto found = std::lower_bound(block.begin(), block.end(), entry);
  if (found == block.end() || *found != entry) return std::nullopt;
  return starts_[at] + static_cast<std::size_t>(found - block.begin());
}

}  // namespace replan
