// The table of a batch: order, filters, and what each planner comes to.
#include "ui/batch/batch_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/base/statistics.hpp"

namespace replan::ui::batch_table_test {
namespace {

RunResult result(std::int64_t run, const std::string& planner, std::optional<double> length) {
  RunResult made;
  made.run = run;
  made.name.world = "worlds/hall.json";
  made.name.planner = planner;
  made.succeeded = length.has_value();
  made.status = length ? "arrived" : "no-path";
  made.plan_ms = {1, 3, 2};
  made.replan_ms = {0, 0, 0};
  for (const ResultColumn& column : result_columns())
    made.figures.push_back(column.name == "length_cells" ? length : std::nullopt);
  return made;
}

std::vector<RunResult> many(std::size_t count) {
  Random random(7);
  std::vector<RunResult> results;
  for (std::size_t i = 0; i < count; ++i)
    results.push_back(result(static_cast<std::int64_t>(i),
                             i % 3 == 0   ? "astar"
                             : i % 3 == 1 ? "jps"
                                          : "rrt",
                             i % 5 == 4 ? std::nullopt : std::optional<double>(random.below(50))));
  // As several jobs bring them: not in the order of their numbers.
  for (std::size_t i = count; i > 1; --i)
    std::swap(results[i - 1], results[random.below(static_cast<std::uint32_t>(i))]);
  return results;
}

std::vector<std::int64_t> runs_of(const BatchTable& table) {
  std::vector<std::int64_t> runs;
  for (std::size_t i = 0; i < table.shown(); ++i) runs.push_back(table.row(i).run);
  return runs;
}

TEST(BatchTable, IsInTheOrderOfItsNumbersAtFirst) {
  BatchTable table;
  table.add(many(60));
  ASSERT_EQ(table.shown(), 60u);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(table.row(i).run, static_cast<std::int64_t>(i));
}

TEST(BatchTable, HeadingsSayInWhichUnitsTheirNumbersAre) {
  EXPECT_EQ(batch_heading(BatchColumn::length), "length  cells");
  EXPECT_EQ(batch_heading(BatchColumn::clearance), "clearance  cells");
  EXPECT_EQ(batch_heading(BatchColumn::time), "time  ms");
  EXPECT_EQ(batch_heading(BatchColumn::expansions), "expansions");
}

TEST(BatchTable, SortsEitherWayWithWhatHasNoValueLast) {
  BatchTable table;
  table.add(many(60));
  for (const bool descending : {false, true}) {
    table.sort_by(BatchColumn::length);
    EXPECT_EQ(table.descending(), descending);
    for (std::size_t i = 1; i < table.shown(); ++i) {
      const auto before = table.row(i - 1).number(BatchColumn::length),
                 here = table.row(i).number(BatchColumn::length);
      if (!here) continue;
      ASSERT_TRUE(before) << "a run without a length stands before one with it";
      EXPECT_TRUE(descending ? *before >= *here : *before <= *here);
      if (*before == *here) {
        EXPECT_LT(table.row(i - 1).run, table.row(i).run);
      }
    }
    EXPECT_FALSE(table.row(table.shown() - 1).number(BatchColumn::length));
  }
}

TEST(BatchTable, ComesToTheSameOrderWhetherResultsComeAtOnceOrOneByOne) {
  const std::vector<RunResult> results = many(200);
  for (const BatchColumn column :
       {BatchColumn::run, BatchColumn::planner, BatchColumn::length, BatchColumn::time}) {
    BatchTable at_once, one_by_one;
    one_by_one.sort_by(BatchColumn::seed);
    one_by_one.sort_by(column);
    for (const RunResult& each : results) one_by_one.add({each});
    at_once.add(results);
    at_once.sort_by(BatchColumn::seed);
    at_once.sort_by(column);
    EXPECT_EQ(runs_of(at_once), runs_of(one_by_one)) << info_of(column).name;
  }
}

/// Worlds and planners that come late, in whatever order, have the places that they would have had from the beginning.
TEST(BatchTable, WordsThatComeLaterComeToTheirPlaces) {
  Random random(11);
  std::vector<RunResult> results;
  for (int i = 0; i < 120; ++i) {
    results.push_back(result(i, "astar", 1.0));
    results.back().name.world = "map " + std::to_string(random.below(40)) + ".json";
  }
  BatchTable table;
  table.sort_by(BatchColumn::world);
  for (std::size_t i = 0; i < results.size(); i += 7)
    table.add({results.begin() + static_cast<std::ptrdiff_t>(i),
               results.begin() + static_cast<std::ptrdiff_t>(std::min(i + 7, results.size()))});
  ASSERT_EQ(table.shown(), results.size());
  const auto number = [&](std::size_t row) {
    return std::stoi(table.text(row, BatchColumn::world).substr(4));
  };
  for (std::size_t i = 1; i < table.shown(); ++i) {
    EXPECT_LE(number(i - 1), number(i));
    if (number(i - 1) == number(i)) {
      EXPECT_LT(table.row(i - 1).run, table.row(i).run);
    }
  }
}

TEST(BatchTable, TextsAreThoseOfTheRun) {
  BatchTable table;
  RunResult run = result(7, "astar", 12.25);
  run.name.settings = "weight=2";
  run.name.line = 3;
  run.name.seed = 12345;
  table.add({run, result(8, "astar", std::nullopt)});
  EXPECT_EQ(table.text(0, BatchColumn::run), "7");
  EXPECT_EQ(table.text(0, BatchColumn::world), "hall:3");
  EXPECT_EQ(table.text(0, BatchColumn::planner), planner_label(run.name));
  EXPECT_EQ(table.text(0, BatchColumn::seed), "12345");
  EXPECT_EQ(table.text(0, BatchColumn::length), "12.250");
  EXPECT_EQ(table.text(0, BatchColumn::time), "2.00");
  EXPECT_EQ(table.text(0, BatchColumn::turns), "");
  EXPECT_EQ(table.text(1, BatchColumn::length), "");
  EXPECT_EQ(table.text(1, BatchColumn::status), "no-path");
}

TEST(BatchTable, ShowsOnlyWhatIsAskedForAlsoOfResultsThatComeLater) {
  BatchTable table;
  table.add(many(30));
  table.show_planner("jps");
  table.show_status("no-path");
  const std::size_t before = table.shown();
  EXPECT_GT(before, 0u);
  table.add({result(100, "jps", std::nullopt), result(101, "jps", 3.0), result(102, "astar", std::nullopt)});
  EXPECT_EQ(table.shown(), before + 1);
  EXPECT_EQ(table.row_of(100), std::optional<std::size_t>(before));
  EXPECT_FALSE(table.row_of(101));
  for (std::size_t i = 0; i < table.shown(); ++i) {
    EXPECT_EQ(table.text(i, BatchColumn::planner), "jps");
    EXPECT_EQ(table.text(i, BatchColumn::status), "no-path");
  }
  table.show_planner("");
  table.show_status("");
  EXPECT_EQ(table.shown(), table.count());
}

TEST(BatchTable, SummariesAreThoseOfAllRunsOfThePlanner) {
  const std::vector<RunResult> results = many(300);
  BatchTable table;
  for (const RunResult& each : results) table.add({each});
  ASSERT_EQ(table.summaries().size(), 3u);
  EXPECT_EQ(table.summaries()[0].label(), "astar") << "in the order of their runs, whichever came first";
  EXPECT_EQ(table.summaries()[1].label(), "jps");
  for (const PlannerSummary& each : table.summaries()) {
    std::vector<double> lengths;
    std::int64_t runs = 0;
    for (const RunResult& run : results) {
      if (run.name.planner != each.label()) continue;
      ++runs;
      if (run.length()) lengths.push_back(*run.length());
    }
    EXPECT_EQ(each.runs(), runs);
    EXPECT_EQ(each.found(), static_cast<std::int64_t>(lengths.size()));
    EXPECT_EQ(each.median(SummaryFigure::length), median(lengths));
    EXPECT_EQ(each.median(SummaryFigure::time), 2);
    EXPECT_FALSE(each.median(SummaryFigure::turns)) << "no run has it";
  }
  const auto ratio = table.summaries()[1].ratio(SummaryFigure::length, table.summaries()[0]);
  EXPECT_EQ(ratio, *table.summaries()[1].median(SummaryFigure::length) /
                       *table.summaries()[0].median(SummaryFigure::length));
}

TEST(BatchTable, LeavesSkippedRunsOutOfTheSummary) {
  BatchTable table;
  RunResult skipped = result(1, "astar", std::nullopt);
  skipped.status = RunResult::kSkipped;
  table.add({result(0, "astar", 4.0), skipped});
  EXPECT_EQ(table.summaries()[0].runs(), 1);
  EXPECT_EQ(table.count(), 2u);
}

}  // namespace
}  // namespace replan::ui::batch_table_test
