// Events in words.
#include "core/debug/event_words.hpp"

#include <gtest/gtest.h>

namespace replan::test::event_words_test {
namespace {

constexpr std::uint64_t raw(std::int64_t cells) {
  return static_cast<std::uint64_t>(Cost::cells(cells).raw);
}

TEST(EventWords, tellWhatEachKindOfEventDid) {
  const Box lattice(10, 8);
  const auto text = [&](EventKind kind, NodeId node, std::uint64_t delta, std::uint64_t after = 0) {
    return event_text(lattice, lookahead_values(), {delta, node, kind, 0, 0}, after);
  };
  const NodeId at = lattice.node(Cell{3, 2});
  const auto infinite = static_cast<std::uint64_t>(Cost::kInfinityRaw);
  EXPECT_EQ(text(EventKind::rhs, at, infinite ^ raw(4), raw(4)), "rhs(3, 2): ∞ → 4.000");
  EXPECT_EQ(text(EventKind::queue, at, raw(4) + 1, raw(4) + 1), "k1(3, 2): not in U → 4.000");
  EXPECT_EQ(text(EventKind::lp, at, at + 2, 0), "lp(3, 2): (4, 2) → none");
  EXPECT_EQ(text(EventKind::known, at, 1, 1), "the robot's map(3, 2): free → obstacle");
  EXPECT_EQ(text(EventKind::scalar, 0, raw(2), raw(2)), "km = 2.000");
  EXPECT_EQ(text(EventKind::scalar, static_cast<NodeId>(Scalar::robot), at + 1, at + 1),
            "the robot = (3, 2)");
  EXPECT_EQ(text(EventKind::scalar, static_cast<NodeId>(Scalar::moves), 7, 7), "moves = 7");
  EXPECT_EQ(text(EventKind::pop, at, 0), "took (3, 2) from the open list");
  EXPECT_EQ(text(EventKind::sight, at, std::uint64_t{at + 1u} | std::uint64_t{1} << 32),
            "(3, 2) sees (4, 2)");
}

TEST(EventWords, tellAnyPositionOfALog) {
  Timeline log{SearchState(80)};
  log.append(
      std::vector<Event>{{raw(3) ^ static_cast<std::uint64_t>(Cost::kInfinityRaw), 5, EventKind::g, 49, 0},
                         {0, 6, EventKind::pop, 44, 0},
                         {raw(3) ^ raw(1), 5, EventKind::g, 49, 0}});
  const Box lattice(10, 8);
  const Settings settings;
  const LogView view{log, lattice, planners().front(), settings};
  EXPECT_EQ(event_text(view, 0), "");
  EXPECT_EQ(event_text(view, 1), "g(5, 0): ∞ → 3.000");
  EXPECT_EQ(event_text(view, 2), "took (6, 0) from the open list");
  EXPECT_EQ(event_text(view, 3), "g(5, 0): 3.000 → 1.000");
  log.seek(3);
  EXPECT_EQ(event_text(view, 1), "g(5, 0): ∞ → 3.000");
  EXPECT_EQ(event_text(view, 3), "g(5, 0): 3.000 → 1.000");
}

TEST(EventWords, nameLinesAsThePageDoes) {
  const auto page = parse_page(
      "# P\n\n## Pseudo-code\n\n```pseudo 100 Algorithm 1: main\n 1: a\n12: b\n```\n\n```pseudo 0 Algorithm "
      "2: "
      "helpers\n 1: c\n```\n",
      "p.md", "/nowhere");
  ASSERT_TRUE(page.ok()) << page.error();
  EXPECT_EQ(line_name(*page, 112), "line 112 of Algorithm 1: main");
  EXPECT_EQ(line_name(*page, 1), "line 1 of Algorithm 2: helpers");
  EXPECT_EQ(line_name(*page, 77), "line 77");
}

}  // namespace
}  // namespace replan::test::event_words_test
