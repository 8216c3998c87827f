// What a batch shall be made of, as the user chooses it: planners, seeds and surprises in the world that is open, or an
// experiment out of a file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "core/experiment/batch_job.hpp"
#include "core/session/session.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// What the user wants, besides starting.
enum class BatchFormWish : std::uint8_t { none, open_experiment, save_experiment };

class BatchForm {
 public:
  explicit BatchForm(const WorkPlace& place = {}) : loader_(place) {}

  /// Takes the open world, with the planners of the panes chosen; what was chosen besides stays. `folder` is where the
  /// results go unless the user says otherwise.
  void take_world(const Session& session, std::string folder);
  /// Takes an experiment's file; it is loaded in the background. Results go to its folder if they are there, else beside
  /// it.
  void take_experiment(const std::string& path);

  BatchFormWish draw(const Look& look, float height);

  /// What is chosen; or why that cannot be made.
  [[nodiscard]] Result<BatchRequest> request() const;
  /// The experiment's own file; empty: it is about the open world.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// Names in it, which the fonts may not hold.
  [[nodiscard]] std::string words() const { return name_ + file_ + folder_; }
  /// How many runs it makes, if that is known yet.
  [[nodiscard]] std::optional<std::int64_t> runs() const;

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

  void add_candidate(const PlannerChoice& choice, bool on);
  [[nodiscard]] Experiment experiment() const;
  void draw_planners(const Look& look);
  void draw_settings(const Look& look);
  void draw_surprises(const Look& look);
  void draw_file(const Look& look);
  void draw_folder(const Look& look);

  std::shared_ptr<const Scenario> world_;
  std::vector<Candidate> candidates_;
  std::string name_;
  std::string file_;
  std::optional<Experiment> from_file_;
  std::optional<Loaded> loaded_;
  std::string error_;  // of the file
  Background<Loaded> loader_;
  bool drive_ = true;
  int surprises_ = 1;  // ExperimentSurprises::Kind
  RandomBlocks blocks_;
  std::uint64_t first_seed_ = 1, seeds_ = 5;
  std::uint64_t repeat_ = 1, jobs_ = 1;
  std::string folder_;
};

}  // namespace replan::ui
