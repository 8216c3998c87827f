// One planner's run of a scenario: the mission in the background or in step, its log in the foreground.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/base/work_place.hpp"
#include "core/debug/log_view.hpp"
#include "core/session/reexecution.hpp"
#include "core/session/run_worker.hpp"
#include "core/session/stop_index.hpp"
#include "core/trace/expansions.hpp"
#include "core/trace/timeline.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Events that a timeline shows and that steps stop at.
inline constexpr KindSet kMilestones{EventKind::plan_begin, EventKind::plan_end,  EventKind::move,
                                     EventKind::surprise,   EventKind::collision, EventKind::waiting,
                                     EventKind::arrival,    EventKind::gave_up,   EventKind::new_goal,
                                     EventKind::put_down,   EventKind::turn};
/// One of them, with all that it tells: nobody has to read the log for it.
struct Milestone {
  std::size_t event;  ///< index in the log
  EventKind kind;
  NodeId node;
  std::uint64_t payload;
};

/// The timeline of what a mission did that runs in the background. pump() is the one place where events come
/// over. All members are for the owner's thread, and none but wait() waits for the background: what has to
/// wait until it has stopped is done by a later pump(). In step pump() does besides what else the thread would, as long as
/// it may. Where the log exceeds its limit, a second mission on the owner's thread works out what was dropped when it is
/// read.
class Run {
 public:
  /// `planner` is an index into scenario->planners. Nothing runs before go() or finish().
  Run(std::shared_ptr<const Scenario> scenario, std::size_t planner, const RunLimits& limits = {},
      const WorkPlace& place = WorkPlace::beside());
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] const Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] const PlannerChoice& choice() const { return scenario_->planners[planner_]; }
  /// info_of(choice()).
  [[nodiscard]] const PlannerInfo& info() const { return *info_; }
  /// settings_of(choice()).
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Which node is which cell.
  [[nodiscard]] const Box& lattice() const { return lattice_; }

  [[nodiscard]] Timeline& timeline() { return *timeline_; }
  [[nodiscard]] const Timeline& timeline() const { return *timeline_; }
  /// For the debugger's instruments; valid until the run begins afresh, which changes log_id().
  [[nodiscard]] LogView log_view() const {
    return {*timeline_, lattice_, *info_, settings_, scenario_->robot.radius};
  }
  /// How much of the robot's last step before the cursor a view shows: 0, still where it came from, to 1.
  [[nodiscard]] double travel() const { return travel_; }
  void set_travel(double travel) { travel_ = travel; }
  /// Where the run can branch, in order; the last one is the latest decision.
  [[nodiscard]] std::span<const Decision> decisions() const { return decisions_; }
  [[nodiscard]] std::span<const Milestone> milestones() const { return milestones_; }
  /// Changes whenever events are cut off, and differs between runs: while it stays the same, the log has only
  /// grown.
  [[nodiscard]] std::uint64_t log_id() const { return log_id_; }
  /// How many first events this log has in common with what it was when it had that id: all of them if it has
  /// it still, none if it never had it. What was read of them need not be read again.
  [[nodiscard]] std::size_t common_with(std::uint64_t log_id) const;
  /// The last decision at or before a position, or nullptr before the first plan stands.
  [[nodiscard]] const Decision* decision_at(std::size_t position) const;
  /// Where an edit that is made at the cursor happens: the first decision of the robot at its step there at
  /// which all that was due before has happened. nullptr before the first plan stands.
  [[nodiscard]] const Decision* decision_for_edit() const;
  /// Where steps stop.
  [[nodiscard]] const StopIndex& stops() const { return stops_; }
  /// Expansions in each of the log's chunks of kCurveChunk events: the curve under the timeline.
  [[nodiscard]] std::span<const std::uint32_t> expansion_curve() const { return curve_; }
  static constexpr std::size_t kCurveChunk = 256;

  /// Asks the background to go on to a target. Further ones replace it.
  void go(Target target);
  /// What pump() takes of a frame where nobody says otherwise.
  static constexpr double kPumpMs = 4;
  /// Takes over what was done in the background, until the deadline has passed; the rest comes with the next calls. In
  /// step it is done here, in slices of which one at most ends behind the deadline. True if anything new came.
  bool pump(const Deadline& deadline = Deadline(kPumpMs));
  /// True while the background works towards the target.
  [[nodiscard]] bool busy() const;
  /// True if there is nothing left to do: the robot has arrived or can go no farther.
  [[nodiscard]] bool over() const;
  /// Why the background could not go on (out of memory, log too long), as a sentence; empty if nothing went
  /// wrong.
  [[nodiscard]] std::string failure() const;
  /// Asks the background to stop; what it has done by then still comes.
  void cancel();
  /// Waits until the background stands still.
  void wait() { static_cast<void>(rest(std::nullopt)); }
  /// The same, but no longer than that; whether it stands still.
  bool rest(std::optional<std::chrono::milliseconds> at_most);
  /// go() and wait().
  void finish(Target target);

  /// Puts in a scenario that differs only in surprises from index `common` on. The log is cut where that
  /// first makes a difference, so that what follows is the run of that scenario; where there is no such
  /// place after the first plan, the run begins afresh. If the background is at work, that happens when it
  /// has stopped; go() afterwards goes on from there.
  void rebase(std::shared_ptr<const Scenario> scenario, std::size_t common);
  /// Whether such a scenario still waits for the background to stop.
  [[nodiscard]] bool rebasing() const { return rebase_.has_value(); }
  /// Puts in another scenario: the log is empty again.
  void restart(std::shared_ptr<const Scenario> scenario);
  /// Puts in a scenario that differs in nothing that this run is made of: other planners, names. It goes on
  /// as it was.
  void adopt(std::shared_ptr<const Scenario> scenario) { scenario_ = std::move(scenario); }

 private:
  /// A batch on its way into the timeline, and how much of it is there.
  struct Handover {
    RunWorker::Batch batch;
    std::size_t base = 0;  // the log's size before it
    std::size_t events = 0, decisions = 0, checkpoints = 0;
  };
  /// A scenario that waits to be put in, and how far to go then.
  struct Rebase {
    std::shared_ptr<const Scenario> scenario;
    std::size_t common = 0;
    std::optional<Target> target = {};
  };

  static std::uint64_t next_log_id();
  void begin_log();
  [[nodiscard]] bool all_mapped();
  [[nodiscard]] bool next_batch();
  void take_over_part();
  void note_events(std::span<const Event> events);
  bool carry_out_rebase();
  [[nodiscard]] bool branch(std::shared_ptr<const Scenario> scenario, std::size_t common);
  [[nodiscard]] static const Decision* decision_of_surprise(std::span<const Decision> decisions,
                                                            std::int64_t clock);
  [[nodiscard]] std::size_t decisions_kept(const Scenario& scenario, std::size_t common) const;
  [[nodiscard]] std::span<const Decision> lasting_decisions() const;
  [[nodiscard]] std::size_t foreseen(const Scenario& scenario) const;
  [[nodiscard]] bool repairs_for_surprise(std::size_t common) const;
  void cut(std::size_t count);
  void tidy();
  void retire_log();

  std::shared_ptr<const Scenario> scenario_;
  std::size_t planner_;
  const PlannerInfo* info_;
  Settings settings_;
  bool in_step_;
  RunLimits limits_;
  Box lattice_;
  SharedBytes mapped_;                  // cells that were looked through: none of them is kUnmapped
  std::shared_ptr<Timeline> timeline_;  // shared with the worker while that reads a state of it
  bool lends_ = false;
  std::vector<std::shared_ptr<Timeline>> retired_;  // of earlier logs, until nothing is left of them
  std::vector<Decision> decisions_;
  std::vector<Milestone> milestones_;
  StopIndex stops_;
  std::vector<std::uint32_t> curve_;
  std::uint64_t log_id_;
  std::map<std::uint64_t, std::size_t> earlier_;  // ids that the log had, and what is left of it since
  double travel_ = 1;
  std::unique_ptr<Reexecution> reexecution_;  // made when it is first needed
  std::optional<Handover> handover_;
  std::optional<Rebase> rebase_;
  std::unique_ptr<RunWorker> worker_;
};

}  // namespace replan
