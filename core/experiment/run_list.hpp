// The runs of an experiment: its worlds loaded, and each run with its number, what it is made of, and the scenario that it
// is.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "core/experiment/experiment.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// A world of an experiment as its file has it.
struct LoadedWorld {
  std::string file;  ///< as the experiment calls it
  /// One for each question; of a scenario or a map one alone, with line 0 and nothing printed.
  std::vector<ScenProblem> problems;
  LengthFormat lengths;  ///< of the problems' listed lengths
  Scenario scenario;     ///< the map; of a scenario its robot, surprises and moving obstacles besides
  std::vector<std::string> notes;  ///< what there is to say of the map, a sentence each
  std::string map_file;            ///< its map's file, as opened
  std::uint64_t digest = 0;        ///< of the bytes of its files and the cells of its map

  /// Whether it is a file of problems.
  [[nodiscard]] bool lengths_are_listed() const { return !problems.empty() && problems.front().line > 0; }
};
Result<LoadedWorld> load_world(const Experiment& experiment, const ExperimentWorld& world);

/// `limit` problems spread evenly over the file in its order, the first and the last among them; all if there
/// are no more than that. 0: all.
std::vector<ScenProblem> even_sample(const std::vector<ScenProblem>& problems, std::size_t limit);

/// What a run is made of: places in the lists of its experiment.
struct RunParts {
  std::size_t world = 0, robot = 0, planner = 0, problem = 0, surprises = 0, seed = 0;
  friend bool operator==(const RunParts&, const RunParts&) = default;
};

/// What a run is called in results, whatever its number: two experiments are compared by this.
struct RunName {
  std::string world = {};             ///< its file
  int line = 0;                       ///< of the problem in its file; 0: the file has one question alone
  std::string start = {}, goal = {};  ///< "3 4"
  std::string planner = {};           ///< registry id
  std::string settings = {};          ///< settings_label() ...
  std::string stages = {};
  std::string robot = {};
  std::string surprises = {};
  std::uint64_t seed = 0;
  [[nodiscard]] auto all() const {
    return std::tie(world, line, start, goal, planner, settings, stages, robot, surprises, seed);
  }
  friend bool operator==(const RunName&, const RunName&) = default;
  // Not by <=>, which not every standard library has for strings.
  friend bool operator<(const RunName& a, const RunName& b) { return a.all() < b.all(); }
};

/// The planner with its settings and stages: "weighted-astar weight=2 | bspline".
std::string planner_label(const RunName& name);

/// All runs of an experiment. They are numbered from 0: worlds are the slowest digit, then robots, planners, problems,
/// surprises, and seeds are the fastest. Where nothing depends on the seed, neither the planner nor the surprises, there is
/// the run of the first seed alone: the others would be the same once more.
class RunList {
 public:
  /// Loads the worlds and checks that every planner can plan in each of them for every robot. `loaded` are the first of
  /// them where they have been loaded already.
  static Result<RunList> load(Experiment experiment, std::vector<LoadedWorld> loaded = {});
  /// The runs in worlds that are there already, unchecked.
  RunList(Experiment experiment, std::vector<LoadedWorld> worlds, std::uint64_t digest);

  [[nodiscard]] const Experiment& experiment() const { return experiment_; }
  [[nodiscard]] std::span<const LoadedWorld> worlds() const { return worlds_; }
  [[nodiscard]] std::int64_t count() const { return groups_.back().first; }
  /// Of all that results depend on: the experiment with every planner's settings, the bytes of its files, and which version
  /// of the figures these are. 16 hexadecimal digits.
  [[nodiscard]] const std::string& digest() const { return digest_; }

  /// `run` is a number below count().
  [[nodiscard]] RunParts parts(std::int64_t run) const;
  [[nodiscard]] RunName name(const RunParts& parts) const;
  /// The planner with the run's seed.
  [[nodiscard]] PlannerChoice choice(const RunParts& parts) const;
  [[nodiscard]] RobotSetup robot(const RunParts& parts) const;
  [[nodiscard]] const LoadedWorld& world(const RunParts& parts) const { return worlds_[parts.world]; }
  [[nodiscard]] const ScenProblem& problem(const RunParts& parts) const {
    return worlds_[parts.world].problems[parts.problem];
  }
  /// Whether its robot drives, or it is planned once.
  [[nodiscard]] bool drives(const RunParts& parts) const;
  /// Whether a length that was found is held against the one that the file lists: the planner finds shortest paths under
  /// the rules that such files were made with, for a robot without a size.
  [[nodiscard]] bool length_is_listed(const RunParts& parts) const;
  /// Start or goal lies in an obstacle of the map, and no scenario has made it so.
  [[nodiscard]] bool skipped(const RunParts& parts) const;
  /// The run as a document: opened and run it gives the run's results.
  [[nodiscard]] Scenario scenario(const RunParts& parts) const;

 private:
  /// Runs of one world, robot and planner, which follow each other.
  struct Group {
    std::int64_t first = 0;
    std::size_t world = 0, robot = 0, planner = 0;
  };

  [[nodiscard]] std::size_t seeds(std::size_t planner, std::size_t surprises) const;
  [[nodiscard]] std::int64_t runs_a_problem(std::size_t planner) const;
  void number_runs();

  Experiment experiment_;
  std::vector<LoadedWorld> worlds_;
  std::vector<Group> groups_;  // and one behind the last
  std::string digest_;
};

/// Whether the lengths of MovingAI files are what a planner must find with these settings: it finds shortest
/// lattice paths, under the rules that the lengths were made with (8 neighbours, no corner cut).
bool lengths_apply(const PlannerChoice& choice);

}  // namespace replan
