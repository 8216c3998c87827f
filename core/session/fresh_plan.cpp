#include "core/session/fresh_plan.hpp"

#include <chrono>
#include <utility>
#include <vector>

#include "core/base/disposal.hpp"
#include "core/plan/navigator.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

constexpr std::int64_t kFreshIterations = 500;
/// Figures kept; a run that is played through asks for many.
constexpr std::size_t kMostPlans = 4096;

}  // namespace

FreshPlanTask::FreshPlanTask(const Run& run)
    : choice(planner_of(run.choice())),
      box(run.lattice()),
      known(run.timeline().state().known_map()),
      radius(run.scenario().robot.radius),
      start(run.timeline().state().node(Scalar::start)),
      goal(run.timeline().state().node(Scalar::goal)) {}

/// Counts the vertices that a log touches. Its own work before the first pop is the setting up of a fresh
/// search, which a planner that is not incremental has to undo first.
class FreshPlanSearch::TouchCount {
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

struct FreshPlanSearch::Parts {
  explicit Parts(FreshPlanTask its_task) : task(std::move(its_task)), touched(task.box.node_count()) {}

  template <class Work>
  bool timed(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    const bool done = work();
    ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return done;
  }
  bool begin() {
    navigator->begin(centre_of(task.box.position(task.start)), centre_of(task.box.position(task.goal)));
    return false;
  }

  FreshPlanTask task;
  Recorder recorder;
  std::unique_ptr<Navigator> navigator;
  TouchCount touched;
  bool begun = false;
  double ms = 0;
};

FreshPlanSearch::FreshPlanSearch(FreshPlanTask task) : parts_(std::make_unique<Parts>(std::move(task))) {}
// A large search is given back where nobody waits for it.
FreshPlanSearch::~FreshPlanSearch() {
  dispose(std::move(parts_));
}

bool FreshPlanSearch::advance() {
  Parts& parts = *parts_;
  const FreshPlanTask& task = parts.task;
  if (!parts.navigator) {
    parts.navigator = make_navigator(task.choice, task.box, task.known, task.radius, &parts.recorder);
    return true;
  }
  const bool done = std::exchange(parts.begun, true)
                        ? parts.timed([&] { return parts.navigator->advance(kFreshIterations); })
                        : parts.timed([&] { return parts.begin(); });
  for (const Event& event : parts.recorder.buffer()) parts.touched.take(event);
  parts.recorder.clear();
  return !done;
}

FreshPlan FreshPlanSearch::counted() const {
  return {.touched = parts_->touched.count(),
          .expansions = parts_->navigator ? parts_->navigator->counters().expansions : 0,
          .ms = parts_->ms};
}

FreshPlan plan_from_scratch(const FreshPlanTask& task, const StopToken& stop) {
  FreshPlanSearch search(task);
  while (!stop.stop_requested() && search.advance()) {
  }
  return search.counted();
}

std::optional<FreshPlan> FreshPlans::of(const Run& run, std::size_t number, bool wait) {
  const Key key{run.log_id(), number};
  go_on();
  const bool under_way = working_ == key || (next_ && next_->key == key);
  if (!under_way && !known_.contains(key)) next_ = Job{key, FreshPlanTask(run)};
  go_on();
  while (wait && !known_.contains(key)) {
    job_.wait();
    go_on();
  }
  const auto found = known_.find(key);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

bool FreshPlans::busy() {
  go_on();
  return working_ || next_;
}

/// Takes over what has come and begins with what is next.
void FreshPlans::go_on() {
  if (const auto fresh = job_.take()) {
    if (known_.size() >= kMostPlans) known_.erase(known_.begin());
    known_.emplace(*std::exchange(working_, std::nullopt), *fresh);
  }
  if (working_ || !next_) return;
  working_ = next_->key;
  job_.start_slices([search = std::make_shared<FreshPlanSearch>(std::move(next_->task))](const StopToken&) {
    return search->advance() ? std::nullopt : std::optional(search->counted());
  });
  next_.reset();
}

}  // namespace replan
