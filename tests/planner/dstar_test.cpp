// D* and focused D*: what their repairs cost, which states they process, and what their back-pointers are after a change.
// (100 000 replans of each in tests/property/dstar_property_test.cpp.)
#include "core/debug/wave.hpp"
#include "core/trace/search_state.hpp"
#include "tests/support/replan_trials.hpp"

namespace replan::test::dstar_test {
namespace {

constexpr const char* kFamily[] = {"dstar", "focused-dstar", "threat-dstar"};

TEST(DStar, RepairsCostWhatBruteForceSaysIn2d) {
  for (const char* id : kFamily) check_replans<2>(id, 7, 1500);
}
TEST(DStar, RepairsCostWhatBruteForceSaysIn3d) {
  for (const char* id : kFamily) check_replans<3>(id, 7, 3000);
}

/// A planner, its lattice and its log, of rows of text: '#' obstacle, 'R' robot, 'G' goal.
class DStarRun {
 public:
  DStarRun(const char* id, const std::vector<std::string>& rows)
      : info_(*find_planner(id)), lattice_(read(rows)) {
    planner_ = make_planner(info_, lattice_, {}, recorder_);
    planner_->begin(robot_, goal_);
    finish(*planner_);
  }

  /// Turns the cells over, with the robot where it is.
  void turn(std::initializer_list<Cell> cells) {
    std::vector<CellEdit> edits;
    for (const Cell cell : cells)
      edits.push_back({lattice_.node(cell), !lattice_.blocked(lattice_.node(cell))});
    const auto moves = lattice_.apply(edits);
    planner_->update({.cells = edits, .moves = moves}, robot_);
    finish(*planner_);
  }
  void move_to(Cell cell) {
    robot_ = lattice_.node(cell);
    planner_->update({.cells = {}, .moves = {}}, robot_);
    finish(*planner_);
  }

  Planner<Grid2>& planner() { return *planner_; }
  const Grid2& lattice() const { return lattice_; }
  [[nodiscard]] NodeId robot() const { return robot_; }
  [[nodiscard]] NodeId goal() const { return goal_; }
  [[nodiscard]] std::span<const Event> log() const { return recorder_.buffer(); }
  [[nodiscard]] SearchState state() const {
    SearchState state(lattice_.node_count(), info_.values.fields);
    for (const Event& event : log()) state.apply(event);
    return state;
  }
  [[nodiscard]] std::vector<oracle::Raw> right_costs() const {
    oracle::World world;
    world.size = {lattice_.width(), lattice_.height(), 1};
    world.blocked.assign(lattice_.cells().begin(), lattice_.cells().end());
    return oracle::costs_to(world, lattice_.rules(), {}, goal_);
  }
  [[nodiscard]] std::int64_t count(EventKind kind) const {
    return std::count_if(log().begin(), log().end(), [kind](const Event& e) { return e.kind == kind; });
  }

 private:
  Grid2 read(const std::vector<std::string>& rows) {
    Grid2 lattice({static_cast<int>(rows[0].size()), static_cast<int>(rows.size())});
    std::vector<CellEdit> edits;
    NodeId n = 0;
    for (const std::string& row : rows)
      for (const char c : row) {
        if (c == 'R') robot_ = n;
        if (c == 'G') goal_ = n;
        if (c == '#') edits.push_back({n, true});
        ++n;
      }
    lattice.apply(edits);
    return lattice;
  }

  const PlannerInfo& info_;
  NodeId robot_ = 0, goal_ = 0;
  Grid2 lattice_;
  Recorder recorder_;
  std::unique_ptr<Planner<Grid2>> planner_;
};

const std::vector<std::string> kHall = {"..............", "..............", "..####........",
                                        ".....#....G...", "..R..#........", ".....#........",
                                        "..####........", "..............", ".............."};

/// The first plan is Dijkstra's search from the goal: it processes what is nearer than the robot, each once.
TEST(DStar, ProcessesEachStateOnceAndThoseAloneThatAreNearerToTheGoal) {
  const DStarRun run("dstar", kHall);
  const SearchState state = run.state();
  const auto right = run.right_costs();
  std::int64_t nearer = 0;
  for (NodeId n = 0; n < run.lattice().node_count(); ++n) {
    const bool is_nearer = right[n] < right[run.robot()];
    EXPECT_EQ(state.times_expanded(n), is_nearer ? 1u : 0u) << "node " << n;
    nearer += is_nearer ? 1 : 0;
  }
  EXPECT_EQ(run.count(EventKind::visit), nearer);
  EXPECT_EQ(run.count(EventKind::pop), nearer);
}

/// What the plan rests on is right after each change, and a state whose way is gone has no back-pointer.
void expect_right_around(const DStarRun& run) {
  const SearchState state = run.state();
  const auto right = run.right_costs();
  const Cost robot = state.g(run.robot());
  for (NodeId n = 0; n < run.lattice().node_count(); ++n) {
    const bool closed =
        state.value(fields::kTag.kind, n) == static_cast<std::uint64_t>(fields::StateTag::closed);
    if (closed && state.g(n) < robot) {
      EXPECT_EQ(state.g(n).raw, right[n]) << "node " << n;
    }
    if (closed && state.g(n).is_infinite()) {
      EXPECT_EQ(state.lp(n), kNoNode);
    }
  }
}

/// The paper's story: the robot stands in a pocket whose way out is shut. RAISE states empty the pocket, and all
/// back-pointers in it lead out by another way; cells behind the goal are not looked at again.
TEST(DStar, RaisesAPocketWhoseWayOutIsShutAndTurnsItsBackPointers) {
  DStarRun run("dstar", {"............", ".########...", ".#..........", ".#..R.......", ".#......#...",
                         ".########...", "............", ".........G.."});
  const std::int64_t first = run.planner().counters().expansions;
  const Cost before = run.planner().cost();
  run.turn({{8, 2}, {8, 3}});
  EXPECT_EQ(run.planner().status(), PlanStatus::no_path);
  EXPECT_EQ(run.state().lp(run.robot()), kNoNode);
  EXPECT_EQ(run.state().queue_size(), 0u) << "the wave has ended";
  run.turn({{1, 3}});
  ASSERT_EQ(run.planner().status(), PlanStatus::found);
  EXPECT_GT(run.planner().cost(), before);
  EXPECT_EQ(run.planner().cost().raw, run.right_costs()[run.robot()]);
  EXPECT_EQ(run.lattice().position(run.state().lp(run.robot())).x, 3) << "out by the other side";
  expect_right_around(run);
  run.turn({{8, 3}});
  EXPECT_EQ(run.planner().cost(), before);
  expect_right_around(run);
  EXPECT_GT(run.planner().counters().expansions, first);
}

/// What windows and texts say of a state: a first plan has LOWER states alone, and what is taken waits in one wave or the
/// other.
TEST(DStar, TakesLowerStatesUntilSomethingIsShutAndRaiseStatesThen) {
  DStarRun run("dstar", kHall);
  const std::size_t first = run.log().size();
  run.turn({{6, 1}, {6, 0}});
  SearchState state(run.lattice().node_count(), find_planner("dstar")->values.fields);
  std::size_t taken[4] = {}, taken_later[4] = {};
  for (std::size_t i = 0; i < run.log().size(); ++i) {
    const Event& event = run.log()[i];
    if (event.kind == EventKind::pop)
      ++(i < first ? taken : taken_later)[static_cast<std::size_t>(wave_of(state, event.node))];
    state.apply(event);
  }
  const auto count = [](const std::size_t* of, Wave wave) { return of[static_cast<std::size_t>(wave)]; };
  EXPECT_GT(count(taken, Wave::lower), 0u);
  EXPECT_EQ(count(taken, Wave::raise), 0u);
  EXPECT_GT(count(taken_later, Wave::raise), 0u);
  EXPECT_EQ(count(taken, Wave::fresh) + count(taken, Wave::closed), 0u);
  EXPECT_EQ(count(taken_later, Wave::fresh) + count(taken_later, Wave::closed), 0u);
}

/// A change that concerns no way to the goal is next to no work: the states at it are processed, and that is all.
TEST(DStar, ChangesThatConcernNobodyEndAtOnce) {
  for (const char* id : {"dstar", "focused-dstar"}) {
    DStarRun run(id, kHall);
    const std::int64_t before = run.planner().counters().expansions;
    run.turn({{0, 8}});
    EXPECT_LE(run.planner().counters().expansions, before + 10) << id;
    run.turn({{12, 3}});
    EXPECT_LE(run.planner().counters().expansions, before + 40) << id;
    EXPECT_EQ(run.planner().cost().raw, run.right_costs()[run.robot()]) << id;
  }
}

/// The wave is led towards the robot: f = k + g(X, R).
TEST(FocusedDStar, ProcessesLessThanDStar) {
  DStarRun plain("dstar", kHall), focused("focused-dstar", kHall);
  EXPECT_EQ(plain.planner().cost(), focused.planner().cost());
  EXPECT_LT(focused.planner().counters().expansions, plain.planner().counters().expansions);
}

/// Keys of an older focus are seen by their bias: a robot that comes back to where it was finds them old all the same.
TEST(FocusedDStar, StatesOfAnOlderFocusAreTakenAndPutBack) {
  DStarRun run("focused-dstar", kHall);
  const auto older = [&run] { return run.count(EventKind::pop) - run.count(EventKind::visit); };
  EXPECT_EQ(older(), 0);
  const Cell home = run.lattice().position(run.robot());
  run.move_to({4, 1});
  run.move_to(home);
  run.turn({{6, 2}, {6, 1}, {6, 0}});
  EXPECT_EQ(run.planner().cost().raw, run.right_costs()[run.robot()]);
  EXPECT_GT(older(), 0);
  expect_right_around(run);
}

}  // namespace
}  // namespace replan::test::dstar_test
