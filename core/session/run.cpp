#include "core/session/run.hpp"

#include <algorithm>
#include <atomic>
#include <new>

#include "core/session/expansions.hpp"

namespace replan {
namespace {

/// Iterations of a planner per slice: some milliseconds, so that a cancel is soon heard.
constexpr std::int64_t kSliceIterations = 20000;
/// Decisions of the robot per slice.
constexpr int kSliceDecisions = 64;
/// Events of one batch, so that taking it over fits between two frames.
constexpr std::size_t kBatchEvents = 400000;

bool is_marker(EventKind kind) {
  switch (kind) {
    case EventKind::plan_begin:
    case EventKind::plan_end:
    case EventKind::move:
    case EventKind::surprise:
    case EventKind::collision:
    case EventKind::waiting:
    case EventKind::arrival:
    case EventKind::gave_up:
    case EventKind::new_goal:
    case EventKind::put_down:
      return true;
    default:
      return false;
  }
}

std::uint64_t next_log_id() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

SearchState initial_state(const Scenario& scenario) {
  return SearchState(initial_knowledge(scenario), initial_truth(scenario));
}

}  // namespace

Run::Run(std::shared_ptr<const Scenario> scenario, std::size_t planner)
    : scenario_(std::move(scenario)),
      planner_(planner),
      info_(find_planner(scenario_->planners[planner].id)),
      lattice_(std::make_unique<const Grid2>(Grid2::Coordinates{scenario_->map.width, scenario_->map.height},
                                             scenario_->map.blocked,
                                             move_rules(scenario_->planners[planner].settings))),
      timeline_(initial_state(*scenario_)),
      log_id_(next_log_id()) {
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

Run::~Run() {
  thread_.request_stop();
  wake_.notify_all();
}

void Run::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [this] { return working_; })) {
    lock.unlock();
    Batch batch;
    std::string failure;
    try {
      batch = slice();
    } catch (const std::bad_alloc&) {
      failure =
          "the memory does not suffice for this run: choose a smaller world, or a planner that expands less";
      recorder_.clear();
    }
    recorded_ += batch.events.size();
    if (recorded_ > kMostEvents)
      failure = "the log of this run has reached its limit of 268 435 456 events: choose a smaller world";
    const bool done = !failure.empty() || reached();
    lock.lock();
    ready_.push_back(std::move(batch));
    if (!failure.empty()) failure_ = std::move(failure);
    if (done || cancelled_ || stop.stop_requested()) {
      working_ = false;
      idle_.notify_all();
    }
  }
}

Run::Batch Run::slice() {
  if (!mission_) mission_ = std::make_unique<Mission<Recorder>>(*scenario_, choice(), recorder_);
  Batch batch;
  for (int i = 0; i < kSliceDecisions && recorder_.buffer().size() < kBatchEvents && !reached(); ++i) {
    if (!mission_->advance(kSliceIterations)) i = kSliceDecisions;
    if (mission_->standing()) {
      batch.marks.push_back(mission_->now());
      batch.marks.back().event = recorder_.buffer().size();
    }
  }
  batch.events = recorder_.take();
  return batch;
}

bool Run::reached() const {
  if (!mission_->standing()) return false;
  if (mission_->state() != MissionState::driving) return true;
  if (target_.kind == Target::Kind::plan) return mission_->settled();
  return target_.kind == Target::Kind::clock && mission_->now().clock >= target_.clock;
}

void Run::go(Target target) {
  cancel();
  if (!failure().empty()) return;
  if (mission_) {
    target_ = target;
    if (reached()) return;
  }
  const std::scoped_lock lock(mutex_);
  target_ = target;
  cancelled_ = false;
  working_ = true;
  wake_.notify_all();
}

std::string Run::failure() const {
  const std::scoped_lock lock(mutex_);
  return failure_;
}

bool Run::busy() const {
  const std::scoped_lock lock(mutex_);
  return working_ || !ready_.empty();
}

bool Run::over() const {
  return !busy() && !marks_.empty() && marks_.back().state != MissionState::driving;
}

bool Run::pump() {
  std::deque<Batch> batches;
  {
    const std::scoped_lock lock(mutex_);
    batches.swap(ready_);
  }
  for (Batch& batch : batches) take_over(std::move(batch));
  return !batches.empty();
}

void Run::cancel() {
  {
    std::unique_lock lock(mutex_);
    cancelled_ = true;
    idle_.wait(lock, [this] { return !working_; });
  }
  pump();
}

void Run::finish(Target target) {
  go(target);
  {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return !working_; });
  }
  pump();
}

void Run::take_over(Batch&& batch) {
  const std::size_t base = timeline_.size();
  ExpansionCounter counter(timeline_, base);
  for (std::size_t i = 0; i < batch.events.size(); ++i) {
    const EventKind kind = batch.events[i].kind;
    const std::size_t bucket = (base + i) / kCurveChunk;
    if (bucket >= curve_.size()) curve_.resize(bucket + 1);
    if (counter.take(batch.events[i])) ++curve_[bucket];
    if (is_marker(kind)) markers_.push_back({base + i, kind});
  }
  for (Mark& mark : batch.marks) {
    mark.event += base;
    marks_.push_back(std::move(mark));
  }
  timeline_.append(batch.events);
}

std::size_t Run::common_with(std::uint64_t log_id) const {
  if (log_id == log_id_) return timeline_.size();
  const auto earlier = earlier_.find(log_id);
  return earlier == earlier_.end() ? 0 : earlier->second;
}

const Mark* Run::mark_at(std::size_t position) const {
  const auto after = std::upper_bound(marks_.begin(), marks_.end(), position,
                                      [](std::size_t p, const Mark& mark) { return p < mark.event; });
  return after == marks_.begin() ? nullptr : &*std::prev(after);
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
  std::size_t count = static_cast<std::size_t>(kept - marks_.begin());
  const bool partial = count < marks_.size();
  marks_.resize(count);
  for (std::size_t i = common; i < scenario->surprises.size(); ++i) {
    const auto& move = scenario->surprises[i].at.move;
    if (!move) return false;
    if (const Mark* mark = mark_for_new_surprise(*move))
      count = std::min(count, static_cast<std::size_t>(mark - marks_.data()) + 1);
  }
  if (count == 0) return false;
  scenario_ = std::move(scenario);
  if (partial || count < marks_.size() || !mission_->standing()) cut(count);
  mission_->set_surprises(scenario_->surprises);
  return true;
}

void Run::adopt(std::shared_ptr<const Scenario> scenario) {
  const Target target = target_;
  bool worked = false;
  {
    const std::scoped_lock lock(mutex_);
    worked = working_;
  }
  cancel();  // the mission may be about to be made from the old one
  scenario_ = std::move(scenario);
  if (worked) go(target);
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
  std::uint32_t expansions = 0;
  ExpansionCounter counter(timeline_, curve_.size() * kCurveChunk);
  for (std::size_t i = curve_.size() * kCurveChunk; i < size; ++i)
    expansions += counter.take(timeline_.event(i)) ? 1 : 0;
  curve_.push_back(expansions);
  recorded_ = size;
  mission_->restore(marks_.back(), timeline_.head());
}

}  // namespace replan
