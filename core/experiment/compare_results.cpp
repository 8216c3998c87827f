#include "core/experiment/compare_results.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/world/json_reader.hpp"

namespace replan {
namespace {

constexpr double kConfidence = 0.95;

using Pair = std::pair<const RunResult*, const RunResult*>;

/// One planner's pairs.
struct PlannerPairs {
  std::string planner;
  std::vector<Pair> pairs;
};

/// In the order of the first results.
std::vector<PlannerPairs> pairs_by_planner(std::span<const RunResult> before,
                                           std::span<const RunResult> after, Comparison& comparison) {
  std::map<RunName, const RunResult*> others;
  for (const RunResult& run : after) others.emplace(run.name, &run);
  std::vector<PlannerPairs> planners;
  std::map<std::string, std::size_t> places;
  for (const RunResult& run : before) {
    const auto other = others.find(run.name);
    if (other == others.end()) {
      ++comparison.only_before;
      continue;
    }
    ++comparison.pairs;
    const std::string label = planner_label(run.name);
    const auto [place, fresh] = places.emplace(label, planners.size());
    if (fresh) planners.push_back({label, {}});
    if (!run.skipped() && !other->second->skipped())
      planners[place->second].pairs.emplace_back(&run, other->second);
    others.erase(other);
  }
  comparison.only_after = static_cast<std::int64_t>(others.size());
  return planners;
}

Trend verdict_of(const ComparedFigure& row, double alpha) {
  if (row.corrected >= alpha || row.effect == 0) return Trend::unchanged;
  return (row.effect < 0) == (row.better == Better::lower) ? Trend::better : Trend::worse;
}

/// A row of a figure, from its values in both.
ComparedFigure figure_row(std::string_view figure, Better better, std::span<const double> before,
                          std::span<const double> after, std::uint64_t seed) {
  ComparedFigure row;
  row.figure = figure;
  row.better = better;
  row.pairs = static_cast<std::int64_t>(before.size());
  std::vector<double> differences, ratios;
  for (std::size_t i = 0; i < before.size(); ++i) {
    differences.push_back(after[i] - before[i]);
    if (before[i] != 0) ratios.push_back(after[i] / before[i]);
    if (differences.back() != 0)
      ++((differences.back() < 0) == (better == Better::lower) ? row.improved : row.worsened);
  }
  row.before = median({before.begin(), before.end()});
  row.after = median({after.begin(), after.end()});
  if (!ratios.empty()) {
    row.interval = bootstrap_median(ratios, kConfidence, seed);
    row.ratio = median(std::move(ratios));
  }
  const SignedRanks ranks = signed_ranks(differences);
  row.effect = ranks.effect();
  row.p = ranks.p;
  return row;
}

ComparedFigure success_row(std::span<const Pair> pairs) {
  ComparedFigure row;
  row.figure = "succeeded";
  row.better = Better::higher;
  row.pairs = static_cast<std::int64_t>(pairs.size());
  for (const auto& [before, after] : pairs) {
    row.before += before->succeeded ? 1 : 0;
    row.after += after->succeeded ? 1 : 0;
    row.improved += !before->succeeded && after->succeeded ? 1 : 0;
    row.worsened += before->succeeded && !after->succeeded ? 1 : 0;
  }
  const std::int64_t changed = row.improved + row.worsened;
  if (changed > 0)
    row.effect = static_cast<double>(row.improved - row.worsened) / static_cast<double>(changed);
  if (row.before > 0) row.ratio = row.after / row.before;
  row.before /= std::max(1.0, static_cast<double>(row.pairs));
  row.after /= std::max(1.0, static_cast<double>(row.pairs));
  row.p = sign_test(row.improved, row.worsened);
  return row;
}

/// The figure's rows: of all columns that can be better or worse, and of times if they are asked for.
class PlannerRows {
 public:
  PlannerRows(const PlannerPairs& planner, const CompareSettings& settings)
      : planner_(planner), settings_(settings) {}

  std::vector<ComparedFigure> rows() {
    add(success_row(planner_.pairs));
    for (const ResultColumn& column : result_columns())
      if (column.better != Better::neither)
        add_figure(column.name, column.better, [&](const RunResult& run) { return run.figure(column.name); });
    if (settings_.times) {
      add_figure("plan_ms", Better::lower, [](const RunResult& run) { return middle(run.plan_ms); });
      add_figure("replan_ms", Better::lower, [](const RunResult& run) { return middle(run.replan_ms); });
    }
    return std::move(rows_);
  }

 private:
  static std::optional<double> middle(const std::vector<double>& times) {
    return times.empty() ? std::nullopt : std::optional(median(times));
  }

  template <class Value>
  void add_figure(std::string_view figure, Better better, Value&& value) {
    std::vector<double> before, after;
    for (const auto& [one, other] : planner_.pairs) {
      if (!one->succeeded || !other->succeeded) continue;
      const auto was = value(*one), is = value(*other);
      if (!was || !is) continue;
      before.push_back(*was);
      after.push_back(*is);
    }
    if (!before.empty()) add(figure_row(figure, better, before, after, settings_.seed));
  }

  void add(ComparedFigure row) {
    row.planner = planner_.planner;
    rows_.push_back(std::move(row));
  }

  const PlannerPairs& planner_;
  const CompareSettings& settings_;
  std::vector<ComparedFigure> rows_;
};

/// A row in which no pair differs is no test: it can call nothing a difference.
void correct_for_all(std::vector<ComparedFigure>& rows, double alpha) {
  std::vector<double> p;
  const auto is_test = [](const ComparedFigure& row) { return row.improved + row.worsened > 0; };
  for (const ComparedFigure& row : rows)
    if (is_test(row)) p.push_back(row.p);
  const std::vector<double> corrected = holm(p);
  std::size_t next = 0;
  for (ComparedFigure& row : rows) {
    if (is_test(row)) row.corrected = corrected[next++];
    row.verdict = verdict_of(row, alpha);
  }
}

}  // namespace

std::optional<double> ComparedFigure::loss() const {
  if (!ratio) return std::nullopt;
  const double part = better == Better::lower ? *ratio - 1 : 1 - *ratio;
  return part > 0 ? std::optional(part) : std::nullopt;
}

Result<void> forget_settings(std::vector<RunResult>& results) {
  std::set<RunName> names;
  for (RunResult& run : results) {
    run.name.settings.clear();
    run.name.stages.clear();
    if (!names.insert(run.name).second)
      return Error{
          "'" + run.name.planner +
          "' is there with several settings, which cannot be told apart without them: give results that have "
          "each planner once"};
  }
  return {};
}

Comparison compare_results(std::span<const RunResult> before, std::span<const RunResult> after,
                           const CompareSettings& settings) {
  Comparison comparison;
  for (const PlannerPairs& planner : pairs_by_planner(before, after, comparison))
    for (ComparedFigure& row : PlannerRows(planner, settings).rows())
      comparison.rows.push_back(std::move(row));
  correct_for_all(comparison.rows, settings.alpha);
  return comparison;
}

std::string comparison_json(const Comparison& comparison) {
  constexpr const char* kChanges[] = {"unchanged", "better", "worse"};
  Json document = {{"pairs", comparison.pairs},
                   {"only_before", comparison.only_before},
                   {"only_after", comparison.only_after},
                   {"rows", Json::array()}};
  for (const ComparedFigure& row : comparison.rows)
    document["rows"].push_back({{"planner", row.planner},
                                {"figure", row.figure},
                                {"pairs", row.pairs},
                                {"improved", row.improved},
                                {"worsened", row.worsened},
                                {"before", plain_number(row.before)},
                                {"after", plain_number(row.after)},
                                {"median_ratio", row.ratio ? plain_number(*row.ratio) : Json()},
                                {"ratio_low", row.interval ? plain_number(row.interval->low) : Json()},
                                {"ratio_high", row.interval ? plain_number(row.interval->high) : Json()},
                                {"effect", plain_number(row.effect)},
                                {"p", plain_number(row.p)},
                                {"p_holm", plain_number(row.corrected)},
                                {"verdict", kChanges[static_cast<std::size_t>(row.verdict)]}});
  return pretty_json(document);
}

}  // namespace replan
