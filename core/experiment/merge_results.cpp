// Parts of an experiment put together.
#include <algorithm>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/base/folders.hpp"
#include "core/experiment/batch_file.hpp"

namespace replan {
namespace {

constexpr std::size_t kStretchesTold = 8;

/// All of the folders' results; the error tells folders that hold different experiments.
Result<KeptResults> gathered(std::span<const std::string> folders) {
  KeptResults all;
  for (const std::string& folder : folders) {
    auto kept = read_results_folder(folder);
    if (!kept) return Error{kept.error()};
    if (&folder == folders.data()) {
      all.head = kept->head;
      all.experiment = kept->experiment;
    } else if (kept->head.digest != all.head.digest) {
      return Error{"'" + folders.front() + "' and '" + folder +
                   "' have results of different experiments, or of one whose settings or maps have changed"};
    }
    for (RunResult& result : kept->results) all.results.push_back(std::move(result));
  }
  std::sort(all.results.begin(), all.results.end(),
            [](const RunResult& a, const RunResult& b) { return a.run < b.run; });
  return all;
}

/// Every run once.
Result<void> check_complete(const KeptResults& all) {
  std::vector<std::int64_t> doubled, missing;
  std::int64_t next = 0;
  for (const RunResult& result : all.results) {
    if (result.run < next) {
      if (doubled.empty() || doubled.back() != result.run) doubled.push_back(result.run);
      continue;
    }
    for (; next < result.run; ++next) missing.push_back(next);
    ++next;
  }
  for (; next < all.head.runs; ++next) missing.push_back(next);
  if (!doubled.empty())
    return Error{"runs are there twice: " + numbers_text(doubled) + "; give each part once"};
  if (!missing.empty())
    return Error{"runs are missing: " + numbers_text(missing) +
                 "; make them by 'replan batch' with the --shard and --out of their part"};
  return {};
}

}  // namespace

std::string numbers_text(std::span<const std::int64_t> numbers) {
  std::string text;
  std::size_t stretches = 0;
  for (std::size_t from = 0, to = 0; from < numbers.size(); from = to) {
    if (stretches++ == kStretchesTold)
      return text + " and " + std::to_string(numbers.size() - from) + " more";
    for (to = from + 1; to < numbers.size() && numbers[to] == numbers[to - 1] + 1;) ++to;
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[from]);
    if (to - from > 1) text += "-" + std::to_string(numbers[to - 1]);
  }
  return text;
}

Result<KeptResults> merge_results(std::span<const std::string> folders, const std::string& out) {
  if (std::filesystem::exists(batch_path(out, kBatchFile)))
    return Error{"'" + out + "' has results already: give another folder"};
  auto all = gathered(folders);
  if (!all) return all;
  if (const auto complete = check_complete(*all); !complete) return Error{complete.error()};
  if (const auto made = make_folder(out); !made) return Error{made.error()};
  std::string journal;
  for (const RunResult& result : all->results) journal += result_line(result) + "\n";
  if (const auto written = write_file_atomically(batch_path(out, kJournalFile), journal); !written)
    return Error{written.error()};
  if (const auto written = write_result_files(out, all->head, all->results); !written)
    return Error{written.error()};
  if (const auto written = write_batch_file(out, all->head, {}, all->experiment); !written)
    return Error{written.error()};
  return all;
}

}  // namespace replan
