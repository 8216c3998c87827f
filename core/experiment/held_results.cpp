#include "core/experiment/held_results.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "core/base/file.hpp"
#include "core/experiment/batch_file.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/world_experiment.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

namespace fs = std::filesystem;

/// No larger file is taken for one of these; results.json of many runs says what it is at its beginning.
constexpr std::int64_t kMostPaperBytes = std::int64_t{1} << 24;
constexpr std::size_t kBeginning = 4096;
/// Of each folder so many files are looked at for the experiment.
constexpr int kMostFilesSought = 1000;

std::string beginning_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kBeginning, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

/// Lines of the journal that are whole.
std::int64_t count_lines(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> part{};
  std::int64_t lines = 0;
  while (file.read(part.data(), part.size()) || file.gcount() > 0)
    lines += std::count(part.begin(), part.begin() + file.gcount(), '\n');
  return lines;
}

/// How many runs there are in a part of so many in all.
std::int64_t runs_in(const Shard& shard, std::int64_t all) {
  return all <= shard.index ? 0 : (all - 1 - shard.index) / shard.count + 1;
}

bool is_that_experiment(const std::string& path, const std::string& text) {
  if (batch_paper(path) != BatchPaper::experiment) return false;
  const auto experiment = read_experiment(path);
  return experiment && experiment_text(*experiment) == text;
}

/// The file in that folder which holds the experiment; empty if there is none.
std::string experiment_in(const fs::path& folder, const std::string& text) {
  std::error_code failed;
  std::vector<std::string> files;
  for (fs::directory_iterator each(folder, failed), end; !failed && each != end; each.increment(failed))
    if (file_extension(each->path().string()) == ".json" && files.size() < kMostFilesSought)
      files.push_back(each->path().string());
  std::sort(files.begin(), files.end());  // of two equal ones the same everywhere
  for (const std::string& file : files)
    if (is_that_experiment(file, text)) return file;
  return "";
}

}  // namespace

BatchPaper batch_paper(const std::string& path) {
  std::error_code failed;
  if (file_extension(path) != ".json" || !fs::is_regular_file(path, failed)) return BatchPaper::none;
  if (beginning_of(path).find("\"replan results\"") != std::string::npos) return BatchPaper::results;
  const auto text = read_file(path, kMostPaperBytes);
  // To look for the word takes much less than to parse a large scenario.
  if (!text || (text->find("\"replan experiment\"") == std::string::npos &&
                text->find("\"replan batch\"") == std::string::npos))
    return BatchPaper::none;
  JsonReader reader(path);
  if (!reader.parse(*text) || !reader.root().value().is_object()) return BatchPaper::none;
  const auto format = reader.root().find("format");
  if (format && format->value() == "replan experiment") return BatchPaper::experiment;
  return format && format->value() == "replan batch" ? BatchPaper::results : BatchPaper::none;
}

Result<std::optional<HeldResults>> held_results(const std::string& folder) {
  std::error_code failed;
  if (!fs::exists(batch_path(folder, kBatchFile), failed)) return std::optional<HeldResults>();
  const auto kept = read_batch_file(folder);
  if (!kept) return Error{kept.error()};
  HeldResults held{.folder = folder, .name = kept->head.name, .shard = kept->shard, .file = {}};
  held.runs = runs_in(kept->shard, kept->head.runs);
  held.done = std::min(count_lines(batch_path(folder, kJournalFile)), held.runs);
  fs::path here = fs::absolute(folder, failed).lexically_normal();
  if (!here.has_filename()) here = here.parent_path();  // it was given with a slash behind it
  for (const fs::path& place :
       {here, here.parent_path(), here.parent_path().parent_path(), fs::current_path(failed)})
    if (held.file.empty()) held.file = experiment_in(place, kept->experiment);
  return std::optional(held);
}

}  // namespace replan
