// The document and everything that is open in it: the scenario, a run per planner, undo, playback.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/background.hpp"
#include "core/session/breakpoints.hpp"
#include "core/session/checks.hpp"
#include "core/session/commands.hpp"
#include "core/session/history.hpp"
#include "core/session/hunt.hpp"
#include "core/session/player.hpp"
#include "core/session/run.hpp"
#include "core/session/watches.hpp"
#include "core/session/world_edit.hpp"

namespace replan {

/// Owns the document and its runs. Panels read it; only apply() and update() change it.
///
/// An edit while a plan stands is an announced surprise at the robot's present step: the planner repairs its
/// plan, and the whole run stays a function of the scenario. The run after the cursor is forgotten and goes
/// another way; what is scripted for later steps, by file or by hand, still happens. An
/// edit before the first plan stands changes the map and starts afresh. Undo brings the old future back: the
/// runs are carried out again in the background until they are as long as they were, and the cursors go where
/// they were.
class Session {
 public:
  static constexpr double kFullSpeed = Player::kFullSpeed, kRealTimeSpeed = Player::kRealTimeSpeed;

  /// Starts planning in the background, or in step: then with the steps of `place`, if it has some, which update() pumps
  /// for all others that have them too, else with its own.
  /// `limits` are for all panes together: they share the log's bytes evenly.
  explicit Session(Scenario scenario, std::string file = {}, const RunLimits& limits = {},
                   WorkPlace place = WorkPlace::beside());

  [[nodiscard]] const Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] std::span<const std::unique_ptr<Run>> runs() const { return runs_; }
  /// The pane whose timeline the transport shows and whose cursor the others follow, and its run.
  [[nodiscard]] std::size_t lead() const { return lead_; }
  [[nodiscard]] const Run& run() const { return *runs_[lead_]; }
  [[nodiscard]] const Playback& playback() const { return player_.state(); }
  [[nodiscard]] Lockstep lockstep() const { return lockstep_; }
  [[nodiscard]] const Breakpoints& breakpoints() const { return breakpoints_; }
  [[nodiscard]] const Watches& watches() const { return watches_; }
  [[nodiscard]] const Checks& checks() const { return checks_; }
  /// Breakpoints and watches as they would be saved. They are no part of scenario(), of undo or of
  /// modified().
  [[nodiscard]] DebugSetup debug() const;
  [[nodiscard]] const std::string& file() const { return file_; }
  /// True if there are edits that were not saved.
  [[nodiscard]] bool modified() const { return history_.modified(); }
  /// How many edits were not saved, counted as undo counts them; 0 if and only if nothing is modified.
  [[nodiscard]] std::size_t unsaved_edits() const { return history_.unsaved(); }
  /// Another number after every edit, undo and redo; the same one when they have led back to the same
  /// document.
  [[nodiscard]] std::uint64_t document_state() const { return history_.document_state(); }
  /// The scenario, to be read from another thread while this one goes on editing.
  [[nodiscard]] std::shared_ptr<const Scenario> snapshot() const { return scenario_; }
  /// How many of its surprises came with the file; the later ones are edits of the running mission.
  [[nodiscard]] std::size_t scripted() const { return history_.scripted(); }
  /// Counts every change of what a view could show: equal numbers, equal pictures.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// What undo would take back and redo bring back; empty if nothing.
  [[nodiscard]] std::string undo_text() const { return history_.undo_text(); }
  [[nodiscard]] std::string redo_text() const { return history_.redo_text(); }
  /// Every edit that can be taken back or brought back, oldest first; the first history_position() of them
  /// are made.
  [[nodiscard]] std::vector<std::string> history() const { return history_.labels(); }
  [[nodiscard]] std::size_t history_position() const { return history_.position(); }
  /// The walls of the true world at the cursor, without what moves.
  [[nodiscard]] GridMap world() const;
  /// One line each, oldest first: what was done and what went wrong.
  [[nodiscard]] std::span<const std::string> log() const { return log_; }

  /// Whether an edit of a large world is being worked out. What is asked for meanwhile is carried out after it, but for
  /// Cancel and ReplaceScenario, which give it and all that waits up.
  [[nodiscard]] bool editing_world() const { return world_edit_.busy(); }
  /// What there is to say of a command besides what it did, and why one that had to wait was not done in the end.
  struct Notice {
    std::string words;  ///< a sentence; empty: nothing
    bool bad = false;
  };
  /// The latest, once.
  [[nodiscard]] Notice take_notice() { return std::exchange(notice_, {}); }

  /// Where what takes long is done, here and by whoever shows the session.
  [[nodiscard]] const WorkPlace& work() const { return place_; }
  /// Whether there is something to be done in step that update() has not done yet, apart from the runs.
  [[nodiscard]] bool has_steps() const { return place_.steps && place_.steps->busy(); }
  /// In step: how many milliseconds of each frame update() takes for planning and all else that is to be done.
  void set_share(double milliseconds) { share_ = milliseconds; }

  /// Carries out a command. An error leaves everything as it was.
  Result<void> apply(const Command& command);
  /// Why a run could not go on, as a sentence; empty if all is well.
  [[nodiscard]] std::string failure() const;
  /// Takes over what the background did, or does it in step, and plays on by `seconds`. True if something to be seen
  /// changed.
  bool update(double seconds);
  /// Shows `look` the runs with that pane leading and at another moment, as after Lead{pane} and Seek{position, travel}, and
  /// comes back: what is played, stepped or looked for goes on as if nothing had been. What `look` sees changes revision().
  void glance(std::size_t pane, std::size_t position, double travel, const std::function<void()>& look);
  /// How long a command may wait for the background before the rest of it is left to update(): as long as it takes,
  /// unless a window says otherwise. Where somebody is so impatient, large worlds are edited in the background too, and
  /// the laws of those above Checks::kCellsAtMost are not checked.
  void set_patience(std::chrono::milliseconds patience) {
    patience_ = patience;
    checks_.most_cells_ = Checks::kCellsAtMost;
  }
  /// Waits until the background stands still and what is looked for is found: for programs without a window.
  void settle();

  /// The scenario as it would be saved: edits made before the robot first moved are part of the map, if
  /// nothing else that may happen then comes before them, and if the robot knows the map. With debug().
  [[nodiscard]] Scenario to_save() const;
  /// Tells that to_save() was written to `file`.
  void saved(const std::string& file);
  /// Whether nothing but cells of the map has changed since the document was opened or saved: a map file can hold that.
  [[nodiscard]] bool only_cells_edited() const;
  /// Whether another world has been put in the place of the one that was opened or saved, which the file is not meant for.
  [[nodiscard]] bool other_world() const;

 private:
  Result<void> run_command(const std::monostate&) { return {}; }
#define REPLAN_COMMAND(NAME) Result<void> run_command(const NAME& command);
#include "core/session/commands.def"
#undef REPLAN_COMMAND

  [[nodiscard]] std::set<NodeId> turned_between(std::size_t decision) const;
  [[nodiscard]] std::vector<CellChange> real_changes(const std::vector<CellChange>& cells,
                                                     const Decision* decision) const;
  [[nodiscard]] std::map<NodeId, bool> cells_to_come(const Decision& decision,
                                                     const std::vector<CellChange>& cells) const;
  [[nodiscard]] const Surprise* surprise_of_stroke(std::uint64_t stroke, const Decision& decision,
                                                   bool announced) const;
  void note_early_ends(std::int64_t clock);
  void note_lost_search();
  Result<void> edit_cells(const std::vector<CellChange>& cells, bool announced, std::uint64_t stroke,
                          std::string label = {});
  void commit(std::string label, std::uint64_t stroke, Scenario changed) {
    commit(std::move(label), stroke, std::move(changed), history_.scripted());
  }
  void commit(std::string label, std::uint64_t stroke, Scenario changed, std::size_t scripted);
  void commit(std::string label, std::uint64_t stroke, Scenario changed, DocumentChange change,
              std::size_t scripted);
  void relabel(const std::string& label);
  void commit_in_place(std::string label, Scenario changed, std::size_t scripted);
  template <class WorldCommand>
  Result<void> edit_world(const WorldCommand& command, std::size_t cells = 0);
  Result<void> take_edit(Result<WorldEdit> edit);
  bool finish_world_edit();
  [[nodiscard]] bool has_to_wait(const Command& command);
  void replace(std::shared_ptr<const Scenario> scenario);
  [[nodiscard]] RunPositions positions() const;
  void return_to(RunPositions positions);
  /// Neither an undo nor steps go on leading somewhere.
  void go_another_way() {
    returning_.reset();
    stepping_.reset();
  }
  bool go_on_stepping();
  void send_on(Run& run, StepUnit unit);
  bool arrive();
  void match_panes();
  bool pump();
  [[nodiscard]] Run& leading() {
    return *runs_[lead_];
  }
  void restart_runs();
  void rebase_runs(std::size_t common);
  void replace_panes();
  void follow_lead();
  /// A planner with those settings of the one before that it has too, with the same meaning.
  [[nodiscard]] static PlannerChoice choice_of(const PlannerInfo& info, const PlannerChoice& before);
  void commit_movers(std::string label, std::uint64_t stroke, std::vector<MovingObstacle> movers);
  [[nodiscard]] bool under_way() const;
  Result<void> edit_script(std::string label, std::uint64_t stroke, Surprise surprise);
  void seek(std::size_t position, double travel = 1);
  [[nodiscard]] bool can_go_on() const;
  void resume();
  bool play(double seconds);
  bool check();
  void show_difference();
  void take_debug(const DebugSetup& debug);
  void start_hunt(HuntTask task);
  void stop_hunt();
  bool hunt(double milliseconds);
  void hunt_breakpoint(double milliseconds);
  void hunt_event();
  void find_nothing(const std::string& words);
  void settle_hunt();
  void go_to_arrival();
  bool run_on();
  void stop_at(Hit hit);
  [[nodiscard]] std::optional<Hit> stop_between(std::size_t from, std::size_t to);
  [[nodiscard]] std::size_t may_play_to(std::size_t from, std::size_t to) const;
  [[nodiscard]] std::optional<std::size_t> last_change(const GoToChange& command, std::size_t before) const;
  [[nodiscard]] std::optional<std::size_t> next_change(const GoToChange& command, std::size_t from) const;
  [[nodiscard]] std::optional<std::size_t> next_arrival(std::size_t from) const;
  [[nodiscard]] CheckedLog checked_log() const;
  [[nodiscard]] Box box() const;
  bool update_instruments();
  bool look_for_stops();
  void say(std::string line) {
    log_.push_back(std::move(line));
  }

  WorkPlace place_;
  double share_ = 10;  // of a frame at 60 Hz
  std::shared_ptr<const Scenario> scenario_;
  std::shared_ptr<const Scenario> kept_;  // as it was opened or saved; nullptr if nobody knows
  std::vector<std::unique_ptr<Run>> runs_;
  RunLimits limits_;
  std::optional<RunPositions>
      returning_;  // to which an undo leads back, while the runs are on their way there
  /// Steps that are still to be done, and whether the run has to come to rest first.
  struct Stepping {
    Step left;
    bool waits = false;
  };
  std::optional<Stepping> stepping_;
  std::optional<std::chrono::milliseconds> patience_;  // nothing: without end
  Background<Result<WorldEdit>> world_edit_{place_};
  std::vector<Command> waiting_;  // for it
  Notice notice_;
  std::size_t lead_ = 0;
  History history_;
  std::string file_;
  Player player_;
  Lockstep lockstep_ = Lockstep::expansions;
  Breakpoints breakpoints_;
  Watches watches_;
  Checks checks_{place_};
  std::optional<HuntTask> hunting_;
  std::uint64_t stopped_log_ = 0;  // where the cursor was stopped
  std::size_t stopped_at_ = 0;
  Box instruments_world_;                // that breakpoints and watches were read for
  bool follow_ = true;                   // the cursor stays at the end of the log
  std::vector<PlannerChoice> put_away_;  // of panes that went; the last of them comes back first
  bool catching_up_ = false;             // a pane beside the leading one has yet to run to where it belongs
  std::size_t stroke_cells_ = 0;         // changed so far by the last stroke of a brush
  std::uint64_t revision_ = 1;
  std::vector<std::string> log_;
};

}  // namespace replan
