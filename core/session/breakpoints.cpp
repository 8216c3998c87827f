#include "core/session/breakpoints.hpp"

#include <algorithm>

#include "core/base/deadline.hpp"
#include "core/session/lockstep.hpp"
#include "core/session/run.hpp"

namespace replan {

Breakpoints::Reading Breakpoints::read(const std::string& condition, const Box& world) {
  Result<Condition> read = parse_condition(condition, world);
  if (!read) return {std::nullopt, read.error()};
  return {std::move(read.value()), ""};
}

void Breakpoints::set_list(std::vector<Breakpoint> list, const Box& world) {
  list_ = std::move(list);
  stopped_.clear();
  read_again(world);
}

Result<void> Breakpoints::add(const std::string& condition, const Box& world) {
  if (list_.size() >= kMaxBreakpoints)
    return Error{"there are " + std::to_string(kMaxBreakpoints) +
                 " breakpoints already, the most there can be: remove one"};
  Reading reading = read(condition, world);
  if (!reading.condition) return Error{reading.problem};
  const auto same = [&](const Reading& other) { return other.condition == reading.condition; };
  if (std::any_of(read_.begin(), read_.end(), same))
    return Error{"there is a breakpoint of that condition already"};
  list_.push_back({condition, true});
  read_.push_back(std::move(reading));
  look_again();
  return {};
}

void Breakpoints::enable(std::size_t index, bool enabled) {
  if (list_[index].enabled == enabled) return;
  list_[index].enabled = enabled;
  look_again();
}

void Breakpoints::remove(std::size_t index) {
  list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(index));
  read_.erase(read_.begin() + static_cast<std::ptrdiff_t>(index));
  look_again();
}

void Breakpoints::read_again(const Box& world) {
  read_.clear();
  for (const Breakpoint& breakpoint : list_) read_.push_back(read(breakpoint.condition, world));
  look_again();
}

bool Breakpoints::wants_any() const {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (is_wanted(i)) return true;
  return false;
}

StopSearch Breakpoints::search(const Run& run, const CheckedLog& checked, std::size_t position) {
  follow_log(run);
  std::vector<NumberedCondition> wanted;
  bool counts = false;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!is_wanted(i)) continue;
    wanted.push_back({i, *read_[i].condition});
    counts |= read_[i].condition->counts_expansions();
  }
  const std::int64_t expansions = counts ? expansions_until(run, position) : 0;
  return {run.log_view(), std::move(wanted), position, checked.verdicts(), expansions};
}

std::size_t Breakpoints::can_look_to(const CheckedLog& checked, std::size_t size) const {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!is_wanted(i)) continue;
    if (read_[i].condition->uses(Happening::invariant)) size = std::min(size, checked.laws);
    if (read_[i].condition->uses(Happening::oracle)) size = std::min(size, checked.oracle);
  }
  return size;
}

void Breakpoints::look_again() {
  hits_.clear();
  looked_ = 0;
  search_.reset();
}

/// Forgets what was found in events that the log no longer has.
void Breakpoints::follow_log(const Run& run) {
  if (run.log_id() == log_id_) return;
  const std::size_t common = run.common_with(log_id_);
  log_id_ = run.log_id();
  looked_ = std::min(looked_, common);
  while (!hits_.empty() && hits_.back().position > looked_) hits_.pop_back();
  search_.reset();
}

/// A checker that begins or ends has another word on what was looked through.
void Breakpoints::follow_checkers(const CheckedLog& checked) {
  if (checked.laws_on == laws_on_ && checked.oracle_on == oracle_on_) return;
  laws_on_ = checked.laws_on;
  oracle_on_ = checked.oracle_on;
  const auto asks = [](const Reading& each) {
    return each.condition &&
           (each.condition->uses(Happening::invariant) || each.condition->uses(Happening::oracle));
  };
  if (std::any_of(read_.begin(), read_.end(), asks)) look_again();
}

bool Breakpoints::look(const Run& run, const CheckedLog& checked, double milliseconds) {
  follow_log(run);
  follow_checkers(checked);
  if (!wants_any()) return false;
  const std::size_t end = can_look_to(checked, run.timeline().size()), before = looked_;
  const Deadline deadline(milliseconds);
  while (looked_ < end && hits_.size() < kMostHits && !deadline.passed()) {
    if (!search_) search_.emplace(search(run, checked, looked_));
    looked_ = std::min(end, looked_ + search_->slice());
    search_->forwards(looked_, checked.verdicts(), hits_);
  }
  return looked_ != before;
}

const Hit* Breakpoints::known_after(std::size_t position) const {
  const auto found = std::upper_bound(hits_.begin(), hits_.end(), position,
                                      [](std::size_t p, const Hit& hit) { return p < hit.position; });
  return found == hits_.end() ? nullptr : &*found;
}

const Hit* Breakpoints::known_before(std::size_t position) const {
  const auto found = std::lower_bound(hits_.begin(), hits_.end(), position,
                                      [](const Hit& hit, std::size_t p) { return hit.position < p; });
  return found == hits_.begin() ? nullptr : &*std::prev(found);
}

}  // namespace replan
