// The ends of the colour map: those of the state at every moment, however little of it a frame has time to look at.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/scene/field.hpp"
#include "core/session/session.hpp"

namespace replan::field_range_test {
namespace {

Scenario open_box(const char* planner) {
  Scenario scenario;
  scenario.map = GridMap(40, 40, 40);
  scenario.start = {1, 1, 1};
  scenario.goal = {38, 37, 36};
  scenario.planners = {{planner, {}, {}}};
  return scenario;
}

/// By looking at every node.
std::optional<FieldRange> range_of(const SearchState& state, const FieldReader& reader) {
  std::optional<FieldRange> range;
  for (NodeId node = 0; node < state.node_count(); ++node) {
    const std::int64_t word = reader.read(state.value(reader.kind, node));
    if (word == FieldReader::kNone) continue;
    const double value = static_cast<double>(word) * reader.unit;
    range = range ? FieldRange{std::min(range->low, value), std::max(range->high, value)}
                  : FieldRange{value, value};
  }
  return range;
}

TEST(FieldRange, IsThatOfTheStateAtEveryMomentOnceItIsNotBehind) {
  Session session(open_box("dstar-lite"));
  session.settle();
  const Timeline& log = session.run().timeline();
  const FieldReader reader = FieldReader::of(Overlay::g);
  FieldRanges so_far, whole;
  const auto head = range_of(log.head(), reader);
  ASSERT_TRUE(head);
  Random random(3);
  std::size_t behind = 0;
  for (int i = 0; i < 40; ++i) {
    const auto end = static_cast<std::uint32_t>(log.size());
    const std::size_t to =
        i % 4 == 0 ? random.below(end) : std::min<std::size_t>(end, log.cursor() + random.below(400));
    ASSERT_TRUE(session.apply(Seek{to}).ok());
    const auto settled = [&](FieldRanges& ranges, FieldSpan span) {
      auto range = ranges.at_cursor(session.run(), Overlay::g, span, Deadline(0));
      for (; ranges.behind(); ++behind)
        range = ranges.at_cursor(session.run(), Overlay::g, span, Deadline(0));
      return range;
    };
    const auto here = range_of(log.state(), reader);
    ASSERT_EQ(settled(so_far, FieldSpan::so_far), here) << "at event " << to;
    const auto both =
        here ? std::optional(FieldRange{std::min(here->low, head->low), std::max(here->high, head->high)})
             : std::nullopt;
    ASSERT_EQ(settled(whole, FieldSpan::whole_run), both) << "at event " << to;
  }
  EXPECT_GT(behind, 100u) << "it never had to be asked twice";
}

/// Far leaps to and fro, of which each makes all of it stale again.
TEST(FieldRange, LooksAtALittleOfItEachTimeAndAtAllOfItInTurn) {
  Session session(open_box("dijkstra"));
  session.settle();
  const Timeline& log = session.run().timeline();
  const FieldReader reader = FieldReader::of(Overlay::g);
  const std::size_t nodes = session.run().lattice().node_count(), end = log.size();
  ASSERT_GT(end, 2 * nodes);
  RangeTracker tracker;
  std::optional<FieldRange> range;
  const std::size_t most = 2048 / 64, calls = nodes / 2048 + 2;
  for (std::size_t i = 0; i < calls; ++i) {
    const std::size_t to = end - (i % 2) * nodes / 16;
    ASSERT_TRUE(session.apply(Seek{to}).ok());
    const std::size_t before = tracker.scanned();
    range = tracker.follow(reader, log, session.run().log_id(), log.state(), to, Deadline(0));
    EXPECT_TRUE(tracker.behind());
    EXPECT_LE(tracker.scanned(), before + most);
  }
  EXPECT_GE(tracker.scanned(), nodes / 64);
  const auto all = range_of(log.head(), reader);
  ASSERT_TRUE(range && all);
  EXPECT_EQ(range->low, all->low);
  EXPECT_GT(range->high, 0.9 * all->high);
}

}  // namespace
}  // namespace replan::field_range_test
