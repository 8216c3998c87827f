#include "ui/tabs/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/debug/arc_words.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/drive_picture.hpp"

namespace replan::ui {
namespace {

/// Why there are no arcs to be told of.
struct NoArcs {
  const char* title;
  std::string advice;
};

NoArcs keeps_to_its_plan() {
  std::string kind;
  for (const RobotInfo& info : robots())
    if (info.drives && kind.empty()) kind = info.name;
  return {"This robot keeps to its plan",
          "It has no choice to explain here. In the Planner tab, choose the robot " + kind +
              ": it drives along arcs, and here stands why it takes one and not another."};
}

NoArcs ended(MissionState state) {
  switch (state) {
    case MissionState::arrived:
      return {"It has arrived", "There is nothing left to decide. Step back to see its last decisions."};
    case MissionState::stuck:
      return {"It is stuck", "It found no arc that leads on along its plan. Step back to see what it tried."};
    case MissionState::collision:
      return {"It has hit something", "Step back to see the decision before."};
    default:
      return {"It stands",
              "There is no way to its goal, so it has no arc to choose. A change of the world may open one."};
  }
}

NoArcs no_arcs(const replan::Run& run) {
  if (!drives(run.scenario(), run.choice())) return keeps_to_its_plan();
  const Decision* decision = run.decision_at(run.timeline().cursor());
  if (decision == nullptr)
    return {"No plan yet", "It chooses its first arc when its plan stands: step on, or play."};
  if (plans_at_cursor(run))
    return {"It plans again", "It chooses its next arc when the new plan stands: step on, or play."};
  if (decision->state == MissionState::driving && !decision->plan->path->empty())
    return {"It plans again", "It has lost sight of its sub-goal, so it makes a new plan from where it is."};
  return ended(decision->state);
}

void heading(Frame& frame, const Decision& decision, const DriveWhy& why) {
  const Look& look = frame.look;
  const DriveDecision& made = why.explanation.decision;
  section_title(look, "Decision at " +
                          fixed(static_cast<double>(decision.time) / static_cast<double>(kSecond), 1) + " s");
  paragraph(look.fonts.ui, look.theme.text, deed_sentence(made));
  ImGui::Dummy({0, look.px.xs});
  const std::vector<std::pair<const char*, std::string>> values = {
      {"sub-goal", cell_text(why.frame.cell(why.goal))},
      {"away", fixed(distance(why.state.pose.spot(), why.goal), 2) + " m"},
      {"speed now", speed_text(why.state.motion.v)},
      {"samples", std::to_string(why.explanation.samples.size())},
      {why.state.motion.w < 0 ? "turn left" : "turn right",
       fixed(std::abs(why.state.motion.w), 2) + " rad/s"},
      {"admissible", std::to_string(made.admissible)}};
  std::vector<KeyValue> pairs;
  float widest = 0;
  for (const auto& [name, value] : values) {
    pairs.push_back({name, value});
    widest = std::max(widest, text_width(look.fonts.mono, name) + text_width(look.fonts.mono, value));
  }
  key_values(look, pairs, 2 * (widest + look.px(18)) <= ImGui::GetContentRegionAvail().x ? 2 : 1);
}

/// A sample that is told of, and what it is.
struct ToldSample {
  DriveSample sample;
  std::string_view what;
};

/// The one that was clicked, or else the runner-up, and the winner; of the winner the runner-up is the other.
std::vector<ToldSample> told_samples(const View& view, const DriveWhy& why) {
  const Explanation& all = why.explanation;
  std::vector<ToldSample> told;
  std::optional<DriveSample> winner, runner_up;
  if (all.decision.winner) winner = all.samples[*all.decision.winner];
  if (all.decision.winner && all.runner_up) runner_up = all.samples[*all.runner_up];
  if (view.motion) {
    const DriveSample sample = sample_of(why, *view.motion);
    const bool wins = winner && sample.motion == winner->motion;
    told.push_back({sample, wins ? "Winner" : "Clicked"});
    if (wins) winner.reset();
    if (!wins) runner_up.reset();
  }
  if (runner_up) told.push_back({*runner_up, "Runner-up"});
  if (winner) told.push_back({*winner, "Winner"});
  return told;
}

std::string told_title(const ToldSample& told) {
  return std::string(told.what) + ": " + speed_text(told.sample.motion.v) + ", " +
         turn_text(told.sample.motion.w);
}

/// Where nothing won: how many samples were rejected for which reason.
void draw_reasons(const Look& look, const DriveWhy& why) {
  section_rule(look);
  section_title(look, "Why nothing won");
  constexpr std::array<std::pair<Rejection, const char*>, 5> kReasons = {
      {{Rejection::too_fast, "too fast to stop"},
       {Rejection::turns_too_fast, "turn too fast to stop"},
       {Rejection::circles, "would circle"},
       {Rejection::stands, "stand or turn in place"},
       {Rejection::none, "admissible"}}};
  std::vector<std::string> counts;
  std::vector<const char*> names;
  for (const auto& [reason, words] : kReasons) {
    const auto count =
        std::count_if(why.explanation.samples.begin(), why.explanation.samples.end(),
                      [wanted = reason](const DriveSample& each) { return each.rejection == wanted; });
    if (count == 0) continue;
    counts.push_back(std::to_string(count));
    names.push_back(words);
  }
  std::vector<KeyValue> pairs;
  for (std::size_t i = 0; i < names.size(); ++i) pairs.push_back({names[i], counts[i]});
  key_values(look, pairs, 1);
}

/// Both samples with their terms; of the first it is told why it won or lost.
void draw_comparison(Frame& frame, const DriveWhy& why) {
  const Look& look = frame.look;
  const std::vector<ToldSample> told = told_samples(frame.view.view, why);
  if (!why.explanation.decision.winner) draw_reasons(look, why);
  for (std::size_t i = 0; i < told.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    section_rule(look);
    section_title(look, told_title(told[i]));
    const DriveSample* other = i == 0 && told.size() > 1 ? &told[1].sample : nullptr;
    if (i == 0)
      paragraph(look.fonts.ui, told[i].sample.admissible() ? look.theme.text : look.theme.bad,
                verdict_sentence(told[i].sample, why.explanation, why.settings));
    term_table(frame, why, told[i].sample, other);
    ImGui::PopID();
  }
}

bool some_pane_drives(const Session& session) {
  return std::any_of(session.runs().begin(), session.runs().end(),
                     [](const auto& run) { return drives(run->scenario(), run->choice()); });
}

}  // namespace

/// Working out the reasons takes a millisecond or more.
void DriveTab::follow(const Frame& frame) {
  const replan::Run& run = frame.run();
  const Moment now{frame.session.revision(), run.log_id(), run.timeline().cursor()};
  if (moment_ == now) return;
  moment_ = now;
  why_ = why_at_cursor(run);
}

void DriveTab::draw(Frame& frame) {
  follow(frame);
  if (!why_) {
    const NoArcs none = no_arcs(frame.run());
    empty_state(frame.look, icon::car, none.title, none.advice);
    return;
  }
  heading(frame, *frame.run().decision_at(frame.run().timeline().cursor()), *why_);
  section_rule(frame.look);
  draw_windows(frame, *why_);
  draw_comparison(frame, *why_);
}

void show_drive(ViewState& view) {
  view.tab = "drive";
  view.panels = true;
}

TabKind drive_tab() {
  return {
      .name = "Drive",
      .label = "Drive",
      .icon = icon::car,
      .chord = fn(10),
      .teach =
          "Why a robot that drives takes one arc and not another: all speeds and turn rates that it tried, "
          "with every term of their scores.",
      .make = make_part<SideTab, DriveTab>,
      .in_bar = some_pane_drives};
}

}  // namespace replan::ui
