#include "core/trace/packed_events.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/session/run.hpp"
#include "core/world/scenario.hpp"

namespace replan::packed_events_test {
namespace {

std::vector<Event> there_and_back(const std::vector<Event>& events) {
  const PackedEvents packed(events);
  EXPECT_EQ(packed.count(), events.size());
  EXPECT_EQ(packed.empty(), events.empty());
  std::vector<Event> back(3);  // with something in it
  packed.unpack(back);
  std::vector<Event> by_stretches, stretch;
  for (std::size_t i = 0; i * PackedEvents::kStretch < events.size(); ++i) {
    packed.unpack_stretch(i, stretch);
    by_stretches.insert(by_stretches.end(), stretch.begin(), stretch.end());
  }
  EXPECT_EQ(by_stretches, back);
  return back;
}

TEST(PackedEvents, OfNothingAreNothing) {
  EXPECT_TRUE(there_and_back({}).empty());
  EXPECT_EQ(PackedEvents().bytes(), 0u);
}

TEST(PackedEvents, ComeBackWhateverTheyAre) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    std::vector<Event> events(random.below(3 * PackedEvents::kStretch));
    // From a planner of few lines and small numbers to events of all kinds and lines with any bits.
    const std::uint32_t kinds = 1 + random.below(63), lines = 1 + random.below(256),
                        nodes = 1 + random.below(9000);
    for (Event& event : events) {
      event.kind = static_cast<EventKind>(random.below(kinds));
      event.line = static_cast<std::uint8_t>(random.below(lines));
      event.node = random.chance(0.01) ? kNoNode : random.below(nodes);
      event.delta = random.next() >> random.below(64);
      if (random.chance(0.3) && &event != events.data()) event.delta = (&event - 1)->delta;
    }
    ASSERT_EQ(there_and_back(events), events) << "seed " << seed;
  }
}

TEST(PackedEvents, OfShippedWorldsTakeLessThanHalf) {
  for (const char* name : {"demo", "office", "everything-at-once", "decks"}) {
    Result<Scenario> read = read_scenario(std::string(REPLAN_SOURCE_DIR "/maps/") + name + ".json");
    ASSERT_TRUE(read.ok()) << name;
    const auto scenario = std::make_shared<const Scenario>(std::move(read.value()));
    for (std::size_t planner = 0; planner < scenario->planners.size(); ++planner) {
      replan::Run run(scenario, planner);  // not the test's own
      run.finish(Target::end());
      std::vector<Event> events(run.timeline().size());
      for (std::size_t i = 0; i < events.size(); ++i) events[i] = run.timeline().event(i);
      ASSERT_EQ(there_and_back(events), events) << name;
      EXPECT_LT(PackedEvents(events).bytes() * 2, events.size() * sizeof(Event))
          << name << ", " << scenario->planners[planner].id;
    }
  }
}

}  // namespace
}  // namespace replan::packed_events_test
