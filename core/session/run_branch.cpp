// How a run goes on with another script: what of its log stays, and from where it goes another way.
#include <algorithm>
#include <atomic>
#include <utility>

#include "core/base/disposal.hpp"
#include "core/session/run.hpp"

namespace replan {
namespace {

/// Ids of earlier logs that are known: who has not looked for longer reads anew.
constexpr std::size_t kMostEarlier = 256;

/// When the next surprise is due that a robot standing at a decision can wait for.
std::optional<std::int64_t> next_due(const Scenario& scenario, const Decision& decision, bool only_goals) {
  std::optional<std::int64_t> next;
  for (std::size_t i = 0; i < scenario.surprises.size(); ++i) {
    const Surprise& surprise = scenario.surprises[i];
    const bool fired = i < decision.fired.size() && decision.fired[i];
    if (surprise.at.move && !fired && (surprise.goal || !only_goals))
      next = std::min(next.value_or(*surprise.at.move), *surprise.at.move);
  }
  return next;
}

/// Whether a robot that looks ahead in the script from a decision sees the same in both. Where something moves it
/// waits step by step and asks only whether anything is to come.
bool same_outlook(const Scenario& a, const Scenario& b, const Decision& decision) {
  for (const bool only_goals : {false, true}) {
    const auto before = next_due(a, decision, only_goals), after = next_due(b, decision, only_goals);
    if (a.movers.empty() ? before != after : before.has_value() != after.has_value()) return false;
  }
  return true;
}

}  // namespace

std::uint64_t Run::next_log_id() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

std::size_t Run::common_with(std::uint64_t log_id) const {
  if (log_id == log_id_) return timeline_->size();
  const auto earlier = earlier_.find(log_id);
  return earlier == earlier_.end() ? 0 : earlier->second;
}

/// How many decisions stay: waiting, giving up and arriving depend on what is still to come, so that with another
/// script the first such decision may be another one.
std::size_t Run::foreseen(const Scenario& scenario) const {
  for (const Milestone& milestone : milestones_) {
    if (milestone.kind != EventKind::waiting && milestone.kind != EventKind::gave_up &&
        milestone.kind != EventKind::arrival)
      continue;
    const Decision* decision = decision_at(milestone.event);
    if (decision != nullptr && !same_outlook(*scenario_, scenario, *decision))
      return static_cast<std::size_t>(decision - decisions_.data()) + 1;
  }
  return decisions_.size();
}

/// Of decisions that are there, where a surprise that is added at the end of the list happens; nullptr if not
/// yet.
const Decision* Run::decision_of_surprise(std::span<const Decision> decisions, std::int64_t clock) {
  const auto first =
      std::lower_bound(decisions.begin(), decisions.end(), clock,
                       [](const Decision& decision, std::int64_t c) { return decision.clock < c; });
  if (first == decisions.end()) return nullptr;
  const auto after = std::partition_point(
      first, decisions.end(), [&](const Decision& decision) { return decision.clock == first->clock; });
  const std::vector<bool>& due = std::prev(after)->fired;
  // What has happened stays so: from some decision on all that was due has.
  const auto lacks_some = [&](const Decision& decision) {
    for (std::size_t i = 0; i < due.size(); ++i)
      if (due[i] && (i >= decision.fired.size() || !decision.fired[i])) return true;
    return false;
  };
  return &*std::partition_point(first, after, lacks_some);
}

/// How many decisions are those of the scenario's own run too, which differs in surprises from number `common`
/// on. None if it has to begin afresh.
std::size_t Run::decisions_kept(const Scenario& scenario, std::size_t common) const {
  const auto nothing_happened = [&](const Decision& decision) {
    const auto begin =
        decision.fired.begin() + static_cast<std::ptrdiff_t>(std::min(common, decision.fired.size()));
    return std::find(begin, decision.fired.end(), true) == decision.fired.end();
  };
  const auto kept = std::partition_point(decisions_.begin(), decisions_.end(), nothing_happened);
  std::size_t count = std::min(static_cast<std::size_t>(kept - decisions_.begin()), foreseen(scenario));
  const auto candidates = std::span(decisions_).first(count);
  for (std::size_t i = common; i < scenario.surprises.size(); ++i) {
    const auto& move = scenario.surprises[i].at.move;
    if (!move) return 0;
    if (const Decision* decision = decision_of_surprise(candidates, *move))
      count = std::min(count, static_cast<std::size_t>(decision - decisions_.data()) + 1);
  }
  return count;
}

std::span<const Decision> Run::lasting_decisions() const {
  return std::span(decisions_)
      .first(rebase_ ? decisions_kept(*rebase_->scenario, rebase_->common) : decisions_.size());
}

const Decision* Run::decision_for_edit() const {
  const auto decisions = lasting_decisions();
  const std::size_t cursor = timeline_->cursor();
  const auto after = std::partition_point(decisions.begin(), decisions.end(),
                                          [&](const Decision& decision) { return decision.event <= cursor; });
  return after == decisions.begin() ? nullptr : decision_of_surprise(decisions, std::prev(after)->clock);
}

void Run::rebase(std::shared_ptr<const Scenario> scenario, std::size_t common) {
  if (rebase_) common = std::min(common, rebase_->common);
  rebase_ = Rebase{.scenario = std::move(scenario), .common = common};
  worker_->stop();
  carry_out_rebase();
}

/// Puts the waiting scenario in if the background has stopped. True if it did.
bool Run::carry_out_rebase() {
  if (!rebase_ || handover_ || !worker_->at_rest()) return false;
  Rebase rebase = *std::exchange(rebase_, std::nullopt);
  if (!branch(rebase.scenario, rebase.common)) restart(std::move(rebase.scenario));
  if (rebase.target) worker_->go(*rebase.target);
  return true;
}

/// Has the run go on with the scenario's script from where that first makes a difference. False if that is
/// before the first plan stands.
bool Run::branch(std::shared_ptr<const Scenario> scenario, std::size_t common) {
  const std::size_t count = decisions_kept(*scenario, common);
  if (count == 0) return false;
  const bool whole = count == decisions_.size();
  const bool standing = whole && decisions_.back().event == timeline_->size();
  if (!whole || (!standing && !repairs_for_surprise(common))) cut(count);
  scenario_ = std::move(scenario);
  if (reexecution_) dispose(std::move(reexecution_));
  worker_->set_script(scenario_);
  return true;
}

/// Whether the repair under way at the end of the log is for one of the first `common` surprises: those that
/// are added behind them come after it.
bool Run::repairs_for_surprise(std::size_t common) const {
  const Event event = timeline_->event(decisions_.back().event);
  return event.kind == EventKind::surprise && event.delta < common;
}

void Run::cut(std::size_t count) {
  decisions_.resize(count);
  const std::size_t size = decisions_.back().event;
  earlier_.emplace(log_id_, size);
  if (earlier_.size() > kMostEarlier) earlier_.erase(earlier_.begin());
  for (auto& [id, common] : earlier_) common = std::min(common, size);
  log_id_ = next_log_id();
  timeline_->truncate(size);
  stops_.truncate(size, size == 0 ? std::uint8_t{0} : timeline_->event(size - 1).line);
  while (!milestones_.empty() && milestones_.back().event >= size) milestones_.pop_back();
  curve_.resize(size / kCurveChunk);
  std::uint32_t expansions = 0;
  for (std::size_t i = curve_.size() * kCurveChunk; i < size; ++i)
    expansions += is_expansion(timeline_->event(i)) ? 1 : 0;
  curve_.push_back(expansions);
  worker_->go_back(decisions_.back(), timeline_);
  lends_ = true;
}

}  // namespace replan
