#include "core/experiment/results_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/file.hpp"
#include "core/base/folders.hpp"
#include "core/experiment/batch_file.hpp"

namespace replan {
namespace {

Error cannot_write(const std::string& path) {
  return {"cannot write '" + path + "': " + std::strerror(errno)};
}

/// What stands in the journal, and how many bytes of it are whole lines: the last one may have been cut off.
struct Journal {
  std::vector<RunResult> results;
  std::size_t whole = 0;
};

/// A line at a time: the text of many runs is as large as they are.
Result<Journal> read_journal(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{"cannot read '" + path + "': " + std::strerror(errno)};
  Journal journal;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line) && !file.eof(); ++number) {
    auto result = parse_result_line(line, path);
    if (!result)
      return Error{"line " + std::to_string(number) + " of '" + path +
                   "' is no result: delete that line, and its run is made again"};
    journal.results.push_back(std::move(result.value()));
    journal.whole += line.size() + 1;
  }
  if (file.bad()) return Error{"cannot read on in '" + path + "': " + std::strerror(errno)};
  return journal;
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
  results_ = own_results(std::move(journal->results));
  for (const RunResult& result : results_) done_.insert(result.run);
  return {};
}

/// Of each run of this part the first.
std::vector<RunResult> ResultsFolder::own_results(std::vector<RunResult> all) const {
  std::unordered_set<std::int64_t> seen;
  std::erase_if(all, [&](const RunResult& result) {
    return result.run >= head_.runs || !shard_.has(result.run) || !seen.insert(result.run).second;
  });
  return all;
}

ResultsFolder::ResultsFolder(ResultsFolder&& other) noexcept
    : path_(std::move(other.path_)),
      lock_(std::move(other.lock_)),
      head_(std::move(other.head_)),
      shard_(other.shard_),
      journal_(std::exchange(other.journal_, -1)),
      keeps_results_(other.keeps_results_),
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
  if (keeps_results_) results_.push_back(std::move(result));
  return {};
}

std::vector<RunResult> ResultsFolder::hand_over() {
  keeps_results_ = false;
  return std::exchange(results_, {});
}

Result<void> ResultsFolder::write_results() {
  std::vector<RunResult> read;
  if (!keeps_results_) {
    auto journal = read_journal(batch_path(path_, kJournalFile));
    if (!journal) return Error{journal.error()};
    read = own_results(std::move(journal->results));
  }
  std::vector<RunResult>& all = keeps_results_ ? results_ : read;
  std::sort(all.begin(), all.end(), [](const RunResult& a, const RunResult& b) { return a.run < b.run; });
  return write_result_files(path_, head_, all);
}

bool ResultsFolder::has_result_files() const {
  std::error_code failed;
  return std::all_of(kResultFiles.begin(), kResultFiles.end(), [&](const char* file) {
    return std::filesystem::exists(batch_path(path_, file), failed);
  });
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
