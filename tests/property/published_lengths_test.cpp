// Lengths that others published: every problem file of the shared benchmark data, the dynamic track of the
// Grid-Based Path Planning Competition, and the project's own replanning workloads.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/registry.hpp"
#include "core/world/formats/movingai.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::test::published_lengths_test {
namespace {

/// A whole file takes about a second up to this many cells x problems; beyond it a sample is taken.
constexpr std::int64_t kWholeFileWork = 40'000'000;
constexpr std::size_t kSample = 60;

std::vector<ScenProblem> chosen_problems(const ScenFile& scen, std::int64_t free_cells) {
  const std::size_t count = scen.problems.size();
  if (static_cast<std::int64_t>(count) * free_cells <= kWholeFileWork || count <= kSample)
    return scen.problems;
  std::vector<ScenProblem> sample;
  for (std::size_t i = 0; i < kSample; ++i) sample.push_back(scen.problems[i * (count - 1) / (kSample - 1)]);
  return sample;
}

/// Trees and deep water in icecrown are terrain of their own, which the project reads as obstacles: see the
/// data's README. Such problems start or end in one.
bool between_other_terrain(const Grid2& lattice, const ScenProblem& problem) {
  return lattice.blocked(lattice.node(problem.start)) || lattice.blocked(lattice.node(problem.goal));
}

void check_file(const std::filesystem::path& path, const char* id) {
  const auto scen = read_scen(path.string());
  ASSERT_TRUE(scen.ok()) << scen.error();
  const auto map_path = map_beside(path.string(), scen->map_name);
  ASSERT_TRUE(map_path.ok()) << map_path.error();
  const auto map = read_movingai_map(*map_path);
  ASSERT_TRUE(map.ok()) << map.error();
  const Grid2 lattice({map->width, map->height}, map->blocked.plain());
  NoTrace trace;
  const auto planner = make_planner(*find_planner(id), lattice, {}, trace);
  const auto problems = chosen_problems(*scen, std::count(map->blocked.begin(), map->blocked.end(), 0));
  int other_terrain = 0;
  for (const ScenProblem& problem : problems) {
    if (between_other_terrain(lattice, problem)) {
      ++other_terrain;
      continue;
    }
    planner->begin(lattice.node(problem.start), lattice.node(problem.goal));
    ASSERT_EQ(finish(*planner), PlanStatus::found) << path << ':' << problem.line;
    const double length = path_length(planner->path());
    ASSERT_TRUE(scen->agrees(length, problem))
        << path << ':' << problem.line << ": found " << length << ", listed " << problem.printed;
    ASSERT_NEAR(planner->cost().to_double(), length, 1e-5);
  }
  EXPECT_LE(other_terrain, path.stem() == "icecrown.map" ? 3 : 0) << path;
  std::printf("%s, %s: %zu of %zu problems agree\n", path.filename().c_str(), id,
              problems.size() - static_cast<std::size_t>(other_terrain), scen->problems.size());
}

class PublishedLengths : public ::testing::TestWithParam<const char*> {};

TEST_P(PublishedLengths, ofEveryMovingAiFileAreFound) {
  REPLAN_NEED_SHARED_DATA();
  const auto files = files_below(shared_data() / "movingai", ".scen");
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    check_file(file, GetParam());
    ASSERT_FALSE(HasFatalFailure());
  }
}
INSTANTIATE_TEST_SUITE_P(Planners, PublishedLengths,
                         ::testing::Values("astar", "dstar-lite", "lpa-star", "jps"), [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// The dynamic track: patches that overwrite parts of an all-free grid, and queries between them.
struct DynamicTrack {
  struct Patch {
    int width = 0, height = 0;
    std::vector<std::string> rows;
  };
  struct Command {
    bool query = false;
    int patch = 0;
    Cell from, to;  ///< a patch's top left is `from`
    double length = 0;
  };
  int width = 0, height = 0;
  std::vector<Patch> patches;
  std::vector<Command> commands;
};

bool read_patches(const std::filesystem::path& path, DynamicTrack& track) {
  std::ifstream in(path);
  std::string word;
  std::size_t count = 0;
  in >> word >> word >> word >> count;
  for (std::size_t i = 0; in && i < count; ++i) {
    DynamicTrack::Patch patch;
    in >> word >> word >> word >> patch.height >> word >> patch.width >> word;
    patch.rows.resize(static_cast<std::size_t>(patch.height));
    for (std::string& row : patch.rows) in >> row;
    track.patches.push_back(patch);
  }
  return static_cast<bool>(in) && track.patches.size() == count;
}

bool read_track(const std::filesystem::path& folder, DynamicTrack& track) {
  std::ifstream in(folder / "dao_arena2.scen");
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    int snapshot = 0;
    DynamicTrack::Command command;
    if (word == "height")
      words >> track.height;
    else if (word == "width")
      words >> track.width;
    else if (word == "P")
      words >> snapshot >> command.patch >> command.from.x >> command.from.y;
    else if (word == "Q")
      words >> snapshot >> command.from.x >> command.from.y >> command.to.x >> command.to.y >> command.length;
    command.query = word == "Q";
    if (word == "P" || word == "Q") track.commands.push_back(command);
  }
  return read_patches(folder / "dao_arena2.patch", track);
}

std::vector<CellEdit> patch_edits(const DynamicTrack& track, const DynamicTrack::Command& command,
                                  const Grid2& lattice) {
  const auto& patch = track.patches[static_cast<std::size_t>(command.patch)];
  std::vector<CellEdit> edits;
  for (int y = 0; y < patch.height; ++y)
    for (int x = 0; x < patch.width; ++x) {
      const NodeId node = lattice.node(Cell{command.from.x + x, command.from.y + y});
      const char letter = patch.rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      const bool blocked = letter != '.';
      if (lattice.blocked(node) != blocked) edits.push_back({node, blocked});
    }
  return edits;
}

bool same_length(double found, double listed) {
  return listed < 0 ? std::isinf(found) : std::abs(found - listed) < 1e-6;
}

TEST(DynamicTrack, everyQueryHasItsPublishedLength) {
  REPLAN_NEED_SHARED_DATA();
  DynamicTrack track;
  ASSERT_TRUE(read_track(shared_data() / "dynamic", track));
  Grid2 lattice({track.width, track.height});
  NoTrace trace;
  const auto astar = make_planner(*find_planner("astar"), lattice, {}, trace);
  const auto dstar = make_planner(*find_planner("dstar-lite"), lattice, {}, trace);
  int queries = 0;
  for (const auto& command : track.commands) {
    if (!command.query) {
      lattice.apply(patch_edits(track, command, lattice));
      continue;
    }
    ++queries;
    for (auto* planner : {astar.get(), dstar.get()}) {
      if (planner == dstar.get() && queries % 10 != 0) continue;
      planner->begin(lattice.node(command.from), lattice.node(command.to));
      const bool found = finish(*planner) == PlanStatus::found;
      const double length = found ? path_length(planner->path()) : HUGE_VAL;
      ASSERT_TRUE(same_length(length, command.length)) << "query " << queries << ": " << length;
    }
  }
  EXPECT_EQ(queries, 2000);
}

/// Each member of the family, one goal, the start moving from query to query, through all changes.
TEST(DynamicTrack, dStarLiteCarriedThroughAllChangesEqualsAFreshPlan) {
  REPLAN_NEED_SHARED_DATA();
  DynamicTrack track;
  ASSERT_TRUE(read_track(shared_data() / "dynamic", track));
  Grid2 lattice({track.width, track.height});
  NoTrace trace;
  const PlannerInfo& info = *find_planner("dstar-lite");
  const auto carried = make_planner(info, lattice, {}, trace), fresh = make_planner(info, lattice, {}, trace);
  const auto astar = make_planner(*find_planner("astar"), lattice, {}, trace);
  const NodeId goal = lattice.node(Cell{track.width / 2, track.height / 2});
  NodeId start = lattice.node(track.commands.front().from);
  carried->begin(start, goal);
  int patches = 0, compared = 0;
  for (std::size_t i = 0; i < track.commands.size(); ++i) {
    const auto& command = track.commands[i];
    if (command.query) {
      start = lattice.node(command.from);
      continue;
    }
    const auto edits = patch_edits(track, command, lattice);
    const auto moves = lattice.apply(edits);
    carried->update({.cells = edits, .moves = moves}, start);
    ++patches;
    if (i + 1 < track.commands.size() && !track.commands[i + 1].query) continue;
    finish(*carried);
    fresh->begin(start, goal);
    finish(*fresh);
    astar->begin(start, goal);
    finish(*astar);
    ASSERT_EQ(carried->cost(), fresh->cost()) << "after " << patches << " patches";
    ASSERT_EQ(carried->cost(), astar->cost()) << "after " << patches << " patches";
    ASSERT_EQ(carried->status(), fresh->status());
    ++compared;
  }
  EXPECT_EQ(patches, 439);
  EXPECT_GE(compared, 90);
}

/// Whether a cost is the length in an .ev file. Those lengths were summed up step by step in single
/// precision: rand512_20 begins with 291 straight and 274 diagonal steps, 678.494516, and lists 678.492981.
/// So they decide to 5e-6 of themselves, and a fresh A* plan decides exactly.
bool is_optimum(Cost cost, double optimum) {
  if (optimum < 0) return cost.is_infinite();
  return std::abs(cost.to_double() - optimum) <= 5e-6 * optimum;
}

void check_workload(const std::filesystem::path& path) {
  SCOPED_TRACE(path.filename().string());
  std::ifstream in(path);
  std::string map_name;
  Cell start, goal;
  double optimum = 0;
  std::size_t events = 0;
  in >> map_name >> start.x >> start.y >> goal.x >> goal.y >> optimum >> events;
  const auto map = read_movingai_map((path.parent_path() / map_name).string());
  ASSERT_TRUE(map.ok()) << map.error();
  Grid2 lattice({map->width, map->height}, map->blocked.plain());
  NoTrace trace;
  const auto planner = make_planner(*find_planner("dstar-lite"), lattice, {}, trace);
  const auto fresh = make_planner(*find_planner("astar"), lattice, {}, trace);
  const auto check = [&] {
    finish(*planner);
    finish(*fresh);
    ASSERT_EQ(planner->cost(), fresh->cost());
    ASSERT_TRUE(is_optimum(planner->cost(), optimum))
        << planner->cost().to_double() << " instead of " << optimum;
  };
  planner->begin(lattice.node(start), lattice.node(goal));
  fresh->begin(lattice.node(start), lattice.node(goal));
  check();
  for (std::size_t i = 0; i < events; ++i) {
    Cell robot;
    std::size_t count = 0;
    in >> robot.x >> robot.y >> optimum >> count;
    std::vector<CellEdit> edits(count);
    for (CellEdit& edit : edits) {
      Cell cell;
      in >> cell.x >> cell.y >> edit.blocked;
      edit.node = lattice.node(cell);
    }
    ASSERT_TRUE(static_cast<bool>(in)) << "event " << i;
    const auto moves = lattice.apply(edits);
    planner->update({.cells = edits, .moves = moves}, lattice.node(robot));
    fresh->update({.cells = edits, .moves = moves}, lattice.node(robot));
    check();
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "event " << i;
  }
}

TEST(ReplanningWorkloads, everyReplanHasTheListedOptimum) {
  REPLAN_NEED_SHARED_DATA();
  int files = 0;
  for (const auto& file : files_below(shared_data() / "events", ".ev")) {
    if (file.filename().string().starts_with("rand2048"))
      continue;  // its map alone takes seconds under sanitizers
    check_workload(file);
    ++files;
  }
  EXPECT_GE(files, 12);
}

}  // namespace
}  // namespace replan::test::published_lengths_test
