// Batches from the window. A dialog says what shall be run and shows what has come of it; the runs go on while it is closed,
// and the status bar tells how far they are. It is a dialog, as wide as the page of keys, and no tab, as the debugger's lists
// are: the side panel has room for four of its twelve columns.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/experiment/batch_job.hpp"
#include "core/session/session.hpp"
#include "ui/batch/batch_form.hpp"
#include "ui/batch/batch_view.hpp"

namespace replan::ui {

class BatchDialog {
 public:
  enum class Wish : std::uint8_t { none, open_experiment, save_experiment, choose_folder };

  /// Shows the batch that there is, else what a new one shall be made of. `folder` is where its results would go.
  void show(const Session& session, std::string folder, const WorkPlace& place);
  /// Takes an experiment's file for a new batch.
  void take_experiment(const std::string& path);
  /// Takes a folder for the results, and the experiment that it holds some of.
  void take_folder(const std::string& folder);
  /// The folder that is chosen, as typed.
  [[nodiscard]] std::string folder() const { return form_ ? form_->folder() : ""; }
  /// Writes what is chosen as an experiment, with its world beside it, and says so.
  void save_experiment(const std::string& path);
  /// Shows results that nobody has made, for pictures.
  void exhibit(BatchRequest request, const std::vector<RunResult>& results, const BatchProgress& progress);

  [[nodiscard]] bool open() const { return open_; }
  void close() { open_ = false; }
  /// What the user wants of the window.
  Wish draw(const Look& look);
  /// Takes what has been done since, once a frame, whether it is drawn or not.
  void keep();
  /// Whether there is more of it than one frame takes.
  [[nodiscard]] bool behind() const { return behind_; }
  /// The run that the user wants to see in the debugger, once it is there; the dialog closes.
  std::optional<Scenario> take_run();

  /// How far the batch is while it is at work.
  [[nodiscard]] std::optional<BatchProgress> at_work() const;
  [[nodiscard]] const BatchTable& table() const { return view_.table(); }
  /// Why it cannot begin or go on; empty: it can.
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Why what is chosen cannot be begun; empty: it can.
  [[nodiscard]] std::string why_not() const;
  /// Characters of it that the fonts may not hold.
  [[nodiscard]] std::string words() const;

 private:
  enum class Page : std::uint8_t { form, results };

  void start(BatchRequest request);
  void open_run(std::int64_t run);
  [[nodiscard]] BatchProgress progress() const;
  [[nodiscard]] bool complete() const;
  [[nodiscard]] std::string progress_words() const;
  [[nodiscard]] std::string command_line() const;
  void draw_form(const Look& look);
  void draw_prospect(const Look& look) const;
  void draw_results(const Look& look);
  void draw_buttons(const Look& look);
  void draw_work_buttons(const Look& look);

  bool open_ = false;
  bool in_step_ = true;  // nobody waits for a frame
  bool behind_ = false;
  Page page_ = Page::form;
  Wish wish_ = Wish::none;  // of this frame
  std::unique_ptr<BatchForm> form_;
  std::unique_ptr<BatchJob> job_;
  std::unique_ptr<Background<Scenario>> opening_;
  BatchRequest request_;  // of the batch on the page of results
  std::string file_;      // its experiment; empty: it is about a world of the window's
  BatchView view_;
  std::optional<BatchProgress> exhibited_;  // in place of a batch that is at work
  std::string error_, note_;
};

}  // namespace replan::ui
