// Where two runs of one world part: against lists made of their logs by the plainest means.
#include <gtest/gtest.h>

#include "core/debug/difference_search.hpp"
#include "core/session/run.hpp"

namespace replan::difference_test {
namespace {

/// One thing that is compared, and where the log says it.
struct Entry {
  std::string what, value;
  std::size_t what_at = 0, value_at = 0;
};

/// All of them, from a log that is walked through with its cursor.
std::vector<Entry> entries(Run& run, Compare what) {
  Timeline& log = run.timeline();
  std::vector<Entry> list;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const Event& event = log.event(i);
    log.seek(i + 1);
    const SearchState& state = log.state();
    if (what == Compare::moves && event.kind == EventKind::move)
      list.push_back({std::to_string(event.node), "", i + 1, i + 1});
    if (what == Compare::costs && event.kind == EventKind::plan_end) {
      const bool lookahead = run.info().values.lookahead();
      const Cost cost = lookahead ? state.rhs(state.node(Scalar::start)) : state.g(state.node(Scalar::goal));
      list.push_back(
          {std::to_string(event.delta), event.delta == 1 ? std::to_string(cost.raw) : "", i + 1, i + 1});
    }
    if (what == Compare::expansions && event.kind == EventKind::pop) {
      // The step goes on to the next one; what it expands, and the g that stays.
      std::size_t end = i + 1;
      while (end < log.size() && log.event(end).kind != EventKind::pop &&
             log.event(end).kind != EventKind::plan_end)
        ++end;
      for (std::size_t k = i; k < end; ++k) {
        if (log.event(k).kind != EventKind::visit) continue;
        std::size_t value_at = k + 1;
        for (std::size_t later = k; later < end; ++later)
          if (log.event(later).kind == EventKind::g && log.event(later).node == event.node)
            value_at = later + 1;
        log.seek(end);
        list.push_back(
            {std::to_string(event.node), std::to_string(log.state().g(event.node).raw), k + 1, value_at});
      }
    }
  }
  return list;
}

/// Two runs of a shipped world to their ends.
struct Pair {
  std::shared_ptr<Scenario> scenario;
  std::unique_ptr<Run> a, b;

  Pair(const std::string& world, PlannerChoice first, PlannerChoice second) {
    auto read = read_scenario(std::string(REPLAN_SOURCE_DIR "/maps/") + world);
    EXPECT_TRUE(read.ok());
    scenario = std::make_shared<Scenario>(std::move(*read));
    scenario->planners = {std::move(first), std::move(second)};
    a = std::make_unique<Run>(scenario, 0);
    b = std::make_unique<Run>(scenario, 1);
    a->finish(Target::end());
    b->finish(Target::end());
  }
  [[nodiscard]] std::optional<Difference> difference(Compare what) const {
    return first_difference(a->log_view(), b->log_view(), what);
  }
};

void expect_as_by_hand(const Pair& pair, Compare what) {
  const auto left = entries(*pair.a, what), right = entries(*pair.b, what);
  std::size_t i = 0;
  while (i < left.size() && i < right.size() && left[i].what == right[i].what &&
         left[i].value == right[i].value)
    ++i;
  const auto found = pair.difference(what);
  ASSERT_EQ(found.has_value(), i < left.size() || i < right.size());
  if (!found) return;
  const bool same_place = i < left.size() && i < right.size() && left[i].what == right[i].what;
  const auto place = [&](const std::vector<Entry>& list, const Run& run) {
    return i >= list.size() ? run.timeline().size() : same_place ? list[i].value_at : list[i].what_at;
  };
  EXPECT_EQ(found->positions[0], place(left, *pair.a)) << found->words;
  EXPECT_EQ(found->positions[1], place(right, *pair.b)) << found->words;
  const auto node = [&](const std::vector<Entry>& list) {
    return i >= list.size() || what == Compare::costs ? "none" : list[i].what;
  };
  const auto found_node = [&](std::size_t side) {
    return found->nodes[side] == kNoNode ? "none" : std::to_string(found->nodes[side]);
  };
  EXPECT_EQ(found_node(0), node(left));
  EXPECT_EQ(found_node(1), node(right));
  EXPECT_NE(found->words.find(what == Compare::costs ? "plan" : std::to_string(i + 1)), std::string::npos)
      << found->words;
}

TEST(FirstDifference, IsWhereListsOfBothLogsPart) {
  const PlannerChoice pairs[][2] = {{{"dstar-lite", {}}, {"dld-star-lite", {}}},
                                    {{"dstar-lite", {}}, {"dist-dstar-lite", {}}},
                                    {{"los-dstar-lite", {}}, {"dstar-lite", {}}},
                                    {{"astar", {}}, {"dijkstra", {}}},
                                    {{"astar", {}}, {"dstar-lite", {}}}};
  for (const char* world : {"demo.json", "closing-door.json"})
    for (const auto& [first, second] : pairs) {
      const Pair pair(world, first, second);
      for (const Compare what : {Compare::expansions, Compare::costs, Compare::moves}) {
        SCOPED_TRACE(std::string(world) + ": " + first.id + " and " + second.id + ", " +
                     std::to_string(static_cast<int>(what)));
        expect_as_by_hand(pair, what);
      }
    }
}

TEST(FirstDifference, OfAPlannerAndItselfThereIsNone) {
  for (const PlannerInfo& info : planners()) {
    const Pair pair("demo.json", {std::string(info.id), {}}, {std::string(info.id), {}});
    for (const Compare what : {Compare::events, Compare::expansions, Compare::costs, Compare::moves})
      EXPECT_FALSE(pair.difference(what)) << info.id << ": " << pair.difference(what)->words;
  }
}

TEST(FirstDifference, IsFoundAfterManyReplansToo) {
  // Alike until the mistake shows, which is after the first plan.
  Settings mistake;
  mistake.set("fault", 1);
  const Pair pair("demo.json", {"dstar-lite", {}}, {"broken-dstar-lite", mistake});
  for (const Compare what : {Compare::events, Compare::expansions}) {
    const auto found = pair.difference(what);
    ASSERT_TRUE(found);
    EXPECT_GT(found->positions[0], pair.a->decisions().front().event) << found->words;
    // Until just before it the logs are the same, event for event.
    for (std::size_t i = 0; what == Compare::events && i + 1 < found->positions[0]; ++i)
      ASSERT_EQ(pair.a->timeline().event(i), pair.b->timeline().event(i));
  }
}

TEST(FirstDifference, OfEventsSaysBothInWords) {
  const Pair pair("demo.json", {"dstar-lite", {}}, {"dist-dstar-lite", {}});
  const auto found = pair.difference(Compare::events);
  ASSERT_TRUE(found);
  for (const std::size_t i : {0u, 1u}) {
    const replan::Run& run = i == 0 ? *pair.a : *pair.b;
    EXPECT_NE(found->words.find(run.info().name), std::string::npos) << found->words;
  }
}

TEST(FirstDifference, WaitsForALogThatGrowsAndComesToTheSame) {
  const Pair pair("demo.json", {"astar", {}}, {"astar", {}});
  const LogView whole = pair.a->log_view();
  Timeline growing(pair.b->timeline().state_at(0));
  const LogView partly{growing, whole.lattice, whole.info, whole.settings};
  DifferenceSearch search(whole, partly, Compare::expansions);
  using enum DifferenceSearch::Outcome;
  for (std::size_t i = 0; i < whole.log.size(); i += 500) {
    auto outcome = search.advance(100, {true, false});
    while (outcome == more) outcome = search.advance(100, {true, false});
    ASSERT_EQ(outcome, waits) << i;
    std::vector<Event> next;
    for (std::size_t k = i; k < std::min(i + 500, whole.log.size()); ++k) next.push_back(whole.log.event(k));
    growing.append(next);
  }
  auto outcome = search.advance(100, {true, true});
  while (outcome == more) outcome = search.advance(100, {true, true});
  EXPECT_EQ(outcome, alike);
  EXPECT_EQ(search.alike(), std::to_string(entries(*pair.a, Compare::expansions).size()) + " expansions");
}

TEST(FirstDifference, SaysWhichPaneChecksSightInTheSearchAndWhichAlongThePath) {
  PlannerChoice search{"dld-star-lite", {}}, path = search;
  path.settings.set("sight_checks", 1);
  const Pair pair("demo.json", search, path);
  EXPECT_FALSE(pair.difference(Compare::expansions).has_value()) << "the search does not depend on sight";
  EXPECT_FALSE(pair.difference(Compare::costs).has_value());
  const auto found = pair.difference(Compare::events);
  ASSERT_TRUE(found.has_value());
  EXPECT_NE(found->words.find("DLD* Lite (sight checked in the search)"), std::string::npos) << found->words;
  EXPECT_NE(found->words.find("DLD* Lite (sight checked along the path)"), std::string::npos) << found->words;
}

}  // namespace
}  // namespace replan::difference_test
