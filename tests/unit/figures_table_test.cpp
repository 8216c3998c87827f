// The table of figures: ratios, the best of each row, and its text in all formats, letter by letter.
#include "core/study/figures_table.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace replan::figures_table_test {
namespace {

RunReport report_of(const char* planner, double length, std::int64_t expansions) {
  RunReport report;
  report.planner = planner;
  report.status = "found";
  report.figures = {.nodes = 61,
                    .length = length,
                    .turns = 12,
                    .turning_angle_deg = 540,
                    .greatest_curvature = 0.75,
                    .min_clearance = 0.5,
                    .mean_clearance = 2.25};
  report.plan_ms = 1.5;
  report.replan_ms = 0;
  report.replans = 0;
  report.counters = {expansions, 2 * expansions, 0};
  report.memory_bytes = 2048000;
  return report;
}

RunReport without_path() {
  RunReport report = report_of("dld-star-lite", 0, 50);
  report.status = "no-path";
  report.figures = {};
  return report;
}

const FigureRow& row_of(const FiguresTable& table, std::string_view key) {
  for (const FigureRow& row : table.rows)
    if (row.info->key == key) return row;
  ADD_FAILURE() << "no row " << key;
  return table.rows.front();
}

TEST(FiguresTable, RelatesEachRunToTheFirst) {
  const RunReport reports[] = {report_of("astar", 50, 0), report_of("dstar-lite", 54, 100)};
  const FiguresTable table = figures_table(reports);
  EXPECT_EQ(table.names, (std::vector<std::string>{"A*", "D* Lite"}));
  EXPECT_FALSE(row_of(table, "length").ratio(0));
  EXPECT_DOUBLE_EQ(row_of(table, "length").ratio(1).value(), 1.08);
  EXPECT_FALSE(row_of(table, "expansions").ratio(1)) << "of nothing there is no multiple";
}

TEST(FiguresTable, MarksTheBestWhereThereIsABetter) {
  RunReport wide = report_of("dist-dstar-lite", 50, 200);
  wide.figures.min_clearance = 2;
  wide.counters.sight_checks = 7;
  const RunReport reports[] = {report_of("astar", 50, 100), report_of("dstar-lite", 54, 100), wide,
                               without_path()};
  const FiguresTable table = figures_table(reports);
  const auto best = [&](std::string_view key) {
    std::vector<std::size_t> runs;
    for (std::size_t i = 0; i < std::size(reports); ++i)
      if (row_of(table, key).best(i)) runs.push_back(i);
    return runs;
  };
  EXPECT_EQ(best("length"), (std::vector<std::size_t>{0, 2})) << "two alike are both best";
  EXPECT_EQ(best("min_clearance"), (std::vector<std::size_t>{2})) << "more is better";
  EXPECT_EQ(best("expansions"), (std::vector<std::size_t>{0, 1})) << "who finds nothing wins nothing";
  EXPECT_TRUE(best("turns").empty()) << "all alike";
  EXPECT_TRUE(best("sight_checks").empty()) << "nobody can say";
}

std::vector<std::size_t> best_of(std::span<const RunReport> reports, std::string_view key) {
  const FiguresTable table = figures_table(reports);
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < reports.size(); ++i)
    if (row_of(table, key).best(i)) runs.push_back(i);
  return runs;
}

TEST(FiguresTable, MarksAlikeWhatReadsAlike) {
  const RunReport reports[] = {report_of("astar", 54.284271247461874, 1),
                               report_of("dstar-lite", 54.284271247446189, 1),
                               report_of("los-dstar-lite", 55, 1)};
  EXPECT_EQ(best_of(reports, "length"), (std::vector<std::size_t>{0, 1}));
}

TEST(FiguresTable, OneTimingIsNotTheBest) {
  RunReport slow = report_of("astar", 50, 1);
  slow.plan_ms = 99;
  const RunReport reports[] = {slow, report_of("dstar-lite", 50, 1)};
  EXPECT_TRUE(best_of(reports, "plan_ms").empty());
}

RunReport driven(const char* planner, MissionState ending, std::int64_t moves, double travelled,
                 std::int64_t expansions) {
  RunReport report = report_of(planner, 50, expansions);
  report.last_plan = Counters{expansions / 2, 0, 0};
  report.replans = moves > 0 ? 1 : 0;
  report.robot = RobotReport{.ending = ending, .moves = moves, .travelled = travelled};
  return report;
}

TEST(FiguresTable, ComparesWholeDrivesAndNotWhatIsUnderWay) {
  using enum MissionState;
  const RunReport begun[] = {driven("astar", driving, 0, 0, 20), driven("dstar-lite", driving, 0, 0, 10)};
  EXPECT_EQ(best_of(begun, "expansions"), (std::vector<std::size_t>{1}));
  EXPECT_EQ(best_of(begun, "last_expansions"), (std::vector<std::size_t>{1}));
  const RunReport under_way[] = {driven("astar", driving, 9, 12, 20),
                                 driven("dstar-lite", driving, 7, 8, 10)};
  EXPECT_TRUE(best_of(under_way, "expansions").empty());
  EXPECT_TRUE(best_of(under_way, "travelled").empty()) << "who has gone less is not ahead";
  const RunReport over[] = {driven("astar", arrived, 30, 50, 20), driven("dstar-lite", arrived, 30, 55, 10),
                            driven("los-dstar-lite", no_path, 3, 4, 5)};
  EXPECT_EQ(best_of(over, "expansions"), (std::vector<std::size_t>{1})) << "who has not arrived wins nothing";
  EXPECT_EQ(best_of(over, "travelled"), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(best_of(over, "last_expansions").empty()) << "the last replans began in different places";
}

TEST(FiguresTable, NumbersAPlannerThatIsThereTwice) {
  const RunReport reports[] = {report_of("astar", 50, 1), report_of("dstar-lite", 50, 1),
                               report_of("astar", 50, 1)};
  EXPECT_EQ(figures_table(reports).names, (std::vector<std::string>{"A*", "D* Lite", "A*#2"}));
}

TEST(FiguresTable, HasTheLatestPlanAndTheRobotOnlyWhereThereIsOne) {
  RunReport driven = report_of("astar", 50, 1);
  driven.last_plan = Counters{5, 6, 7};
  driven.robot = RobotReport{.ending = MissionState::arrived, .moves = 9, .travelled = 10.5};
  const RunReport plain[] = {report_of("astar", 50, 1)}, whole[] = {driven};
  EXPECT_EQ(figures_table(plain).rows.size(), 14u);
  EXPECT_EQ(figures_table(whole).rows.size(), 21u);
  EXPECT_EQ(row_of(figures_table(whole), "last_queue_operations").values.front(), 6);
  EXPECT_EQ(row_of(figures_table(whole), "travelled").values.front(), 10.5);
}

TEST(FiguresText, Markdown) {
  const RunReport reports[] = {report_of("dstar-lite", 50, 100), report_of("los-dstar-lite", 48.5, 110),
                               without_path()};
  EXPECT_EQ(figures_text(FiguresFormat::markdown, reports),
            R"(| figure                  | D\* Lite |       Los D\* Lite |    DLD\* Lite |
|-------------------------|---------:|-------------------:|--------------:|
| nodes                   |       61 |         61 (×1.00) |             – |
| length (cells)          |   50.000 | **48.500** (×0.97) |             – |
| turns                   |       12 |         12 (×1.00) |             – |
| turning (°)             |    540.0 |      540.0 (×1.00) |             – |
| top curvature (1/cells) |    0.750 |      0.750 (×1.00) |             – |
| least clearance (cells) |    0.500 |      0.500 (×1.00) |             – |
| mean clearance (cells)  |    2.250 |      2.250 (×1.00) |             – |
| first plan (ms)         |    1.500 |      1.500 (×1.00) | 1.500 (×1.00) |
| replans (ms)            |    0.000 |              0.000 |         0.000 |
| replans                 |        0 |                  0 |             0 |
| expansions              |  **100** |        110 (×1.10) |    50 (×0.50) |
| queue operations        |  **200** |        220 (×1.10) |   100 (×0.50) |
| sight checks            |        0 |                  0 |             0 |
| planner's memory (kB)   |     2048 |       2048 (×1.00) |  2048 (×1.00) |
)");
}

TEST(FiguresText, Latex) {
  const RunReport reports[] = {report_of("dstar-lite", 50, 100), report_of("los-dstar-lite", 48.5, 110),
                               without_path()};
  EXPECT_EQ(figures_text(FiguresFormat::latex, reports), R"(% needs \usepackage{booktabs}
\begin{tabular}{lrrr}
\toprule
Figure & D* Lite & Los D* Lite & DLD* Lite \\
\midrule
nodes & 61 & 61 {\footnotesize($\times$1.00)} & -- \\
length (cells) & 50.000 & \textbf{48.500} {\footnotesize($\times$0.97)} & -- \\
turns & 12 & 12 {\footnotesize($\times$1.00)} & -- \\
turning ($^\circ$) & 540.0 & 540.0 {\footnotesize($\times$1.00)} & -- \\
top curvature (1/cells) & 0.750 & 0.750 {\footnotesize($\times$1.00)} & -- \\
least clearance (cells) & 0.500 & 0.500 {\footnotesize($\times$1.00)} & -- \\
mean clearance (cells) & 2.250 & 2.250 {\footnotesize($\times$1.00)} & -- \\
\midrule
first plan (ms) & 1.500 & 1.500 {\footnotesize($\times$1.00)} & 1.500 {\footnotesize($\times$1.00)} \\
replans (ms) & 0.000 & 0.000 & 0.000 \\
replans & 0 & 0 & 0 \\
expansions & \textbf{100} & 110 {\footnotesize($\times$1.10)} & 50 {\footnotesize($\times$0.50)} \\
queue operations & \textbf{200} & 220 {\footnotesize($\times$1.10)} & 100 {\footnotesize($\times$0.50)} \\
sight checks & 0 & 0 & 0 \\
planner's memory (kB) & 2048 & 2048 {\footnotesize($\times$1.00)} & 2048 {\footnotesize($\times$1.00)} \\
\bottomrule
\end{tabular}
)");
}

TEST(FiguresText, NamesCannotBreakATable) {
  RunReport odd = report_of("a|b_c & 50% #1 \\ ~^{}$", 1, 1);
  const RunReport reports[] = {odd};
  EXPECT_NE(figures_text(FiguresFormat::markdown, reports).find(R"(| a\|b\_c & 50% #1 \\ ~^{}$ |)"),
            std::string::npos)
      << figures_text(FiguresFormat::markdown, reports);
  EXPECT_NE(
      figures_text(FiguresFormat::latex, reports)
          .find(
              R"(Figure & a|b\_c \& 50\% \#1 \textbackslash{} \textasciitilde{}\textasciicircum{}\{\}\$ \\)"),
      std::string::npos)
      << figures_text(FiguresFormat::latex, reports);
}

TEST(FiguresText, Csv) {
  const RunReport reports[] = {report_of("dstar-lite", 50, 100), without_path()};
  EXPECT_EQ(figures_text(FiguresFormat::csv, reports),
            "planner,status,nodes,length,turns,turning_angle_deg,greatest_curvature,min_clearance,mean_"
            "clearance,plan_ms,replan_ms,"
            "replans,expansions,queue_operations,sight_checks,memory_bytes\n"
            "dstar-lite,found,61,50,12,540,0.75,0.5,2.25,1.5,0,0,100,200,0,2048000\n"
            "dld-star-lite,no-path,0,0,0,0,0,0,0,1.5,0,0,50,100,0,2048000\n");
}

TEST(FiguresText, Json) {
  const RunReport reports[] = {report_of("dstar-lite", 50, 100), without_path()};
  const auto runs = nlohmann::json::parse(figures_text(FiguresFormat::json, reports))["runs"];
  EXPECT_EQ(runs[0]["planner"], "dstar-lite");
  EXPECT_EQ(runs[0]["figures"]["length"], 50.0);
  EXPECT_EQ(runs[1]["status"], "no-path");
  EXPECT_EQ(runs[1]["figures"]["length"], 0) << "a program is promised numbers";
  EXPECT_EQ(runs[1]["figures"]["expansions"], 50);
  EXPECT_EQ(runs[1]["figures"].size(), 14u);
}

}  // namespace
}  // namespace replan::figures_table_test
