// replan_ompl_bench: our planners that sample beside OMPL's, on the same maps, with the same exact test of ways, in one run.
//   replan_ompl_bench DATA [--seeds N] [--seconds S] [--only MAP]
// DATA is the folder that holds movingai/ and anyangle/computed.tsv. Races of both sides take turns, seed by seed. Printed are
// medians over the seeds: when there was a path, and what the path came to after 0.1, 1, 10 s, over the optimum; a race without
// a path by then counts as one that is endlessly long.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/world/formats/movingai.hpp"
#include "race.hpp"

namespace {

using namespace replan;
using namespace replan::bench;

constexpr double kMoments[] = {0.1, 1, 10};  // seconds
constexpr double kNever = std::numeric_limits<double>::infinity();

struct Options {
  std::string data, only;
  std::uint32_t seeds = 20;
  double seconds = 10;
};

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--seeds" && i + 1 < argc)
      options.seeds = static_cast<std::uint32_t>(std::max(1, std::atoi(argv[++i])));
    else if (argument == "--seconds" && i + 1 < argc)
      options.seconds = std::atof(argv[++i]);
    else if (argument == "--only" && i + 1 < argc)
      options.only = argv[++i];
    else
      options.data = argument;
  }
  return options;
}

/// The longest question of each map, with its exact optimum.
std::vector<RaceProblem> read_problems(const std::string& table) {
  std::vector<RaceProblem> problems;
  std::ifstream in(table);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    RaceProblem read;
    double between_corners = 0;
    if (!(words >> read.name >> read.start.x >> read.start.y >> read.goal.x >> read.goal.y >>
          between_corners >> read.optimum))
      continue;
    if (problems.empty() || problems.back().name != read.name) problems.emplace_back();
    if (problems.back().optimum < read.optimum) problems.back() = read;
  }
  return problems;
}

double first(const Race& race) {
  return race.empty() ? kNever : race.front().seconds;
}
double cost_by(const Race& race, double seconds) {
  double cost = kNever;
  for (const Gain& gain : race)
    if (gain.seconds <= seconds) cost = gain.cost;
  return cost;
}
double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Side {
  std::vector<Race> races;
  [[nodiscard]] double first_ms() const {
    return 1000 * of([](const Race& race) { return first(race); });
  }
  [[nodiscard]] double cost(double seconds) const {
    return of([seconds](const Race& race) { return cost_by(race, seconds); });
  }

 private:
  template <class Read>
  [[nodiscard]] double of(Read&& read) const {
    std::vector<double> values;
    for (const Race& race : races) values.push_back(read(race));
    return median(std::move(values));
  }
};

std::string told(double value, const char* format) {
  if (value == kNever) return "none";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}
void print_pair(double ours, double theirs, const char* format) {
  std::printf(" %s / %s |", told(ours, format).c_str(), told(theirs, format).c_str());
}

void print_row(const RaceProblem& problem, Racer racer, const Options& options) {
  Side ours, theirs;
  for (std::uint32_t seed = 1; seed <= options.seeds; ++seed) {
    ours.races.push_back(run_ours(problem, racer, seed, options.seconds));
    theirs.races.push_back(run_theirs(problem, racer, seed, options.seconds));
  }
  std::printf("| %s | %s |", problem.name.c_str(), racer_name(racer));
  print_pair(ours.first_ms(), theirs.first_ms(), "%.3g");
  for (const double seconds : kMoments)
    if (seconds <= options.seconds)
      print_pair(ours.cost(seconds) / problem.optimum, theirs.cost(seconds) / problem.optimum, "%.4f");
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = parse(argc, argv);
  auto problems = read_problems(options.data + "/anyangle/computed.tsv");
  std::erase_if(problems, [&](const RaceProblem& problem) {
    return !options.only.empty() && problem.name.find(options.only) == std::string::npos;
  });
  if (problems.empty()) {
    std::fprintf(stderr, "Name the folder that holds anyangle/computed.tsv and movingai/.\n");
    return 2;
  }
  std::printf("Ours / OMPL's, medians of %u seeds; costs over the optimum.\n\n", options.seeds);
  std::printf("| map | planner | first path, ms |");
  for (const double seconds : kMoments)
    if (seconds <= options.seconds) std::printf(" after %g s |", seconds);
  std::printf("\n|---|---|---|---|---|---|\n");
  for (RaceProblem& problem : problems) {
    const auto map = read_movingai_map(options.data + "/movingai/" + problem.name + ".map");
    if (!map) {
      std::fprintf(stderr, "%s\n", map.error().c_str());
      return 1;
    }
    const Grid2 world({map->width, map->height}, map->blocked.plain());
    problem.world = &world;
    // As long as OMPL makes it where nothing else is asked for: a fifth of the diagonal.
    problem.step = 0.2 * std::hypot(map->width, map->height);
    for (const Racer racer : kRacers) print_row(problem, racer, options);
  }
  return 0;
}
