// The hunt for the next breakpoint, the next change of a value or the arrival.
#include <algorithm>
#include <chrono>

#include "core/base/deadline.hpp"
#include "core/debug/event_words.hpp"
#include "core/session/session.hpp"

namespace replan {
namespace {

/// Of one update, so that it stays within a frame.
constexpr double kMillisecondsOfLooking = 2, kMillisecondsOfHunting = 4;
/// Steps of the robot that a hunt runs the mission on at a time.
constexpr std::int64_t kStepsAhead = 64;

/// What GoToChange looks for, in words: "rhs(3, 4)", "km".
std::string subject_of(const GoToChange& change, const Run& run) {
  if (change.kind == EventKind::scalar) return value_name(static_cast<Scalar>(change.node));
  return value_name(run.info().values.field(change.kind)) + node_text(run.lattice(), change.node);
}

}  // namespace

Result<void> Session::run_command(const GoToBreakpoint& command) {
  if (!breakpoints_.wants_any())
    return Error{breakpoints_.list().empty() ? "there is no breakpoint: add a condition to stop at"
                                             : "no breakpoint is switched on"};
  const Run& run = this->run();
  const CheckedLog checked = checked_log();
  breakpoints_.look(run, checked, 0);  // so that what is known is of this log
  const std::size_t cursor = run.timeline().cursor(), known = breakpoints_.looked_through();
  const bool forwards = command.direction > 0;
  if (const Hit* hit = forwards ? breakpoints_.known_after(cursor) : breakpoints_.known_before(cursor);
      hit != nullptr && (forwards || known + 1 >= cursor)) {
    stop_at(*hit);
    return {};
  }
  HuntTask task{.direction = forwards ? 1 : -1, .looked = forwards ? std::max(cursor, known) : cursor};
  task.end = forwards ? run.timeline().size() : std::min(cursor, known);
  task.search.emplace(breakpoints_.search(run, checked, task.looked));
  start_hunt(std::move(task));
  return {};
}

Result<void> Session::run_command(const GoToChange& command) {
  const Timeline& log = run().timeline();
  const bool scalar = command.kind == EventKind::scalar;
  const std::size_t nodes = scalar ? static_cast<std::size_t>(Scalar::count) : run().lattice().node_count();
  if (command.node >= nodes || !Event{.kind = command.kind}.changes_value())
    return Error{"there is no such value to follow"};
  if (command.direction > 0) {
    HuntTask task{
        .prey = HuntTask::Prey::change, .change = command, .looked = log.cursor(), .end = log.size()};
    start_hunt(std::move(task));
    return {};
  }
  player_.stop();
  // The event that the cursor stands behind is where it has gone already.
  const auto event = last_change(command, log.cursor() == 0 ? 0 : log.cursor() - 1);
  if (!event) {
    say(subject_of(command, run()) + " does not change before here");
    return {};
  }
  follow_ = false;
  seek(*event + 1);
  return {};
}

/// The latest event before a position of the leading log that makes the value another one.
std::optional<std::size_t> Session::last_change(const GoToChange& command, std::size_t before) const {
  const Timeline& log = run().timeline();
  auto event = log.last_event(command.node, {command.kind}, before);
  while (event && !log.changes(*event, command.node, command.kind))
    event = log.last_event(command.node, {command.kind}, *event);
  return event;
}

std::optional<std::size_t> Session::next_change(const GoToChange& command, std::size_t from) const {
  const Timeline& log = run().timeline();
  auto event = log.next_event(command.node, {command.kind}, from);
  while (event && !log.changes(*event, command.node, command.kind))
    event = log.next_event(command.node, {command.kind}, *event + 1);
  return event;
}

std::optional<std::size_t> Session::next_arrival(std::size_t from) const {
  for (const Milestone& milestone : run().milestones())
    if (milestone.kind == EventKind::arrival && milestone.event >= from) return milestone.event;
  return std::nullopt;
}

// To where the robot arrives, or to the end; if that is still to come, the mission runs on.
void Session::go_to_arrival() {
  HuntTask task{.prey = HuntTask::Prey::arrival, .looked = run().timeline().cursor()};
  task.end = run().timeline().size();
  start_hunt(std::move(task));
}

void Session::start_hunt(HuntTask task) {
  player_.stop();
  follow_ = false;
  task.log_id = run().log_id();
  task.from = run().timeline().cursor();
  hunting_ = std::move(task);
  breakpoints_.set_hunt(Hunt{hunting_->direction, -1});
  hunt(kMillisecondsOfHunting);
}

void Session::stop_hunt() {
  hunting_.reset();
  breakpoints_.set_hunt(std::nullopt);
}

/// Goes on with the hunt for at most so many milliseconds. True if something to be seen changed.
bool Session::hunt(double milliseconds) {
  if (!hunting_) return false;
  const Timeline& log = run().timeline();
  if (run().log_id() != hunting_->log_id || log.cursor() != hunting_->from) {
    stop_hunt();
    return true;
  }
  const std::size_t looked_before = hunting_->looked;
  if (hunting_->prey == HuntTask::Prey::breakpoint)
    hunt_breakpoint(milliseconds);
  else
    hunt_event();
  if (!hunting_) return true;
  const HuntTask& task = *hunting_;
  const double way = task.direction > 0 ? static_cast<double>(task.end) - static_cast<double>(task.from)
                                        : static_cast<double>(task.from - task.end);
  const double gone = std::abs(static_cast<double>(task.looked) - static_cast<double>(task.from));
  breakpoints_.set_hunt(Hunt{task.direction, gone < way ? gone / way : -1});
  return task.looked != looked_before;
}

void Session::hunt_breakpoint(double milliseconds) {
  const Deadline deadline(milliseconds);
  HuntTask& task = *hunting_;
  const CheckedLog checked = checked_log();
  if (task.direction < 0) {
    while (task.looked > task.end && !deadline.passed()) {
      const std::size_t slice = std::min(task.search->slice(), task.looked - task.end);
      const auto hit = task.search->backwards(task.looked - slice, checked.verdicts());
      task.looked = task.search->position();
      if (hit) return stop_at(*hit);
    }
    if (task.looked > task.end) return;
    const Hit* known = breakpoints_.known_before(task.end);
    return known != nullptr ? stop_at(*known) : find_nothing("no breakpoint before here");
  }
  const std::size_t size = run().timeline().size(), end = breakpoints_.can_look_to(checked, size);
  std::vector<Hit> hits;
  while (task.looked < end && !deadline.passed()) {
    task.looked = std::min(end, task.looked + task.search->slice());
    task.search->forwards(task.looked, checked.verdicts(), hits);
    if (!hits.empty()) return stop_at(hits.front());
  }
  if (task.looked >= size && !run_on()) find_nothing("no breakpoint after here");
}

/// A change of a value, or the arrival: both are found by index.
void Session::hunt_event() {
  HuntTask& task = *hunting_;
  const std::size_t size = run().timeline().size();
  const bool arrival = task.prey == HuntTask::Prey::arrival;
  std::optional<std::size_t> event;
  if (!arrival) event = next_change(task.change, task.looked);
  if (arrival) event = next_arrival(task.looked);
  task.looked = size;
  if (!event && run_on()) return;
  if (!event && !arrival) return find_nothing(subject_of(task.change, run()) + " does not change after here");
  stop_hunt();
  seek(event ? *event + 1 : size);
}

void Session::find_nothing(const std::string& words) {
  say(words);
  stop_hunt();
}

/// Waits until what is hunted is found, and the other panes have come to where they belong.
void Session::settle_hunt() {
  while (hunting_) {
    if (hunting_->direction > 0) {
      const Decision* last = run().decisions().empty() ? nullptr : &run().decisions().back();
      leading().finish(last == nullptr ? Target::plan() : Target::clock_at(last->clock + 1));
    }
    update(0);
    checks_.settle(runs_);
  }
  const auto busy = [](const auto& run) { return run->busy(); };
  while (catching_up_ && std::any_of(runs_.begin(), runs_.end(), busy)) {
    for (const auto& run : runs_) run->rest(std::chrono::milliseconds(1));
    update(0);
  }
}

/// Has the leading run go on, in the background. False if nothing is left to do.
bool Session::run_on() {
  Run& run = leading();
  if (run.busy()) return true;
  const Decision* last = run.decisions().empty() ? nullptr : &run.decisions().back();
  if ((last != nullptr && last->state != MissionState::driving) || !run.failure().empty()) return false;
  run.go(last == nullptr ? Target::plan() : Target::clock_at(last->clock + kStepsAhead));
  return true;
}

void Session::stop_at(const Hit hit) {
  stop_hunt();
  player_.play(0);
  follow_ = false;
  seek(hit.position);
  const std::string& condition = breakpoints_.list()[hit.breakpoint].condition;
  const CheckedLog checked = checked_log();
  Probe probe(run().log_view(), breakpoints_.condition(hit.breakpoint), hit.position, checked.verdicts());
  const std::string values = values_text(probe, run().lattice());
  const std::string event = event_text(run().log_view(), hit.position);
  breakpoints_.set_stopped("stopped: " + condition + " (" + (values.empty() ? event : values + " now") + ")");
  stopped_log_ = run().log_id();
  stopped_at_ = hit.position;
  say(breakpoints_.stopped());
}

bool Session::look_for_stops() {
  bool changed = breakpoints_.wants_any() && breakpoints_.look(run(), checked_log(), kMillisecondsOfLooking);
  changed |= hunt(kMillisecondsOfHunting);
  return watches_.look(runs_, kMillisecondsOfLooking) || changed;
}

}  // namespace replan
