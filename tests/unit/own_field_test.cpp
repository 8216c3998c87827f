// A planner's own values per node, declared and nothing else: the log, the debugger and exports know them.
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/debug/cell_history.hpp"
#include "core/debug/event_words.hpp"
#include "core/debug/probe.hpp"
#include "core/export/json_lines.hpp"

namespace replan::own_field_test {
namespace {

constexpr std::string_view kTags[] = {"new", "open", "closed"};
constexpr EventKind kTag = own_field(0), kLowest = own_field(1), kBack = own_field(2);

/// As Stentz's D* would declare it: a tag, the lowest cost since it is in the list, and a parent that outlives searches.
PlannerInfo info() {
  PlannerInfo result;
  result.id = "with-values-of-its-own";
  result.values.fields.push_back(
      {.kind = kTag, .name = "tag", .type = FieldType::name, .label = "tag", .names = kTags});
  result.values.fields.push_back({.kind = kLowest,
                                  .name = "lowest",
                                  .type = FieldType::cost,
                                  .label = "k",
                                  .initial = fields::kInfinite});
  result.values.fields.push_back(
      {.kind = kBack, .name = "back", .type = FieldType::node, .label = "back", .forgotten = false});
  return result;
}

class OwnFields : public ::testing::Test {
 protected:
  static std::uint64_t raw(Cost cost) { return static_cast<std::uint64_t>(cost.raw); }
  void change(EventKind kind, NodeId node, std::uint64_t before, std::uint64_t after) {
    const Event event{before ^ after, node, kind, 7, 0};
    log_.append({&event, 1});
  }
  void forget() {
    const Event event{0, 0, EventKind::epoch, 1, 0};
    log_.append({&event, 1});
  }
  [[nodiscard]] std::string words(std::size_t position) const { return event_text(view_, position); }
  /// Where the condition stops, looked for from the beginning.
  [[nodiscard]] std::vector<std::size_t> stops(const std::string& text) const {
    const auto condition = parse_condition(text, {5, 4}, info_.values.fields);
    EXPECT_TRUE(condition.ok()) << condition.error();
    if (!condition) return {};
    std::vector<std::size_t> found;
    Probe probe(view_, *condition, 0);
    while (const auto stop = probe.forwards(log_.size())) found.push_back(*stop);
    return found;
  }

  void SetUp() override {
    change(kTag, 3, 0, 1);
    change(kLowest, 3, fields::kInfinite, raw(Cost{Cost::kScale * 5 / 2}));
    change(kBack, 3, 0, 9);
    change(kTag, 3, 1, 2);
    forget();
    change(kTag, 3, 0, 1);
  }

  PlannerInfo info_ = info();
  Box box_{5, 4};
  Settings settings_;
  Timeline log_{SearchState(20, info_.values.fields)};
  LogView view_{log_, box_, info_, settings_};
};

TEST_F(OwnFields, AreWalkedOverInBothDirections) {
  const SearchState before = log_.state_at(4);
  EXPECT_EQ(before.value(kTag, 3), 2u);
  EXPECT_EQ(before.value(kLowest, 3), raw(Cost{Cost::kScale * 5 / 2}));
  EXPECT_EQ(before.value(kLowest, 4), fields::kInfinite);
  EXPECT_EQ(log_.state_at(0).hash(), SearchState(20, info_.values.fields).hash());
  log_.seek(6);
  log_.seek(2);
  EXPECT_EQ(log_.state().value(kTag, 3), 1u);
}

TEST_F(OwnFields, AreForgottenByAnEpochIfTheyAreDeclaredSo) {
  const SearchState after = log_.state_at(5);
  EXPECT_EQ(after.value(kTag, 3), 0u);
  EXPECT_EQ(after.value(kLowest, 3), fields::kInfinite);
  EXPECT_EQ(after.value(kBack, 3), 9u);
}

TEST_F(OwnFields, HaveAHistory) {
  CellHistory history;
  history.follow(log_, 1, 3, {kTag, kBack}, 100);
  ASSERT_EQ(history.size(), 5u);
  EXPECT_EQ(history[0].after, 1u);
  EXPECT_EQ(history[1].kind, kTag) << "the epoch";
  EXPECT_EQ(history[1].before, 2u);
  EXPECT_EQ(history[1].after, 0u);
  EXPECT_EQ(history[3].kind, kBack);
}

TEST_F(OwnFields, AreToldInWordsAndInTraces) {
  EXPECT_EQ(words(1), "tag(3, 0): new → open");
  EXPECT_EQ(words(2), "lowest(3, 0): ∞ → 2.500");
  EXPECT_EQ(words(3), "back(3, 0): none → (3, 1)");
  const TraceRun run{view_, "", {}, {}, {}};
  JsonLines lines(run);
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) lines.event(text, i, log_.event(i), log_.state_at(i));
  EXPECT_EQ(text,
            "{\"event\":0,\"line\":7,\"kind\":\"tag\",\"cell\":[3,0],\"before\":\"new\",\"after\":\"open\"}\n"
            "{\"event\":1,\"line\":7,\"kind\":\"lowest\",\"cell\":[3,0],\"before\":\"inf\",\"after\":2.5}\n"
            "{\"event\":2,\"line\":7,\"kind\":\"back\",\"cell\":[3,0],\"before\":null,\"after\":[3,1]}\n");
}

TEST_F(OwnFields, CanBeStoppedAt) {
  EXPECT_EQ(stops("tag(3, 0) == 2"), (std::vector<std::size_t>{4}));
  EXPECT_EQ(stops("lowest(3, 0) < 3"), (std::vector<std::size_t>{2}));
  EXPECT_EQ(stops("back(3, 0) == (3, 1)"), (std::vector<std::size_t>{3}));
  EXPECT_EQ(stops("changed(tag(3, 0))"), (std::vector<std::size_t>{1, 4, 5, 6}));
  EXPECT_EQ(expression_text(*parse_condition("changed( tag(3,0) )", {5, 4}, info_.values.fields)),
            "changed(tag(3, 0))");
  EXPECT_EQ(parse_condition("lowets(3, 0) == 2", {5, 4}, info_.values.fields).error(),
            "character 1: unknown name 'lowets'; did you mean 'lowest'?");
  EXPECT_EQ(parse_condition("tag == 2", {5, 4}, info_.values.fields).error(),
            "character 5: 'tag' needs a cell with whole-number coordinates: tag(x, y)");
}

TEST_F(OwnFields, OfAnotherPlannerAreUnset) {
  const auto condition =
      parse_quantity("other(3, 0)", {5, 4}, std::array{Field{.kind = kTag, .name = "other"}});
  ASSERT_TRUE(condition.ok()) << condition.error();
  Probe probe(view_, *condition, 4);
  EXPECT_EQ(probe.value().number, HUGE_VAL);
}

}  // namespace
}  // namespace replan::own_field_test
