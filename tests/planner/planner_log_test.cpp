// The log of a planner tells the truth: played back it gives the planner's values, which keep D* Lite's
// invariants; played backwards it leads back through the same states; and a search taken up from any of these
// states goes on as if it had never stopped.
#include <span>

#include <gtest/gtest.h>

#include "core/trace/search_state.hpp"
#include "tests/support/each_planner.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::planner_log_test {
namespace {

constexpr const char* kFamily[] = {"dstar-lite", "los-dstar-lite", "dist-dstar-lite", "dld-star-lite"};

/// One change of map and start; the search then runs to its end, or only `budget` iterations.
struct Step {
  std::vector<CellEdit> edits = {};
  NodeId start = 0;
  std::int64_t budget = 0;  ///< 0: to the end
};

/// A world, a planner's settings, and what happens.
template <int D>
struct Script {
  const PlannerInfo* info = nullptr;
  Settings settings;
  typename BoxLattice<D>::Coordinates size{};
  std::vector<std::uint8_t> cells = {};
  NodeId goal = 0;
  std::vector<Step> steps = {};  ///< the first one is the first plan; its edits are not used

  [[nodiscard]] BoxLattice<D> lattice() const { return BoxLattice<D>(size, cells, move_rules(settings)); }
};

template <int D>
Script<D> random_script(const PlannerInfo& info, std::uint64_t seed, int replans) {
  Random random(seed);
  Script<D> script{.info = &info, .settings = random_settings(random, info)};
  if constexpr (D == 2)
    script.size = random_size<2>(random, {5, 5}, {14, 11});
  else
    script.size = random_size<3>(random, {3, 3, 2}, {6, 5, 4});
  script.cells = random_cells<D>(random, script.size);
  TwinWorld<D> world(script.size, script.cells, move_rules(script.settings));
  script.goal = random_free(random, world.plain);
  for (int i = 0; i <= replans; ++i) {
    Step step{.start = random_free(random, world.plain)};
    if (i > 0 && random.chance(0.9)) step.edits = random_edits<D>(random, world.plain, 4);
    if (random.chance(0.2)) step.budget = random.between(1, 30);
    world.apply(step.edits);
    script.steps.push_back(step);
  }
  return script;
}

/// Where the events of one step of a script stand in the log.
struct Marks {
  std::size_t changed = 0;   ///< after begin() or update()
  std::size_t searched = 0;  ///< after advance()
  std::size_t done = 0;      ///< after path()
};

/// Plays a script, from its beginning or from the middle of it.
template <int D>
class Player {
 public:
  explicit Player(const Script<D>& script)
      : script_(script),
        lattice_(script.lattice()),
        planner_(make_planner(*script.info, lattice_, script.settings, recorder_)) {}

  void change(std::size_t i) {
    const Step& step = script_.steps[i];
    if (i == 0) {
      planner_->begin(step.start, script_.goal);
    } else {
      const auto moves = lattice_.apply(step.edits);
      planner_->update({.cells = step.edits, .moves = moves}, step.start);
    }
  }
  /// Runs the search of step i; `spent` iterations of its budget were spent before.
  void search(std::size_t i, std::int64_t spent = 0) {
    const std::int64_t budget = script_.steps[i].budget;
    if (budget == 0)
      finish(*planner_);
    else if (budget > spent)
      planner_->advance(budget - spent);
  }
  void read_path() { planner_->path(); }
  Marks play(std::size_t i) {
    Marks marks;
    change(i);
    marks.changed = log().size();
    search(i);
    marks.searched = log().size();
    read_path();
    marks.done = log().size();
    return marks;
  }
  /// Changes the map as steps 0 .. i do, without telling the planner.
  void show_map_of(std::size_t i) {
    for (std::size_t k = 1; k <= i; ++k) lattice_.apply(script_.steps[k].edits);
  }
  Planner<BoxLattice<D>>& planner() { return *planner_; }
  [[nodiscard]] std::span<const Event> log() const { return recorder_.buffer(); }
  [[nodiscard]] const BoxLattice<D>& lattice() const { return lattice_; }

 private:
  const Script<D>& script_;
  BoxLattice<D> lattice_;
  Recorder recorder_;
  std::unique_ptr<Planner<BoxLattice<D>>> planner_;
};

template <int D>
oracle::World plain_world(const BoxLattice<D>& lattice) {
  oracle::World world{.dimensions = D, .size = {1, 1, 1}, .blocked = {}};
  for (std::size_t axis = 0; axis < D; ++axis) world.size[axis] = lattice.size()[axis];
  world.blocked.assign(lattice.cells().begin(), lattice.cells().end());
  return world;
}

Heuristic heuristic_of(const Settings& settings) {
  constexpr Heuristic kByChoice[] = {Heuristic::octile, Heuristic::euclidean, Heuristic::zero};
  return kByChoice[static_cast<std::size_t>(settings.get("heuristic", 0))];
}

/// D* Lite's invariants of one node, by the oracle's moves, penalties and estimates; what is broken, or
/// empty.
template <int D>
std::string broken_invariant(const Script<D>& script, const oracle::World& world,
                             const std::vector<oracle::Raw>& penalty, const SearchState& state, NodeId n) {
  const MoveRules rules = move_rules(script.settings);
  oracle::Raw least = n == script.goal ? 0 : oracle::kNever;
  NodeId parent = n == script.goal ? n : kNoNode;
  if (n != script.goal)
    for (const std::size_t s : oracle::neighbours(world, rules, n)) {
      const oracle::Raw sum = state.g(static_cast<NodeId>(s)).raw + oracle::step_between(world, n, s) +
                              (penalty.empty() ? 0 : penalty[s]);
      if (sum >= least) continue;
      least = sum;
      parent = static_cast<NodeId>(s);
    }
  if (state.rhs(n).raw != least) return "rhs is not the least over the successors";
  if (state.lp(n) != parent) return "lp is not the argmin of smallest index";
  if (!penalty.empty() && state.dist(n).raw != penalty[n]) return "dist is not the penalty";
  if (penalty.empty() && state.dist(n).raw != 0) return "dist without clearance";
  if (state.queued(n) != (state.g(n) != state.rhs(n))) return "in U and consistent, or the other way round";
  const oracle::Raw key =
      std::min(state.g(n).raw, state.rhs(n).raw) + state.km().raw +
      oracle::estimate(world, rules, heuristic_of(script.settings), state.node(Scalar::start), n);
  if (state.queued(n) && state.k1(n).raw > key) return "the key in U is above the true one";
  return "";
}

template <int D>
void check_invariants(const Script<D>& script, const BoxLattice<D>& lattice, const SearchState& state) {
  const oracle::World world = plain_world(lattice);
  const auto penalty = expected_penalties(*script.info, script.settings, world);
  for (NodeId n = 0; n < lattice.node_count(); ++n)
    ASSERT_EQ(broken_invariant<D>(script, world, penalty, state, n), "") << "node " << n;
}

class FamilyLog : public ::testing::TestWithParam<const char*> {};

template <int D>
void check_replayed_values(const char* id, std::uint64_t seed) {
  const Script<D> script = random_script<D>(*find_planner(id), seed, 12);
  SCOPED_TRACE(describe_settings(*script.info, script.settings) + ", seed " + std::to_string(seed));
  Player<D> player(script);
  SearchState state(player.lattice().node_count(), script.info->values.all_fields());
  std::size_t applied = 0;
  const auto catch_up = [&] {
    for (; applied < player.log().size(); ++applied) state.apply(player.log()[applied]);
    check_invariants(script, player.lattice(), state);
  };
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    player.change(i);
    catch_up();
    for (bool done = false; !done;) {  // the invariants hold before every iteration
      done = player.planner().advance(1);
      catch_up();
      ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "step " << i;
    }
    if (player.planner().cost().raw != oracle::kNever) {
      ASSERT_EQ(player.planner().cost(), state.rhs(state.node(Scalar::start)));
      ASSERT_EQ(state.g(state.node(Scalar::start)), state.rhs(state.node(Scalar::start)));
    }
    ASSERT_EQ(state.node(Scalar::goal), script.goal);
  }
}

TEST_P(FamilyLog, replayedValuesKeepTheInvariantsBeforeEveryIterationIn2d) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) check_replayed_values<2>(GetParam(), seed);
}
TEST_P(FamilyLog, replayedValuesKeepTheInvariantsBeforeEveryIterationIn3d) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) check_replayed_values<3>(GetParam(), seed);
}
INSTANTIATE_TEST_SUITE_P(Family, FamilyLog, ::testing::ValuesIn(kFamily), [](const auto& param) {
  std::string name = param.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

/// The length of a straight way, rounded up.
oracle::Raw straight_up(const oracle::World& world, NodeId a, NodeId b) {
  const oracle::Place p = world.place(a), q = world.place(b);
  std::int64_t squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    squared += std::int64_t{p[axis] - q[axis]} * (p[axis] - q[axis]);
  const oracle::Raw down = oracle::root_floor(squared);
  return down +
         (down % oracle::kUnit == 0 && down / oracle::kUnit * (down / oracle::kUnit) == squared ? 0 : 1);
}

/// What the straight way between two nodes costs: one step, or as many as a jump takes.
oracle::Raw straight_between(const oracle::World& world, NodeId a, NodeId b) {
  const auto p = world.place(a), q = world.place(b);
  int steps = 0, axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    steps = std::max(steps, std::abs(p[axis] - q[axis]));
    axes += p[axis] != q[axis] ? 1 : 0;
  }
  return steps * oracle::step(axes);
}

/// Best-first searches by their log: every settled or open node has its parent's cost plus one step, or one jump, or
/// more while the parent waits in the list with a better one. Of an any-angle search the way to the remote parent is
/// straight, and it may cost more than that for good: what else has a better way to the parent need not pass the node.
template <int D>
void check_forward_values(const PlannerInfo& info, std::uint64_t seed) {
  const Script<D> script = random_script<D>(info, seed, 6);
  Player<D> player(script);
  SearchState state(player.lattice().node_count(), script.info->values.all_fields());
  std::size_t applied = 0;
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    player.play(i);
    for (; applied < player.log().size(); ++applied) state.apply(player.log()[applied]);
    const oracle::World world = plain_world(player.lattice());
    const auto penalty = expected_penalties(info, script.settings, world);
    for (NodeId n = 0; n < world.blocked.size(); ++n) {
      ASSERT_EQ(state.dist(n).raw, penalty.empty() ? 0 : penalty[n]) << "node " << n;
      if (state.g(n).is_infinite()) {
        ASSERT_TRUE(state.lp(n) == kNoNode && !state.queued(n)) << "node " << n;
      } else if (n != state.node(Scalar::start)) {
        const NodeId parent = state.lp(n);
        ASSERT_NE(parent, kNoNode);
        if (!info.point_only.empty()) {  // its values are those of corners: parents have a lower g
          ASSERT_LT(state.g(parent), state.g(n)) << "node " << n;
          continue;
        }
        if (info.any_angle) {
          ASSERT_NE(state.rp(n), kNoNode);
          ASSERT_GE(state.g(n).raw, state.g(state.rp(n)).raw + straight_up(world, state.rp(n), n))
              << "node " << n;
          continue;
        }
        const oracle::Raw through =
            state.g(parent).raw + straight_between(world, parent, n) + state.dist(n).raw;
        ASSERT_TRUE(state.g(n).raw == through || (state.g(n).raw > through && state.queued(parent)))
            << "node " << n;
      }
    }
  }
}

TEST(ForwardLog, everyReachedNodeCostsItsParentPlusOneStepAndNothingStaysOfAnEarlierSearch) {
  for (const PlannerInfo& info : planners())
    if (!info.incremental && !info.from_goal)
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(std::string(info.id) + ", seed " + std::to_string(seed));
        check_forward_values<2>(info, seed);
        if (!info.planar) check_forward_values<3>(info, seed);
      }
}

template <int D>
void check_backwards(const PlannerInfo& info, std::uint64_t seed) {
  SCOPED_TRACE(std::string(info.id) + ", seed " + std::to_string(seed));
  const Script<D> script = random_script<D>(info, seed, 4);
  Player<D> player(script);
  for (std::size_t i = 0; i < script.steps.size(); ++i) player.play(i);
  SearchState state(player.lattice().node_count(), script.info->values.all_fields());
  std::vector<std::uint64_t> hashes;
  std::vector<SearchState> before_epochs;  // what an epoch forgets is not in the log
  for (const Event& event : player.log()) {
    hashes.push_back(state.hash());
    if (event.kind == EventKind::epoch) before_epochs.push_back(state);
    state.apply(event);
  }
  for (std::size_t i = player.log().size(); i-- > 0;) {
    if (player.log()[i].kind == EventKind::epoch) {
      state = before_epochs.back();
      before_epochs.pop_back();
    } else {
      state.apply(player.log()[i]);
    }
    ASSERT_EQ(state.hash(), hashes[i]) << "event " << i;
  }
  ASSERT_EQ(state.hash(),
            SearchState(player.lattice().node_count(), script.info->values.all_fields()).hash());
}

TEST(Log, appliedBackwardsLeadsThroughTheSameStates) {
  for (const PlannerInfo& info : planners())
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      check_backwards<2>(info, seed);
      if (!info.planar) check_backwards<3>(info, seed);
    }
}

/// The work that the log shows, from the latest begin() on.
struct WorkMeter {
  Counters counters;
  std::int64_t iterations = 0;  ///< of the main loop since the last change
  void take(const Event& event, const SearchState& after) {
    if (event.kind == EventKind::pop) ++iterations;
    if (event.kind == EventKind::visit && after.value(EventKind::visit, event.node) != 0)
      ++counters.expansions;
    if (event.kind == EventKind::queue && event.line != 1) ++counters.queue_operations;
    if (event.kind == EventKind::sight) ++counters.sight_checks;
  }
};

/// `log` from event `at` on is `rest`.
void expect_same_rest(std::span<const Event> log, std::size_t at, std::span<const Event> rest) {
  ASSERT_EQ(log.size() - at, rest.size());
  for (std::size_t k = 0; k < rest.size(); ++k)
    ASSERT_EQ(log[at + k], rest[k]) << "event " << at + k << ", " << k << " after the restart";
}

/// Takes the search up in the state before event `at` of step `i`, plays to the end and compares the logs.
template <int D>
void check_taken_up(const Script<D>& script, std::span<const Event> log, const Marks& marks, std::size_t i,
                    std::size_t at, const SearchState& state, const WorkMeter& meter) {
  Player<D> player(script);
  player.show_map_of(i);
  player.planner().restore(state, meter.counters);
  if (at < marks.searched) player.search(i, meter.iterations);
  if (at <= marks.searched) player.read_path();
  for (std::size_t k = i + 1; k < script.steps.size(); ++k) player.play(k);
  expect_same_rest(log, at, player.log());
}

template <int D>
void check_restore(const PlannerInfo& info, std::uint64_t seed) {
  Random random(seed);
  const Script<D> script = random_script<D>(info, seed, 5);
  SCOPED_TRACE(describe_settings(info, script.settings) + ", seed " + std::to_string(seed));
  Player<D> player(script);
  std::vector<Marks> marks;
  for (std::size_t i = 0; i < script.steps.size(); ++i) marks.push_back(player.play(i));
  const std::span<const Event> log = player.log();
  SearchState state(player.lattice().node_count(), script.info->values.all_fields());
  WorkMeter meter;
  for (std::size_t at = 0, i = 0; at <= log.size(); ++at) {
    while (i + 1 < marks.size() && at > marks[i].done) ++i;
    if (at == marks[i].changed) meter.iterations = 0;
    const bool before_pop =
        at >= marks[i].changed && at < marks[i].searched && log[at].kind == EventKind::pop;
    const bool standing = at == marks[i].searched || at == marks[i].done;
    if ((before_pop && random.chance(0.25)) || standing) {
      check_taken_up(script, log, marks[i], i, at, state, meter);
      ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "taken up at event " << at << " in step " << i;
    }
    if (at == log.size()) break;
    state.apply(log[at]);
    meter.take(log[at], state);
  }
}

class EveryLog : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(EveryLog, aSearchTakenUpFromItsLogGoesOnEventForEventIn2d) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) check_restore<2>(*GetParam(), seed);
}
TEST_P(EveryLog, aSearchTakenUpFromItsLogGoesOnEventForEventIn3d) {
  if (GetParam()->planar) GTEST_SKIP() << "plans in the plane alone";
  for (std::uint64_t seed = 0; seed < 30; ++seed) check_restore<3>(*GetParam(), seed);
}

INSTANTIATE_TEST_SUITE_P(Planners, EveryLog, ::testing::ValuesIn(each_of(planners())), planner_test_name);

TEST_P(EveryLog, holdsNoValueThatThePlannerHasNotDeclared) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Script<2> script = random_script<2>(*GetParam(), seed, 4);
    Player<2> player(script);
    for (std::size_t i = 0; i < script.steps.size(); ++i) player.play(i);
    for (const Event& event : player.log()) {
      if (!is_wide(event.kind)) continue;
      const std::vector<Field> declared = GetParam()->values.all_fields();
      ASSERT_TRUE(std::any_of(declared.begin(), declared.end(),
                              [&](const Field& field) { return field.kind == event.kind; }))
          << static_cast<int>(event.kind) << ", seed " << seed;
    }
  }
}

// Also after the search was taken up in between: the log does not show how the open list is laid out.
TEST_P(EveryLog, anotherBeginAfterTakingUpIsRecordedTheSame) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Script<2> script = random_script<2>(*GetParam(), seed, 0);
    script.steps[0].budget = 12;
    Player<2> first(script), second(script);
    first.play(0);
    SearchState state(first.lattice().node_count(), script.info->values.all_fields());
    for (const Event& event : first.log()) state.apply(event);
    second.planner().restore(state, first.planner().counters());
    const std::size_t before = first.log().size();
    first.change(0);
    second.change(0);
    expect_same_rest(first.log(), before, second.log());
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "seed " << seed;
  }
}

// A second begin() in one log starts from nothing again, on the record.
TEST_P(EveryLog, anotherBeginInTheSameLogForgetsTheFirstSearch) {
  const Script<2> script = random_script<2>(*GetParam(), 7, 3);
  Player<2> player(script);
  for (std::size_t i = 0; i < script.steps.size(); ++i) player.play(i);
  const std::size_t first = player.log().size();
  player.planner().begin(script.steps[0].start, script.goal);
  finish(player.planner());
  SearchState twice(player.lattice().node_count(), script.info->values.all_fields()), once(twice);
  for (const Event& event : player.log()) twice.apply(event);
  Script<2> alone = script;
  alone.cells.assign(player.lattice().cells().begin(), player.lattice().cells().end());
  alone.steps[0].budget = 0;
  Player<2> fresh(alone);
  fresh.change(0);
  fresh.search(0);
  for (const Event& event : fresh.log()) once.apply(event);
  EXPECT_EQ(twice.hash(), once.hash()) << "after " << first << " events of the first run";
  EXPECT_EQ(player.planner().counters().expansions, fresh.planner().counters().expansions);
}

}  // namespace
}  // namespace replan::test::planner_log_test
