// Four planners on ten random maps: grid search, any-angle search that keeps clear of obstacles, samples, and evolution.
//
//  Huang L. & Zhou F., "Path planning of moving robot based on path optimization of D* Lite algorithm", Control and
//  Decision, 2018 (in Chinese), doi 10.13195/j.kzyjc.2018.0583, figure 5
#include <algorithm>
#include <array>
#include <cmath>

#include "core/study/papers/dld_entries.hpp"
#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_words.hpp"

namespace replan {
namespace {

constexpr std::uint64_t kRandomMaps = 10;
enum RandomEntry : std::size_t { kDstarLite, kDld, kRrtStar, kGenetic, kEntries };

using ByEntry = std::array<double, kEntries>;

StudyClaim nodes_claim(const ByEntry& nodes) {
  const bool most = nodes[kDstarLite] > 3 * nodes[kDld];
  const bool fewest = std::max(nodes[kRrtStar], nodes[kGenetic]) < nodes[kDld];
  StudyClaim claim{.paper =
                       "D* Lite's paths have by far the most nodes (182.7), DLD* Lite's fewer (31.2), those "
                       "of RRT* and of the "
                       "genetic algorithm the fewest (15.1 and 13.3).",
                   .ours = "D* Lite " + told(nodes[kDstarLite], 1) + ", DLD* Lite " + told(nodes[kDld], 1) +
                           ", RRT* " + told(nodes[kRrtStar], 1) + ", genetic algorithm " +
                           told(nodes[kGenetic], 1) + ".",
                   .verdict = most && fewest   ? Verdict::reproduced
                              : most || fewest ? Verdict::partly
                                               : Verdict::not_reproduced,
                   .why = {}};
  if (!most)
    claim.why = "How many nodes a path of remote parents saves depends on how open the maps are.";
  else if (!fewest)
    claim.why =
        "How many nodes a path of samples has depends on the length of their steps, which the paper does not "
        "name.";
  return claim;
}

StudyClaim length_claim_of(const ByEntry& length) {
  const bool alike = std::abs(length[kDld] / length[kDstarLite] - 1) <= 0.03;
  const bool last = length[kGenetic] > std::max({length[kRrtStar], length[kDld], length[kDstarLite]});
  const bool best = std::max(length[kDld], length[kDstarLite]) < std::min(length[kRrtStar], length[kGenetic]);
  StudyClaim claim{
      .paper =
          "The paths of D* Lite and DLD* Lite are about equally long and the shortest; those of the genetic "
          "algorithm are the longest.",
      .ours = "D* Lite " + told(length[kDstarLite], 1) + ", DLD* Lite " + told(length[kDld], 1) + ", RRT* " +
              told(length[kRrtStar], 1) + ", genetic algorithm " + told(length[kGenetic], 1) + " cells.",
      .verdict = alike && best && last     ? Verdict::reproduced
                 : alike && (best || last) ? Verdict::partly
                                           : Verdict::not_reproduced,
      .why = {}};
  if (!best)
    claim.why =
        "A path that goes from one cell to its neighbours is up to 8 % longer than the shortest one; what is "
        "not "
        "bound to eight directions can come below it, as it does here.";
  else if (!last)
    claim.why = "How far evolution comes is set by its generations, which the paper does not name.";
  else if (!alike)
    claim.why = "What keeping clear costs in length depends on how narrow the maps are.";
  return claim;
}

/// Within a factor of two of the paper's.
bool near_paper(double ours, double paper) {
  return ours < 2 * paper && paper < 2 * ours;
}

StudyClaim time_claim_of(const ByEntry& time) {
  const double dld = time[kDld] / time[kDstarLite], genetic = time[kGenetic] / time[kDstarLite],
               rrt = time[kRrtStar] / time[kDstarLite];
  const bool order = 1 < dld && dld < genetic && genetic < rrt;
  const bool ratios = near_paper(dld, 1.45) && near_paper(genetic, 3.8) && near_paper(rrt, 4.9);
  StudyClaim claim{.paper =
                       "D* Lite is the fastest (502 ms), DLD* Lite takes 1.45 times as long (727 ms), the "
                       "genetic algorithm 3.8 "
                       "times (1 900 ms) and RRT* 4.9 times (2 464 ms).",
                   .ours = "DLD* Lite takes " + told(dld, 2) +
                           " times as long as D* Lite, the genetic algorithm " + told(genetic, 1) +
                           " times and RRT* " + told(rrt, 1) + " times.",
                   .verdict = order && ratios                           ? Verdict::reproduced
                              : 1 < dld && dld < std::min(genetic, rrt) ? Verdict::partly
                                                                        : Verdict::not_reproduced,
                   .why = {}};
  if (claim.verdict != Verdict::reproduced) {
    claim.why =
        "How long samples and generations take is set by how many of them are asked for, which the paper "
        "does not name; "
        "and a search of the grid takes less than 2 ms here.";
    if (rrt < genetic) claim.why += " So RRT* and the genetic algorithm have changed places.";
  }
  return claim;
}

/// Where a planner has no path there is nothing to hold against the paper.
StudyClaim claim_of(const StudyReport& report, PlanFigure figure, StudyClaim (*claim)(const ByEntry&)) {
  const std::vector<double> values = typical_values(report, figure);
  ByEntry by_entry{1, 1, 1, 1};
  if (values.empty()) return without_paths(claim(by_entry));
  std::copy_n(values.begin(), kEntries, by_entry.begin());
  return claim(by_entry);
}

Result<std::vector<StudyEntry>> random_entries() {
  return study_entries({{"D* Lite", "dstar-lite"},
                        {"DLD* Lite", "dld-star-lite", {{"sight", "bresenham"}}},
                        {"RRT*", "rrt-star", {{"step", "20"}, {"goal_reach", "20"}, {"samples", "5000"}}},
                        {"Improved GA", "improved-ga"}});
}

Result<StudyReport> run_random(const StudyWatch& watch) {
  auto runs = plan_on_random_maps(random_entries(), kRandomMaps, watch);
  if (!runs) return Error{runs.error()};
  StudyReport& report = runs->report;
  report.paper = {{kNodes, kDstarLite, {}, 182.7},  {kNodes, kDld, {}, 31.2},
                  {kNodes, kRrtStar, {}, 15.1},     {kNodes, kGenetic, {}, 13.3},
                  {kPlanTime, kDstarLite, {}, 502}, {kPlanTime, kDld, {}, 727},
                  {kPlanTime, kRrtStar, {}, 2464},  {kPlanTime, kGenetic, {}, 1900}};
  report.charts = {{"nodes", "Nodes of the path", kNodes, StudyChart::Form::lines, true},
                   {"length", "Length of the path", kLength, StudyChart::Form::lines},
                   {"time", "Time of a plan", kPlanTime, StudyChart::Form::lines, true}};
  if (runs->whole)
    report.claims = {claim_of(report, kNodes, nodes_claim), claim_of(report, kLength, length_claim_of),
                     claim_of(report, kPlanTime, time_claim_of)};
  return std::move(report);
}

/// The first of the maps, as figure 6 has one of the paper's.
Result<std::vector<StudyPicture>> random_pictures() {
  return one_picture(library_scenario("dld-fig-5.json"), "paths",
                     "What the four planners come to on the first map, as in figure 6 of the paper.", false,
                     {"path"});
}

}  // namespace

StudyInfo dld_random_study() {
  return {"dld-random",
          "DLD* Lite beside D* Lite, RRT* and a genetic algorithm on random maps",
          "Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, figure 5",
          "Ten maps of 200 x 200 cells from (15, 15) to (175, 175), of rectangles with sides of 5 to 15 "
          "cells that cover 17 in "
          "100: with these D* Lite's paths have as many nodes as the paper's. DLD* Lite keeps clear within 2 "
          "cells. RRT* takes "
          "steps of 20 cells and 5 000 samples; the genetic algorithm is set as it is by itself. Each seed "
          "is a run of every "
          "planner on every map, which for the first two are alike but for the time. The first map opens in "
          "the window as "
          "maps/dld-fig-5.json.",
          5,
          1,
          run_random,
          random_pictures};
}

}  // namespace replan
