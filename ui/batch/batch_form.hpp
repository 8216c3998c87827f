// What a batch shall be made of, as the user chooses it: planners, seeds and surprises in the world that is open, or an
// experiment out of a file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "core/experiment/batch_job.hpp"
#include "core/experiment/held_results.hpp"
#include "core/session/session.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// What the user wants, besides starting.
enum class BatchFormWish : std::uint8_t { none, open_experiment, save_experiment, choose_folder };

class BatchForm {
 public:
  explicit BatchForm(const WorkPlace& place = {}) : loader_(place), looker_(place) {}

  /// Takes the open world, with the planners of the panes chosen; what was chosen besides stays. `folder` is where the
  /// results go unless the user says otherwise.
  void take_world(const Session& session, std::string folder);
  /// Takes an experiment's file; it is loaded in the background. Results go to its folder if they are there, else beside
  /// it.
  void take_experiment(const std::string& path);
  /// Results go to that folder. If it holds some of an experiment whose file is found, that is taken too.
  void take_folder(const std::string& folder);

  BatchFormWish draw(const Look& look, float height);

  /// What is chosen; or why that cannot be made.
  [[nodiscard]] Result<BatchRequest> request() const;
  /// The experiment's own file; empty: it is about the open world.
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// Names in it, which the fonts may not hold.
  [[nodiscard]] std::string words() const { return name_ + file_ + folder_; }
  /// How many runs it makes, if that is known yet.
  [[nodiscard]] std::optional<std::int64_t> runs() const;
  /// Whether some planner makes one run of several seeds: neither it nor the surprises draw by chance.
  [[nodiscard]] bool seeds_are_one() const;
  /// What the folder holds of the experiment that is chosen; nullptr if that is nothing, or not known yet.
  [[nodiscard]] const HeldResults* gone_on_with() const;

 private:
  struct Candidate {
    PlannerChoice choice;
    std::string label;    // with settings that are not the usual ones
    std::string why_not;  // it cannot plan in this world, as a sentence
    bool on = false;
  };
  struct Loaded {
    std::string error;
    std::int64_t runs = 0;
  };
  struct Held {
    std::string error;
    std::optional<HeldResults> results;
  };

  void add_candidate(const PlannerChoice& choice, bool on);
  [[nodiscard]] Experiment experiment() const;
  void draw_choices(const Look& look, float height);
  void draw_planners(const Look& look);
  void draw_settings(const Look& look);
  void draw_surprises(const Look& look);
  void draw_file(const Look& look);
  bool draw_folder(const Look& look);
  void draw_jobs(const Look& look);
  void look_into_folder();
  void take_held();
  void draw_held(const Look& look);

  std::shared_ptr<const Scenario> world_;
  std::vector<Candidate> candidates_;
  std::string name_;
  std::string file_;
  std::optional<Experiment> from_file_;
  std::optional<Loaded> loaded_;
  std::string error_;  // of the file
  Background<Loaded> loader_;
  Background<Held> looker_;
  std::string looked_into_;  // the folder that looker_ was sent to
  Held held_;                // what it has found there
  bool takes_held_ = false;  // the experiment of that folder is to be taken once it is found
  bool drive_ = true;
  int surprises_ = 1;  // ExperimentSurprises::Kind
  RandomBlocks blocks_;
  std::uint64_t first_seed_ = 1, seeds_ = 5;
  std::uint64_t repeat_ = 1, jobs_ = 1;
  std::string folder_;
};

}  // namespace replan::ui
