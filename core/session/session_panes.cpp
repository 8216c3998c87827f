// The session's panes: how many there are, which of them leads, and how the others keep step with it.
#include <algorithm>

#include "core/base/words.hpp"
#include "core/session/session.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

constexpr std::size_t kMostPanes = 4;

/// In how many traits two planners differ.
int unlikeness(const PlannerInfo& a, const PlannerInfo& b) {
  const bool other_search = a.incremental != b.incremental || a.from_goal != b.from_goal;
  return (other_search ? 1 : 0) + (a.any_angle != b.any_angle ? 1 : 0) +
         ((a.clearance != nullptr) != (b.clearance != nullptr) ? 1 : 0) + (a.sight != b.sight ? 1 : 0);
}

/// The planner that is least like any of those there: there is most to see. Of equals the later one in the
/// registry, which has the plainest first. What draws by chance stands beside what does so too. nullptr if all that fit the world
/// and the robot are there.
const PlannerInfo* planner_beside(std::span<const PlannerChoice> there, const Box& box, double radius) {
  const PlannerInfo* best = nullptr;
  int most = 0;
  for (const PlannerInfo& info : planners()) {
    const auto is_there = [&](const PlannerChoice& each) { return each.id == info.id; };
    const bool of_kind = there.empty() || info.can_miss() == info_of(there.front()).can_miss();
    const bool can_plan = of_kind && !info.exercise && fits(info, box, radius);
    if (!can_plan || std::any_of(there.begin(), there.end(), is_there)) continue;
    int least = 100;
    for (const PlannerChoice& each : there) least = std::min(least, unlikeness(info, info_of(each)));
    if (best != nullptr && least < most) continue;
    best = &info;
    most = least;
  }
  return best;
}

}  // namespace

Result<void> Session::run_command(const SetPanes& command) {
  if (command.count < 1 || command.count > kMostPanes)
    return Error{"there can be from 1 to " + std::to_string(kMostPanes) + " panes"};
  if (command.count == scenario_->planners.size()) return {};
  Scenario changed = *scenario_;
  std::vector<PlannerChoice>& panes = changed.planners;
  for (; panes.size() > command.count; panes.pop_back()) put_away_.push_back(panes.back());
  for (; panes.size() < command.count && !put_away_.empty(); put_away_.pop_back()) {
    const auto is_there = [&](const PlannerChoice& each) { return each.id == put_away_.back().id; };
    if (std::none_of(panes.begin(), panes.end(), is_there) &&
        fits(info_of(put_away_.back()), box(), changed.robot.radius))
      panes.push_back(put_away_.back());
  }
  while (panes.size() < command.count) {
    const PlannerInfo* info = planner_beside(panes, box(), changed.robot.radius);
    if (info == nullptr) return Error{"there is no further planner to compare with"};
    panes.push_back(choice_of(*info, run().choice()));
  }
  commit("show " + counted(command.count, "pane"), 0, std::move(changed));
  history_.excuse_last();
  return {};
}

Result<void> Session::run_command(const SetLockstep& command) {
  lockstep_ = command.by;
  follow_lead();
  return {};
}

// All stay where they are until the playhead moves next: to look at a pane's values changes no picture.
Result<void> Session::run_command(const Lead& command) {
  if (command.pane >= runs_.size()) return Error{"there is no such pane"};
  if (command.pane == lead_) return {};
  stop_hunt();
  lead_ = command.pane;
  catching_up_ = false;
  follow_ = run().timeline().cursor() == run().timeline().size();
  return {};
}

/// The panes have changed and nothing else has: runs whose planner stays are kept as they are, and the new
/// ones catch up with the leading one.
void Session::replace_panes() {
  const Run* led = &run();
  const std::uint64_t log = led->log_id();
  match_panes();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (runs_[i]->choice() == scenario_->planners[i]) {
      runs_[i]->adopt(scenario_);
      if (runs_[i]->timeline().size() > 0 || runs_[i]->busy()) continue;
    } else {
      runs_[i]->restart(scenario_);
    }
    runs_[i]->go(Target::plan());
  }
  if (&run() != led || run().log_id() != log) follow_ = run().timeline().cursor() == run().timeline().size();
  follow_lead();
}

/// The script has changed from the surprise number `common` on.
void Session::rebase_runs(std::size_t common) {
  const std::size_t before = runs_.size();
  match_panes();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (i < before && runs_[i]->choice() == scenario_->planners[i])
      runs_[i]->rebase(scenario_, common);
    else
      runs_[i]->restart(scenario_);
    runs_[i]->go(Target::plan());
  }
  follow_ = !player_.plays();  // what plays goes on at its own pace
}

/// Puts the other panes where they belong beside the leading one, as far as they have come; the rest of the
/// way they go in the background.
void Session::follow_lead() {
  catching_up_ = false;
  const Run& first = run();
  for (const auto& each : runs_) {
    if (each.get() == &first) continue;
    const Standing standing = standing_beside(first, *each, lockstep_);
    if (standing.lacking && each->failure().empty()) {
      catching_up_ = true;
      if (!each->busy()) each->go(*standing.lacking);
    }
    each->timeline().seek(standing.position);
  }
}

}  // namespace replan
