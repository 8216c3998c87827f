// Theta* and Lazy Theta* on the shared maps: never longer than A*'s path, and never shorter than the shortest
// any-angle path, of which 101 lengths were published (Grid-Based Path Planning Competition) and 1602 computed.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/registry.hpp"
#include "core/world/formats/movingai.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::test::any_angle_lengths_test {
namespace {

/// Two ends on a map, and how long the shortest any-angle path between their centres is at least.
struct Question {
  Cell start, goal;
  double least = 0;
  double lattice = 0;  ///< the shortest lattice path; 0: not listed
};

/// What a planner came to over many questions, against the listed lengths.
struct Tally {
  std::int64_t questions = 0, shorter = 0;
  double over_optimum = 0, under_astar = 0, most_over = 0;  // sums of ratios; the largest
  double seconds = 0, astar_seconds = 0;
};

/// The path's length, and the processor time of planning.
std::pair<double, double> length_and_seconds(Planner<Grid2>& planner, const Grid2& map,
                                             const Question& question) {
  const std::clock_t begin = std::clock();
  planner.begin(map.node(question.start), map.node(question.goal));
  EXPECT_EQ(finish(planner), PlanStatus::found);
  const Path path = planner.path();
  const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_TRUE(path_is_free(map, path));
  return {path_length(path), took};
}

void ask(const Grid2& map, const std::vector<Question>& questions, std::map<std::string, Tally>& tallies) {
  NoTrace nobody;
  const auto astar = make_planner(*find_planner("astar"), map, {}, nobody);
  for (const char* id : {"theta-star", "lazy-theta-star"}) {
    const auto planner = make_planner(*find_planner(id), map, {}, nobody);
    Tally& tally = tallies[id];
    for (const Question& question : questions) {
      const auto [length, seconds] = length_and_seconds(*planner, map, question);
      const auto [lattice, astar_seconds] = length_and_seconds(*astar, map, question);
      ASSERT_LE(planner->cost(), astar->cost()) << id;
      ASSERT_LE(length, lattice + 1e-9) << id;
      ASSERT_GE(length, question.least - 1e-6) << id;
      ASSERT_TRUE(question.lattice == 0 || std::abs(lattice - question.lattice) <= 1e-4 * lattice + 0.006);
      ++tally.questions;
      tally.shorter += length < lattice - 1e-6 ? 1 : 0;
      tally.over_optimum += length / question.least - 1;
      tally.most_over = std::max(tally.most_over, length / question.least - 1);
      tally.under_astar += length / lattice - 1;
      tally.seconds += seconds;
      tally.astar_seconds += astar_seconds;
    }
  }
}

void tell(const std::string& what, const std::map<std::string, Tally>& tallies) {
  for (const auto& [id, tally] : tallies) {
    const auto percent = [&tally = tally](double sum) {
      return 100 * sum / static_cast<double>(tally.questions);
    };
    std::printf(
        "%s, %s: %lld paths, %lld shorter than A*'s, %.3f %% on average; %.3f %% above the shortest on "
        "average, %.2f "
        "%% at most; %.2f times A*'s time\n",
        what.c_str(), id.c_str(), static_cast<long long>(tally.questions),
        static_cast<long long>(tally.shorter), percent(tally.under_astar), percent(tally.over_optimum),
        100 * tally.most_over, tally.seconds / tally.astar_seconds);
  }
}

std::unique_ptr<Grid2> read_lattice(const std::filesystem::path& path) {
  const auto map = read_movingai_map(path.string());
  EXPECT_TRUE(map.ok()) << map.error();
  return map ? std::make_unique<Grid2>(Grid2::Coordinates{map->width, map->height}, map->blocked.plain())
             : nullptr;
}

/// `computed.tsv`: centre_length is the shortest way of a point between the cells' centres.
TEST(AnyAngleLengths, areBetweenTheComputedOptimumAndAStar) {
  REPLAN_NEED_SHARED_DATA();
  std::ifstream in(shared_data() / "anyangle" / "computed.tsv");
  std::map<std::string, std::vector<Question>> by_map;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#') || line.empty()) continue;
    std::istringstream words(line);
    std::string map;
    Question question;
    double vertex_length = 0;
    words >> map >> question.start.x >> question.start.y >> question.goal.x >> question.goal.y >>
        vertex_length >> question.least >> question.lattice;
    ASSERT_TRUE(static_cast<bool>(words)) << line;
    by_map[map].push_back(question);
  }
  std::map<std::string, Tally> tallies;
  for (const auto& [name, questions] : by_map) {
    const auto lattice = read_lattice(shared_data() / "movingai" / (name + ".map"));
    ASSERT_NE(lattice, nullptr) << name;
    std::map<std::string, Tally> here;
    ask(*lattice, questions, here);
    ASSERT_FALSE(HasFatalFailure()) << name;
    tell(name, here);
    for (const auto& [id, tally] : here) {
      tallies[id].questions += tally.questions;
      tallies[id].shorter += tally.shorter;
      tallies[id].over_optimum += tally.over_optimum;
      tallies[id].under_astar += tally.under_astar;
      tallies[id].most_over = std::max(tallies[id].most_over, tally.most_over);
      tallies[id].seconds += tally.seconds;
      tallies[id].astar_seconds += tally.astar_seconds;
    }
  }
  tell("all", tallies);
  EXPECT_EQ(tallies["theta-star"].questions, 1602);
  // The shortest path turns at obstacles' corners, these at centres of cells beside them: near walls that shows.
  for (const auto& [id, tally] : tallies) {
    EXPECT_GT(tally.shorter, 1400) << id;
    EXPECT_LT(tally.over_optimum / static_cast<double>(tally.questions), 0.035) << id;
    EXPECT_LT(tally.under_astar / static_cast<double>(tally.questions), -0.04) << id;
  }
}

/// The published lengths are between the cells' top left corners, half a cell's diagonal from their centres.
TEST(AnyAngleLengths, areBetweenThePublishedOptimumAndAStar) {
  REPLAN_NEED_SHARED_DATA();
  const auto folder = shared_data() / "anyangle";
  const auto lattice = read_lattice(folder / "AcrosstheCape.map");
  ASSERT_NE(lattice, nullptr);
  std::ifstream in(folder / "AcrosstheCape.map.scen");
  std::vector<Question> questions;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string map;
    int bucket = 0, width = 0, height = 0;
    Question question;
    double length = 0;
    if (!(words >> bucket >> map >> width >> height >> question.start.x >> question.start.y >>
          question.goal.x >> question.goal.y >> length))
      continue;
    question.least = std::max(length - std::sqrt(2.0), 1e-9);
    questions.push_back(question);
  }
  EXPECT_EQ(questions.size(), 101u);
  const auto blocked = [&](const Question& question) {
    return lattice->blocked(lattice->node(question.start)) || lattice->blocked(lattice->node(question.goal));
  };
  const auto left_out = std::erase_if(questions, blocked);  // corners of a cell that is itself an obstacle
  std::printf("%zu published questions begin or end in an obstacle's cell\n", left_out);
  std::map<std::string, Tally> tallies;
  ask(*lattice, questions, tallies);
  tell("AcrosstheCape (at least the published length less two half diagonals)", tallies);
}

}  // namespace
}  // namespace replan::test::any_angle_lengths_test
