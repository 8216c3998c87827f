// Studies: the experiments of the papers, run anew, with what each paper reports beside what comes out here.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/stop.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// What is measured of each run.
struct StudyFigure {
  std::string_view key;    ///< its fixed name in CSV and JSON: "first_length"
  std::string_view label;  ///< "first path"
  std::string_view unit;   ///< may be empty
  int decimals = 0;
  bool wall_time = false;  ///< differs from run to run and from machine to machine
};

/// One run of one planner.
struct StudyRun {
  std::size_t world = 0, planner = 0;  ///< places in StudyReport's lists
  std::uint64_t seed = 0;
  bool found = false;
  std::vector<std::optional<double>> values;  ///< by figure; nothing where there is none
};

/// What the paper reports as a number: of a planner in a world, or over all of them.
struct PaperFigure {
  std::size_t figure = 0, planner = 0;
  std::optional<std::size_t> world = {};
  double value = 0;
};

/// What came out of a claim. `answered`: what the paper leaves open, and what the runs here say to it.
enum class Verdict : std::uint8_t { reproduced, partly, not_reproduced, answered };
/// "reproduced", ...
const char* verdict_name(Verdict verdict);

/// What the paper claims, as a sentence; what came out here; and, where that is not the same, why.
struct StudyClaim {
  std::string paper;
  std::string ours;
  Verdict verdict = Verdict::not_reproduced;
  std::string why;
};

/// A diagram of a figure, as the papers draw them.
struct StudyChart {
  enum class Form : std::uint8_t {
    bars,  ///< a bar for each planner, with its spread; a group of bars for each world where worlds are apart
    lines,  ///< from world to world, a line for each planner
  };
  std::string_view id;  ///< part of its files' names
  std::string title;
  std::size_t figure = 0;
  Form form = Form::bars;
  bool logarithmic = false;
};

/// What the planners of a scenario come to in it, drawn side by side.
struct StudyPicture {
  std::string_view id;  ///< part of its files' names
  std::string caption;
  Scenario scenario;                  ///< its planners are drawn in their order, at most four
  bool at_end = false;                ///< when the robots are there; else when the first plans stand
  std::vector<std::string> overlays;  ///< by their ids
};

struct StudyReport {
  std::vector<std::string> worlds,
      planners;  ///< by their names; figures are held against the first planner's
  std::vector<StudyFigure> figures;
  std::vector<PaperFigure> paper;
  std::vector<StudyRun> runs;
  std::vector<StudyClaim> claims;
  std::vector<StudyChart> charts;
  std::uint64_t seeds = 0;    ///< with so many it was run
  std::string machine;        ///< a sentence about what the times were taken on; may be empty
  std::string supplement;     ///< tables of another kind, as Markdown; may be empty
  bool worlds_apart = false;  ///< each world has a table of its own; else they are taken together
};

/// How a study is run, watched and stopped.
struct StudyWatch {
  std::uint64_t seeds = 1;
  std::function<void(std::size_t done, std::size_t all)> progress = {};  ///< after each run
  StopToken stop = {};  ///< the report then has the runs done so far, and no claims
  /// The folder of the BARN benchmark, for the study that can use it; empty: it goes without.
  std::string barn = {};
};

struct StudyInfo {
  std::string_view id;
  std::string_view title;
  std::string_view source;   ///< the paper, and which of its figures
  std::string_view setting;  ///< how it is run here, and what the paper leaves open
  std::uint64_t seeds = 1;   ///< as many as the paper's, or as its claims need
  std::uint64_t quick_seeds = 1;
  Result<StudyReport> (*run)(const StudyWatch& watch) = nullptr;
  Result<std::vector<StudyPicture>> (*pictures)() = nullptr;  ///< may be left out
};

/// All of them, in the order of the papers.
std::span<const StudyInfo> studies();
/// With an error that suggests the nearest id.
Result<const StudyInfo*> require_study(std::string_view id);

/// How the values of a figure are spread; nothing of no values.
struct Spread {
  std::size_t count = 0;
  double mean = 0, deviation = 0;        ///< the sample's standard deviation; 0 of one value
  double low = 0, median = 0, high = 0;  ///< quartiles, between two values by their share
};
std::optional<Spread> spread_of(std::vector<double> values);
/// Of a figure of a planner's runs, in a world or in all.
std::optional<Spread> spread_of(const StudyReport& report, std::size_t figure, std::size_t planner,
                                std::optional<std::size_t> world = {});
/// A planner's figure over another's, run by run with the same world and seed, where both have found a path.
std::optional<Spread> ratio_of(const StudyReport& report, std::size_t figure, std::size_t planner,
                               std::size_t to, std::optional<std::size_t> world = {});
/// The median of wall times, which a few slow runs do not move; the mean of all else, as papers have it.
double typical(const StudyFigure& figure, const Spread& spread);

/// The report for people: tables with the paper's figures, and a verdict for each claim.
std::string study_markdown(const StudyInfo& info, const StudyReport& report);
/// A line for each run under a line of names with units.
std::string study_csv(const StudyReport& report);
/// Everything, for programs.
std::string study_json(const StudyInfo& info, const StudyReport& report);

}  // namespace replan
