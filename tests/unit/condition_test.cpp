// The condition language: what it reads, what it says of mistakes, and what it means on small logs.
#include "core/debug/condition.hpp"

#include <set>

#include <gtest/gtest.h>

#include "core/debug/probe.hpp"

namespace replan::test::condition_test {
namespace {

const Box kWorld{20, 10};

std::string error_of(const std::string& text) {
  const auto read = parse_condition(text, kWorld);
  EXPECT_FALSE(read.ok()) << text;
  return read.ok() ? "" : read.error();
}

std::string spelt(const std::string& text) {
  const auto read = parse_expression(text, kWorld);
  EXPECT_TRUE(read.ok()) << text << ": " << read.error();
  return read.ok() ? expression_text(*read) : "";
}

TEST(ConditionLanguage, spellsWhatItReadInOneWay) {
  EXPECT_EQ(spelt("g( 12,4 )>30||km>5&&size(U)>=100"), "g(12, 4) > 30 || km > 5 && size(U) >= 100");
  EXPECT_EQ(spelt("(km > 5 || km < 1) && true"), "(km > 5 || km < 1) && true");
  EXPECT_EQ(spelt("((km)) - (moves - 1)"), "km - (moves - 1)");
  EXPECT_EQ(spelt("(km - moves) - 1"), "km - moves - 1");
  EXPECT_EQ(spelt("-(km + 1) * --2"), "-(km + 1) * --2");
  EXPECT_EQ(spelt("!(km>5)&&!queued(1,2)"), "!(km > 5) && !queued(1, 2)");
  EXPECT_EQ(spelt("lp(1,2) == (3 , 4)"), "lp(1, 2) == (3, 4)");
  EXPECT_EQ(spelt("rp(1,2) != none"), "rp(1, 2) != none");
  EXPECT_EQ(spelt("taken || taken(3,4)"), "taken || taken(3, 4)");
  EXPECT_EQ(spelt("line(48) || line == 48"), "line(48) || line == 48");
  EXPECT_EQ(spelt("changed( g(1,2) ) || event( replan )"), "changed(g(1, 2)) || event(replan)");
  EXPECT_EQ(spelt("score( winner )<0.20||admissible==0"), "score(winner) < 0.2 || admissible == 0");
  EXPECT_EQ(spelt("changed(sub_goal) || sub_goal == (3,4)"), "changed(sub_goal) || sub_goal == (3, 4)");
  EXPECT_EQ(spelt("0.50 + 1e3 + inf"), "0.5 + 1000 + inf");
  EXPECT_EQ(spelt("(km > 1) == (km > 2)"), "km > 1 == km > 2");
}

TEST(ConditionLanguage, namesCellsByThreeCoordinatesInSpace) {
  const Box box(20, 10, 3);
  for (const char* text :
       {"g(12, 4, 2) > 30", "taken(0, 0, 0) || robot == (3, 4, 1)", "changed(lp(1, 2, 0))"}) {
    const auto read = parse_condition(text, box);
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(expression_text(*read), text);
  }
  const auto error = [&](const char* text) { return parse_condition(text, box).error(); };
  EXPECT_EQ(error("g > 3"), "character 1: 'g' needs a cell: g(x, y, z)");
  EXPECT_EQ(error("g(12, 4) > 3"), "character 2: 'g' needs a cell with whole-number coordinates: g(x, y, z)");
  EXPECT_EQ(error("robot == (3, 4)"), "character 10: a cell needs three whole numbers: (x, y, z)");
  EXPECT_EQ(
      error("robot == (3, 4, 3)"),
      "character 10: (3, 4, 3) is outside the world: x goes from 0 to 19, y from 0 to 9, z from 0 to 2");
  EXPECT_EQ(error("changed(3)"),
            "character 9: 'changed' needs a value of the search: changed(g(x, y, z)), changed(km)");
  EXPECT_EQ(parse_condition("g(1, 2, 0) > 3", kWorld).error(),
            "character 2: 'g' needs a cell with whole-number coordinates: g(x, y)");
}

TEST(ConditionLanguage, pointsAtWhatIsWrongAndSaysTheMend) {
  const std::pair<const char*, const char*> kMistakes[] = {
      {"", "character 1: an expression is missing: for example km > 5"},
      {"rsh(1, 2) > 3", "character 1: unknown name 'rsh'; did you mean 'rhs'?"},
      {"km > 5 && g > 30", "character 11: 'g' needs a cell: g(x, y)"},
      {"g(1) > 30", "character 2: 'g' needs a cell with whole-number coordinates: g(x, y)"},
      {"g(1.5, 2) > 30", "character 2: 'g' needs a cell with whole-number coordinates: g(x, y)"},
      {"g(20, 4) > 1", "character 2: (20, 4) is outside the world: x goes from 0 to 19, y from 0 to 9"},
      {"robot == (3, -1)", "character 10: (3, -1) is outside the world: x goes from 0 to 19, y from 0 to 9"},
      {"km && true",
       "character 1: '&&' needs a truth on its left, this is a number: compare it, as in km > 5"},
      {"true && robot", "character 9: '&&' needs a truth on its right, this is a cell"},
      {"robot > 3", "character 1: '>' needs a number on its left, this is a cell"},
      {"robot == 3", "character 7: '==' compares two of a kind: left of it is a cell, right of it a number"},
      {"!km > 5",
       "character 1: '!' needs a truth, this is a number: put what is denied in parentheses, as in !(km > "
       "5)"},
      {"-robot == 3", "character 1: '-' needs a number, this is a cell"},
      {"km = 5", "character 4: write '==' to compare"},
      {"taken & km > 5", "character 7: write '&&' for 'and'"},
      {"taken or km > 5", "character 7: write '||' for 'or'"},
      {"not taken", "character 1: a value is missing; 'not' is written '!'"},
      {"(km > 5", "character 1: this '(' is not closed: a ')' is missing"},
      {"km > 5)", "character 7: this ')' closes nothing"},
      {"km > ", "character 6: the expression ends too soon: a value is missing"},
      {"km > 5 7",
       "character 8: '7' is not expected here: an operator such as && or > is missing, or the end"},
      {"km", "character 1: a breakpoint needs a truth, this is a number: compare it, as in km > 5"},
      {"km(3, 4) > 5", "character 3: 'km' takes nothing in parentheses"},
      {"size(V) > 5", "character 1: 'size' is told of the open list only: size(U)"},
      {"score(loser) > 1", "character 1: 'score' is told of the arc that was chosen only: score(winner)"},
      {"score < 0.2", "character 1: 'score' needs what it is about: score(winner)"},
      {"size > 5", "character 1: 'size' needs what it is about: size(U)"},
      {"line(x)", "character 1: 'line' needs the number of a pseudo-code line: line(48)"},
      {"line(300)", "character 1: 'line' needs the number of a pseudo-code line: line(48)"},
      {"changed(3)", "character 9: 'changed' needs a value of the search: changed(g(x, y)), changed(km)"},
      {"changed(taken)", "character 9: 'changed' needs a value of the search: changed(g(x, y)), changed(km)"},
      {"event(repln)", "character 7: unknown event; did you mean 'replan'?"},
      {"event(xyzxyzxyz)",
       "character 7: 'event' needs a name: plan, replan, underconsistent, sight_failed, first_path, rewired, "
       "no_path, blocked, surprise, move, arrival, invariant, oracle"},
      {"1e999 > km", "character 1: this is no number that can be held: write for example 2.5"},
      {"3x > km", "character 1: a number goes on in letters here: write for example 2.5"},
      {"km > é", "character 6: 'é' is not expected here: a value such as km is missing"},
      {"é", "character 1: 'é' is not expected here: a value such as km is missing"},
      {"true == é", "character 9: 'é' is not expected here: a value such as km is missing"},
  };
  for (const auto& [text, error] : kMistakes) EXPECT_EQ(error_of(text), error) << text;
  EXPECT_EQ(parse_quantity("km > 5", kWorld).error(),
            "character 1: a watch needs a number, this is a truth: name a value, as in km or size(U)");
}

TEST(ConditionLanguage, hasLimits) {
  const auto repeated = [](int count, const std::string& part, const std::string& last) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text + last;
  };
  EXPECT_TRUE(parse_condition(repeated(60, "!", "true"), kWorld).ok());
  EXPECT_EQ(error_of(repeated(70, "!", "true")), "character 65: nested too deeply: at most 64 levels");
  EXPECT_EQ(error_of(repeated(100000, "(", "")), "the expression is too long: at most 16384 characters");
  EXPECT_EQ(error_of(repeated(9000, "(", "")), "character 65: nested too deeply: at most 64 levels");
  EXPECT_TRUE(parse_condition(repeated(99, "true||", "true"), kWorld).ok());
  EXPECT_NE(error_of(repeated(100, "true||", "true")).find("at most 200 terms"), std::string::npos);
}

TEST(ConditionLanguage, everyNameReadsAsItsHelpShowsIt) {
  for (const ConditionName& name : condition_names()) {
    std::string form(name.form);
    for (const auto& [place, example] : {std::pair{"(x, y)", "(3, 4)"},
                                         {"(n)", "(48)"},
                                         {"(v)", "(17)"},
                                         {"(value)", "(km)"},
                                         {"(name)", "(replan)"}})
      if (const std::size_t at = form.find(place); at != std::string::npos)
        form.replace(at, std::string(place).size(), example);
    const auto read = parse_expression(form, kWorld);
    ASSERT_TRUE(read.ok()) << form << ": " << read.error();
    EXPECT_EQ(read->root().op, name.op) << form;
    EXPECT_EQ(read->root().type, name.type) << form;
    EXPECT_TRUE(name.help.ends_with('.') || name.help.ends_with(')')) << name.help;
  }
  for (const HappeningName& each : happening_names()) {
    const auto read = parse_condition("event(" + std::string(each.name) + ")", kWorld);
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(read->root().happening, each.happening);
    EXPECT_EQ(expression_text(*read), "event(" + std::string(each.name) + ")");
  }
}

/// A log written by hand on the world of 20 x 10.
struct SmallLog {
  Box lattice = kWorld;
  Settings settings;
  Timeline log{SearchState(kWorld.node_count())};
  Recorder recorder;

  LogView view() {
    log.append(recorder.take());
    return {log, lattice, *find_planner("dstar-lite"), settings};
  }
  NodeId at(int x, int y) const { return lattice.node(Cell{x, y}); }
  std::vector<std::size_t> stops(const std::string& text, Verdicts verdicts = {}) {
    const auto condition = parse_condition(text, kWorld);
    EXPECT_TRUE(condition.ok()) << text << ": " << condition.error();
    Probe probe(view(), *condition, 0, verdicts);
    std::vector<std::size_t> found;
    while (const auto stop = probe.forwards(log.size())) found.push_back(*stop);
    return found;
  }
};
using Positions = std::vector<std::size_t>;

TEST(ConditionMeaning, aTruthStopsWhereItBeginsToHold) {
  SmallLog small;
  const NodeId v = small.at(3, 4);
  small.recorder.line(10);
  small.recorder.change(EventKind::g, v, Cost::infinity(), Cost::cells(5));  // position 1
  small.recorder.change(EventKind::g, small.at(0, 0), Cost::infinity(), Cost::cells(50));
  small.recorder.change(EventKind::g, v, Cost::cells(5), Cost::cells(7));  // 3
  small.recorder.line(11);
  small.recorder.change(EventKind::g, v, Cost::cells(7), Cost::infinity());  // 4
  small.recorder.change(EventKind::g, v, Cost::infinity(), Cost::cells(6));  // 5
  EXPECT_EQ(small.stops("g(3, 4) < 10"), (Positions{1, 5}));
  EXPECT_EQ(small.stops("g(3, 4) > 6"), (Positions{3})) << "it holds before the first event too: infinite";
  EXPECT_EQ(small.stops("g(3, 4) == inf"), (Positions{4}));
  EXPECT_EQ(small.stops("changed(g(3, 4))"), (Positions{1, 3, 4, 5}));
  EXPECT_EQ(small.stops("line(11)"), (Positions{4}));
  EXPECT_EQ(small.stops("line == 10 && g(0, 0) < inf"), (Positions{2}));
  EXPECT_EQ(small.stops("true"), Positions{});
}

TEST(ConditionMeaning, anEventStopsEachTimeThoughItComesInARow) {
  SmallLog small;
  const NodeId v = small.at(3, 4), w = small.at(5, 5);
  small.recorder.note(EventKind::plan_begin, v, 0);  // 1
  small.recorder.note(EventKind::pop, v);            // 2
  small.recorder.note(EventKind::pop, w);            // 3
  small.recorder.note(EventKind::pop, v);            // 4
  small.recorder.note(EventKind::plan_begin, v, 1);  // 5
  small.recorder.note(EventKind::sight, v, std::uint64_t{w} | std::uint64_t{1} << 32);
  small.recorder.note(EventKind::sight, v, w);                                                 // 7
  small.recorder.note(EventKind::plan_end, v, static_cast<std::uint64_t>(PlanStatus::found));  // 8
  small.recorder.note(EventKind::plan_end, v, static_cast<std::uint64_t>(PlanStatus::no_path));
  EXPECT_EQ(small.stops("taken"), (Positions{2, 3, 4}));
  EXPECT_EQ(small.stops("taken(3, 4)"), (Positions{2, 4}));
  EXPECT_EQ(small.stops("!taken"), (Positions{5})) << "it holds before the first event too";
  EXPECT_EQ(small.stops("event(plan)"), (Positions{1}));
  EXPECT_EQ(small.stops("event(replan)"), (Positions{5}));
  EXPECT_EQ(small.stops("event(sight_failed)"), (Positions{7}));
  EXPECT_EQ(small.stops("event(no_path)"), (Positions{9}));
  const std::size_t breaches[] = {2, 6};
  EXPECT_EQ(small.stops("event(invariant)", {breaches, {}}), (Positions{2, 6}));
  EXPECT_EQ(small.stops("event(oracle)", {breaches, {}}), Positions{});
}

TEST(ConditionMeaning, theOpenListAndItsKeys) {
  SmallLog small;
  const NodeId v = small.at(3, 4), w = small.at(5, 5);
  const auto in = [](int cells) { return static_cast<std::uint64_t>(Cost::cells(cells).raw) + 1; };
  small.recorder.change(EventKind::queue, v, 0, in(3));      // 1
  small.recorder.change(EventKind::queue, w, 0, in(4));      // 2
  small.recorder.change(EventKind::queue, v, in(3), in(9));  // 3: another key, the same size
  small.recorder.change(EventKind::queue, w, in(4), 0);      // 4
  EXPECT_EQ(small.stops("size(U) == 2"), (Positions{2}));
  EXPECT_EQ(small.stops("size(U) < 2"), (Positions{4}));
  EXPECT_EQ(small.stops("changed(size(U))"), (Positions{1, 2, 4}));
  EXPECT_EQ(small.stops("k1(3, 4) == 9"), (Positions{3}));
  EXPECT_EQ(small.stops("k1(5, 5) == inf"), (Positions{4}));
  EXPECT_EQ(small.stops("queued(3, 4)"), (Positions{1}));
}

TEST(ConditionMeaning, costsAreComparedWithOneAnotherExactly) {
  SmallLog small;
  const NodeId v = small.at(3, 4);
  // They differ in a unit that a double of this size does not hold.
  const Cost large{(Cost::kInfinityRaw >> 1) + 1}, same_double{Cost::kInfinityRaw >> 1};
  small.recorder.change(EventKind::g, v, Cost::infinity(), large);          // 1
  small.recorder.change(EventKind::rhs, v, Cost::infinity(), same_double);  // 2
  small.recorder.change(EventKind::rhs, v, same_double, large);             // 3
  ASSERT_EQ(large.to_double(), same_double.to_double());
  EXPECT_EQ(small.stops("g(3, 4) == rhs(3, 4)"), (Positions{3}));
  EXPECT_EQ(small.stops("rhs(3, 4) < g(3, 4)"), (Positions{2}));
  EXPECT_EQ(small.stops("consistent(3, 4)"), (Positions{3}));
}

TEST(ConditionMeaning, whatAFreshPlanWipesIsNoExpansion) {
  SmallLog small;
  const NodeId v = small.at(3, 4), w = small.at(5, 5);
  const auto visit = [](std::uint64_t times, std::uint64_t number) { return times << 32 | number; };
  small.recorder.note(EventKind::plan_begin, v, 0);
  small.recorder.note(EventKind::pop, v);
  small.recorder.change(EventKind::visit, v, 0, visit(1, 1));  // 3
  small.recorder.note(EventKind::pop, w);
  small.recorder.change(EventKind::visit, w, 0, visit(1, 2));  // 5
  small.recorder.note(EventKind::plan_begin, v, 1);
  small.recorder.note(EventKind::epoch, v);
  small.recorder.note(EventKind::pop, w);
  small.recorder.change(EventKind::visit, w, 0, visit(1, 1));  // 9
  EXPECT_EQ(small.stops("changed(expansions)"), (Positions{3, 5, 9}));
  EXPECT_EQ(small.stops("expansions == 3"), (Positions{9}));
  EXPECT_EQ(small.stops("order(5, 5) == 1"), (Positions{9}));
  EXPECT_EQ(small.stops("order(5, 5) == 0"), (Positions{7}));  // what the epoch forgot
}

TEST(ConditionMeaning, itsValuesAreToldInWords) {
  SmallLog small;
  small.recorder.change(EventKind::g, small.at(3, 4), Cost::infinity(), Cost{Cost::cells(63).raw / 2});
  const auto condition =
      parse_condition("g(3, 4) > 30 && (rhs(3, 4) == g(3, 4) || size(U) > 3 || lp(3, 4) == none)", kWorld);
  ASSERT_TRUE(condition.ok()) << condition.error();
  Probe probe(small.view(), *condition, 1);
  EXPECT_EQ(values_text(probe, small.lattice),
            "g(3, 4) is 31.500, rhs(3, 4) is ∞, size(U) is 0, lp(3, 4) is none");
}

}  // namespace
}  // namespace replan::test::condition_test
