#include "ui/canvas/chips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/plan/stage.hpp"
#include "core/world/ends.hpp"
#include "ui/canvas/replan_card.hpp"
#include "ui/colormap.hpp"
#include "ui/icons.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Height of the design from which on a canvas has room for the whole card of a replan.
constexpr float kWholeCardHeight = 560;

struct SignEntry {
  Sign sign;
  LegendShape shape;
  ImU32 Theme::*colour;
  const char* label;
};
constexpr std::array<SignEntry, static_cast<std::size_t>(Sign::count)> kSigns = {{
#define REPLAN_SIGN(ID, SHAPE, COLOUR, LABEL) {Sign::ID, LegendShape::SHAPE, &Theme::COLOUR, LABEL},
#include "core/scene/signs.def"
#undef REPLAN_SIGN
}};

std::string value_text(double value) {
  char text[32];
  if (value == std::floor(value)) return grouped(static_cast<std::int64_t>(value));
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/// The width that an entry takes in a legend, with the space before it.
float entry_width(const Look& look, const LegendEntry& entry) {
  const bool long_mark = entry.shape == LegendShape::long_arrow || entry.shape == LegendShape::line ||
                         entry.shape == LegendShape::dashed;
  return look.px(18) + look.px(5) + look.px(long_mark ? 13 : 9) +
         std::ceil(text_width(look.fonts.ui, entry.label));
}

/// All that is in sight, what is rarest and needs telling most first.
std::vector<LegendEntry> entries_in_sight(const Look& look, const Scene& scene) {
  std::vector<LegendEntry> entries;
  for (const SignEntry& entry : kSigns)
    if (scene.shows(entry.sign)) entries.push_back({entry.shape, look.theme.*entry.colour, entry.label});
  entries.push_back({LegendShape::dot, look.theme.start, "start"});
  entries.push_back({LegendShape::dot, look.theme.goal, "goal"});
  return entries;
}

/// Breaks entries into rows no wider than `room`; the first has `used` taken already.
std::vector<std::vector<LegendEntry>> in_rows(const Look& look, const std::vector<LegendEntry>& entries,
                                              float used, float room) {
  std::vector<std::vector<LegendEntry>> rows(1);
  float width = used;
  for (const LegendEntry& entry : entries) {
    const float more = entry_width(look, entry);
    if (width + more > room && !rows.back().empty()) {
      rows.emplace_back();
      width = look.px(20);
    }
    width += more;
    rows.back().push_back(entry);
  }
  return rows;
}

/// One row over the world; the rest unfolds above it while the mouse is there, so that it hides no cells.
void draw_legend(const Look& look, ImDrawList& list, const Scene& scene, ImVec2 min, ImVec2 max) {
  const float margin = look.px(12), room = max.x - min.x - 2 * margin;
  LegendField field;
  std::string low, high;
  float used = look.px(20);
  if (scene.range) {
    low = value_text(scene.range->low);
    high = value_text(scene.range->high);
    field = {overlays()[static_cast<std::size_t>(*scene.field)].label, &viridis(), low, high};
    used += look.px(120 + 28) + text_width(look.fonts.ui, field.label) +
            text_width(look.fonts.mono, low + high + "   ");
  }
  const std::vector<LegendEntry> entries = entries_in_sight(look, scene);
  auto rows = in_rows(look, entries, used, room);
  if (rows.size() > 1) rows = in_rows(look, entries, used, room - look.px(46));
  const ImVec2 foot(min.x + margin, max.y - margin);
  const ImVec2 size = legend(look, list, foot, field, rows.front());
  if (rows.size() == 1) return;
  const std::string more = "+" + std::to_string(entries.size() - rows.front().size());
  const std::array<TextRun, 1> runs = {{{more, look.theme.dim, look.fonts.ui}}};
  const ImVec2 chip_size =
      chip(look, list, {foot.x + size.x + look.px.xs, foot.y}, runs, Corner::bottom_left);
  const ImVec2 end(foot.x + size.x + look.px.xs + chip_size.x, foot.y);
  if (!ImGui::IsMouseHoveringRect({foot.x, foot.y - size.y}, end, false)) return;
  float bottom = foot.y - size.y - look.px.xs;
  for (std::size_t i = 1; i < rows.size(); ++i)
    bottom -= legend(look, list, {foot.x, bottom}, LegendField{}, rows[i]).y + look.px.xs;
}

/// The settings that tell a pane from another one with the same planner; empty if there is none.
std::string distinction(const Run& run) {
  const PlannerChoice& own = run.choice();
  std::string text;
  for (const PlannerChoice& other : run.scenario().planners) {
    if (other.id != own.id || other == own) continue;
    for (const Parameter& parameter : run.info().parameters)
      if (own.settings.get(parameter) != other.settings.get(parameter))
        text += (text.empty() ? ", " : " · ") + std::string(parameter.label) + " " +
                format_value(parameter, own.settings.get(parameter));
    if (own.stages != other.stages)
      for (const StageChoice& stage : own.stages)
        text += (text.empty() ? ", " : " · ") + std::string(find_stage(stage.id)->name);
    return text;
  }
  return text;
}

/// Why a plan that was found cannot be driven.
const char* why_wrong(const Run& run) {
  return run.info().exercise ? ": this planner is broken on purpose."
                             : ": its remote parents were never checked.";
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
    return {"Planning: " + count_text(expanded, "expansion", "expansions") + " so far", false};
  }
  if (decision == nullptr) return {};
  switch (decision->state) {
    case MissionState::collision:
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
  const SearchState& state = run.timeline().state();
  const NodeId robot = state.node(Scalar::robot);
  const bool away = robot != run.lattice().node(run.scenario().start);
  if (decision->plan->status == PlanStatus::start_blocked && away)
    return {"The robot stands in an obstacle: clear its cell, or put it elsewhere.", true};
  if (decision->plan->status == PlanStatus::no_path && state.truly_blocked(robot))
    return {"An obstacle stands on the robot's cell, and no way leads out of it.", true};
  const bool start = decision->plan->status == PlanStatus::start_blocked;
  if (start || decision->plan->status == PlanStatus::goal_blocked)
    if (std::string unknown = unknown_end_sentence(run.scenario(), start); !unknown.empty())
      return {std::move(unknown), true};
  return {status_sentence(decision->plan->status), true};
}

std::vector<LegendEntry> all_signs(const Look& look) {
  std::vector<LegendEntry> entries = {{LegendShape::dot, look.theme.start, "start"},
                                      {LegendShape::dot, look.theme.goal, "goal"}};
  for (auto entry = kSigns.rbegin(); entry != kSigns.rend(); ++entry)
    entries.push_back({entry->shape, look.theme.*entry->colour, entry->label});
  return entries;
}

ImVec2 draw_chips(const Look& look, ImDrawList& list, const Run& run, const Scene& scene, SceneMemory& memory,
                  FreshPlans& plans, const ViewState& state, ImVec2 min, ImVec2 max, bool choosable) {
  const Theme& theme = look.theme;
  const float margin = look.px(12);
  const std::size_t cursor = run.timeline().cursor();
  const Decision* decision = run.decision_at(cursor);
  std::string figures = count_text(memory.expansions(run, cursor), "expansion", "expansions");
  if (decision != nullptr && !decision->plan->path->empty())
    figures += " · " + count_text(static_cast<std::int64_t>(decision->plan->path->size()), "node", "nodes");
  if (run.lattice().solid()) figures += " · layer " + std::to_string(state.view.slice);
  const std::string name = std::string(run.info().name) + distinction(run);
  const std::array<TextRun, 3> title = {{{name, theme.text, look.fonts.title},
                                         {figures, theme.dim, look.fonts.small},
                                         {icon::caret_down, theme.faint, look.fonts.ui}}};
  const ImVec2 left =
      chip(look, list, {min.x + margin, min.y + margin}, std::span(title).first(choosable ? 3 : 2));
  float below = min.y + margin + left.y + look.px.s;
  ImVec2 card_foot(max.x, min.y);  // lower left corner
  if (const RepairFigures repair = memory.repair(run, cursor); repair.number > 0) {
    const auto fresh = plans.of(run, static_cast<std::size_t>(repair.number), !state.live);
    const ReplanReport report{repair, fresh, state.live};
    const float room = max.x - min.x - left.x - 3 * margin;
    const bool brief = max.y - min.y < look.px(kWholeCardHeight);  // it would hide too much of the world
    const bool beside = replan_card_size(look, report, brief).x <= room;
    const float top = beside ? min.y + margin : below;
    const ImVec2 size = draw_replan_card(look, list, {max.x - margin, top}, report, brief);
    card_foot = {max.x - margin - size.x, top + size.y};
  }
  if (const StateMessage message = state_message(run, memory); !message.text.empty()) {
    const TextRun text{message.text, message.bad ? theme.bad : theme.text, look.fonts.ui};
    const float right = min.x + 2 * margin + text_width(look.fonts.ui, message.text) + look.px(20);
    const bool clear = right < card_foot.x || card_foot.y < below;
    chip_message(look, list, {min.x + margin, clear ? below : card_foot.y + look.px.s}, text,
                 max.x - min.x - 2 * margin);
  }
  if (state.legend) draw_legend(look, list, scene, min, max);
  return left;
}

}  // namespace replan::ui
