// How a run goes on with another script: what of its log stays, and from where it goes another way.
#include <algorithm>
#include <atomic>

#include "core/session/run.hpp"

namespace replan {
namespace {

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
  if (log_id == log_id_) return timeline_.size();
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

const Mark* Run::mark_for_new_surprise(std::int64_t clock) const {
  const auto first = std::lower_bound(marks_.begin(), marks_.end(), clock,
                                      [](const Mark& mark, std::int64_t c) { return mark.clock < c; });
  if (first == marks_.end()) return nullptr;
  const auto after =
      std::find_if(first, marks_.end(), [&](const Mark& mark) { return mark.clock > first->clock; });
  const std::vector<bool>& due = std::prev(after)->fired;
  const auto all_happened = [&](const Mark& mark) {
    for (std::size_t i = 0; i < due.size(); ++i)
      if (due[i] && (i >= mark.fired.size() || !mark.fired[i])) return false;
    return true;
  };
  return &*std::find_if(first, after, all_happened);
}

bool Run::rebase(std::shared_ptr<const Scenario> scenario, std::size_t common) {
  cancel();
  if (!mission_) return false;
  const auto happened = [&](const Mark& mark) {
    return std::find(mark.fired.begin() + static_cast<std::ptrdiff_t>(std::min(common, mark.fired.size())),
                     mark.fired.end(), true) != mark.fired.end();
  };
  const auto kept = std::find_if(marks_.begin(), marks_.end(), happened);
  std::size_t count = std::min(static_cast<std::size_t>(kept - marks_.begin()), foreseen(*scenario));
  const bool partial = count < marks_.size();
  marks_.resize(count);
  for (std::size_t i = common; i < scenario->surprises.size(); ++i) {
    const auto& move = scenario->surprises[i].at.move;
    if (!move) return false;
    if (const Mark* mark = mark_for_new_surprise(*move))
      count = std::min(count, static_cast<std::size_t>(mark - marks_.data()) + 1);
  }
  if (count == 0) return false;
  if (partial || count < marks_.size() || !mission_->standing()) cut(count);
  scenario_ = std::move(scenario);
  reexecution_.reset();
  mission_->set_surprises(scenario_->surprises);
  return true;
}

void Run::cut(std::size_t mark_count) {
  marks_.resize(mark_count);
  const std::size_t size = marks_.back().event;
  earlier_.emplace(log_id_, size);
  for (auto& [id, common] : earlier_) common = std::min(common, size);
  log_id_ = next_log_id();
  timeline_.truncate(size);
  while (!markers_.empty() && markers_.back().event >= size) markers_.pop_back();
  curve_.resize(size / kCurveChunk);
  counter_ = ExpansionCounter(timeline_, curve_.size() * kCurveChunk);
  for (std::size_t i = curve_.size() * kCurveChunk; i < size; ++i) counter_.take(timeline_.event(i));
  curve_.push_back(static_cast<std::uint32_t>(counter_.count()));
  recorded_ = size;
  mission_->restore(marks_.back(), timeline_.head());
}

}  // namespace replan
