#include "core/experiment/batch_job.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <mutex>
#include <new>

#include "core/base/threads.hpp"
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
  [[nodiscard]] StopToken token() const { return stop_.get_token(); }
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

  void begin(std::shared_ptr<const RunList> list, std::deque<RunResult> kept) {
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

  std::vector<RunResult> take(std::size_t most) {
    const std::lock_guard lock(mutex_);
    const auto end = fresh_.begin() + static_cast<std::ptrdiff_t>(std::min(most, fresh_.size()));
    std::vector<RunResult> taken(std::make_move_iterator(fresh_.begin()), std::make_move_iterator(end));
    fresh_.erase(fresh_.begin(), end);
    return taken;
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
  Signal resumed_;
  StopSource stop_;
  std::shared_ptr<const RunList> list_;
  std::deque<RunResult> fresh_;
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

/// A batch that was begun.
struct OpenBatch {
  std::shared_ptr<const RunList> list;
  ResultsFolder folder;
  std::vector<std::int64_t> missing;  ///< runs that the folder had not
};

/// Loads the runs, and lets `shared`, a BatchJob::Shared, know of them and of the results that the folder holds.
template <class S>
Result<OpenBatch> open_batch(const BatchRequest& request, S& shared) {
  auto loaded = list_of(request);
  if (!loaded) return Error{loaded.error()};
  const auto list = std::make_shared<const RunList>(std::move(loaded.value()));
  auto folder = ResultsFolder::open(request.folder, *list, {});
  if (!folder) return Error{folder.error()};
  std::deque<RunResult> before;
  if (const auto read = folder->each([&](const RunResult& result) { before.push_back(result); }); !read)
    return Error{read.error()};
  shared.begin(list, std::move(before));
  std::vector<std::int64_t> missing = folder->missing();
  return OpenBatch{list, std::move(folder.value()), std::move(missing)};
}

/// Files that are complete are left alone.
BatchEnd close_batch(const OpenBatch& batch) {
  if (batch.missing.empty() && batch.folder.has_result_files()) return {true, ""};
  if (const auto written = batch.folder.write_results(); !written) return {false, written.error()};
  return {true, ""};
}

/// Makes the runs that the folder lacks, on a thread and others of its own.
template <class S>
BatchEnd make_batch(const BatchRequest& request, S& shared, const std::function<void()>& wake) {
  auto batch = open_batch(request, shared);
  if (!batch) return {false, batch.error()};
  Result<void> kept;
  const auto take = [&](const RunResult& result) {
    kept = batch->folder.add(result);
    if (!kept) return false;
    if (shared.add(result) && wake) wake();
    shared.wait_while_paused();
    return true;
  };
  const bool all =
      make_runs(*batch->list, batch->missing, request.jobs, {.take = take, .stop = shared.token()});
  if (!kept) return {false, kept.error()};
  return all ? close_batch(*batch) : BatchEnd{};
}

/// The same in step: one run after the other, each of them a slice.
template <class S>
class BatchInStep {
 public:
  BatchInStep(BatchRequest request, std::shared_ptr<S> shared)
      : request_(std::move(request)), shared_(std::move(shared)) {}

  /// Its end, once it has come to it.
  std::optional<BatchEnd> advance() {
    if (!worker_) return begin();
    if (shared_->token().stop_requested()) return BatchEnd{};
    if (next_ == batch_->missing.size()) return close_batch(*batch_);
    auto result = worker_->make(batch_->missing[next_++], shared_->token());
    if (!result) return BatchEnd{};
    if (const auto kept = batch_->folder.add(*result); !kept) return BatchEnd{false, kept.error()};
    shared_->add(std::move(*result));
    return std::nullopt;
  }

 private:
  std::optional<BatchEnd> begin() {
    auto batch = open_batch(request_, *shared_);
    if (!batch) return BatchEnd{false, batch.error()};
    batch_.emplace(std::move(batch.value()));
    worker_.emplace(*batch_->list);
    return std::nullopt;
  }

  BatchRequest request_;
  std::shared_ptr<S> shared_;
  std::optional<OpenBatch> batch_;
  std::size_t next_ = 0;  // in its missing runs
  std::optional<ExperimentWorker> worker_;
};

/// What `make` comes to, where memory suffices for it.
template <class Make>
auto within_memory(const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
    return BatchEnd{false, "there is too little memory for these runs: give fewer jobs, or a smaller world"};
  }
}

}  // namespace

void BatchJob::start(BatchRequest request) {
  shared_ = std::make_shared<Shared>();
  if (place_.on_thread())
    return work_.start(
        [shared = shared_, request = std::move(request), wake = place_.wake](const StopToken&) {
          return within_memory([&] { return make_batch(request, *shared, wake); });
        });
  work_.start_slices([batch = std::make_shared<BatchInStep<Shared>>(std::move(request), shared_)](
                         const StopToken&) { return within_memory([&] { return batch->advance(); }); },
                     [shared = shared_] { return shared->paused() && !shared->token().stop_requested(); });
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

std::vector<RunResult> BatchJob::take_results(std::size_t most) {
  return shared_ ? shared_->take(most) : std::vector<RunResult>();
}

std::shared_ptr<const RunList> BatchJob::list() const {
  return shared_ ? shared_->list() : nullptr;
}

}  // namespace replan
