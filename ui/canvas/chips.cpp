#include "ui/canvas/chips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/plan/stage.hpp"
#include "core/scene/cover.hpp"
#include "core/world/choices.hpp"
#include "core/world/ends.hpp"
#include "ui/canvas/slice_bar.hpp"
#include "ui/icons.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// A whole card of which a larger share lies over the world, or under which a larger share of the world lies, is one
/// line until it is clicked.
constexpr double kMostHidden = 0.25, kMostOfWorld = 0.06;

/// The settings that tell a pane from another one with the same planner; empty if there is none.
std::string distinction(const Run& run) {
  const PlannerChoice& own = run.choice();
  std::string text;
  for (const PlannerChoice& other : run.scenario().planners) {
    if (other.id != own.id || other == own) continue;
    const Settings its = settings_of(other, run.scenario().robot);
    for (const Parameter& parameter : run.info().parameters)
      if (run.settings().get(parameter) != its.get(parameter))
        text += (text.empty() ? ", " : " · ") + std::string(parameter.label) + " " +
                format_value(parameter, run.settings().get(parameter));
    if (own.stages != other.stages)
      for (const StageChoice& stage : own.stages)
        text += (text.empty() ? ", " : " · ") + std::string(find_stage(stage.id)->name);
    return text;
  }
  return text;
}

/// How much a planner has done, in steps of its own.
std::string work_text(const Run& run, std::int64_t count) {
  const StepWords& step = run.info().step;
  return grouped(count) + " " + std::string(count == 1 ? step.one : step.many);
}

/// What stands beside the planner's name; where there is no room for all panes, how to come to the others.
std::string title_figures(const Look& look, const Run& run, SceneMemory& memory, const ViewState& state,
                          const ShownSlice& slice) {
  if (state.hides_panes) {
    const std::string panes = std::to_string(run.scenario().planners.size()) + " panes";
    return look.px.fingers ? "one of " + panes : "N shows the next of " + panes;
  }
  const std::size_t cursor = run.timeline().cursor();
  const Decision* decision = run.decision_at(cursor);
  std::string figures = work_text(run, memory.expansions(run, cursor));
  if (decision != nullptr && !decision->plan->path->empty())
    figures += " · " + count_text(static_cast<std::int64_t>(decision->plan->path->size()), "node", "nodes");
  if (!slice.sheet.box.solid()) return figures;
  if (!slice.bar) figures += " · " + layer_text(slice.sheet);
  return slice.orbits ? figures : figures + " · " + axes_text(slice.sheet.box.along());
}

/// Why a plan that was found cannot be driven.
const char* why_wrong(const Run& run) {
  return run.info().exercise ? ": this planner is broken on purpose."
                             : ": its remote parents were never checked.";
}

struct CardPlace {
  ImVec2 at;
  double hidden = 0;    ///< the share of the card that lies over the world
  double of_world = 0;  ///< the share of the world that lies under it
  [[nodiscard]] bool roomy() const { return hidden <= kMostHidden && of_world <= kMostOfWorld; }
  [[nodiscard]] bool hides_nothing() const { return hidden <= 0; }
};

/// Where a card of that size hides least of the world: at the right, from `top` or from `below` the title, or at the left
/// below that.
CardPlace card_place(const Look& look, const Scene& scene, const ScreenArea& area, ImVec2 size, float top,
                     float below) {
  const float margin = look.px(12), left = area.min.x + margin, right = area.max.x - margin - size.x;
  const PixelBox world = Cover::world(scene);
  CardPlace best{{right, top}, 2};
  for (const ImVec2 at : {ImVec2(right, top), ImVec2(right, below), ImVec2(left, below)}) {
    const auto x = static_cast<double>(at.x - area.min.x), y = static_cast<double>(at.y - area.min.y);
    const PixelBox box{x, y, x + static_cast<double>(size.x), y + static_cast<double>(size.y)};
    const double common = box.common(world);
    if (const double hidden = common / (box.width() * box.height()); hidden < best.hidden)
      best = {at, hidden, common / std::max(world.width() * world.height(), 1.0)};
  }
  return best;
}

/// The fullest line that has room beside the title.
CardForm line_form(const Look& look, const ReplanReport& report, float room) {
  for (const CardForm form : {CardForm::line, CardForm::comparison, CardForm::touched})
    if (replan_card_size(look, report, form).x <= room) return form;
  return CardForm::least;
}

struct CardDrawn {
  CardAnswer answer;
  ScreenArea area;
};

/// The card of a replan in a pane, beside its title or below it.
CardDrawn draw_card(const Look& look, const Scene& scene, const ReplanReport& report, const CardFold& fold,
                    const ScreenArea& pane, const ScreenArea& title, float below) {
  const float room = pane.max.x - title.max.x - 2 * look.px(12);
  const auto place = [&](CardForm form) {
    const ImVec2 size = replan_card_size(look, report, form);
    return card_place(look, scene, pane, size, size.x <= room ? title.min.y : below, below);
  };
  // A picture has the whole card where that hides little of the world, and no number.
  const CardPlace widest = place(CardForm::whole);
  const bool roomy = scene.numbers == NumbersShown::none ? widest.roomy() : widest.hides_nothing();
  const bool whole = report.times ? fold.whole(ImGui::GetTime(), roomy) : roomy;
  const CardForm form = whole ? CardForm::whole : line_form(look, report, room);
  const ImVec2 at = place(form).at, size = replan_card_size(look, report, form);
  return {draw_replan_card(look, at, report, form), {at, {at.x + size.x, at.y + size.y}}};
}

}  // namespace

std::string grouped(std::int64_t number) {
  std::string text = std::to_string(std::abs(number));
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, " ");
  return number < 0 ? "-" + text : text;
}

std::string count_text(std::int64_t count, const char* one, const char* many) {
  return grouped(count) + " " + (count == 1 ? one : many);
}

StateMessage state_message(const Run& run, SceneMemory& memory) {
  const std::size_t cursor = run.timeline().cursor();
  const Decision* decision = run.decision_at(cursor);
  if (memory.searching_since(run, cursor)) {
    if (!run.busy() || cursor != run.timeline().size()) return {};
    const std::int64_t expanded = memory.expansions(run, cursor);
    return {"Planning: " + work_text(run, expanded) + " so far", false};
  }
  if (decision == nullptr) return {};
  switch (decision->state) {
    case MissionState::stuck:
      return {"The robot is stuck: it finds no arc that leads it on, and has given up.", true};
    case MissionState::collision:
      if (decision->drive.begun) return {"The robot hit something that came nearer than it can stop.", true};
      return {std::string("The plan leads through an obstacle") + why_wrong(run), true};
    case MissionState::loop:
      return {std::string("The plan leads round in a circle") + why_wrong(run), true};
    case MissionState::endless:
      return {"Moving obstacles turned the robot back, or kept it waiting, again and again; it has given up.",
              true};
    case MissionState::nearest:
      return {"The goal cannot be reached: the robot stands on the reachable cell nearest to it.", false};
    default:
      break;
  }
  if (decision->plan->status == PlanStatus::found || decision->plan->status == PlanStatus::searching)
    return {};
  if (decision->plan->status == PlanStatus::found_nearest)
    return {status_sentence(decision->plan->status), false};
  const bool has_size = run.scenario().robot.radius > 0;
  const SearchState& state = run.timeline().state();
  const NodeId robot = state.node(Scalar::robot);
  const bool away = robot != run.lattice().node(run.scenario().start);
  if (decision->plan->status == PlanStatus::start_blocked && away)
    return {
        has_size
            ? "The robot stands in an obstacle, or so near to one that no way leads out: clear cells, or put "
              "it elsewhere."
            : "The robot stands in an obstacle: clear its cell, or put it elsewhere.",
        true};
  if (decision->plan->status == PlanStatus::no_path && state.truly_blocked(robot))
    return {"An obstacle stands on the robot's cell, and no way leads out of it.", true};
  const bool start = decision->plan->status == PlanStatus::start_blocked;
  if (start || decision->plan->status == PlanStatus::goal_blocked)
    if (std::string unknown = unknown_end_sentence(run.scenario(), start); !unknown.empty())
      return {std::move(unknown), true};
  return {status_sentence(decision->plan->status, has_size), true};
}

float pane_title_height(const Look& look) {
  return look.px(12) + look.px(29) + look.px.xs;
}

ChipsDrawn draw_chips(const Look& look, ImDrawList& list, const Run& run, const Scene& scene,
                      SceneMemory& memory, FreshPlans& plans, const ViewState& state, const ShownSlice& slice,
                      ImVec2 min, ImVec2 max, bool choosable, CardFold& fold) {
  const Theme& theme = look.theme;
  const float margin = look.px(12);
  const std::size_t cursor = run.timeline().cursor();
  const std::string figures = title_figures(look, run, memory, state, slice);
  const std::string name = std::string(run.info().name) + distinction(run);
  const std::array<TextRun, 3> title = {{{name, theme.text, look.fonts.title},
                                         {figures, theme.dim, look.fonts.small},
                                         {icon::caret_down, theme.faint, look.fonts.ui}}};
  ChipsDrawn drawn;
  const ImVec2 corner(min.x + margin, min.y + margin);
  const ImVec2 left = chip(look, list, corner, std::span(title).first(choosable ? 3 : 2));
  drawn.title = {corner, {corner.x + left.x, corner.y + left.y}};
  float below = min.y + margin + left.y + look.px.s + (slice.bar ? slice_bar_height(look) : 0);
  ImVec2 card_foot(max.x, min.y);  // lower left corner
  const RepairFigures repair = memory.repair(run, cursor);
  fold.see(repair.number, ImGui::GetTime());
  if (repair.number > 0) {
    const auto fresh = plans.of(run, static_cast<std::size_t>(repair.number), !state.live);
    const ReplanReport report{&run.info(), repair, fresh, state.live, run.info().incremental};
    const CardDrawn card = draw_card(look, scene, report, fold, {min, max}, drawn.title, below);
    drawn.card = card.answer;
    if (card.area.min.x > min.x + margin)
      card_foot = {card.area.min.x, card.area.max.y};
    else
      below = card.area.max.y + look.px.s;
  }
  if (const StateMessage message = state_message(run, memory); !message.text.empty()) {
    const TextRun text{message.text, message.bad ? theme.bad : theme.text, look.fonts.ui};
    const float width = text_width(look.fonts.ui, message.text) + look.px(20);
    const float right = min.x + 2 * margin + width, after_title = drawn.title.max.x + look.px.s;
    const bool clear = right < card_foot.x || card_foot.y < below;
    // Beside the title it is on nothing, for a fitted world begins below that.
    const bool beside = after_title + width + margin <= card_foot.x;
    const ImVec2 at = beside ? ImVec2(after_title, corner.y)
                             : ImVec2(min.x + margin, clear ? below : card_foot.y + look.px.s);
    const ImVec2 size = chip_message(look, list, at, text, max.x - min.x - 2 * margin);
    drawn.message = {at, {at.x + size.x, at.y + size.y}};
  }
  return drawn;
}

}  // namespace replan::ui
