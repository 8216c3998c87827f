#include "core/session/checks.hpp"

#include <algorithm>
#include <chrono>

#include "core/base/background.hpp"
#include "core/debug/difference_search.hpp"
#include "core/debug/law_checker.hpp"
#include "core/debug/plan_oracle.hpp"
#include "core/session/run.hpp"

namespace replan {
namespace {

/// Of one update, so that the drawing thread keeps its pace, and what is read between two looks at the clock.
constexpr std::chrono::microseconds kSliceTime{4000};
constexpr std::size_t kSliceEvents = 2048;
/// Disagreements kept.
constexpr std::size_t kMostKept = 1000;

using Clock = std::chrono::steady_clock;

}  // namespace

/// What is known of one run. Nothing here is used before meet() has seen that its log is still the same.
struct Checks::Pane {
  std::uint64_t log_id = 0;
  std::unique_ptr<LawChecker> laws;

  // The oracle, one plan after the other.
  bool exact = true;
  std::size_t next_milestone = 0;     // of the run's, the next to be looked at
  std::size_t plan = 0;               // the next to be asked about
  std::vector<std::size_t> answered;  // by plan, where it stands
  std::vector<Disagreement> disagreements;
  std::size_t wrong = 0;  // disagreements in all
  using Answer = std::pair<PlanQuestion, Cost>;
  std::unique_ptr<Background<Answer>> job;

  /// The next plan that nobody asked about; nullptr if all were.
  const Milestone* next_plan(const Run& run) {
    const auto milestones = run.milestones();
    while (next_milestone < milestones.size() && milestones[next_milestone].kind != EventKind::plan_end)
      ++next_milestone;
    return next_milestone < milestones.size() ? &milestones[next_milestone] : nullptr;
  }
  [[nodiscard]] bool asking() const { return job && job->busy(); }
  /// The question under way is not waited for: it may be in the middle of a large map.
  void give_up() {
    if (job) job->cancel();
  }

  /// The next question, if there is one.
  std::optional<PlanQuestion> question(const Run& run) {
    const Milestone* stands = next_plan(run);
    if (stands == nullptr) return std::nullopt;
    ++next_milestone;
    return ask_about(run.log_view(), plan++, stands->event + 1);
  }
  void ask(const Run& run, const WorkPlace& place) {
    if (asking()) return;
    auto next = question(run);
    if (!next) return;
    if (!job) job = std::make_unique<Background<Answer>>(place);
    job->start_slices([asked = *next, search = std::make_shared<RightCostSearch>(*next)](const StopToken&) {
      const auto right = search->advance();
      return right ? std::optional(Answer{asked, *right}) : std::nullopt;
    });
  }
  /// True if an answer came.
  bool hear() {
    if (!job) return false;
    const auto answer = job->take();
    if (answer) keep(answer->first, answer->second);
    return answer.has_value();
  }
  void keep(const PlanQuestion& asked, Cost right) {
    answered.push_back(asked.position);
    const auto wrong_one = judge(asked, right);
    if (!wrong_one) return;
    ++wrong;
    if (disagreements.size() < kMostKept) disagreements.push_back(*wrong_one);
  }
  /// All that is left, without anybody's help.
  void answer_all(const Run& run) {
    if (asking()) job->wait();
    hear();
    while (const auto next = question(run)) keep(*next, right_cost(*next));
  }
  /// The log was cut there, where a plan stood.
  void cut(const Run& run, std::size_t position) {
    if (laws) laws->rewind(position);
    give_up();
    std::erase_if(answered, [position](std::size_t stands) { return stands > position; });
    std::erase_if(disagreements, [position](const Disagreement& each) { return each.position > position; });
    wrong = disagreements.size();
    plan = answered.size();
    next_milestone = 0;
    for (std::size_t i = 0; i < plan; ++i)
      if (next_plan(run) != nullptr) ++next_milestone;
  }
  void forget_oracle() {
    give_up();
    next_milestone = plan = wrong = 0;
    answered.clear();
    disagreements.clear();
  }
};

/// Two runs on their way to where they part.
struct Checks::Comparison {
  DifferenceSearch search;
  Compared of;
};

Checks::Checks(WorkPlace place) : place_(std::move(place)) {}
Checks::~Checks() = default;
Checks::Checks(Checks&&) noexcept = default;
Checks& Checks::operator=(Checks&&) noexcept = default;

LawReport Checks::laws(std::size_t pane) const {
  if (pane >= panes_.size() || !panes_[pane].laws) return {};
  const LawChecker& checker = *panes_[pane].laws;
  LawReport report{.on = true, .checked = checker.checked(), .breaches = checker.breach_count(), .first = {}};
  if (!checker.breaches().empty()) report.first = checker.breaches().front();
  return report;
}

OracleReport Checks::oracle(std::size_t pane) const {
  if (pane >= panes_.size() || !oracle_) return {};
  const Pane& held = panes_[pane];
  OracleReport report{.on = true,
                      .exact = held.exact,
                      .asked = held.answered.size(),
                      .busy = held.asking(),
                      .disagreements = held.wrong,
                      .first = {}};
  if (!held.disagreements.empty()) report.first = held.disagreements.front();
  return report;
}

std::span<const Breach> Checks::breaches(std::size_t pane) const {
  return pane < panes_.size() && panes_[pane].laws ? panes_[pane].laws->breaches()
                                                   : std::span<const Breach>{};
}

std::span<const Disagreement> Checks::disagreements(std::size_t pane) const {
  return pane < panes_.size() ? panes_[pane].disagreements : std::span<const Disagreement>{};
}

bool Checks::laws_on(const Run& run) const {
  const std::size_t cells = run.lattice().node_count();
  return cells <= most_cells_ && laws_.value_or(cells <= kCellsByDefault);
}

void Checks::set(bool laws, bool oracle) {
  laws_ = laws;
  oracle_ = oracle;
  for (Pane& pane : panes_) {
    if (!laws) pane.laws.reset();
    if (!oracle) pane.forget_oracle();
  }
}

/// Brings the panes in line with the runs as they are now: what was cut off a log is forgotten, and all of a
/// log that was replaced.
void Checks::meet(Runs runs) {
  panes_.resize(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = *runs[i];
    Pane& pane = panes_[i];
    if (pane.log_id != run.log_id()) {
      const std::size_t common = run.common_with(pane.log_id);
      if (common == 0) {
        pane.laws.reset();
        pane.forget_oracle();
      } else {
        pane.cut(run, common);
      }
      pane.log_id = run.log_id();
    }
    if (laws_on(run) && !pane.laws) pane.laws = std::make_unique<LawChecker>(run.log_view());
    pane.exact = claims_cheapest(run.info(), run.settings());
  }
  forget_difference(runs);
}

/// Of runs that were cut or replaced since they were compared.
void Checks::forget_difference(Runs runs) {
  if (!compared_) return;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t pane = compared_->panes[i];
    if (pane < runs.size() && runs[pane]->log_id() == compared_->log_ids[i]) continue;
    compared_.reset();
    difference_.reset();
    comparison_.clear();
    return;
  }
}

bool Checks::update(Runs runs) {
  meet(runs);
  const Clock::time_point begin = Clock::now();
  bool changed = false;
  busy_ = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Pane& pane = panes_[i];
    if (oracle_) {
      changed |= pane.hear();
      pane.ask(*runs[i], place_);
      busy_ |= pane.asking();
    }
    if (!pane.laws || pane.laws->checked() == runs[i]->timeline().size()) continue;
    changed = true;
    // Each pane has its share, so that all get on.
    const auto share = kSliceTime * static_cast<int>(i + 1) / static_cast<int>(runs.size());
    bool more = true;
    while (more && Clock::now() - begin < share) more = pane.laws->advance(kSliceEvents);
    busy_ |= more;
  }
  return changed;
}

void Checks::settle(Runs runs) {
  meet(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Pane& pane = panes_[i];
    while (pane.laws && pane.laws->advance(kSliceEvents)) {
    }
    if (oracle_) pane.answer_all(*runs[i]);
  }
  busy_ = false;
}

bool Checks::compare(Runs runs, const std::array<std::size_t, 2>& panes, Compare what) {
  const Run &a = *runs[panes[0]], &b = *runs[panes[1]];
  const Compared asked{panes, what, {a.log_id(), b.log_id()}};
  if (compared_ == asked) return false;
  compared_.reset();
  difference_.reset();
  comparison_.clear();
  comparison_under_way_ =
      std::make_unique<Comparison>(Comparison{DifferenceSearch(a.log_view(), b.log_view(), what), asked});
  comparing_ = true;
  return true;
}

void Checks::stop_comparing() {
  comparison_under_way_.reset();
  comparing_ = false;
}

bool Checks::compare_on(Runs runs) {
  if (!comparing_) return false;
  Comparison& comparison = *comparison_under_way_;
  std::array<bool, 2> ended{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t pane = comparison.of.panes[i];
    if (pane >= runs.size() || runs[pane]->log_id() != comparison.of.log_ids[i]) {
      stop_comparing();  // the world was edited
      return false;
    }
    Run& run = *runs[pane];
    const bool over = !run.decisions().empty() && run.decisions().back().state != MissionState::driving;
    ended[i] = !run.busy() && (over || !run.failure().empty());
    if (!ended[i] && !run.busy()) run.go(Target::end());  // something else had set it a nearer target
  }
  const Clock::time_point begin = Clock::now();
  auto outcome = DifferenceSearch::Outcome::more;
  while (outcome == DifferenceSearch::Outcome::more && Clock::now() - begin < kSliceTime)
    outcome = comparison.search.advance(kSliceEvents, ended);
  if (outcome == DifferenceSearch::Outcome::more || outcome == DifferenceSearch::Outcome::waits) return false;
  difference_ = comparison.search.difference();
  if (difference_) difference_->panes = comparison.of.panes;
  comparison_ = difference_ ? difference_->words : "alike to the end: " + comparison.search.alike();
  compared_ = comparison.of;
  stop_comparing();
  return true;
}

}  // namespace replan
