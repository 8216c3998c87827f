#include "core/session/run_worker.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "core/base/disposal.hpp"

namespace replan {
namespace {

/// Decisions of the robot per batch.
constexpr int kBatchDecisions = 64;
/// Events of one batch: some milliseconds of work. In step a batch is what one call of the mission has recorded.
constexpr std::size_t kBatchEvents = 100000;
/// Batches that wait to be taken. With more the thread waits too.
constexpr std::size_t kMostReady = 16;
/// Events: a larger batch gives its memory back to the system, which takes too long for who has taken it over.
constexpr std::size_t kMostSpared = std::size_t{1} << 20;

}  // namespace

RunWorker::RunWorker(std::shared_ptr<const Scenario> scenario, std::size_t planner, const RunLimits& limits,
                     bool on_thread)
    : planner_(planner), limits_(limits), on_thread_(on_thread), scenario_(std::move(scenario)) {
  if (on_thread_) thread_ = Thread([this](const StopToken& stop) { work(stop); });
}

RunWorker::~RunWorker() {
  hurry_ = true;
  thread_.request_stop();
}

// Orders.

void RunWorker::go(Target target) {
  const std::scoped_lock lock(mutex_);
  if (!failure_.empty()) return;
  target_ = target;
  wanted_ = true;
  wake_.notify_all();
}

void RunWorker::stop() {
  const std::scoped_lock lock(mutex_);
  wanted_ = false;
  hurry_ = true;
  room_.notify_all();
}

void RunWorker::begin_afresh(std::shared_ptr<const Scenario> scenario) {
  stop();
  const std::scoped_lock lock(mutex_);
  ++begun_;
  orders_ = {.fresh = std::move(scenario), .script = {}, .back = {}};
  dispose(std::exchange(ready_, {}));
  failure_.clear();
}

void RunWorker::set_script(std::shared_ptr<const Scenario> scenario) {
  const std::scoped_lock lock(mutex_);
  orders_.script = std::move(scenario);
}

void RunWorker::go_back(const Decision& decision, std::shared_ptr<Timeline> log) {
  const SearchState* head = &log->lend_head();
  const std::scoped_lock lock(mutex_);
  orders_.back = Back{decision, std::move(log), head};
  lent_ = true;
}

// What the owner asks.

bool RunWorker::head_returned() const {
  const std::scoped_lock lock(mutex_);
  return !lent_;
}

std::optional<RunWorker::Batch> RunWorker::take() {
  const std::scoped_lock lock(mutex_);
  if (ready_.empty()) return std::nullopt;
  Batch batch = std::move(ready_.front());
  ready_.pop_front();
  room_.notify_all();
  return batch;
}

void RunWorker::give_back(std::vector<Event> memory) {
  {
    const std::scoped_lock lock(mutex_);
    if (memory.capacity() <= kMostSpared && spare_.size() < kMostReady / 2)
      return spare_.push_back(std::move(memory));
  }
  dispose(std::move(memory));  // a whole world's, of a planner that sets up every cell
}

bool RunWorker::at_rest() const {
  const std::scoped_lock lock(mutex_);
  return !wanted_ && !at_work_ && ready_.empty();
}

std::string RunWorker::failure() const {
  const std::scoped_lock lock(mutex_);
  return failure_;
}

void RunWorker::wait(std::chrono::steady_clock::time_point until) {
  if (!on_thread_) {
    while (ready_.empty() && std::chrono::steady_clock::now() < until && step()) {
    }
    return;
  }
  std::unique_lock lock(mutex_);
  const auto news = [this] { return !ready_.empty() || (!wanted_ && !at_work_); };
  if (until == std::chrono::steady_clock::time_point::max())
    news_.wait(lock, news);  // no clock can tell that time
  else
    news_.wait_until(lock, until, news);
}

bool RunWorker::step() {
  std::unique_lock lock(mutex_);
  if (!wanted_ || ready_.size() >= kMostReady) return false;
  do_some(lock);
  return true;
}

// The thread.

void RunWorker::work(const StopToken& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [this] { return wanted_; }) && !stop.stop_requested()) {
    do_some(lock);
    news_.notify_all();
    room_.wait(lock, stop, [this] { return ready_.size() < kMostReady || !wanted_; });
  }
}

/// What was ordered, and a batch.
void RunWorker::do_some(std::unique_lock<std::mutex>& lock) {
  Orders orders = std::exchange(orders_, {});
  const std::uint64_t begun = begun_;
  const Target target = target_;
  at_work_ = true;
  hurry_ = false;
  lock.unlock();
  Batch batch;
  std::string failure = work_on(std::move(orders), target, batch);
  lock.lock();
  at_work_ = false;
  if (!orders_.back) lent_ = false;
  if (begun != begun_) return;
  if (!batch.events.empty() || !batch.decisions.empty()) ready_.push_back(std::move(batch));
  if (!orders_.any() && (!failure.empty() || reached(target_))) wanted_ = false;
  failure_ = std::move(failure);
}

/// Why it could not be done, or nothing.
std::string RunWorker::work_on(Orders orders, Target target, Batch& batch) {
  try {
    const bool made_ready = orders.any() || !mission_;
    carry_out(std::move(orders));
    set_out();
    if (!on_thread_ && made_ready) return {};  // that was a slice
    fill(batch, target);
  } catch (const std::bad_alloc&) {
    recorder_.clear();
    batch = {};
    return "the memory does not suffice for this run: choose a smaller world, or a planner that expands less";
  }
  recorded_ += batch.events.size();
  static_assert(kMostEvents == 1'073'741'824);
  if (recorded_ > kMostEvents)
    return "the log of this run has reached its limit of 1 073 741 824 events: choose a smaller world";
  return {};
}

void RunWorker::carry_out(Orders orders) {
  if (orders.fresh) {
    mission_.reset();
    scenario_ = std::move(orders.fresh);
    recorder_ = {};
    recorded_ = next_checkpoint_ = 0;
  }
  if (orders.back) {
    set_out();
    recorder_.clear();
    mission_->restore(orders.back->decision, *orders.back->head);
    recorded_ = next_checkpoint_ = orders.back->decision.event;
  }
  if (orders.script) {
    scenario_ = std::move(orders.script);
    if (mission_) mission_->set_surprises(scenario_->surprises);
  }
}

void RunWorker::set_out() {
  if (!mission_) mission_ = make_mission(*scenario_, choice(), &recorder_);
}

void RunWorker::fill(Batch& batch, Target target) {
  // Several to a key frame, so that one stands wherever the timeline wants one.
  const std::size_t checkpoint_events = std::max<std::size_t>(1, limits_.log.frame_interval / 8);
  const auto recorded = [this] { return recorder_.buffer().size(); };
  const int most = on_thread_ ? kBatchDecisions : 1;
  for (int i = 0; i < most && recorded() < kBatchEvents && !hurry_ && !reached(target); ++i) {
    if (!mission_->advance(limits_.slice_iterations)) i = most;
    if (mission_->standing()) {
      batch.decisions.push_back(mission_->now());
      batch.decisions.back().event = recorded();
    }
    if (recorded_ + recorded() < next_checkpoint_) continue;
    auto checkpoint = std::make_shared<Checkpoint>(mission_->checkpoint());
    checkpoint->line = recorder_.current_line();
    batch.checkpoints.emplace_back(recorded(), std::move(checkpoint));
    next_checkpoint_ = recorded_ + recorded() + checkpoint_events;
  }
  batch.events = recorder_.take(spare());
}

bool RunWorker::reached(Target target) const {
  if (!mission_) return false;
  if (target.kind == Target::Kind::length && recorded_ + recorder_.buffer().size() >= target.length)
    return true;
  if (!mission_->standing()) return false;
  if (mission_->state() != MissionState::driving) return true;
  if (target.kind == Target::Kind::plan) return mission_->settled();
  return target.kind == Target::Kind::clock && mission_->now().clock >= target.clock;
}

std::vector<Event> RunWorker::spare() {
  const std::scoped_lock lock(mutex_);
  if (spare_.empty()) return {};
  std::vector<Event> memory = std::move(spare_.back());
  spare_.pop_back();
  return memory;
}

}  // namespace replan
