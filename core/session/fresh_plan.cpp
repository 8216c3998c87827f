#include "core/session/fresh_plan.hpp"

#include <chrono>
#include <vector>

#include "core/plan/navigator.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

constexpr std::int64_t kSliceIterations = 20000;
/// Figures kept; a run that is played through asks for many.
constexpr std::size_t kMostPlans = 4096;

/// Counts the vertices that a log touches. Its own work before the first pop is the setting up of a fresh
/// search, which a planner that is not incremental has to undo first.
class TouchCount {
 public:
  explicit TouchCount(std::size_t nodes) : touched_(nodes) {}
  void take(const Event& event) {
    const bool touches =
        event.kind == EventKind::g || event.kind == EventKind::rhs || event.kind == EventKind::visit;
    if (!touches || touched_[event.node]) return;
    touched_[event.node] = true;
    ++count_;
  }
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  std::vector<bool> touched_;
  std::int64_t count_ = 0;
};

}  // namespace

FreshPlanTask::FreshPlanTask(const Run& run)
    : choice(planner_of(run.choice())),
      box(run.lattice()),
      known(run.timeline().state().known_map()),
      radius(run.scenario().robot.radius),
      start(run.timeline().state().node(Scalar::start)),
      goal(run.timeline().state().node(Scalar::goal)) {}

FreshPlan plan_from_scratch(const FreshPlanTask& task, const std::stop_token& stop) {
  Recorder recorder;
  const auto navigator = make_navigator(task.choice, task.box, task.known, task.radius, &recorder);
  TouchCount touched(task.box.node_count());
  FreshPlan fresh;
  const auto timed = [&fresh](auto&& step) {
    const auto begin = std::chrono::steady_clock::now();
    const bool done = step();
    fresh.ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return done;
  };
  timed([&] {
    navigator->begin(centre_of(task.box.position(task.start)), centre_of(task.box.position(task.goal)));
    return true;
  });
  for (bool done = false; !done && !stop.stop_requested();) {
    done = timed([&] { return navigator->advance(kSliceIterations); });
    for (const Event& event : recorder.take()) touched.take(event);
  }
  fresh.touched = touched.count();
  fresh.expansions = navigator->counters().expansions;
  return fresh;
}

FreshPlans::FreshPlans() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

std::optional<FreshPlan> FreshPlans::of(const Run& run, std::size_t number, bool wait) {
  const Key key{run.log_id(), number};
  std::unique_lock lock(mutex_);
  const auto answer = [&]() -> std::optional<FreshPlan> {
    const auto found = known_.find(key);
    return found == known_.end() ? std::nullopt : std::optional(found->second);
  };
  if (const auto known = answer()) return known;
  const bool under_way = working_ == key || (next_ && next_->key == key);
  if (!under_way) next_ = Job{key, FreshPlanTask(run)};
  wake_.notify_all();
  if (wait) done_.wait(lock, [&] { return known_.contains(key); });
  return answer();
}

bool FreshPlans::busy() const {
  const std::scoped_lock lock(mutex_);
  return working_.has_value() || next_.has_value();
}

void FreshPlans::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [this] { return next_.has_value(); })) {
    const Job job = std::move(*next_);
    next_.reset();
    working_ = job.key;
    lock.unlock();
    const FreshPlan fresh = plan_from_scratch(job.task, stop);
    lock.lock();
    working_.reset();
    if (stop.stop_requested()) return;
    if (known_.size() >= kMostPlans) known_.erase(known_.begin());
    known_.emplace(job.key, fresh);
    done_.notify_all();
  }
}

}  // namespace replan
