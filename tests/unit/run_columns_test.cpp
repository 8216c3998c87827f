// The columns of a scatter plot, against the state and the log at every moment of small runs; and what is painted of them.
#include "core/debug/run_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/debug/plot_bins.hpp"
#include "core/plan/tree_values.hpp"
#include "core/session/run.hpp"

namespace replan::run_columns_test {
namespace {

/// A wall with a gap, which a surprise closes while the robot is under way.
std::unique_ptr<Run> surprised_run(const char* planner) {
  Scenario scenario;
  scenario.map = GridMap(12, 9);
  for (int y = 1; y < 8; ++y) scenario.map.set({6, y}, y != 4);
  scenario.start = {1, 4};
  scenario.goal = {10, 4};
  scenario.planners = {{planner, {}}};
  if (find_planner(planner)->sampling) scenario.planners[0].settings.set("samples", 60);
  Surprise surprise;
  surprise.at.move = 2;
  surprise.cells = {{{6, 4}, true}};
  scenario.surprises = {surprise};
  auto run = std::make_unique<Run>(std::make_shared<const Scenario>(scenario), 0);
  run->finish(Target::end());
  return run;
}

const Measure& measure_named(const std::vector<Measure>& all, std::string_view id) {
  const auto found =
      std::find_if(all.begin(), all.end(), [id](const Measure& each) { return each.id == id; });
  EXPECT_NE(found, all.end()) << id;
  return *found;
}

/// The points that the search wrote to since it began afresh, each with its first event: event by event.
class PlainTouches {
 public:
  explicit PlainTouches(const Run& run) : run_(run) {}
  void go_on(std::size_t index) {
    const Event event = run_.timeline().event(index);
    if (event.kind == EventKind::epoch) first_.clear();
    const bool grows = run_.info().values.grows();
    const bool value = is_wide(event.kind) && event.kind != EventKind::dist;
    if (grows ? is_own_field(event.kind) : value) first_.try_emplace(event.node, index + 1);
  }
  [[nodiscard]] const std::map<NodeId, std::size_t>& first() const { return first_; }

 private:
  const Run& run_;
  std::map<NodeId, std::size_t> first_;
};

struct Row {
  double x, y;
};
std::map<NodeId, Row> rows_of(const RunColumns& columns) {
  std::map<NodeId, Row> rows;
  for (std::size_t i = 0; i < columns.points.size(); ++i)
    EXPECT_TRUE(rows.emplace(columns.points[i], Row{columns.x[i], columns.y[i]}).second) << "twice";
  return rows;
}

using PlainValue = std::optional<double> (*)(const Run&, const SearchState&, NodeId);

std::optional<double> finite(Cost cost) {
  return cost.is_infinite() ? std::nullopt : std::optional<double>(cost.to_double());
}

void expect_rows(const Run& run, const SearchState& state, const PlainTouches& touches,
                 const RunColumns& columns, PlainValue plain, const std::string& where) {
  const auto rows = rows_of(columns);
  std::size_t with = 0;
  for (const auto& [point, event] : touches.first()) {
    const auto value = plain(run, state, point);
    const auto row = rows.find(point);
    ASSERT_EQ(row != rows.end(), value.has_value()) << where << ", point " << point;
    if (!value) continue;
    ++with;
    ASSERT_EQ(row->second.x, static_cast<double>(event)) << where << ", point " << point;
    ASSERT_EQ(row->second.y, *value) << where << ", point " << point;
  }
  ASSERT_EQ(rows.size(), with) << where;
  ASSERT_EQ(columns.without, touches.first().size() - with) << where;
}

struct Asked {
  const char* planner;
  const char* measure;
  PlainValue plain;
};
const Asked kAsked[] = {
    {"astar", "g", [](const Run&, const SearchState& s, NodeId n) { return finite(s.g(n)); }},
    {"astar", "queue",
     [](const Run&, const SearchState& s, NodeId n) { return s.queued(n) ? finite(s.k1(n)) : std::nullopt; }},
    {"astar", "second",
     [](const Run&, const SearchState& s, NodeId n) {
       return s.queued(n) ? finite(Cost{s.k1(n).raw - s.g(n).raw}) : std::nullopt;
     }},
    {"dstar-lite", "rhs", [](const Run&, const SearchState& s, NodeId n) { return finite(s.rhs(n)); }},
    {"dld-star-lite", "dist", [](const Run&, const SearchState& s, NodeId n) { return finite(s.dist(n)); }},
    {"dstar", "expansion",
     [](const Run&, const SearchState& s, NodeId n) {
       return s.order(n) > 0 ? std::optional<double>(s.order(n)) : std::nullopt;
     }},
    {"theta-star", "times",
     [](const Run&, const SearchState& s, NodeId n) { return std::optional<double>(s.times_expanded(n)); }},
    {"dstar-lite", "to_goal",
     [](const Run& run, const SearchState& s, NodeId n) {
       const Cell cell = run.lattice().position(n), goal = run.lattice().position(s.wanted_goal());
       return std::optional<double>(std::hypot(cell.x - goal.x, cell.y - goal.y));
     }},
    {"rrt-star", "vertex_cost",
     [](const Run&, const SearchState& s, NodeId v) { return finite(vertex_cost(s, v)); }},
    {"rrt-star", "vertex", [](const Run&, const SearchState&, NodeId v) { return std::optional<double>(v); }},
};

TEST(RunColumns, AtEveryMomentAreWhatTheLogAndTheStateHold) {
  for (const Asked& asked : kAsked) {
    const auto run = surprised_run(asked.planner);
    Timeline& log = run->timeline();
    const std::vector<Measure> all = measures_of(run->info());
    const Measure &x = measure_named(all, "event"), &y = measure_named(all, asked.measure);
    PlainTouches touches(*run);
    std::size_t most = 0;
    for (std::size_t p = 0; p <= log.size(); ++p) {
      if (p > 0) touches.go_on(p - 1);
      log.seek(p);
      if (p % 3 != 0 && p != log.size()) continue;
      const RunColumns columns = run_columns(run->log_view(), p, x, y);
      expect_rows(*run, log.state(), touches, columns, asked.plain,
                  std::string(asked.planner) + " " + asked.measure + " at " + std::to_string(p));
      if (testing::Test::HasFatalFailure()) return;
      most = std::max(most, columns.points.size());
    }
    EXPECT_GT(most, 5u) << asked.planner << " " << asked.measure;
  }
}

TEST(RunColumns, OfAReaderThatIsTakenBackAndForthAreThoseOfTheMoment) {
  for (const char* planner : {"astar", "dstar-lite", "rrt"}) {
    const auto run = surprised_run(planner);
    Timeline& log = run->timeline();
    const std::vector<Measure> all = measures_of(run->info());
    const Measure &x = measure_named(all, "event"), &y = all[2];
    ColumnReader reader;
    std::size_t at = 0;
    for (std::size_t i = 0; i < 400; ++i) {
      at = (at + (i % 3 == 0 ? log.size() - 7 : 29)) % (log.size() + 1);
      log.seek(at);
      reader.follow(run->log_view(), run->log_id(), x, y, true, Deadline::never());
      ASSERT_FALSE(reader.behind());
      const RunColumns expected = run_columns(run->log_view(), at, x, y);
      const RunColumns& columns = *reader.columns();
      ASSERT_EQ(columns.position, at);
      ASSERT_EQ(columns.points, expected.points);
      ASSERT_EQ(columns.x, expected.x);
      ASSERT_EQ(columns.y, expected.y);
      ASSERT_EQ(columns.states, expected.states);
      ASSERT_EQ(columns.without, expected.without);
    }
  }
}

/// Every slice has run out of time, and the cursor moves with each.
TEST(RunColumns, ThatWereBegunAreOfOneMomentThoughTheCursorMovesOn) {
  Scenario scenario;
  scenario.map = GridMap(120, 120);
  scenario.start = {1, 60};
  scenario.goal = {118, 60};
  scenario.planners = {{"dijkstra", {}}};
  replan::Run run(std::make_shared<const Scenario>(scenario), 0);
  run.finish(Target::plan());
  Timeline& log = run.timeline();
  const std::vector<Measure> all = measures_of(run.info());
  const Measure &x = measure_named(all, "expansion"), &y = measure_named(all, "g");
  ColumnReader reader;
  log.seek(log.size());
  int slices = 0;
  while (!reader.columns()) {
    reader.follow(run.log_view(), run.log_id(), x, y, false, Deadline(0));
    log.seek(log.cursor() - 100);
    ASSERT_LT(++slices, 1000);
  }
  EXPECT_GT(slices, 5) << "it was meant to take several";
  const RunColumns expected = run_columns(run.log_view(), log.size(), x, y);
  EXPECT_EQ(reader.columns()->position, log.size());
  EXPECT_EQ(reader.columns()->points, expected.points);
  EXPECT_EQ(reader.columns()->y, expected.y);
  // In a hurry the present moment is what counts.
  reader.follow(run.log_view(), run.log_id(), x, y, true, Deadline::never());
  EXPECT_EQ(reader.columns()->position, log.cursor());
}

TEST(RunColumns, StatesAreThoseOfTheSearch) {
  const auto run = surprised_run("dstar-lite");
  Timeline& log = run->timeline();
  const std::vector<Measure> all = measures_of(run->info());
  std::size_t on_path = 0;
  for (std::size_t p = 0; p <= log.size(); p += 5) {
    log.seek(p);
    const SearchState& state = log.state();
    const RunColumns columns = run_columns(run->log_view(), p, all[0], measure_named(all, "to_goal"));
    for (std::size_t i = 0; i < columns.points.size(); ++i) {
      const NodeId n = columns.points[i];
      if (columns.states[i] == PointState::on_path) {
        ++on_path;
        continue;
      }
      const bool open = columns.states[i] == PointState::open;
      ASSERT_EQ(open, state.queued(n));
      if (!open) {
        ASSERT_EQ(columns.states[i] == PointState::inconsistent, state.g(n) != state.rhs(n));
      }
    }
  }
  EXPECT_GT(on_path, 0u);
}

TEST(RunColumns, AsCsvHaveARowForEachPoint) {
  const auto run = surprised_run("astar");
  const std::vector<Measure> all = measures_of(run->info());
  const RunColumns columns = run_columns(run->log_view(), run->timeline().size(), measure_named(all, "event"),
                                         measure_named(all, "g"));
  const Measure &x = measure_named(all, "event"), &y = measure_named(all, "g");
  const std::string csv = columns_csv(run->log_view(), columns, x, y, {}, SIZE_MAX);
  EXPECT_TRUE(csv.starts_with("cell_x,cell_y,event,g,state\n")) << csv.substr(0, 60);
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), columns.points.size() + 1);
  const PlotBrush brush{columns.x[3], columns.x[3], 0, 1e9};
  const std::string one = columns_csv(run->log_view(), columns, x, y, brush, SIZE_MAX);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 2);
  const std::string few = columns_csv(run->log_view(), columns, x, y, {}, 4);
  EXPECT_EQ(std::count(few.begin(), few.end(), '\n'), 5);
}

std::shared_ptr<RunColumns> columns_of(const std::vector<Row>& rows) {
  auto columns = std::make_shared<RunColumns>();
  columns->nodes = 1000;
  for (const Row& row : rows) {
    columns->points.push_back(static_cast<NodeId>(columns->points.size()));
    columns->x.push_back(row.x);
    columns->y.push_back(row.y);
    columns->states.push_back(columns->points.size() % 3 == 0 ? PointState::open : PointState::closed);
    columns->x_range.take(row.x);
    columns->y_range.take(row.y);
  }
  return columns;
}

TEST(PlotPicture, HoldsEveryPointOnceAndTheBrushThoseWithin) {
  std::vector<Row> rows;
  for (int i = 0; i < 900; ++i) rows.push_back({i * 7 % 100 + 0.5, i * 13 % 37 - 3.0});
  const auto columns = columns_of(rows);
  const PlotBrush brush{20, 60, 0, 12};
  PlotPainter painter;
  painter.follow({columns, false, false, 50, 40, brush}, Deadline::never());
  ASSERT_FALSE(painter.behind());
  const PlotPicture& picture = *painter.picture();
  std::size_t held = 0, within = 0;
  for (const PlotBin& bin : picture.bins) held += bin.count;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool in = rows[i].x >= 20 && rows[i].x <= 60 && rows[i].y >= 0 && rows[i].y <= 12;
    within += in ? 1 : 0;
    EXPECT_EQ(picture.brushed->has(static_cast<NodeId>(i)), in);
  }
  EXPECT_EQ(held, rows.size());
  EXPECT_EQ(picture.shown, rows.size());
  EXPECT_EQ(picture.brushed_points, within);
  EXPECT_GE(picture.brushed_x.low, 20);
  EXPECT_LE(picture.brushed_y.high, 12);
}

TEST(PlotPicture, ALogarithmicAxisLeavesOutWhatIsNotAboveZero) {
  const auto columns = columns_of({{-1, 1}, {0, 1}, {1, 1}, {10, 1}, {100, 1}});
  PlotPainter painter;
  painter.follow({columns, true, false, 10, 10, {}}, Deadline::never());
  const PlotPicture& picture = *painter.picture();
  EXPECT_EQ(picture.shown, 3u);
  EXPECT_DOUBLE_EQ(picture.x.low, 1);
  EXPECT_NEAR(picture.x.place(10), 0.5, 1e-12);
  EXPECT_NEAR(picture.x.value(0.5), 10, 1e-9);
  EXPECT_DOUBLE_EQ(picture.y.place(1), 0.5) << "one number alone stands in the middle";
}

TEST(PlotPicture, IsBroughtToItsEndSliceBySlice) {
  std::vector<Row> rows(40'000, Row{1, 2});
  const auto columns = columns_of(rows);
  columns->nodes = rows.size();
  PlotPainter painter;
  int slices = 0;
  while (!painter.picture()) {
    painter.follow({columns, false, false, 10, 10, {}}, Deadline(0));
    ASSERT_LT(++slices, 100);
  }
  EXPECT_GT(slices, 2);
  EXPECT_EQ(painter.picture()->most, rows.size());
}

}  // namespace
}  // namespace replan::run_columns_test
