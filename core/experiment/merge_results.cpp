// Parts of an experiment put together.
#include <algorithm>
#include <filesystem>

#include "core/base/folders.hpp"
#include "core/base/pending_file.hpp"
#include "core/experiment/batch_file.hpp"
#include "core/experiment/result_files.hpp"

namespace replan {
namespace {

constexpr std::size_t kStretchesTold = 8;

/// The folders' journals, and what they say of their experiment.
struct Parts {
  ResultsHead head;
  std::string experiment;
  std::vector<Journal> journals;

  /// A line of one of them.
  struct Place {
    Journal::Line line;
    std::size_t journal = 0;
  };
  /// Of all lines, in the order of their runs.
  [[nodiscard]] std::vector<Place> places() const {
    std::vector<Place> all;
    for (std::size_t i = 0; i < journals.size(); ++i)
      for (const Journal::Line& line : journals[i].lines()) all.push_back({line, i});
    std::sort(all.begin(), all.end(), [](const Place& a, const Place& b) { return a.line.run < b.line.run; });
    return all;
  }
};

/// The error tells folders that hold different experiments.
Result<Parts> gathered(std::span<const std::string> folders) {
  Parts parts;
  for (const std::string& folder : folders) {
    auto kept = read_batch_file(folder);
    if (!kept) return Error{kept.error()};
    if (&folder == folders.data()) {
      parts.head = kept->head;
      parts.experiment = kept->experiment;
    } else if (kept->head.digest != parts.head.digest) {
      return Error{"'" + folders.front() + "' and '" + folder +
                   "' have results of different experiments, or of one whose settings or maps have changed"};
    }
    auto journal = Journal::read(batch_path(folder, kJournalFile));
    if (!journal) return Error{journal.error()};
    parts.journals.push_back(std::move(journal.value()));
  }
  return parts;
}

/// Every run once.
Result<void> check_complete(std::span<const Parts::Place> places, std::int64_t runs) {
  std::vector<std::int64_t> doubled, missing;
  std::int64_t next = 0;
  for (const Parts::Place& place : places) {
    const std::int64_t run = place.line.run;
    if (run < next) {
      if (doubled.empty() || doubled.back() != run) doubled.push_back(run);
      continue;
    }
    for (; next < run; ++next) missing.push_back(next);
    ++next;
  }
  for (; next < runs; ++next) missing.push_back(next);
  if (!doubled.empty())
    return Error{"runs are there twice: " + numbers_text(doubled) + "; give each part once"};
  if (!missing.empty())
    return Error{"runs are missing: " + numbers_text(missing) +
                 "; make them by 'replan batch' with the --shard and --out of their part"};
  return {};
}

/// The files of the whole. batch.json comes last: it is what a folder of results is known by.
Result<void> write_whole(const Parts& parts, std::span<const Parts::Place> places, const std::string& out,
                         const TakeResult& also) {
  auto files = ResultFiles::create(out, parts.head);
  if (!files) return Error{files.error()};
  auto journal = PendingFile::create(batch_path(out, kJournalFile));
  if (!journal) return Error{journal.error()};
  for (const Parts::Place& place : places) {
    const auto result = parts.journals[place.journal].result(place.line);
    if (!result) return Error{result.error()};
    if (const auto written = journal->write(result_line(*result) + "\n"); !written) return written;
    if (const auto written = files->add(*result); !written) return written;
    if (also) also(*result);
  }
  if (const auto named = journal->commit(); !named) return named;
  if (const auto named = files->commit(); !named) return named;
  return write_batch_file(out, parts.head, {}, parts.experiment);
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

Result<std::size_t> merge_results(std::span<const std::string> folders, const std::string& out,
                                  const TakeResult& also) {
  if (std::filesystem::exists(batch_path(out, kBatchFile)))
    return Error{"'" + out + "' has results already: give another folder"};
  const auto parts = gathered(folders);
  if (!parts) return Error{parts.error()};
  const std::vector<Parts::Place> places = parts->places();
  if (const auto complete = check_complete(places, parts->head.runs); !complete)
    return Error{complete.error()};
  if (const auto made = make_folder(out); !made) return Error{made.error()};
  if (const auto written = write_whole(*parts, places, out, also); !written) return Error{written.error()};
  return places.size();
}

}  // namespace replan
