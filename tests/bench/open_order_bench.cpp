// The open list in the planner's order at a million entries: sorted once, then kept up with a cursor.
#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/debug/open_order.hpp"

namespace replan {
namespace {

constexpr int kSide = 2048;
constexpr std::uint32_t kEntries = 1'000'000;
constexpr std::size_t kSteps = 20000;

/// A log that puts a million vertices into the list, and then goes on as a search does: it takes one and
/// gives its neighbours new keys.
struct BigList {
  Box lattice{kSide, kSide};
  Settings settings;
  Timeline log{SearchState(std::size_t{kSide} * kSide)};
  std::size_t full = 0;  // the position at which all are in

  BigList() {
    Random random(1);
    std::vector<Event> events;
    for (std::uint32_t i = 0; i < kEntries; ++i) put(events, i * 4u + random.below(4), random);
    full = events.size();
    for (std::size_t i = 0; i < kSteps; ++i) {
      const NodeId taken = random.below(kEntries) * 4u;
      events.push_back({0, taken, EventKind::pop, 44});
      for (NodeId n = 0; n < 8; ++n) put(events, taken + n, random);
    }
    log.append(events);
  }
  void put(std::vector<Event>& events, NodeId node, Random& random) {
    const std::uint64_t key = static_cast<std::uint64_t>(Cost::cells(1000).raw) + (random.next() >> 25);
    node = std::min(node, static_cast<NodeId>(kSide * kSide - 1));
    std::uint64_t& now = keys_[node];
    events.push_back({now ^ key, node, EventKind::queue, 31});
    events.push_back({random.next() >> 30, node, EventKind::rhs, 21});
    now = key;
  }

 private:
  std::vector<std::uint64_t> keys_ = std::vector<std::uint64_t>(std::size_t{kSide} * kSide);
};

BigList& big_list() {
  static BigList list;
  return list;
}

LogView view_of(const BigList& list) {
  return {list.log, list.lattice, *find_planner("dstar-lite"), list.settings};
}

void BM_open_order_anew(benchmark::State& state) {
  BigList& list = big_list();
  list.log.seek(list.full);
  for (auto _ : state) {
    OpenOrder order;
    order.follow(view_of(list), 1);
    benchmark::DoNotOptimize(order.size());
  }
}
BENCHMARK(BM_open_order_anew)->Unit(benchmark::kMillisecond);

/// The argument: events that the cursor goes on by.
void BM_open_order_step(benchmark::State& state) {
  BigList& list = big_list();
  const auto step = static_cast<std::size_t>(state.range(0));
  list.log.seek(list.full);
  OpenOrder order;
  order.follow(view_of(list), 1);
  for (auto _ : state) {
    state.PauseTiming();
    const std::size_t next = list.log.cursor() + step;
    list.log.seek(next <= list.log.size() ? next : list.full);
    if (next > list.log.size()) order.follow(view_of(list), 1);
    state.ResumeTiming();
    order.follow(view_of(list), 1);
    benchmark::DoNotOptimize(order[0].node);
  }
  state.counters["entries"] = static_cast<double>(order.size());
}
BENCHMARK(BM_open_order_step)->Arg(1)->Arg(20)->Arg(2000)->Arg(20000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace replan
