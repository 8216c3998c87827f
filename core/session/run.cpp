#include "core/session/run.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/disposal.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

/// Events after which pump() looks at the clock.
constexpr std::size_t kPartEvents = 8192;
/// In step a slice of the planner has to end soon: of the largest searches these take half a millisecond.
constexpr std::int64_t kStepIterations = 500;

RunLimits limits_for(RunLimits limits, bool in_step) {
  if (in_step) limits.slice_iterations = std::min(limits.slice_iterations, kStepIterations);
  return limits;
}

}  // namespace

Run::Run(std::shared_ptr<const Scenario> scenario, std::size_t planner, const RunLimits& limits,
         const WorkPlace& place)
    : scenario_(std::move(scenario)),
      planner_(planner),
      in_step_(!place.on_thread()),
      limits_(limits_for(limits, in_step_)),
      worker_(std::make_unique<RunWorker>(scenario_, planner, limits_, !in_step_)) {
  begin_log();
}

// Nobody waits for the thread, nor until a large log is freed, unless somebody has kept a state of it: all
// that share its pages are for one thread.
Run::~Run() {
  worker_->stop();
  retire_log();
  tidy();
  if (retired_.empty()) dispose(std::move(worker_));
  dispose(std::move(reexecution_));
}

void Run::restart(std::shared_ptr<const Scenario> scenario) {
  scenario_ = std::move(scenario);
  worker_->begin_afresh(scenario_);
  rebase_.reset();
  begin_log();
}

/// The log of the scenario before its first event.
void Run::begin_log() {
  info_ = &info_of(choice());
  settings_ = settings_of(choice(), scenario_->robot);
  lattice_ = scenario_->map.box();
  if (timeline_) retire_log();
  if (reexecution_) dispose(std::move(reexecution_));
  const bool mapped = all_mapped();
  timeline_ = std::make_shared<Timeline>(initial_state(*scenario_, choice(), mapped), limits_.log);
  timeline_->set_source(
      [this](std::size_t position, const KeyFrame& frame, std::size_t from, std::size_t to) {
        if (!reexecution_)
          reexecution_ = std::make_unique<Reexecution>(scenario_, planner_, limits_.slice_iterations);
        return reexecution_->events(position, frame, from, to);
      });
  lends_ = false;
  dispose(std::exchange(decisions_, {}));
  milestones_.clear();
  dispose(std::exchange(stops_, {}));
  curve_.clear();
  earlier_.clear();
  dispose(std::exchange(handover_, std::nullopt));
  travel_ = 1;
  log_id_ = next_log_id();
}

/// Whether the map has no unmapped cell. Of a map that was looked through before only what has changed is
/// looked at.
bool Run::all_mapped() {
  const SharedBytes& cells = scenario_->map.blocked;
  bool mapped = true;
  const auto look = [&](std::size_t, std::span<const std::uint8_t>, std::span<const std::uint8_t> now) {
    mapped = mapped && !has_unmapped(now);
  };
  if (mapped_.size() != cells.size()) mapped_ = SharedBytes(cells.size());
  SharedBytes::each_unshared(mapped_, cells, look);
  mapped_ = mapped ? cells : SharedBytes();
  return mapped;
}

void Run::go(Target target) {
  if (rebase_)
    rebase_->target = target;
  else
    worker_->go(target);
}

void Run::cancel() {
  if (rebase_) rebase_->target.reset();
  worker_->stop();
}

std::string Run::failure() const {
  return worker_->failure();
}

bool Run::busy() const {
  return rebase_ || handover_ || !worker_->at_rest();
}

bool Run::over() const {
  return !busy() && !decisions_.empty() && decisions_.back().state != MissionState::driving;
}

bool Run::pump(const Deadline& deadline) {
  bool came = false;
  while (!deadline.passed()) {
    if (next_batch()) {
      take_over_part();
      came = true;
    } else if (!in_step_ || !worker_->step()) {
      break;
    }
  }
  if (carry_out_rebase()) came = true;
  tidy();
  return came;
}

void Run::finish(Target target) {
  go(target);
  wait();
}

bool Run::rest(std::optional<std::chrono::milliseconds> at_most) {
  using std::chrono::steady_clock;
  const steady_clock::time_point until =
      at_most ? steady_clock::now() + *at_most : steady_clock::time_point::max();
  while (busy() && steady_clock::now() < until) {
    if (!handover_) worker_->wait(until);
    while (steady_clock::now() < until && next_batch()) take_over_part();
    carry_out_rebase();
  }
  tidy();
  return !busy();
}

/// The log goes as soon as nobody else has a state of it. If somebody keeps one, its own are let go of by and
/// by.
void Run::retire_log() {
  retired_.push_back(std::move(timeline_));
  if (!retired_.back()->owns_its_states()) retired_.back()->retire();
}

/// Lets go of what cuts and earlier logs have left over, a state at a time.
void Run::tidy() {
  std::erase_if(retired_, [](std::shared_ptr<Timeline>& log) {
    if (log->owns_its_states()) dispose_of(std::move(log));
    return !log || !log->tidy();
  });
  if (!timeline_) return;
  if (lends_ && worker_->head_returned()) {
    timeline_->take_back();
    lends_ = false;
  }
  timeline_->tidy();
}

/// Whether there is a batch to take over; the next one comes into handover_.
bool Run::next_batch() {
  if (handover_) return true;
  auto batch = worker_->take();
  if (!batch) return false;
  handover_ = Handover{.batch = std::move(*batch), .base = timeline_->size()};
  return true;
}

/// Takes over the events up to the next checkpoint, but no more than a part.
void Run::take_over_part() {
  Handover& from = *handover_;
  RunWorker::Batch& batch = from.batch;
  const bool to_checkpoint = from.checkpoints < batch.checkpoints.size() &&
                             batch.checkpoints[from.checkpoints].first - from.events <= kPartEvents;
  const std::size_t end = to_checkpoint ? batch.checkpoints[from.checkpoints].first
                                        : std::min(from.events + kPartEvents, batch.events.size());
  const std::span<const Event> events =
      std::span<const Event>(batch.events).subspan(from.events, end - from.events);
  note_events(events);
  timeline_->append(events, to_checkpoint ? batch.checkpoints[from.checkpoints++].second : nullptr);
  from.events = end;
  for (; from.decisions < batch.decisions.size() && batch.decisions[from.decisions].event <= end;
       ++from.decisions) {
    decisions_.push_back(std::move(batch.decisions[from.decisions]));
    decisions_.back().event += from.base;
  }
  if (end < batch.events.size()) return;
  worker_->give_back(std::move(batch.events));
  handover_.reset();
}

void Run::note_events(std::span<const Event> events) {
  std::size_t position = timeline_->size();
  for (const Event& event : events) {
    const std::size_t bucket = position / kCurveChunk;
    if (bucket >= curve_.size()) curve_.resize(bucket + 1);
    if (is_expansion(event)) ++curve_[bucket];
    const bool milestone = kMilestones.has(event.kind);
    if (milestone) milestones_.push_back({position, event.kind, event.node, event.delta});
    stops_.add(event, milestone || event.kind == EventKind::pop);
    ++position;
  }
}

const Decision* Run::decision_at(std::size_t position) const {
  const auto after =
      std::upper_bound(decisions_.begin(), decisions_.end(), position,
                       [](std::size_t p, const Decision& decision) { return p < decision.event; });
  return after == decisions_.begin() ? nullptr : &*std::prev(after);
}

}  // namespace replan
