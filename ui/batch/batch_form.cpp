#include "ui/batch/batch_form.hpp"

#include <filesystem>

#include "core/base/file.hpp"
#include "core/experiment/run_list.hpp"
#include "core/world/choices.hpp"
#include "ui/documents/files.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

/// Why what a folder holds cannot be gone on with here.
std::string part_words(const Shard& shard) {
  const std::string part = std::to_string(shard.index + 1) + "/" + std::to_string(shard.count);
  return "this folder holds part " + part + " of an experiment: give another folder, or go on with it by " +
         "'replan batch' with --shard " + part;
}

/// How many runs an experiment in one world makes.
std::int64_t count_runs(const Experiment& experiment) {
  LoadedWorld world;
  world.problems.resize(1);
  std::vector<LoadedWorld> worlds;
  worlds.push_back(std::move(world));
  return RunList(experiment, std::move(worlds), 0).count();
}

}  // namespace

void BatchForm::add_candidate(const PlannerChoice& choice, bool on) {
  for (const Candidate& each : candidates_)
    if (each.choice == choice) return;
  const PlannerInfo* info = find_choice(choice.id);
  Candidate candidate{choice, std::string(info->name), "", on};
  for (const std::string& more : {settings_label(choice), stages_label(choice)})
    if (!more.empty()) candidate.label += "  " + more;
  if (const auto fit = fits(info_of(choice), world_->map.box(), world_->robot.radius); !fit) {
    candidate.why_not = as_sentence(fit.error()) + ".";
    candidate.on = false;
  }
  candidates_.push_back(std::move(candidate));
}

void BatchForm::take_world(const Session& session, std::string folder) {
  world_ = session.snapshot();
  name_ = session.file().empty() ? world_->name : file_stem(session.file());
  folder_ = std::move(folder);
  looked_into_.clear();
  takes_held_ = false;
  file_.clear();
  from_file_.reset();
  loaded_.reset();
  error_.clear();
  loader_.cancel();
  candidates_.clear();
  for (const PlannerChoice& choice : world_->planners) add_candidate(choice, true);
  for (const PlannerInfo& info : choices())
    if (!info.exercise && !info.blind) add_candidate({std::string(info.id), {}}, false);
}

void BatchForm::take_experiment(const std::string& path) {
  file_ = path;
  takes_held_ = false;
  loaded_.reset();
  from_file_.reset();
  error_.clear();
  loader_.cancel();
  auto read = read_experiment(path);
  if (!read) {
    error_ = read.error();
    return;
  }
  from_file_ = std::move(read.value());
  const std::string beside = file_folder(path);
  folder_ =
      std::filesystem::exists(beside + "/batch.json") ? beside : beside + "/" + file_stem(path) + "-results";
  loader_.start([experiment = *from_file_](const StopToken&) {
    const auto list = RunList::load(experiment);
    return list ? Loaded{"", list->count()} : Loaded{list.error(), 0};
  });
}

void BatchForm::take_folder(const std::string& folder) {
  folder_ = folder;
  looked_into_.clear();  // also into the same one anew
  takes_held_ = true;
}

/// What is typed is looked into as it comes to name a folder.
void BatchForm::look_into_folder() {
  const std::string folder = typed_path(folder_);
  if (folder != looked_into_) {
    looked_into_ = folder;
    held_ = {};
    looker_.start([folder](const StopToken&) {
      auto held = held_results(folder);
      return held ? Held{"", std::move(held.value())} : Held{held.error(), std::nullopt};
    });
  }
  auto found = looker_.take();
  if (!found) return;
  held_ = std::move(*found);
  if (std::exchange(takes_held_, false) && held_.results && !held_.results->file.empty()) take_held();
}

/// The experiment of the results in the folder, which goes on with them.
void BatchForm::take_held() {
  const std::string folder = folder_;
  take_experiment(held_.results->file);
  folder_ = folder;
}

const HeldResults* BatchForm::gone_on_with() const {
  if (!held_.results || file_.empty() || held_.results->file.empty()) return nullptr;
  std::error_code failed;
  return std::filesystem::equivalent(held_.results->file, file_, failed) ? &*held_.results : nullptr;
}

Experiment BatchForm::experiment() const {
  Experiment wanted;
  wanted.name = name_;
  for (const Candidate& each : candidates_)
    if (each.on) wanted.planners.push_back(each.choice);
  ExperimentWorld world;
  world.file = kept_world_file(name_);
  wanted.worlds = {world};
  wanted.surprises = {{static_cast<ExperimentSurprises::Kind>(surprises_), blocks_}};
  wanted.seeds.clear();
  for (std::uint64_t i = 0; i < seeds_; ++i) wanted.seeds.push_back(first_seed_ + i);
  wanted.drive = drive_;
  wanted.repeat = static_cast<int>(repeat_);
  return wanted;
}

std::optional<std::int64_t> BatchForm::runs() const {
  if (!file_.empty()) return loaded_ && loaded_->error.empty() ? std::optional(loaded_->runs) : std::nullopt;
  return world_ ? std::optional(count_runs(experiment())) : std::nullopt;
}

bool BatchForm::seeds_are_one() const {
  if (!file_.empty() || !world_) return false;
  const Experiment wanted = experiment();
  const std::size_t all = wanted.planners.size() * wanted.seeds.size();
  return static_cast<std::size_t>(count_runs(wanted)) < all;
}

Result<BatchRequest> BatchForm::request() const {
  if (!error_.empty()) return Error{error_};
  if (loaded_ && !loaded_->error.empty()) return Error{loaded_->error};
  if (folder_.empty()) return Error{"the results need a folder: give one"};
  if (held_.results && !held_.results->whole() && typed_path(folder_) == looked_into_)
    return Error{part_words(held_.results->shard)};
  BatchRequest request{.what = {}, .folder = typed_path(folder_), .jobs = static_cast<std::size_t>(jobs_)};
  if (!file_.empty()) {
    request.what.experiment = *from_file_;
    return request;
  }
  request.what = {experiment(), world_};
  if (request.what.experiment.planners.empty()) return Error{"no planner is chosen: switch one on"};
  return request;
}

}  // namespace replan::ui
