#include "core/experiment/results_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/file.hpp"
#include "core/base/folders.hpp"
#include "core/experiment/batch_file.hpp"

namespace replan {
namespace {

constexpr std::int64_t kMaxJournalBytes = std::int64_t{1} << 36;

Error cannot_write(const std::string& path) {
  return {"cannot write '" + path + "': " + std::strerror(errno)};
}

/// What stands in the journal, and how many bytes of it are whole lines: the last one may have been cut off.
struct Journal {
  std::vector<RunResult> results;
  std::size_t whole = 0;
};

Result<Journal> read_journal(const std::string& path) {
  const auto text = read_file(path, kMaxJournalBytes);
  if (!text) return Error{text.error()};
  Journal journal;
  for (std::size_t number = 1;; ++number) {
    const std::size_t end = text->find('\n', journal.whole);
    if (end == std::string::npos) return journal;
    auto result = parse_result_line(text->substr(journal.whole, end - journal.whole), path);
    if (!result)
      return Error{"line " + std::to_string(number) + " of '" + path +
                   "' is no result: delete that line, and its run is made again"};
    journal.results.push_back(std::move(result.value()));
    journal.whole = end + 1;
  }
}

}  // namespace

Result<ResultsFolder> ResultsFolder::open(const std::string& path, const RunList& list, const Shard& shard) {
  if (const auto made = make_folder(path); !made) return Error{made.error()};
  auto lock = LockFile::try_lock(batch_path(path, "lock"));
  if (!lock)
    return Error{"another process is at work in the folder '" + path + "', or it cannot be written to"};
  ResultsFolder folder(path, std::move(*lock), results_head(list), shard);
  const std::string file = batch_path(path, kBatchFile);
  if (!std::filesystem::exists(file)) {
    if (std::filesystem::exists(batch_path(path, kJournalFile)))
      return Error{"'" + path + "' has runs of an experiment that is not there: give another folder"};
    if (const auto written = write_batch_file(path, folder.head_, shard, experiment_text(list.experiment()));
        !written)
      return Error{written.error()};
  }
  const auto kept = read_batch_file(path);
  if (!kept) return Error{kept.error()};
  if (kept->head.digest != folder.head_.digest)
    return Error{"'" + path +
                 "' has results of another experiment, or its settings or maps have changed since: give "
                 "another folder"};
  if (kept->shard != shard)
    return Error{"'" + path + "' has results of part " + std::to_string(kept->shard.index + 1) + " of " +
                 std::to_string(kept->shard.count) + ": give another folder, or --shard as before"};
  if (const auto taken = folder.take_up(); !taken) return Error{taken.error()};
  return folder;
}

Result<void> ResultsFolder::take_up() {
  const std::string path = batch_path(path_, kJournalFile);
  journal_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (journal_ < 0) return cannot_write(path);
  auto journal = read_journal(path);
  if (!journal) return Error{journal.error()};
  if (::ftruncate(journal_, static_cast<off_t>(journal->whole)) != 0) return cannot_write(path);
  for (RunResult& result : journal->results)
    if (result.run < head_.runs && shard_.has(result.run) && done_.insert(result.run).second)
      results_.push_back(std::move(result));
  return {};
}

ResultsFolder::ResultsFolder(ResultsFolder&& other) noexcept
    : path_(std::move(other.path_)),
      lock_(std::move(other.lock_)),
      head_(std::move(other.head_)),
      shard_(other.shard_),
      journal_(std::exchange(other.journal_, -1)),
      results_(std::move(other.results_)),
      done_(std::move(other.done_)) {}

ResultsFolder::~ResultsFolder() {
  if (journal_ >= 0) ::close(journal_);
  lock_.remove();
}

std::vector<std::int64_t> ResultsFolder::missing() const {
  std::vector<std::int64_t> numbers;
  for (std::int64_t run = shard_.index; run < head_.runs; run += shard_.count)
    if (!done_.contains(run)) numbers.push_back(run);
  return numbers;
}

Result<void> ResultsFolder::add(RunResult result) {
  if (write_all(journal_, result_line(result) + "\n") != 0)
    return cannot_write(batch_path(path_, kJournalFile));
  done_.insert(result.run);
  results_.push_back(std::move(result));
  return {};
}

Result<void> ResultsFolder::write_results() {
  std::sort(results_.begin(), results_.end(),
            [](const RunResult& a, const RunResult& b) { return a.run < b.run; });
  return write_result_files(path_, head_, results_);
}

Result<KeptResults> read_results_folder(const std::string& path) {
  auto kept = read_batch_file(path);
  if (!kept) return Error{kept.error()};
  auto journal = read_journal(batch_path(path, kJournalFile));
  if (!journal) return Error{journal.error()};
  kept->results = std::move(journal->results);
  return kept;
}

}  // namespace replan
