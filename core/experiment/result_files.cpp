#include "core/experiment/result_files.hpp"

#include "core/experiment/batch_file.hpp"

namespace replan {
namespace {

/// Fewer and larger writes; all that is ever held of a file.
constexpr std::size_t kMostHeld = std::size_t{1} << 16;

}  // namespace

Result<void> ResultFiles::Text::put(std::string_view more, std::size_t most_held) {
  held += more;
  if (held.size() <= most_held) return {};
  const auto written = file.write(held);
  held.clear();
  return written;
}

Result<ResultFiles> ResultFiles::create(const std::string& folder, const ResultsHead& head) {
  ResultFiles files;
  for (const auto& [name, begin] : {std::pair{kCsvFile, results_csv_head()},
                                    {kJsonFile, results_json_head(head)},
                                    {kTimesFile, times_csv_head()}}) {
    auto file = PendingFile::create(batch_path(folder, name));
    if (!file) return Error{file.error()};
    files.texts_.push_back({std::move(file.value()), begin});
  }
  return files;
}

Result<void> ResultFiles::add(const RunResult& result) {
  const std::string json = (first_ ? "\n" : ",\n") + results_json_row(result);
  first_ = false;
  if (const auto put = texts_[0].put(results_csv_row(result), kMostHeld); !put) return put;
  if (const auto put = texts_[1].put(json, kMostHeld); !put) return put;
  return texts_[2].put(times_csv_row(result), kMostHeld);
}

Result<void> ResultFiles::commit() {
  texts_[1].held += kResultsJsonEnd;
  for (Text& text : texts_)
    if (const auto put = text.put("", 0); !put) return put;
  for (Text& text : texts_)
    if (const auto done = text.file.commit(); !done) return done;
  return {};
}

}  // namespace replan
