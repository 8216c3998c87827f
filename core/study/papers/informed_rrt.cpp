// The improved Informed RRT* against the original in worlds of rectangles.
//
//  Dai J., Li Z., Li Y. & Zhao J., "Robot path planning based on improved Informed-RRT* algorithm", 2022 (in Chinese),
//  tables 1 and 2
#include <algorithm>
#include <array>
#include <limits>

#include "core/base/cpu_time.hpp"
#include "core/study/anytime.hpp"
#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_runs.hpp"
#include "core/study/study_words.hpp"
#include "core/world/scenario.hpp"

namespace replan {
namespace {

enum Figure : std::size_t { kFirstSamples, kFirstTime, kFirstLength, kLastLength, kSameTime, kTime };
enum Entry : std::size_t { kOriginal, kImproved };
constexpr std::size_t kWorlds = 3;
constexpr const char* kIds[] = {"informed-rrt-star", "greedy-informed-rrt-star"};

/// One of the three worlds, and what its planners are set to there.
struct World {
  Scenario scenario;
  [[nodiscard]] const PlannerChoice& choice(Entry entry) const {
    for (const PlannerChoice& choice : scenario.planners)
      if (choice.id == kIds[entry]) return choice;
    return scenario.planners.front();
  }
};

Result<std::vector<World>> read_worlds() {
  std::vector<World> worlds;
  for (const char* name : {"informed-rrt-1.json", "informed-rrt-2.json", "informed-rrt-3.json"}) {
    auto read = library_scenario(name);
    if (!read) return Error{read.error()};
    worlds.push_back({std::move(*read)});
    for (const Entry entry : {kOriginal, kImproved})
      if (worlds.back().choice(entry).id != kIds[entry])
        return Error{std::string(name) + " does not have the planner " + kIds[entry] +
                     ", which the study compares"};
  }
  return worlds;
}

AnytimeRun plan_in(const World& world, Entry entry, std::uint64_t seed) {
  PlannerChoice choice = world.choice(entry);
  choice.settings.set("seed", static_cast<double>(seed));
  const Scenario& scenario = world.scenario;
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  return plan_anytime(scenario.map, scenario.start, scenario.goal, choice, scenario.robot.radius, kNoLimit,
                      {}, thread_cpu_ms);
}

/// The best path's length by then, in cells.
std::optional<double> length_by(const AnytimeRun& plan, double ms) {
  std::optional<double> length;
  for (const Gain& gain : plan.gains)
    if (gain.ms <= ms) length = gain.length;
  return length;
}

/// The first path, the one that has come of it when all samples are drawn, and the one that there was when the improved
/// method had drawn all of its own. Lengths in metres.
StudyRun run_once(const World& world, Entry entry, std::uint64_t seed) {
  const AnytimeRun plan = plan_in(world, entry, seed);
  const double metres = world.scenario.map.resolution;
  StudyRun run{.planner = entry, .seed = seed, .values = std::vector<std::optional<double>>(kTime + 1)};
  run.found = plan.found();
  run.values[kTime] = plan.ms;
  if (!run.found) return run;
  const Gain &first = plan.gains.front(), &last = plan.gains.back();
  run.values[kFirstSamples] = static_cast<double>(first.samples);
  run.values[kFirstTime] = first.ms;
  run.values[kFirstLength] = first.length * metres;
  run.values[kLastLength] = last.length * metres;
  const double until = entry == kImproved ? plan.ms : plan_in(world, kImproved, seed).ms;
  if (const auto length = length_by(plan, until)) run.values[kSameTime] = *length * metres;
  return run;
}

using ByWorld = std::array<double, kWorlds>;

/// By how much a figure of the improved method differs from the original's in each world: -0.2 is a fifth less.
ByWorld changes(const StudyReport& report, Figure figure) {
  ByWorld shares{};
  for (std::size_t w = 0; w < kWorlds; ++w) {
    const auto original = spread_of(report, figure, kOriginal, w),
               improved = spread_of(report, figure, kImproved, w);
    const auto value = [&](const Spread& spread) {
      return report.figures[figure].wall_time ? spread.median : spread.mean;
    };
    if (original && improved) shares[w] = value(*improved) / value(*original) - 1;
  }
  return shares;
}

/// Reproduced where it holds in each world; partly where each world's value has the sign of what the paper says at least.
template <class Holds>
Verdict verdict_of(const ByWorld& values, double sign, Holds&& holds) {
  if (std::all_of(values.begin(), values.end(), holds)) return Verdict::reproduced;
  const bool alike =
      std::all_of(values.begin(), values.end(), [sign](double value) { return value * sign > 0; });
  return alike ? Verdict::partly : Verdict::not_reproduced;
}
std::string changes_text(const ByWorld& shares) {
  return signed_percent(shares[0]) + ", " + signed_percent(shares[1]) + " and " + signed_percent(shares[2]);
}

StudyClaim time_claim(const StudyReport& report) {
  const ByWorld all = changes(report, kTime), first = changes(report, kFirstTime);
  return {
      "The improved method's planning takes less time: -88.93 %, -89.53 % and -83.22 % in the three worlds.",
      "The time for all samples: " + changes_text(all) +
          "; that up to the first path: " + changes_text(first) + ".",
      verdict_of(all, -1, [](double share) { return share <= -0.795; }),
      "The paper does not say which of the two it measured. After the first path the improved method looks "
      "at the "
      "path's few nodes alone, the original at its whole tree."};
}

StudyClaim length_claim(const StudyReport& report, Figure figure, const char* claim, const char* why) {
  const ByWorld shares = changes(report, figure);
  const Verdict verdict =
      verdict_of(shares, -1, [](double share) { return share <= -0.095 && share >= -0.205; });
  return {claim, "Its length: " + changes_text(shares) + ".", verdict,
          verdict == Verdict::reproduced ? "" : why};
}

/// By how many metres optimising makes the first path shorter.
ByWorld gains(const StudyReport& report, Entry entry) {
  ByWorld metres{};
  for (std::size_t w = 0; w < kWorlds; ++w) {
    const auto first = spread_of(report, kFirstLength, entry, w),
               last = spread_of(report, kLastLength, entry, w);
    if (first && last) metres[w] = first->mean - last->mean;
  }
  return metres;
}

/// How many of the original's plans have a path when the improved method is done.
std::string in_time_text(const StudyReport& report) {
  std::size_t runs = 0, in_time = 0;
  for (const StudyRun& run : report.runs) {
    if (run.planner != kOriginal) continue;
    ++runs;
    in_time += run.values[kSameTime] ? 1 : 0;
  }
  return filled("{1} of {2}", {std::to_string(in_time), std::to_string(runs)});
}

/// What may stand behind the paper's numbers.
StudyClaim same_time_claim(const StudyReport& report) {
  const ByWorld shares = changes(report, kSameTime);
  const bool better = std::all_of(shares.begin(), shares.end(), [](double share) { return share < 0; });
  return {"Whether the methods were given equal numbers of samples or equal time is left open.",
          filled("In the time that the improved method takes for all its samples {1} of the original's plans "
                 "have a path, and "
                 "the improved method's is {2} as against theirs.",
                 {in_time_text(report), changes_text(shares)}),
          Verdict::answered,
          better ? "A sample of the improved method is cheap, since it looks at the few nodes of a path and "
                   "not at a tree: it "
                   "is the better one where time is short, and the worse one where samples are counted."
                 : "So equal time does not bear out the paper's lengths in each world either."};
}

StudyClaim gain_claim(const StudyReport& report) {
  const ByWorld original = gains(report, kOriginal), improved = gains(report, kImproved);
  const auto holds = [](double metres) { return metres >= 1 && metres <= 2; };
  const Verdict verdict = std::max(verdict_of(original, 1, holds), verdict_of(improved, 1, holds));
  const auto list = [](const ByWorld& metres) {
    return told(metres[0], 2) + ", " + told(metres[1], 2) + " and " + told(metres[2], 2) + " m";
  };
  return {"Optimising makes the first path of either method shorter by 1 to 2 m.",
          "The original's becomes shorter by " + list(original) + ", the improved one's by " +
              list(improved) + ".",
          verdict,
          verdict == Verdict::reproduced ? ""
                                         : "How much there is to gain depends on the rectangles and on the "
                                           "number of samples, neither of which the paper gives."};
}

/// Whether both methods have a path in each world; else there is nothing to hold against the paper.
bool can_be_compared(const StudyReport& report) {
  for (std::size_t w = 0; w < kWorlds; ++w)
    for (const Entry entry : {kOriginal, kImproved})
      if (!spread_of(report, kLastLength, entry, w)) return false;
  return true;
}

void add_claims(StudyReport& report) {
  report.claims = {
      time_claim(report),
      length_claim(report, kFirstLength, "The improved method's first path is 10 % to 20 % shorter.",
                   "The original's first path is one of a tree that is rewired as it grows."),
      length_claim(
          report, kLastLength, "The improved method's optimised path is 10 % to 20 % shorter.",
          "With the same number of samples the original betters its whole tree, and finds other ways round "
          "obstacles; the improved method keeps to the way that its first path takes."),
      gain_claim(report), same_time_claim(report)};
  if (can_be_compared(report)) return;
  for (StudyClaim& claim : report.claims) {
    claim.ours = "In one of the worlds a method has found no path with any of these seeds.";
    claim.verdict = Verdict::not_reproduced;
    claim.why = "Without its paths there is nothing to compare.";
  }
}

Result<StudyReport> run_study(const StudyWatch& watch) {
  const auto worlds = read_worlds();
  if (!worlds) return Error{worlds.error()};
  StudyReport report;
  report.worlds_apart = true;
  report.planners = {"Informed RRT*", "improved"};
  report.figures = {{"first_samples", "samples to the first path", "", 0},
                    {"first_ms", "time to it", "ms", 3, true},
                    {"first_length", "first path", "m", 2},
                    {"last_length", "optimised path", "m", 2},
                    {"same_time_length", "path in the improved method's time", "m", 2},
                    {"all_ms", "time for all samples", "ms", 2, true}};
  report.charts = {{"first", "Length of the first path", kFirstLength},
                   {"last", "Length of the optimised path", kLastLength},
                   {"same-time", "Length of the path in the improved method's time", kSameTime},
                   {"first-time", "Time to the first path", kFirstTime},
                   {"time", "Time for all samples", kTime}};
  for (const World& world : *worlds) report.worlds.push_back(world.scenario.name);
  const bool whole = run_all(report, watch, [&](std::size_t world, std::size_t planner, std::uint64_t seed) {
    return run_once((*worlds)[world], static_cast<Entry>(planner), seed);
  });
  if (whole) add_claims(report);
  return report;
}

Result<std::vector<StudyPicture>> informed_pictures() {
  auto worlds = read_worlds();
  if (!worlds) return Error{worlds.error()};
  std::vector<StudyPicture> pictures;
  for (std::size_t w = 0; w < worlds->size(); ++w) {
    Scenario scenario = std::move((*worlds)[w].scenario);
    std::erase_if(scenario.planners, [](const PlannerChoice& choice) {
      return std::find(std::begin(kIds), std::end(kIds), choice.id) == std::end(kIds);
    });
    constexpr std::array kPictures{"environment-1", "environment-2", "environment-3"};
    std::string caption = filled(
        "The original and the improved method when all samples are drawn, their trees and best paths. World: "
        "{1}.",
        {scenario.name});
    pictures.push_back({kPictures[w], std::move(caption), std::move(scenario), false, {"tree", "path"}});
  }
  return pictures;
}

}  // namespace

StudyInfo informed_rrt_study() {
  return {"informed-rrt",
          "The improved Informed RRT* against the original",
          "Dai, Li, Li & Zhao 2022, \"Robot path planning based on improved Informed-RRT* algorithm\", "
          "tables 1 and 2",
          "Three worlds of 9 x 7 m from (1, 2.4) to (8, 1.5), as the paper has them, with rectangles of our "
          "own drawing, since "
          "its own are a small picture: maps/informed-rrt-1.json to -3.json, which open in the window. Steps "
          "of 30 cm, a ball "
          "and a threshold as large, 3 000 samples, of which 5 in 100 are the goal until there is a path; "
          "the paper names none "
          "of these. Each seed is a run of either method.",
          50,
          5,
          run_study,
          informed_pictures};
}

}  // namespace replan
