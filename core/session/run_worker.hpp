// The background of a run: the mission, which takes orders and hands over what it recorded, on a thread of its own or in
// step with its owner.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/threads.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/timeline.hpp"
#include "core/world/scenario.hpp"

namespace replan {

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

/// The mission belongs to the thread alone: making it, taking it back and dropping it, each of which costs as
/// much as the map is large, are orders like any other. No call waits for the thread, but wait() and the
/// destructor. Without a thread the same orders are carried out by step(), and by nothing else but wait().
class RunWorker {
 public:
  /// Some milliseconds of recorded work.
  struct Batch {
    std::vector<Event> events;
    std::vector<Decision> decisions;  ///< their `event` counts from the batch's first
    std::vector<std::pair<std::size_t, std::shared_ptr<const Checkpoint>>> checkpoints;  ///< as do these
  };

  /// `planner` is an index into scenario->planners. Nothing is done before go().
  RunWorker(std::shared_ptr<const Scenario> scenario, std::size_t planner, const RunLimits& limits,
            bool on_thread = kThreads);
  ~RunWorker();
  RunWorker(const RunWorker&) = delete;
  RunWorker& operator=(const RunWorker&) = delete;

  /// Asks for work up to a target. Further ones replace it.
  void go(Target target);
  /// Asks to stop soon; what has been recorded until then is handed over.
  void stop();
  /// Drops the mission and all that was not taken: the next go() begins another one.
  void begin_afresh(std::shared_ptr<const Scenario> scenario);
  /// Puts another script in place. Only while at_rest().
  void set_script(std::shared_ptr<const Scenario> scenario);
  /// Takes the mission back to a decision of the log, whose end has been cut off there. `log` stays alive, and
  /// its head is lent, until head_returned(). Only while at_rest().
  void go_back(const Decision& decision, std::shared_ptr<Timeline> log);
  /// Whether nobody reads a log's head any more that was lent for go_back().
  [[nodiscard]] bool head_returned() const;

  /// The next batch, if there is one.
  [[nodiscard]] std::optional<Batch> take();
  /// Memory of a batch that was taken, to be used again.
  void give_back(std::vector<Event> memory);
  /// Whether the thread is not at work nor about to be, and all batches were taken.
  [[nodiscard]] bool at_rest() const;
  /// Why it could not go on, as a sentence; empty if nothing went wrong.
  [[nodiscard]] std::string failure() const;
  /// Without a thread: carries out what was ordered, or else goes on by one slice of the planner or one move of the robot.
  /// False if there is nothing to do, or too much to take. Making a mission, and what its planner does before its first
  /// iteration, cannot be cut up: each is a slice as long as the map is large.
  bool step();
  /// Waits until there is a batch to take or nothing more to wait for, but no longer than until then.
  void wait(std::chrono::steady_clock::time_point until);

 private:
  /// Where the mission is to be taken up.
  struct Back {
    Decision decision;
    std::shared_ptr<Timeline> log;
    const SearchState* head;
  };
  /// What is to be done to the mission before it goes on; what is not set stays as it is.
  struct Orders {
    std::shared_ptr<const Scenario> fresh, script;
    std::optional<Back> back;
    [[nodiscard]] bool any() const { return fresh || script || back; }
  };

  /// Events of one run: their index alone takes half a GiB.
  static constexpr std::size_t kMostEvents = std::size_t{1} << 30;

  void work(const StopToken& stop);
  void do_some(std::unique_lock<std::mutex>& lock);
  [[nodiscard]] std::string work_on(Orders orders, Target target, Batch& batch);
  void carry_out(Orders orders);
  void fill(Batch& batch, Target target);
  void set_out();
  [[nodiscard]] const PlannerChoice& choice() const { return scenario_->planners[planner_]; }
  [[nodiscard]] bool reached(Target target) const;
  [[nodiscard]] std::vector<Event> spare();

  const std::size_t planner_;
  const RunLimits limits_;
  const bool on_thread_;

  // The thread's own.
  std::shared_ptr<const Scenario> scenario_;
  Recorder recorder_;
  std::size_t recorded_ = 0;         // events handed over
  std::size_t next_checkpoint_ = 0;  // of the log, from which on there is to be another
  std::unique_ptr<Mission> mission_;

  std::atomic<bool> hurry_ = false;  // the batch under way is to end soon
  mutable std::mutex mutex_;         // guards what follows
  Signal wake_, news_, room_;
  Orders orders_;
  Target target_;
  bool wanted_ = false;      // go() holds
  bool at_work_ = false;     // on a batch
  bool lent_ = false;        // a log's head
  std::uint64_t begun_ = 0;  // how often it began afresh: what was recorded before is not handed over
  std::deque<Batch> ready_;
  std::vector<std::vector<Event>> spare_;  // memory of batches that were taken
  std::string failure_;
  Thread thread_;  // last: it ends before what it uses
};

}  // namespace replan
