#include "core/experiment/results_folder.hpp"

#include <algorithm>
#include <filesystem>

#include "core/base/folders.hpp"
#include "core/experiment/batch_file.hpp"
#include "core/experiment/result_files.hpp"

namespace replan {
namespace {

/// What is in the folder, if it can be gone on with.
Result<void> check_kept(const std::string& path, const ResultsHead& head, const Shard& shard) {
  const auto kept = read_batch_file(path);
  if (!kept) return Error{kept.error()};
  if (kept->head.digest != head.digest)
    return Error{
        "'" + path +
        "' has results of another experiment, or its settings or maps have changed since, or an older "
        "replan has made them: give another folder"};
  if (kept->shard != shard)
    return Error{"'" + path + "' has results of part " + std::to_string(kept->shard.index + 1) + " of " +
                 std::to_string(kept->shard.count) + ": give another folder, or --shard as before"};
  return {};
}

/// What an earlier process has left there, or the beginning of it.
Result<Journal> begin_or_go_on(const std::string& path, const RunList& list, const Shard& shard) {
  const ResultsHead head = results_head(list);
  if (!std::filesystem::exists(batch_path(path, kBatchFile))) {
    if (std::filesystem::exists(batch_path(path, kJournalFile)))
      return Error{"'" + path + "' has runs of an experiment that is not there: give another folder"};
    if (const auto written = write_batch_file(path, head, shard, experiment_text(list.experiment()));
        !written)
      return Error{written.error()};
  }
  if (const auto good = check_kept(path, head, shard); !good) return Error{good.error()};
  return Journal::take_up(batch_path(path, kJournalFile));
}

bool has_lower_number(const Journal::Line& a, const Journal::Line& b) {
  return a.run < b.run;
}

}  // namespace

Result<ResultsFolder> ResultsFolder::open(const std::string& path, const RunList& list, const Shard& shard) {
  if (const auto made = make_folder(path); !made) return Error{made.error()};
  auto lock = LockFile::take(batch_path(path, "lock"));
  if (!lock)
    return Error{"cannot keep results in the folder '" + path + "': its file 'lock' cannot be made: " +
                 lock.error() + "; give a folder on a disk that you may write to and that takes file locks"};
  if (!lock->has_value())
    return Error{"another process is at work in the folder '" + path +
                 "': wait for its end, or give another folder"};
  auto journal = begin_or_go_on(path, list, shard);
  if (journal)
    return ResultsFolder(path, std::move(*lock.value()), std::move(journal.value()), results_head(list),
                         shard);
  lock.value()->remove();
  return Error{journal.error()};
}

ResultsFolder::ResultsFolder(std::string path, LockFile lock, Journal journal, ResultsHead head,
                             const Shard& shard)
    : path_(std::move(path)),
      lock_(std::move(lock)),
      journal_(std::move(journal)),
      head_(std::move(head)),
      shard_(shard) {
  for (const Journal::Line& line : journal_.lines())
    if (line.run < head_.runs && shard_.has(line.run) && done_.insert(line.run).second) kept_.push_back(line);
}

ResultsFolder::~ResultsFolder() {
  lock_.remove();
}

std::vector<std::int64_t> ResultsFolder::missing() const {
  std::vector<std::int64_t> numbers;
  for (std::int64_t run = shard_.index; run < head_.runs; run += shard_.count)
    if (!done_.contains(run)) numbers.push_back(run);
  return numbers;
}

Result<void> ResultsFolder::add(const RunResult& result) {
  if (const auto added = journal_.add(result); !added) return added;
  done_.insert(result.run);
  kept_.push_back(journal_.lines().back());
  return {};
}

Result<void> ResultsFolder::each(const TakeResult& take) const {
  std::vector<Journal::Line> lines = kept_;
  std::sort(lines.begin(), lines.end(), has_lower_number);
  for (const Journal::Line& line : lines) {
    const auto result = journal_.result(line);
    if (!result) return Error{result.error()};
    take(*result);
  }
  return {};
}

Result<void> ResultsFolder::write_results(const TakeResult& also) const {
  auto files = ResultFiles::create(path_, head_);
  if (!files) return Error{files.error()};
  Result<void> written;
  const auto read = each([&](const RunResult& result) {
    if (written) written = files->add(result);
    if (also) also(result);
  });
  if (!read) return read;
  return written ? files->commit() : written;
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
  const auto journal = Journal::read(batch_path(path, kJournalFile));
  if (!journal) return Error{journal.error()};
  for (const Journal::Line& line : journal->lines()) {
    auto result = journal->result(line);
    if (!result) return Error{result.error()};
    kept->results.push_back(std::move(result.value()));
  }
  return kept;
}

}  // namespace replan
