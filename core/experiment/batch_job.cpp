#include "core/experiment/batch_job.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>

#include "core/experiment/results_folder.hpp"
#include "core/experiment/run_experiment.hpp"

namespace replan {
namespace {

using Clock = std::chrono::steady_clock;

/// A window that is woken for every run of many short ones would do nothing else.
constexpr auto kBetweenWakes = std::chrono::milliseconds(50);

}  // namespace

/// What both threads know of a batch.
class BatchJob::Shared {
 public:
  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  void stop() { stop_.request_stop(); }

  void pause(bool on) {
    const std::lock_guard lock(mutex_);
    paused_ = on;
    restart_clock();
    resumed_.notify_all();
  }
  [[nodiscard]] bool paused() const {
    const std::lock_guard lock(mutex_);
    return paused_;
  }

  void begin(std::shared_ptr<const RunList> list, std::vector<RunResult> kept) {
    const std::lock_guard lock(mutex_);
    list_ = std::move(list);
    done_ = kept.size();
    fresh_ = std::move(kept);
    restart_clock();
  }
  /// Whether the window should be woken.
  bool add(RunResult result) {
    const std::lock_guard lock(mutex_);
    fresh_.push_back(std::move(result));
    ++done_;
    ++made_;
    const bool due = Clock::now() - woken_ > kBetweenWakes;
    if (due) woken_ = Clock::now();
    return due;
  }
  void wait_while_paused() {
    std::unique_lock lock(mutex_);
    resumed_.wait(lock, stop_.get_token(), [this] { return !paused_; });
  }

  std::vector<RunResult> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(fresh_, {});
  }
  [[nodiscard]] std::shared_ptr<const RunList> list() const {
    const std::lock_guard lock(mutex_);
    return list_;
  }
  [[nodiscard]] BatchProgress progress() const {
    const std::lock_guard lock(mutex_);
    BatchProgress progress{done_, list_ ? static_cast<std::size_t>(list_->count()) : 0, std::nullopt};
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    if (made_ > 0 && !paused_)
      progress.seconds_left =
          seconds / static_cast<double>(made_) * static_cast<double>(progress.all - done_);
    return progress;
  }

 private:
  void restart_clock() {
    begun_ = Clock::now();
    made_ = 0;
  }

  mutable std::mutex mutex_;
  std::condition_variable_any resumed_;
  std::stop_source stop_;
  std::shared_ptr<const RunList> list_;
  std::vector<RunResult> fresh_;
  bool paused_ = false;
  std::size_t done_ = 0;
  std::size_t made_ = 0;  // since begun_
  Clock::time_point begun_, woken_;
};

namespace {

/// The experiment with its worlds loaded, and both in the folder if they are in no file yet.
Result<RunList> list_of(const BatchRequest& request) {
  auto experiment = put_world(request.what, request.folder);
  if (!experiment) return Error{experiment.error()};
  auto list = RunList::load(std::move(experiment.value()));
  if (!list || request.what.world == nullptr) return list;
  const std::string file = request.folder + "/" + kExperimentFile;
  if (const auto put = put_experiment(list->experiment(), file); !put) return Error{put.error()};
  return list;
}

/// Makes the runs that the folder lacks. `S` is BatchJob::Shared.
template <class S>
BatchEnd make_batch(const BatchRequest& request, S& shared, const std::function<void()>& wake) {
  auto loaded = list_of(request);
  if (!loaded) return {false, loaded.error()};
  const auto list = std::make_shared<const RunList>(std::move(loaded.value()));
  auto folder = ResultsFolder::open(request.folder, *list, {});
  if (!folder) return {false, folder.error()};
  std::vector<RunResult> before;
  auto kept = folder->each([&](const RunResult& result) { before.push_back(result); });
  if (!kept) return {false, kept.error()};
  shared.begin(list, std::move(before));
  const auto take = [&](const RunResult& result) {
    kept = folder->add(result);
    if (!kept) return false;
    if (shared.add(result) && wake) wake();
    shared.wait_while_paused();
    return true;
  };
  const bool all = make_runs(*list, folder->missing(), request.jobs, {.take = take, .stop = shared.token()});
  if (!kept) return {false, kept.error()};
  if (!all) return {};
  if (const auto written = folder->write_results(); !written) return {false, written.error()};
  return {true, ""};
}

}  // namespace

void BatchJob::start(BatchRequest request) {
  shared_ = std::make_shared<Shared>();
  work_.start([shared = shared_, request = std::move(request),
               wake = place_.wake](const std::stop_token&) -> BatchEnd {
    try {
      return make_batch(request, *shared, wake);
    } catch (const std::bad_alloc&) {
      return {false, "there is too little memory for these runs: give fewer jobs, or a smaller world"};
    }
  });
}

void BatchJob::pause() {
  if (shared_) shared_->pause(true);
}

void BatchJob::go_on() {
  if (shared_) shared_->pause(false);
}

void BatchJob::stop() {
  if (shared_) shared_->stop();
}

bool BatchJob::paused() const {
  return busy() && shared_->paused();
}

BatchProgress BatchJob::progress() const {
  return shared_ ? shared_->progress() : BatchProgress{};
}

std::vector<RunResult> BatchJob::take_results() {
  return shared_ ? shared_->take() : std::vector<RunResult>();
}

std::shared_ptr<const RunList> BatchJob::list() const {
  return shared_ ? shared_->list() : nullptr;
}

}  // namespace replan
