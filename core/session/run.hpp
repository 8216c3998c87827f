// One planner's run of a scenario: the mission in the background, its log in the foreground.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/session/reexecution.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/expansions.hpp"
#include "core/trace/timeline.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Events that a timeline shows and that steps stop at.
inline constexpr KindSet kMarkers{
    EventKind::plan_begin, EventKind::plan_end, EventKind::move,    EventKind::surprise, EventKind::collision,
    EventKind::waiting,    EventKind::arrival,  EventKind::gave_up, EventKind::new_goal, EventKind::put_down};
/// One of them.
struct Marker {
  std::size_t event;  ///< index in the log
  EventKind kind;
};

/// How far a run is to be taken.
struct Target {
  enum class Kind : std::uint8_t { plan, clock, length, end } kind = Kind::plan;
  std::int64_t clock = 0;  ///< for Kind::clock
  std::size_t length = 0;  ///< for Kind::length

  static Target plan() { return {Kind::plan}; }                        ///< until the plan stands
  static Target clock_at(std::int64_t c) { return {Kind::clock, c}; }  ///< until the robot's clock shows c
  static Target length_of(std::size_t n) { return {Kind::length, 0, n}; }  ///< until the log has n events
  static Target end() { return {Kind::end}; }                              ///< until nothing is left to do
};

/// What the log of a run may take, and how finely the run is cut up.
struct RunLimits {
  LogLimits log;
  /// Iterations of the planner between two places where the run can be taken up again.
  std::int64_t slice_iterations = 2000;
};

/// A mission that runs on a thread of its own in slices, and the timeline of what it did. The thread owns the
/// mission while it works; pump() is the one place where events come over. All members are for the owner's
/// thread. Where the log exceeds its limit, a second mission on the owner's thread works out what was dropped
/// when it is read.
class Run {
 public:
  /// `planner` is an index into scenario->planners. Nothing runs before go() or finish().
  Run(std::shared_ptr<const Scenario> scenario, std::size_t planner, const RunLimits& limits = {});
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] const Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] const PlannerChoice& choice() const { return scenario_->planners[planner_]; }
  [[nodiscard]] const PlannerInfo& info() const { return *info_; }
  /// Node arithmetic of the world; its cells are those of the map before the run.
  [[nodiscard]] const Grid2& lattice() const { return *lattice_; }

  [[nodiscard]] Timeline& timeline() { return timeline_; }
  [[nodiscard]] const Timeline& timeline() const { return timeline_; }
  /// For the debugger's instruments; valid as long as the run.
  [[nodiscard]] LogView log_view() const { return {timeline_, *lattice_, *info_, choice().settings}; }
  /// How much of the robot's last step before the cursor a view shows: 0, still where it came from, to 1.
  [[nodiscard]] double travel() const { return travel_; }
  void set_travel(double travel) { travel_ = travel; }
  /// Where the run can branch, in order; the last one is the latest decision.
  [[nodiscard]] std::span<const Mark> marks() const { return marks_; }
  [[nodiscard]] std::span<const Marker> markers() const { return markers_; }
  /// Changes whenever events are cut off, and differs between runs: while it stays the same, the log has only
  /// grown.
  [[nodiscard]] std::uint64_t log_id() const { return log_id_; }
  /// How many first events this log has in common with what it was when it had that id: all of them if it has
  /// it still, none if it never had it. What was read of them need not be read again.
  [[nodiscard]] std::size_t common_with(std::uint64_t log_id) const;
  /// The last mark at or before a position, or nullptr before the first plan stands.
  [[nodiscard]] const Mark* mark_at(std::size_t position) const;
  /// Where a surprise that is added at the end of the list, due at `clock`, would happen: the first decision
  /// of the robot at that step after all others that are due then. nullptr if the run has not come that far.
  [[nodiscard]] const Mark* mark_for_new_surprise(std::int64_t clock) const;
  /// Expansions in each of the log's chunks of kCurveChunk events: the curve under the timeline.
  [[nodiscard]] std::span<const std::uint32_t> expansion_curve() const { return curve_; }
  static constexpr std::size_t kCurveChunk = 256;

  /// Asks the background to go on to a target. Further ones replace it.
  void go(Target target);
  /// Takes over what was done in the background, for a few milliseconds; the rest comes with the next calls.
  /// True if anything new came.
  bool pump();
  /// True while the background works towards the target.
  [[nodiscard]] bool busy() const;
  /// True if there is nothing left to do: the robot has arrived or can go no farther.
  [[nodiscard]] bool over() const;
  /// Why the background could not go on (out of memory, log too long), as a sentence; empty if nothing went
  /// wrong.
  [[nodiscard]] std::string failure() const;
  /// Stops the background after its current slice and takes over what was done.
  void cancel();
  /// go() and wait, for programs without a window.
  void finish(Target target);

  /// Puts in a scenario that differs only in surprises from index `common` on. The log is cut where that
  /// first makes a difference, so that what follows is the run of that scenario; false if there is no such
  /// place after the first plan (the run has to start afresh).
  bool rebase(std::shared_ptr<const Scenario> scenario, std::size_t common);
  /// Puts in a scenario that differs in nothing that this run is made of: other planners, names. It goes on
  /// as it was.
  void adopt(std::shared_ptr<const Scenario> scenario);

 private:
  struct Batch {
    std::vector<Event> events;
    std::vector<Mark> marks;  // their `event` counts from the batch's first
    std::vector<std::pair<std::size_t, std::shared_ptr<const Checkpoint>>> checkpoints;  // as do these
  };
  /// A batch on its way into the timeline, and how much of it is there.
  struct Handover {
    Batch batch;
    std::size_t base = 0;  // the log's size before it
    std::size_t events = 0, marks = 0, checkpoints = 0;
  };

  /// Events of one run: their index alone takes half a GiB.
  static constexpr std::size_t kMostEvents = std::size_t{1} << 30;

  static std::uint64_t next_log_id();
  void work(const std::stop_token& stop);
  [[nodiscard]] Batch slice();
  [[nodiscard]] bool reached() const;
  [[nodiscard]] bool next_batch();
  void take_over_part();
  void take_over_all();
  void note_events(std::span<const Event> events);
  [[nodiscard]] std::size_t foreseen(const Scenario& scenario) const;
  void cut(std::size_t mark_count);

  std::shared_ptr<const Scenario> scenario_;
  std::size_t planner_;
  const PlannerInfo* info_;
  std::unique_ptr<const Grid2> lattice_;
  Timeline timeline_;
  std::vector<Mark> marks_;
  std::vector<Marker> markers_;
  std::vector<std::uint32_t> curve_;
  std::uint64_t log_id_;
  std::map<std::uint64_t, std::size_t> earlier_;  // ids that the log had, and what is left of it since
  double travel_ = 1;
  RunLimits limits_;
  std::unique_ptr<Reexecution> reexecution_;  // made when it is first needed
  std::optional<Handover> handover_;
  ExpansionCounter counter_;  // at the end of the log

  // The thread's own while working_, the owner's while not.
  Recorder recorder_;
  std::size_t recorded_ = 0;  // events handed over
  std::unique_ptr<Mission<Recorder>> mission_;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable_any wake_, idle_, room_;
  std::deque<Batch> ready_;
  std::vector<std::vector<Event>> spare_;  // memory of batches that were taken over
  Target target_;
  bool working_ = false;
  bool cancelled_ = false;
  std::string failure_;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace replan
