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

/// When the next surprise is due that a robot standing at a mark can wait for.
std::optional<std::int64_t> next_due(const Scenario& scenario, const Mark& mark, bool only_goals) {
  std::optional<std::int64_t> next;
  for (std::size_t i = 0; i < scenario.surprises.size(); ++i) {
    const Surprise& surprise = scenario.surprises[i];
    const bool fired = i < mark.fired.size() && mark.fired[i];
    if (surprise.at.move && !fired && (surprise.goal || !only_goals))
      next = std::min(next.value_or(*surprise.at.move), *surprise.at.move);
  }
  return next;
}

/// Whether a robot that looks ahead in the script from a mark sees the same in both. Where something moves it
/// waits step by step and asks only whether anything is to come.
bool same_outlook(const Scenario& a, const Scenario& b, const Mark& mark) {
  for (const bool only_goals : {false, true}) {
    const auto before = next_due(a, mark, only_goals), after = next_due(b, mark, only_goals);
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

/// How many marks stay: waiting, giving up and arriving depend on what is still to come, so that with another
/// script the first such decision may be another one.
std::size_t Run::foreseen(const Scenario& scenario) const {
  for (const Marker& marker : markers_) {
    if (marker.kind != EventKind::waiting && marker.kind != EventKind::gave_up &&
        marker.kind != EventKind::arrival)
      continue;
    const Mark* mark = mark_at(marker.event);
    if (mark != nullptr && !same_outlook(*scenario_, scenario, *mark))
      return static_cast<std::size_t>(mark - marks_.data()) + 1;
  }
  return marks_.size();
}

/// Of marks that are there, where a surprise that is added at the end of the list happens; nullptr if not
/// yet.
const Mark* Run::place_of_surprise(std::span<const Mark> marks, std::int64_t clock) {
  const auto first = std::lower_bound(marks.begin(), marks.end(), clock,
                                      [](const Mark& mark, std::int64_t c) { return mark.clock < c; });
  if (first == marks.end()) return nullptr;
  const auto after =
      std::partition_point(first, marks.end(), [&](const Mark& mark) { return mark.clock == first->clock; });
  const std::vector<bool>& due = std::prev(after)->fired;
  // What has happened stays so: from some mark on all that was due has.
  const auto lacks_some = [&](const Mark& mark) {
    for (std::size_t i = 0; i < due.size(); ++i)
      if (due[i] && (i >= mark.fired.size() || !mark.fired[i])) return true;
    return false;
  };
  return &*std::partition_point(first, after, lacks_some);
}

/// How many marks are those of the scenario's own run too, which differs in surprises from number `common`
/// on. None if it has to begin afresh.
std::size_t Run::marks_kept(const Scenario& scenario, std::size_t common) const {
  const auto nothing_happened = [&](const Mark& mark) {
    const auto begin = mark.fired.begin() + static_cast<std::ptrdiff_t>(std::min(common, mark.fired.size()));
    return std::find(begin, mark.fired.end(), true) == mark.fired.end();
  };
  const auto kept = std::partition_point(marks_.begin(), marks_.end(), nothing_happened);
  std::size_t count = std::min(static_cast<std::size_t>(kept - marks_.begin()), foreseen(scenario));
  const auto candidates = std::span(marks_).first(count);
  for (std::size_t i = common; i < scenario.surprises.size(); ++i) {
    const auto& move = scenario.surprises[i].at.move;
    if (!move) return 0;
    if (const Mark* mark = place_of_surprise(candidates, *move))
      count = std::min(count, static_cast<std::size_t>(mark - marks_.data()) + 1);
  }
  return count;
}

std::span<const Mark> Run::lasting_marks() const {
  return std::span(marks_).first(rebase_ ? marks_kept(*rebase_->scenario, rebase_->common) : marks_.size());
}

const Mark* Run::mark_for_edit() const {
  const auto marks = lasting_marks();
  const std::size_t cursor = timeline_->cursor();
  const auto after = std::partition_point(marks.begin(), marks.end(),
                                          [&](const Mark& mark) { return mark.event <= cursor; });
  return after == marks.begin() ? nullptr : place_of_surprise(marks, std::prev(after)->clock);
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
  const std::size_t count = marks_kept(*scenario, common);
  if (count == 0) return false;
  const bool whole = count == marks_.size();
  const bool standing = whole && marks_.back().event == timeline_->size();
  if (!whole || (!standing && !repairs_for_surprise(common))) cut(count);
  scenario_ = std::move(scenario);
  if (reexecution_) dispose(std::move(reexecution_));
  worker_->set_script(scenario_);
  return true;
}

/// Whether the repair under way at the end of the log is for one of the first `common` surprises: those that
/// are added behind them come after it.
bool Run::repairs_for_surprise(std::size_t common) const {
  const Event event = timeline_->event(marks_.back().event);
  return event.kind == EventKind::surprise && event.delta < common;
}

void Run::cut(std::size_t mark_count) {
  marks_.resize(mark_count);
  const std::size_t size = marks_.back().event;
  earlier_.emplace(log_id_, size);
  if (earlier_.size() > kMostEarlier) earlier_.erase(earlier_.begin());
  for (auto& [id, common] : earlier_) common = std::min(common, size);
  log_id_ = next_log_id();
  timeline_->truncate(size);
  while (!markers_.empty() && markers_.back().event >= size) markers_.pop_back();
  curve_.resize(size / kCurveChunk);
  counter_ = ExpansionCounter(*timeline_, curve_.size() * kCurveChunk);
  for (std::size_t i = curve_.size() * kCurveChunk; i < size; ++i) counter_.take(timeline_->event(i));
  curve_.push_back(static_cast<std::uint32_t>(counter_.count()));
  worker_->go_back(marks_.back(), timeline_);
  lends_ = true;
}

}  // namespace replan
