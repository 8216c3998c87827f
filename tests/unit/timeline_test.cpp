// The timeline: every moment is the same whichever way it was reached.
#include "core/trace/timeline.hpp"

#include <map>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/trace/tracer.hpp"

namespace replan::timeline_test {
namespace {

constexpr std::size_t kNodes = 5000;

/// A log of random changes, kept consistent with the values they change.
std::vector<Event> random_log(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  SearchState values(kNodes);
  std::vector<Event> log;
  while (log.size() < count) {
    Event event;
    event.kind = static_cast<EventKind>(random.below(static_cast<std::uint32_t>(EventKind::gave_up) + 1));
    event.node = event.kind == EventKind::scalar ? random.below(static_cast<std::uint32_t>(Scalar::count))
                                                 : random.below(kNodes);
    const bool narrow = event.kind == EventKind::known || event.kind == EventKind::truth;
    event.delta = narrow ? 1 : random.next();
    event.line = static_cast<std::uint8_t>(random.below(64));
    values.apply(event);
    log.push_back(event);
  }
  return log;
}

TEST(Timeline, SeekingReachesTheSameStateFromEverywhere) {
  const std::vector<Event> log = random_log(3000, 1);
  Timeline timeline{SearchState(kNodes)};
  timeline.append(log);
  std::vector<std::uint64_t> hashes;
  SearchState state(kNodes);
  hashes.push_back(state.hash());
  for (const Event& event : log) {
    state.apply(event);
    hashes.push_back(state.hash());
  }
  for (std::size_t p = 0; p <= log.size(); p += 37) {  // forwards
    timeline.seek(p);
    ASSERT_EQ(timeline.state().hash(), hashes[p]);
  }
  for (std::size_t p = log.size(); p > 50; p -= 41) {  // backwards
    timeline.seek(p);
    ASSERT_EQ(timeline.state().hash(), hashes[p]);
  }
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const std::size_t p = random.below(static_cast<std::uint32_t>(log.size()) + 1);
    timeline.seek(p);
    ASSERT_EQ(timeline.cursor(), p);
    ASSERT_EQ(timeline.state().hash(), hashes[p]);
  }
}

TEST(Timeline, KeyFramesAreThinnedOutUnderTheirBudgetAndSeeksStayRight) {
  const std::vector<Event> log = random_log(600000, 2);
  Timeline rich{SearchState(kNodes)};
  Timeline poor(SearchState(kNodes), {.bytes = 1});  // no budget: frames are thrown away as they come
  rich.append(log);
  poor.append(log);
  EXPECT_GT(rich.key_frames(), 3u);
  EXPECT_LE(poor.key_frames(), 2u);
  for (const std::size_t p : {0u, 131072u, 131073u, 300000u, 599999u, 42u, 600000u}) {
    rich.seek(p);
    poor.seek(p);
    ASSERT_EQ(rich.state().hash(), poor.state().hash()) << "at " << p;
  }
}

TEST(Timeline, KeyFramesStandEvenlyAndUnderTheirBudgetHoweverLongTheLogGrows) {
  const std::vector<Event> log = random_log(400000, 8);
  const LogLimits limits{.bytes = std::size_t{16} << 20, .frame_interval = 4096};
  Timeline timeline(SearchState(kNodes), limits);
  for (std::size_t done = 0; done < log.size(); done += 4096) {
    timeline.append(std::span(log).subspan(done, std::min<std::size_t>(4096, log.size() - done)));
    // A quarter, and what the end of the log has written since the last frame.
    ASSERT_LE(timeline.frame_bytes(), limits.bytes / 3);
  }
  // A frame takes half a MiB at most.
  EXPECT_GE(timeline.key_frames(), 7u);
}

TEST(Timeline, TruncatingForgetsAndAppendingGoesOn) {
  const std::vector<Event> log = random_log(300000, 3);
  Timeline timeline{SearchState(kNodes)};
  timeline.append(log);
  timeline.seek(100000);
  const std::uint64_t then = timeline.state().hash();
  const std::uint64_t whole = timeline.log_hash();
  for (const std::size_t cut : {200000u, 131072u, 65536u, 1u}) {
    timeline.seek(timeline.size());
    timeline.truncate(cut);
    EXPECT_EQ(timeline.size(), cut);
    EXPECT_EQ(timeline.cursor(), cut);
    timeline.append({log.begin() + static_cast<std::ptrdiff_t>(cut), log.end()});
    ASSERT_EQ(timeline.log_hash(), whole);
    timeline.seek(100000);
    ASSERT_EQ(timeline.state().hash(), then);
    timeline.seek(timeline.size());
    ASSERT_EQ(timeline.state().hash(), timeline.head().hash());
  }
}

/// A log with searches that are forgotten now and then, some of them soon after they began.
std::vector<Event> log_with_epochs(std::size_t size, std::uint64_t seed) {
  std::vector<Event> log = random_log(size, seed);
  Random random(seed + 1);
  for (std::size_t i = 0; i < log.size(); i += 1 + random.below(random.chance(0.5) ? 50 : 20000))
    log[i] = {0, log[i].node, EventKind::epoch, 1, 0};
  return log;
}

TEST(Timeline, GoesBackOverEpochsToWhatTheyForgot) {
  const std::vector<Event> log = log_with_epochs(300000, 11);
  Timeline timeline{SearchState(kNodes)};
  timeline.append(log);
  std::map<std::size_t, std::uint64_t> hashes;
  Random random(12);
  for (int i = 0; i < 60; ++i) hashes[random.below(static_cast<std::uint32_t>(log.size()) + 1)] = 0;
  for (const std::size_t epoch : timeline.epochs())
    for (const std::size_t near : {epoch, epoch + 1}) hashes[near] = 0;
  ASSERT_GT(timeline.epochs().size(), 20u);
  SearchState state(kNodes);
  std::size_t at = 0;
  for (auto& [position, hash] : hashes) {
    for (; at < position; ++at) state.apply(log[at]);
    hash = state.hash();
  }
  for (auto each = hashes.rbegin(); each != hashes.rend(); ++each) {  // from the end to the beginning
    timeline.seek(each->first);
    ASSERT_EQ(timeline.state().hash(), each->second) << "at " << each->first;
  }
  for (int i = 0; i < 300; ++i) {
    const auto& [position, hash] =
        *std::next(hashes.begin(), random.below(static_cast<std::uint32_t>(hashes.size())));
    timeline.seek(position);
    ASSERT_EQ(timeline.state().hash(), hash) << "at " << position;
    ASSERT_EQ(timeline.state_at(position).hash(), hash);
  }
}

TEST(Timeline, CutsBeforeAndBehindEpochsAndGoesOn) {
  const std::vector<Event> log = log_with_epochs(100000, 13);
  Timeline whole{SearchState(kNodes)}, cut{SearchState(kNodes)};
  whole.append(log);
  cut.append(log);
  const std::vector<std::size_t> epochs(whole.epochs().begin(), whole.epochs().end());
  for (auto epoch = epochs.rbegin(); epoch != epochs.rend(); ++epoch)
    for (const std::size_t size : {*epoch + 1, *epoch}) {
      cut.truncate(size);
      ASSERT_EQ(cut.head().hash(), whole.state_at(size).hash()) << "at " << size;
      cut.append(std::span(log).subspan(size, std::min<std::size_t>(50, log.size() - size)));
      cut.truncate(size);
      ASSERT_EQ(cut.head().hash(), whole.state_at(size).hash()) << "again at " << size;
    }
}

TEST(Timeline, AnEpochIsALastAndNextEventOfEveryNodeThatItForgets) {
  Timeline timeline{SearchState(kNodes)};
  Recorder recorder;
  recorder.change(EventKind::g, 7, 5, 6);     // 0
  recorder.change(EventKind::dist, 7, 0, 1);  // 1
  recorder.note(EventKind::epoch, 3);         // 2
  recorder.change(EventKind::g, 8, 5, 6);     // 3
  recorder.note(EventKind::epoch, 3);         // 4
  timeline.append(recorder.take());
  EXPECT_EQ(timeline.last_event(7, {EventKind::g}, 5), 4u);
  EXPECT_FALSE(timeline.changes(4, 7, EventKind::g));  // it was forgotten before
  EXPECT_TRUE(timeline.changes(4, 8, EventKind::g));
  EXPECT_TRUE(timeline.changes(2, 7, EventKind::g));
  EXPECT_EQ(timeline.last_event(7, {EventKind::g}, 2), 0u);
  EXPECT_EQ(timeline.last_event(7, {EventKind::dist}, 5), 1u);  // not forgotten
  EXPECT_EQ(timeline.next_event(7, {EventKind::g}, 1), 2u);
  EXPECT_EQ(timeline.next_event(7, {EventKind::dist}, 2), std::nullopt);
}

/// 64 chunks of events that have little in common.
class EventStoreTest : public testing::Test {
 protected:
  static constexpr std::size_t kChunk = 1024, kChunks = 64;

  void SetUp() override { store_.append(events_); }
  /// The event at a position, whatever it takes to open its chunk.
  Event read(std::size_t index) {
    if (store_.find(index) == nullptr) store_.open(store_.chunk_of(index));
    return *store_.find(index);
  }
  [[nodiscard]] std::size_t held() const {
    std::size_t count = 0;
    for (std::size_t chunk = 0; chunk < kChunks; ++chunk) count += store_.holds(chunk) ? 1 : 0;
    return count;
  }

  const std::vector<Event> events_ = random_log(kChunk * kChunks, 9);
  EventStore store_{kChunk};
  const std::size_t whole_ = events_.size() * sizeof(Event);
};

TEST_F(EventStoreTest, PacksWhatIsNotReadAndOpensItAgain) {
  EXPECT_EQ(store_.bytes(), whole_);
  store_.shrink(whole_ / 8, whole_, 0, 0);
  EXPECT_LT(store_.bytes(), whole_ * 9 / 10);  // of memory: bytes() counts what the chunks have taken
  EXPECT_EQ(held(), kChunks);
  EXPECT_FALSE(store_.dropped());
  EXPECT_NE(store_.find(0), nullptr) << "the chunk that is kept";
  EXPECT_NE(store_.find(events_.size() - 1), nullptr) << "the last one";
  EXPECT_EQ(store_.find(10 * kChunk), nullptr);
  for (std::size_t i = 0; i < events_.size(); ++i) ASSERT_EQ(read(i), events_[i]) << i;
}

TEST_F(EventStoreTest, DropsWhatEvenPackedTakesTooMuch) {
  store_.shrink(whole_ / 8, whole_ / 2, 0, 20);
  EXPECT_LE(store_.bytes(), whole_ / 2);
  EXPECT_TRUE(store_.dropped());
  for (std::size_t chunk = 0; chunk < 20; ++chunk)
    EXPECT_TRUE(store_.holds(chunk)) << "that must not be dropped";
  EXPECT_FALSE(store_.holds(30));
  const std::size_t before = held();
  store_.put_back(30, std::span(events_).subspan(30 * kChunk, kChunk));
  EXPECT_EQ(held(), before + 1);
  EXPECT_EQ(read(30 * kChunk + 7), events_[30 * kChunk + 7]);
}

TEST_F(EventStoreTest, GrowsOnWhereItWasCut) {
  store_.shrink(whole_ / 8, whole_, 0, 0);
  const std::size_t size = 40 * kChunk + 100;
  static_cast<void>(read(size - 1));  // what becomes the last chunk has to lie open
  static_cast<void>(store_.truncate(size));
  store_.append(std::span(events_).subspan(size));
  for (std::size_t i = 0; i < events_.size(); ++i) ASSERT_EQ(read(i), events_[i]) << i;
  while (store_.size() > 0) static_cast<void>(store_.truncate((store_.size() - 1) / kChunk * kChunk));
  EXPECT_EQ(store_.bytes(), 0u) << "every byte is accounted for";
}

TEST(Timeline, CountsTheOpenListInBothDirections) {
  const std::vector<Event> log = random_log(20000, 4);
  Timeline timeline{SearchState(kNodes)};
  timeline.append(log);
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    timeline.seek(random.below(static_cast<std::uint32_t>(log.size()) + 1));
    std::size_t counted = 0;
    for (NodeId n = 0; n < kNodes; ++n) counted += timeline.state().queued(n) ? 1 : 0;
    ASSERT_EQ(timeline.state().queue_size(), counted);
  }
}

/// The answers by looking at every event.
std::optional<std::size_t> last_by_scan(const std::vector<Event>& log, NodeId node, KindSet kinds,
                                        std::size_t before) {
  for (std::size_t i = std::min(before, log.size()); i-- > 0;)
    if (log[i].node == node && kinds.has(log[i].kind)) return i;
  return std::nullopt;
}
std::optional<std::size_t> next_by_scan(const std::vector<Event>& log, NodeId node, KindSet kinds,
                                        std::size_t from) {
  for (std::size_t i = from; i < log.size(); ++i)
    if (log[i].node == node && kinds.has(log[i].kind)) return i;
  return std::nullopt;
}

/// Asks for random nodes, most of them rare or absent, before and after random places.
void expect_histories(const Timeline& timeline, const std::vector<Event>& log, Random& random) {
  ASSERT_EQ(timeline.size(), log.size());
  for (int i = 0; i < 200; ++i) {
    const NodeId node = random.chance(0.5) ? random.below(40) : random.below(2 * kNodes);
    KindSet kinds{EventKind::g, EventKind::scalar};
    if (random.chance(0.5)) kinds.add(EventKind::pop);
    const std::size_t place = random.below(static_cast<std::uint32_t>(log.size()) + 10);
    ASSERT_EQ(timeline.last_event(node, kinds, place), last_by_scan(log, node, kinds, place)) << place;
    ASSERT_EQ(timeline.next_event(node, kinds, place), next_by_scan(log, node, kinds, place)) << place;
  }
}

TEST(Timeline, HistoriesOfNodesAreThoseOfALinearScanAlsoAfterCuts) {
  Random random(6);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    // Longer than 64 blocks of the index at times, and shorter than one.
    std::vector<Event> log = random_log(seed % 2 == 0 ? 400000 : 3000, 10 + seed);
    for (std::size_t i = 0; i < log.size(); ++i)  // a stretch where few nodes occur at all
      if (i / 50000 % 2 == 1 && log[i].kind != EventKind::scalar) log[i].node %= 64;
    LogLimits limits;
    if (seed >= 2) limits.bytes = std::size_t{1} << 20;  // so that most of it lies packed
    if (seed >= 4) limits.chunk_events = 512;            // in pieces shorter than a block of the index
    Timeline timeline{SearchState(kNodes), limits};
    timeline.append(log);
    expect_histories(timeline, log, random);
    for (int cut = 0; cut < 4; ++cut) {
      const std::size_t left = random.below(static_cast<std::uint32_t>(log.size()) + 1);
      timeline.truncate(left);
      log.resize(left);
      expect_histories(timeline, log, random);
      const std::vector<Event> more = random_log(random.below(100000), 100 + seed);
      timeline.append(more);
      log.insert(log.end(), more.begin(), more.end());
      expect_histories(timeline, log, random);
    }
  }
}

TEST(SearchState, OfAStretchAtOnceIsThatOfItsEventsOneByOneInBothDirections) {
  Random random(9);
  PageOrder order;
  for (const std::size_t nodes : {1u, 15u, 700u, 5000u}) {
    std::vector<Event> log = random_log(20000, nodes);
    for (Event& event : log)
      if (event.kind != EventKind::scalar) event.node %= static_cast<NodeId>(nodes);
    SearchState at_once(nodes), one_by_one(nodes);
    for (int i = 0; i < 30; ++i) {
      const std::size_t from = random.below(20000),
                        count = random.below(static_cast<std::uint32_t>(20001 - from));
      const std::span<const Event> stretch = std::span(log).subspan(from, count);
      const SearchState before = at_once;
      at_once.apply(stretch, order);
      for (const Event& event : stretch) one_by_one.apply(event);
      ASSERT_EQ(at_once.hash(), one_by_one.hash());
      ASSERT_EQ(at_once.queue_size(), one_by_one.queue_size());
      SearchState back = at_once;
      back.apply(stretch, order);
      ASSERT_EQ(back.hash(), before.hash());
      ASSERT_EQ(back.queue_size(), before.queue_size());
    }
  }
}

TEST(PageOrder, HoldsTheWideEventsPageByPageInTheOrderOfTheLog) {
  std::vector<Event> log = random_log(5000, 11);
  for (std::size_t i = 0; i < log.size(); ++i) log[i].delta = i;
  PageOrder order;
  const std::span<const Event> sorted = order.sort(log, kNodes);
  std::map<std::uint64_t, std::vector<std::uint64_t>> pages;
  for (const Event& event : log)
    if (static_cast<int>(event.kind) < kWideFields) pages[PageOrder::page_of(event)].push_back(event.delta);
  std::vector<std::uint64_t> expected, found;
  for (const auto& [page, places] : pages) expected.insert(expected.end(), places.begin(), places.end());
  for (const Event& event : sorted) found.push_back(event.delta);
  EXPECT_EQ(found, expected);
}

TEST(PagedArray, CopiesShareUntilOneWrites) {
  PagedArray<int> a(5000, 7);
  EXPECT_EQ(a[4999], 7);
  EXPECT_FALSE(a.touched(4999));
  a.at(4999) = 1;
  PagedArray<int> b = a;
  b.at(4998) = 2;
  EXPECT_EQ(a[4998], 7);
  EXPECT_EQ(b[4999], 1);
  EXPECT_FALSE(b.touched(0));
}

TEST(PagedArray, CopiesBehaveLikeArraysOfTheirOwnAndLeaveNoPageBehind) {
  constexpr std::size_t kSize = 3000;
  Random random(3);
  const auto pool = std::make_shared<PagePool<std::uint64_t>>();
  {
    std::vector<PagedArray<std::uint64_t>> paged(5, PagedArray<std::uint64_t>(kSize, 9, pool));
    std::vector<std::vector<std::uint64_t>> plain(5, std::vector<std::uint64_t>(kSize, 9));
    for (int i = 0; i < 20000; ++i) {
      const std::size_t a = random.below(5), b = random.below(5);
      if (random.chance(0.02)) {  // assigns over shared and unshared pages, and to itself
        paged[a] = paged[b];
        plain[a] = plain[b];
      } else if (random.chance(0.01)) {
        paged[a] = PagedArray<std::uint64_t>(paged[b]);
        plain[a] = plain[b];
      } else {
        const std::size_t at = random.chance(0.5) ? random.below(100) : random.below(kSize);
        paged[a].at(at) = plain[a][at] = random.next();
      }
      const std::size_t at = random.below(kSize);
      ASSERT_EQ(paged[b][at], plain[b][at]);
    }
    for (std::size_t a = 0; a < paged.size(); ++a)
      for (std::size_t at = 0; at < kSize; ++at) ASSERT_EQ(paged[a][at], plain[a][at]);
    EXPECT_GE(pool->bytes(), paged[0].page_bytes());
    EXPECT_GT(paged[0].page_bytes(), 0u);
  }
  EXPECT_EQ(pool->bytes(), 0u);
}

}  // namespace
}  // namespace replan::timeline_test
