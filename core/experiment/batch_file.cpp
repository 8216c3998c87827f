#include "core/experiment/batch_file.hpp"

#include <filesystem>

#include "core/base/file.hpp"
#include "core/world/json_reader.hpp"

namespace replan {

std::string batch_path(const std::string& folder, const char* file) {
  return (std::filesystem::path(folder) / file).string();
}

Result<void> write_batch_file(const std::string& folder, const ResultsHead& head, const Shard& shard,
                              const std::string& experiment) {
  const Json document = {
      {"format", "replan batch"}, {"version", 1},          {"name", head.name},
      {"digest", head.digest},    {"runs", head.runs},     {"repeats", head.repeats},
      {"shard", shard.index + 1}, {"shards", shard.count}, {"experiment", Json::parse(experiment)}};
  return write_file_atomically(batch_path(folder, kBatchFile), pretty_json(document));
}

Result<KeptResults> read_batch_file(const std::string& folder) {
  const std::string path = batch_path(folder, kBatchFile);
  const auto text = read_file(path);
  if (!text) return Error{text.error()};
  JsonReader reader(path);
  if (!reader.parse(*text)) return Error{reader.error()};
  const JsonNode root = reader.root();
  KeptResults kept;
  if (const auto format = root.find("format"); !format || format->value() != "replan batch")
    return Error{path +
                 ": not the file of a batch: the key \"format\" with the value \"replan batch\" is missing"};
  if (const auto name = root.require("name")) kept.head.name = name->text();
  if (const auto digest = root.require("digest")) kept.head.digest = digest->text();
  if (const auto runs = root.require("runs")) kept.head.runs = runs->whole(0, kMostRuns);
  if (const auto repeats = root.require("repeats")) kept.head.repeats = repeats->toggle();
  const auto shard = root.require("shard"), shards = root.require("shards");
  if (shards) kept.shard.count = shards->whole(1, kMostShards);
  if (shard) kept.shard.index = shard->whole(1, kept.shard.count) - 1;
  if (const auto experiment = root.require("experiment")) kept.experiment = pretty_json(experiment->value());
  if (!reader.ok()) return Error{reader.error()};
  return kept;
}

}  // namespace replan
