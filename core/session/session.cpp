#include "core/session/session.hpp"

#include <algorithm>
#include <cmath>

namespace replan {
namespace {

/// How many surprises two scenarios begin with in common, or nothing if no run can be carried over, whatever
/// its planner.
std::optional<std::size_t> common_surprises(const Scenario& a, const Scenario& b) {
  const bool same_run = a.map == b.map && a.start == b.start && a.goal == b.goal && a.robot == b.robot &&
                        a.movers == b.movers && a.seed == b.seed;
  if (!same_run) return std::nullopt;
  return Surprises::common(a.surprises, b.surprises);
}

/// What is done in step has somebody who does it.
WorkPlace with_steps(WorkPlace place) {
  if (!place.on_thread() && !place.steps) place.steps = std::make_shared<Steps>();
  return place;
}

}  // namespace

Session::Session(Scenario scenario, std::string file, const RunLimits& limits, WorkPlace place)
    : place_(with_steps(std::move(place))),
      scenario_(std::make_shared<const Scenario>(std::move(scenario))),
      kept_(scenario_),
      limits_(limits),
      history_(scenario_->surprises.size()),
      file_(std::move(file)) {
  restart_runs();
  take_debug(scenario_->debug);
}

Result<void> Session::apply(const Command& command) {
  if (has_to_wait(command)) return {};
  Result<void> done = std::visit([this](const auto& each) { return run_command(each); }, command);
  if (!done) say(done.error());
  update_instruments();
  ++revision_;
  return done;
}

/// Has each pane a run of its own; those that are there already are kept as they are.
void Session::match_panes() {
  RunLimits limits = limits_;
  limits.log.bytes /= scenario_->planners.size();
  runs_.resize(std::min(runs_.size(), scenario_->planners.size()));
  while (runs_.size() < scenario_->planners.size())
    runs_.push_back(std::make_unique<Run>(scenario_, runs_.size(), limits, place_));
  lead_ = std::min(lead_, runs_.size() - 1);
}

void Session::restart_runs() {
  go_another_way();
  match_panes();
  for (const auto& run : runs_) {
    run->restart(scenario_);
    run->go(Target::plan());
  }
  follow_ = !player_.plays();
}

/// Whoever has waited for a long search hears that an edit makes it begin again.
void Session::note_lost_search() {
  constexpr std::size_t kLongSearch = 1'000'000;  // events
  if (!run().decisions().empty() || run().timeline().size() < kLongSearch) return;
  notice_ = {"The first plan was not found yet: its search begins again on the changed world.", false};
  say(notice_.words);
}

void Session::replace(std::shared_ptr<const Scenario> scenario) {
  go_another_way();
  const auto common = common_surprises(*scenario_, *scenario);
  const bool same_script = scenario_->surprises == scenario->surprises;
  scenario_ = std::move(scenario);
  if (!common) {
    note_lost_search();
    restart_runs();
  } else if (same_script)
    replace_panes();
  else
    rebase_runs(*common);
}

Result<void> Session::run_command(const ReplaceScenario& command) {
  scenario_ = std::make_shared<const Scenario>(command.scenario);
  kept_ = command.unsaved_edits == 0 ? scenario_ : nullptr;
  file_ = command.file;
  put_away_.clear();
  const std::size_t surprises = scenario_->surprises.size();
  history_.begin(std::min(command.scripted.value_or(surprises), surprises), command.unsaved_edits);
  player_.stop();
  lead_ = 0;
  restart_runs();
  take_debug(scenario_->debug);
  say(file_.empty() ? "new world" : "opened " + file_);
  return {};
}

Result<void> Session::run_command(const Restart&) {
  Scenario changed = tidied(*scenario_, scripted());
  if (changed == *scenario_)
    restart_runs();
  else
    commit("plan from scratch", 0, std::move(changed));
  return {};
}

Result<void> Session::run_command(const Play& command) {
  stop_hunt();
  player_.play(command.direction);
  go_another_way();
  for (const auto& run : runs_) run->set_travel(1);
  if (command.direction != 0) follow_ = false;
  return {};
}

Result<void> Session::run_command(const SetSpeed& command) {
  player_.set_speed(command.expansions_per_second);
  return {};
}

Result<void> Session::run_command(const Step& command) {
  stop_hunt();
  player_.stop();
  go_another_way();
  follow_ = false;
  if (command.unit == StepUnit::mission && command.count > 0) {
    go_to_arrival();
    return {};
  }
  stepping_ = Stepping{command};
  go_on_stepping();
  return {};
}

/// Steps as far as the run has come. Where it has to go on first, that is waited for as long as patience lasts, and
/// then the rest of the steps is done by later updates.
bool Session::go_on_stepping() {
  if (!stepping_) return false;
  Run& run = leading();
  Step& step = stepping_->left;
  for (; step.count != 0; step.count -= step.count > 0 ? 1 : -1, stepping_->waits = false) {
    const std::size_t cursor = run.timeline().cursor();
    run.pump();
    if (step.count > 0 && cursor == run.timeline().size() && !stepping_->waits) send_on(run, step.unit);
    if (stepping_->waits && !run.rest(patience_)) return false;
    seek(step.count > 0 ? next_stop(run, cursor, step.unit) : previous_stop(run, cursor, step.unit));
  }
  stepping_.reset();
  return true;
}

/// At the end of its log a run goes on to its next decision. A first plan goes on in the background anyway: nobody
/// waits for it.
void Session::send_on(Run& run, StepUnit unit) {
  if (run.busy() && run.decisions().empty()) return;
  const Decision* decision = run.decision_at(run.timeline().size());
  run.go(unit == StepUnit::replan ? Target::end()
                                  : Target::clock_at(decision == nullptr ? 0 : decision->clock + 1));
  stepping_->waits = true;
}

Result<void> Session::run_command(const Seek& command) {
  go_another_way();
  stop_hunt();
  follow_ = command.position >= run().timeline().size();
  seek(command.position, command.travel);
  return {};
}

Result<void> Session::run_command(const RunTo& command) {
  stop_hunt();
  player_.stop();
  go_another_way();
  leading().go(Target::length_of(command.events));
  follow_ = true;
  return {};
}

Result<void> Session::run_command(const RunToEnd&) {
  stop_hunt();
  player_.stop();
  go_another_way();
  for (const auto& run : runs_) run->go(Target::end());
  follow_ = true;
  return {};
}

Result<void> Session::run_command(const Cancel&) {
  go_another_way();
  stop_hunt();
  checks_.stop_comparing();
  for (const auto& run : runs_) run->cancel();
  catching_up_ = false;
  return {};
}

void Session::seek(std::size_t position, double travel) {
  Run& first = leading();
  for (const auto& run : runs_) run->set_travel(std::clamp(travel, 0.0, 1.0));
  first.timeline().seek(std::min(position, first.timeline().size()));
  follow_lead();
}

void Session::glance(std::size_t pane, std::size_t position, double travel,
                     const std::function<void()>& look) {
  struct Place {
    std::size_t cursor;
    double travel;
  };
  std::vector<Place> places;
  for (const auto& run : runs_) places.push_back({run->timeline().cursor(), run->travel()});
  const bool catching_up = catching_up_;
  const std::size_t lead = std::exchange(lead_, pane);
  seek(position, travel);
  ++revision_;
  look();
  for (std::size_t i = 0; i < places.size(); ++i) {
    runs_[i]->timeline().seek(places[i].cursor);
    runs_[i]->set_travel(places[i].travel);
  }
  lead_ = lead;
  catching_up_ = catching_up_ || catching_up;
  ++revision_;
}

/// Takes over what was done beside the session, or does it: each run has its own share of a frame, and so has all else
/// that is to be done in step.
bool Session::pump() {
  const auto at_work = std::count_if(runs_.begin(), runs_.end(), [](const auto& run) { return run->busy(); });
  const double parts = static_cast<double>(at_work + (has_steps() ? 1 : 0));
  const double share = place_.on_thread() ? Run::kPumpMs : share_ / std::max(parts, 1.0);
  if (!place_.on_thread()) place_.steps->pump(Deadline(share));
  bool changed = finish_world_edit();
  for (const auto& run : runs_)
    if (run->pump(Deadline(share))) changed = true;
  return changed;
}

bool Session::update(double seconds) {
  bool changed = catching_up_;  // finish() may have taken over what a pane waited for
  if (pump()) changed = true;
  const bool returning = returning_.has_value();
  Run& first = leading();
  if (follow_ && !returning && first.timeline().cursor() != first.timeline().size()) {
    first.timeline().seek(first.timeline().size());
    changed = true;
  }
  if (arrive()) changed = true;
  if (go_on_stepping()) changed = true;
  if (changed && !returning && (follow_ || catching_up_)) follow_lead();
  if (play(seconds)) changed = true;
  if (check()) changed = true;
  if (look_for_stops()) changed = true;
  if (update_instruments()) changed = true;
  if (changed) ++revision_;
  return changed;
}

/// Whether the leading robot has farther to go, as far as is known.
bool Session::can_go_on() const {
  const auto decisions = run().decisions();
  return (decisions.empty() || decisions.back().state == MissionState::driving) && run().failure().empty();
}

/// Goes on playing where that had come to an end before the goal, once there is a way again.
void Session::resume() {
  if (!player_.waits() || returning_ || !can_go_on()) return;
  player_.play(1);
  follow_ = false;
}

bool Session::play(double seconds) {
  resume();
  if (!player_.plays()) return false;
  Run& run = leading();
  const std::size_t begin = run.timeline().cursor();
  const double travel_before = run.travel();
  const Player::Shown shown = player_.advance(run, seconds);
  const std::size_t cursor = may_play_to(begin, shown.cursor);
  if (const auto stop = stop_between(begin, cursor)) {
    stop_at(*stop);
    return true;
  }
  seek(cursor, shown.travel);
  const Decision* last = run.decisions().empty() ? nullptr : &run.decisions().back();
  if (player_.forwards() && can_go_on() && run.timeline().size() - cursor < 64 && !run.busy())
    run.go(last == nullptr ? Target::plan() : Target::clock_at(last->clock + 4));
  const bool finished =
      player_.forwards() ? cursor >= run.timeline().size() && !can_go_on() && !run.busy() : cursor == 0;
  if (finished && player_.forwards() && last != nullptr && last->state != MissionState::arrived)
    player_.wait();
  else if (finished)
    player_.stop();
  return cursor != begin || finished || run.travel() != travel_before;
}

void Session::settle() {
  while (has_steps()) place_.steps->pump(Deadline::never());
  world_edit_.wait();
  finish_world_edit();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Target way = returning_ ? Target::length_of(returning_->lengths[i]) : Target::plan();
    runs_[i]->wait();  // what was asked for comes first
    runs_[i]->finish(checks_.comparing() ? Target::end() : way);
  }
  do update(0);
  while (checks_.comparing());
  checks_.settle(runs_);
  settle_hunt();
  breakpoints_.look(run(), checked_log(), HUGE_VAL);
  watches_.look(runs_, HUGE_VAL);
}

std::string Session::failure() const {
  for (const auto& run : runs_)
    if (std::string failure = run->failure(); !failure.empty()) return failure;
  return {};
}

}  // namespace replan
