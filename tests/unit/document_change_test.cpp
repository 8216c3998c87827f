// What an edit did to a scenario leads back and forth between its two versions, whatever the edit was.
#include "core/session/document_change.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::document_change_test {
namespace {

Cell some_cell(Random& random, const Scenario& scenario) {
  return {random.between(0, scenario.map.width - 1), random.between(0, scenario.map.height - 1)};
}

Surprise some_surprise(Random& random, const Scenario& scenario) {
  Surprise surprise;
  surprise.at.move = random.between(0, 5);
  for (int n = random.between(1, 4); n > 0; --n)
    surprise.cells.push_back({some_cell(random, scenario), random.chance(0.5)});
  return surprise;
}

/// Another version: a stroke on the map, surprises at the end of the list or in its middle, something else.
/// Another map only if `may_replace_map`.
Scenario edited(Random& random, Scenario scenario, bool may_replace_map) {
  switch (random.below(may_replace_map ? 6 : 5)) {
    case 0:
      for (int n = random.between(1, 9); n > 0; --n)
        scenario.map.set(some_cell(random, scenario), random.chance(0.5));
      break;
    case 1:
      for (int n = random.between(1, 40); n > 0; --n)
        scenario.surprises.push_back(some_surprise(random, scenario));
      break;
    case 2:
      scenario.surprises.truncate(random.below(static_cast<std::uint32_t>(scenario.surprises.size()) + 1));
      break;
    case 3:
      if (!scenario.surprises.empty())
        scenario.surprises.erase(random.below(static_cast<std::uint32_t>(scenario.surprises.size())));
      scenario.surprises.push_back(some_surprise(random, scenario));
      break;
    case 4:
      scenario.goal = some_cell(random, scenario);
      break;
    default:
      scenario.map = GridMap(random.between(1, 30), random.between(1, 30));
      for (int n = 0; n < 200; ++n) scenario.map.set(some_cell(random, scenario), true);
  }
  return scenario;
}

Scenario first_version() {
  Scenario scenario;
  scenario.map = GridMap(40, 30);
  scenario.planners = {{"dstar-lite", {}}};
  return scenario;
}

void expect_leads_both_ways(const DocumentChange& change, const Scenario& before, const Scenario& after) {
  Scenario scenario = after;
  take_back(change, scenario);
  ASSERT_EQ(scenario, before);
  make_again(change, scenario);
  ASSERT_EQ(scenario, after);
}

TEST(DocumentChange, LeadsBackAndForth) {
  Random random(1);
  Scenario scenario = first_version();
  for (int i = 0; i < 2000; ++i) {
    Scenario next = edited(random, scenario, true);
    expect_leads_both_ways(change_between(scenario, next), scenario, next);
    scenario = std::move(next);
  }
}

TEST(DocumentChange, SeveralInARowBecomeOne) {
  Random random(2);
  Scenario scenario = first_version();
  for (int i = 0; i < 500; ++i) {
    const Scenario first = scenario;
    DocumentChange whole;
    for (int n = 0; n < 6; ++n) {
      Scenario next = edited(random, scenario, false);
      DocumentChange change = change_between(scenario, next);
      if (n == 0)
        whole = std::move(change);
      else
        append(whole, std::move(change));
      scenario = std::move(next);
    }
    expect_leads_both_ways(whole, first, scenario);
  }
}

TEST(DocumentChange, TakesMemoryForWhatDiffersAlone) {
  Scenario before = first_version();
  before.map = GridMap(2000, 2000);
  for (int i = 0; i < 1000; ++i) before.surprises.push_back({});
  Scenario after = before;
  after.map.set({5, 5}, true);
  after.surprises.push_back({});
  const DocumentChange change = change_between(before, after);
  EXPECT_EQ(change.cells.size(), 1u);
  EXPECT_FALSE(change.replaces_map());
  EXPECT_TRUE(change.surprises_before.empty());
  EXPECT_EQ(change.surprises_after.size(), 1u);
  EXPECT_EQ(change.rest_before, nullptr);
}

}  // namespace
}  // namespace replan::document_change_test
