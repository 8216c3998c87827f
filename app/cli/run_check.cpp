#include "app/cli/run_check.hpp"

#include <algorithm>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/cli/output.hpp"
#include "core/debug/law_checker.hpp"
#include "core/debug/plan_oracle.hpp"
#include "core/session/run.hpp"

namespace replan::cli {
namespace {

using Json = nlohmann::ordered_json;

/// What came of one planner's run.
struct Verdict {
  std::string planner;
  std::vector<int> cell;  ///< of the first breach
  int line = 0;           ///< that wrote last at its vertex
  LawReport laws;
  OracleReport oracle;

  [[nodiscard]] bool holds() const { return laws.breaches == 0 && oracle.disagreements == 0; }
};

/// The pseudo-code line of the last event about the breach's vertex before it showed.
int line_of(const PlannerInfo& planner, const Timeline& log, const Breach& breach) {
  KindSet values{EventKind::known, EventKind::truth};
  for (const Field& field : planner.values.fields) values.add(field.kind);
  const auto event = log.last_event(breach.node, values, breach.position);
  return event ? log.event(*event).line : 0;
}

Result<Verdict> check(const std::shared_ptr<const Scenario>& scenario, std::size_t planner) {
  Run run(scenario, planner);
  run.finish(Target::end());
  if (std::string failure = run.failure(); !failure.empty())
    return Error{scenario->planners[planner].id + ": " + failure};
  const LogView view = run.log_view();
  Verdict verdict{.planner = scenario->planners[planner].id, .cell = {}, .laws = {}, .oracle = {}};
  LawChecker checker(view);
  while (checker.advance(view.log.size())) {
  }
  verdict.laws = {.on = true, .checked = checker.checked(), .breaches = checker.breach_count(), .first = {}};
  if (!checker.breaches().empty()) {
    verdict.laws.first = checker.breaches().front();
    verdict.cell = coordinates_of(view.lattice.position(verdict.laws.first->node), view.lattice.solid());
    verdict.line = line_of(view.info, view.log, *verdict.laws.first);
  }
  verdict.oracle = {.on = true, .exact = claims_cheapest(view.info, view.settings), .first = {}};
  for (const Milestone& milestone : run.milestones()) {
    if (milestone.kind != EventKind::plan_end) continue;
    const PlanQuestion question = ask_about(view, verdict.oracle.asked++, milestone.event + 1);
    const auto wrong = judge(question, right_cost(question));
    if (wrong && verdict.oracle.disagreements++ == 0) verdict.oracle.first = wrong;
  }
  return verdict;
}

std::string text_of(const Verdict& verdict) {
  const LawReport& laws = verdict.laws;
  const OracleReport& oracle = verdict.oracle;
  std::string text = verdict.planner + "\n";
  if (laws.breaches == 0)
    text += "  laws hold over " + counted(laws.checked, "event") + "\n";
  else
    text += "  laws are broken " + counted(laws.breaches, "time") + " in " + counted(laws.checked, "event") +
            ", first at event " + std::to_string(laws.first->position) + ", line " +
            std::to_string(verdict.line) + ":\n    " + laws.first->law + "\n    " + laws.first->words + "\n";
  const std::string plans = counted(oracle.asked, "plan");
  if (oracle.disagreements == 0)
    text += "  oracle agrees with " + plans +
            (oracle.exact ? "" : "; none is meant to be the cheapest with these settings") + "\n";
  else
    text += "  oracle disagrees with " + std::to_string(oracle.disagreements) + " of " + plans +
            ", first at event " + std::to_string(oracle.first->position) + ":\n    " +
            disagreement_text(*oracle.first) + "\n";
  return text;
}

Json cost_json(Cost cost) {
  return cost.is_infinite() ? Json() : Json(cost.to_double());
}

Json json_of(const Verdict& verdict) {
  Json laws = {{"hold", verdict.laws.breaches == 0},
               {"events", verdict.laws.checked},
               {"breaches", verdict.laws.breaches},
               {"first", Json()}};
  if (const auto& first = verdict.laws.first)
    laws["first"] = {{"position", first->position},
                     {"line", verdict.line},
                     {"cell", verdict.cell},
                     {"law", first->law},
                     {"words", first->words}};
  Json oracle = {{"agrees", verdict.oracle.disagreements == 0},
                 {"plans", verdict.oracle.asked},
                 {"disagreements", verdict.oracle.disagreements},
                 {"meant_cheapest", verdict.oracle.exact},
                 {"first", Json()}};
  if (const auto& first = verdict.oracle.first)
    oracle["first"] = {{"plan", first->plan},
                       {"position", first->position},
                       {"claimed", cost_json(first->claimed)},
                       {"right", cost_json(first->right)},
                       {"words", disagreement_text(*first)}};
  return {{"planner", verdict.planner}, {"laws", std::move(laws)}, {"oracle", std::move(oracle)}};
}

}  // namespace

Result<int> check_runs(const Scenario& scenario, bool json) {
  const auto shared = std::make_shared<const Scenario>(scenario);
  Json checks = Json::array();
  std::string text;
  bool holds = true;
  for (std::size_t i = 0; i < scenario.planners.size(); ++i) {
    const Result<Verdict> verdict = check(shared, i);
    if (!verdict) return Error{verdict.error()};
    holds &= verdict->holds();
    checks.push_back(json_of(*verdict));
    text += text_of(*verdict);
  }
  print(json ? Json{{"checks", std::move(checks)}}.dump(2) + "\n" : text);
  return holds ? kDone : kFailed;
}

}  // namespace replan::cli
