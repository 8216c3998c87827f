#include "core/session/run.hpp"

#include <algorithm>
#include <chrono>
#include <new>

namespace replan {
namespace {

/// Decisions of the robot per slice, and stretches of a search.
constexpr int kSliceDecisions = 64;
/// Events of one batch: some milliseconds of work, so that a cancel is soon heard.
constexpr std::size_t kBatchEvents = 400000;
/// Batches that wait to be taken over. With more the background waits too.
constexpr std::size_t kMostReady = 8;
/// Time that pump() takes of a frame, and the events after which it looks at the clock.
constexpr std::chrono::milliseconds kPumpTime{4};
constexpr std::size_t kPartEvents = 16384;

SearchState initial_state(const Scenario& scenario) {
  return SearchState(initial_knowledge(scenario), initial_truth(scenario));
}

}  // namespace

Run::Run(std::shared_ptr<const Scenario> scenario, std::size_t planner, const RunLimits& limits)
    : scenario_(std::move(scenario)),
      planner_(planner),
      info_(find_planner(scenario_->planners[planner].id)),
      lattice_(std::make_unique<const Grid2>(Grid2::Coordinates{scenario_->map.width, scenario_->map.height},
                                             scenario_->map.blocked,
                                             move_rules(scenario_->planners[planner].settings))),
      timeline_(initial_state(*scenario_), limits.log),
      log_id_(next_log_id()),
      limits_(limits) {
  timeline_.set_source([this](std::size_t position, const KeyFrame& frame, std::size_t from, std::size_t to) {
    if (!reexecution_)
      reexecution_ = std::make_unique<Reexecution>(scenario_, planner_, limits_.slice_iterations);
    return reexecution_->events(position, frame, from, to);
  });
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
    if (!done) room_.wait(lock, stop, [this] { return ready_.size() < kMostReady || cancelled_; });
    if (done || cancelled_ || stop.stop_requested()) working_ = false;
    idle_.notify_all();
  }
}

Run::Batch Run::slice() {
  if (!mission_) mission_ = std::make_unique<Mission<Recorder>>(*scenario_, choice(), recorder_);
  // Several to a key frame, so that one stands wherever the timeline wants one.
  const std::size_t checkpoint_events = std::max<std::size_t>(1, limits_.log.frame_interval / 8);
  const auto recorded = [this] { return recorder_.buffer().size(); };
  Batch batch;
  std::size_t next_checkpoint = 0;
  for (int i = 0; i < kSliceDecisions && recorded() < kBatchEvents && !reached(); ++i) {
    if (!mission_->advance(limits_.slice_iterations)) i = kSliceDecisions;
    if (mission_->standing()) {
      batch.marks.push_back(mission_->now());
      batch.marks.back().event = recorded();
    }
    if (recorded() < next_checkpoint) continue;
    auto checkpoint = std::make_shared<Checkpoint>(mission_->checkpoint());
    checkpoint->line = recorder_.current_line();
    batch.checkpoints.emplace_back(recorded(), std::move(checkpoint));
    next_checkpoint = recorded() + checkpoint_events;
  }
  std::vector<Event> next;
  if (const std::scoped_lock lock(mutex_); !spare_.empty()) {
    next = std::move(spare_.back());
    spare_.pop_back();
  }
  batch.events = recorder_.take(std::move(next));
  return batch;
}

bool Run::reached() const {
  if (target_.kind == Target::Kind::length && recorded_ + recorder_.buffer().size() >= target_.length)
    return true;
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
  return working_ || !ready_.empty() || handover_.has_value();
}

bool Run::over() const {
  return !busy() && !marks_.empty() && marks_.back().state != MissionState::driving;
}

bool Run::pump() {
  const auto until = std::chrono::steady_clock::now() + kPumpTime;
  bool came = false;
  while (std::chrono::steady_clock::now() < until && next_batch()) {
    take_over_part();
    came = true;
  }
  return came;
}

void Run::take_over_all() {
  while (next_batch()) take_over_part();
}

void Run::cancel() {
  {
    std::unique_lock lock(mutex_);
    cancelled_ = true;
    room_.notify_all();
    idle_.wait(lock, [this] { return !working_; });
  }
  take_over_all();
}

void Run::finish(Target target) {
  go(target);
  for (bool more = true; more;) {
    {
      std::unique_lock lock(mutex_);
      idle_.wait(lock, [this] { return !working_ || !ready_.empty(); });
      more = working_;
    }
    take_over_all();
  }
}

/// Whether there is a batch to take over; the next one comes into handover_.
bool Run::next_batch() {
  if (handover_) return true;
  const std::scoped_lock lock(mutex_);
  if (ready_.empty()) return false;
  handover_ = Handover{};
  handover_->batch = std::move(ready_.front());
  handover_->base = timeline_.size();
  ready_.pop_front();
  room_.notify_all();
  return true;
}

/// Takes over the events up to the next checkpoint, but no more than a part.
void Run::take_over_part() {
  Handover& from = *handover_;
  Batch& batch = from.batch;
  const bool to_checkpoint = from.checkpoints < batch.checkpoints.size() &&
                             batch.checkpoints[from.checkpoints].first - from.events <= kPartEvents;
  const std::size_t end = to_checkpoint ? batch.checkpoints[from.checkpoints].first
                                        : std::min(from.events + kPartEvents, batch.events.size());
  const std::span<const Event> events =
      std::span<const Event>(batch.events).subspan(from.events, end - from.events);
  note_events(events);
  timeline_.append(events, to_checkpoint ? batch.checkpoints[from.checkpoints++].second : nullptr);
  from.events = end;
  for (; from.marks < batch.marks.size() && batch.marks[from.marks].event <= end; ++from.marks) {
    marks_.push_back(std::move(batch.marks[from.marks]));
    marks_.back().event += from.base;
  }
  if (end < batch.events.size()) return;
  const std::scoped_lock lock(mutex_);
  if (spare_.size() < kMostReady) spare_.push_back(std::move(batch.events));
  handover_.reset();
}

void Run::note_events(std::span<const Event> events) {
  std::size_t position = timeline_.size();
  for (const Event& event : events) {
    const std::size_t bucket = position / kCurveChunk;
    if (bucket >= curve_.size()) curve_.resize(bucket + 1);
    if (counter_.take(event)) ++curve_[bucket];
    if (kMarkers.has(event.kind)) markers_.push_back({position, event.kind});
    ++position;
  }
}

const Mark* Run::mark_at(std::size_t position) const {
  const auto after = std::upper_bound(marks_.begin(), marks_.end(), position,
                                      [](std::size_t p, const Mark& mark) { return p < mark.event; });
  return after == marks_.begin() ? nullptr : &*std::prev(after);
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

}  // namespace replan
