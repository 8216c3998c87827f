#include "ui/tabs/debug.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "core/debug/cost_words.hpp"
#include "core/plan/tree_values.hpp"
#include "core/robots/drive_sense.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/watch_chart.hpp"

namespace replan::ui {
namespace {

/// What is about to be typed: a condition, or a quantity.
struct Entry {
  const char* id;
  const char* placeholder;
  bool quantity;
};

/// The names of the language and what they mean, beside the field.
void language_help(Frame& frame, const Entry& entry) {
  const Look& look = frame.look;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.l, look.px.m));
  if (ImGui::BeginPopup("language")) {
    section_title(look, entry.quantity ? "What can be watched" : "What a condition is made of");
    ImGui::BeginChild("names", {look.px(480), look.px(380)});
    for (const LanguageWord& word : language_words(entry.quantity)) {
      const float y = ImGui::GetCursorPosY();
      text(look.fonts.mono, look.theme.text, word.form);
      ImGui::SetCursorPos({look.px(150), y});
      paragraph(look.fonts.ui, look.theme.dim, word.help);
    }
    ImGui::EndChild();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

/// The field in which a condition or a quantity is typed, with what is wrong with it. Whether it was entered.
bool entry_field(Frame& frame, const Entry& entry, std::string& draft) {
  const Look& look = frame.look;
  ImGui::PushID(entry.id);
  const std::string error = draft.empty() ? "" : language_error(frame.session, draft, entry.quantity);
  const float buttons = look.px.small * 2 + look.px.xs * 2;
  // Whether Enter was pressed on what stands there: who is still typing needs to be told what is missing, not scolded.
  bool& refused = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("refused"));
  const bool typing = ImGui::GetActiveID() == ImGui::GetID("##field");
  const Fault fault = error.empty() ? Fault::none : refused || !typing ? Fault::refused : Fault::unfinished;
  const std::string before = draft;
  bool entered = code_field(look, "##field", entry.placeholder, draft,
                            ImGui::GetContentRegionAvail().x - buttons, fault);
  ImGui::SameLine(0, look.px.xs);
  entered |=
      small_button(look, "add", {.icon = icon::plus, .hint = {"Add", "Enter"}, .enabled = !draft.empty()});
  ImGui::SameLine(0, look.px.xs);
  if (small_button(look, "help", {.icon = icon::question, .hint = {"What can be typed here"}}))
    ImGui::OpenPopup("language");
  language_help(frame, entry);
  if (entered || draft != before) refused = entered && !error.empty();
  if (!error.empty())
    paragraph(look.fonts.ui, fault == Fault::refused ? look.theme.bad : look.theme.dim, as_sentence(error));
  else if (typing && !draft.empty())
    paragraph(look.fonts.small, look.theme.faint, "Enter adds it.");
  ImGui::PopID();
  return entered && !draft.empty() && error.empty();
}

/// Examples that a click takes over into the field.
void examples(const Look& look, std::span<const std::pair<std::string, std::string>> list,
              std::string& draft) {
  for (const auto& [expression, meaning] : list) {
    if (link(look, expression.c_str(), expression, look.fonts.mono)) draft = expression;
    ImGui::SameLine(0, look.px.m);
    text(look.fonts.small, look.theme.faint, meaning);
  }
  ImGui::Dummy({0, look.px.xs});
}

Cell some_cell(const Frame& frame) {
  return frame.cell().value_or(frame.session.scenario().goal);
}

using Examples = std::vector<std::pair<std::string, std::string>>;

/// To stop where the best path has become shorter: conditions are in cells, whatever the window shows.
std::pair<std::string, std::string> shorter_path(const Frame& frame, const std::string& what) {
  const Scenario& scenario = frame.session.scenario();
  const SearchState& state = frame.run().timeline().state();
  const Box& world = frame.run().lattice();
  const NodeId start = state.node(Scalar::start), goal = state.wanted_goal();
  const double least = distance(start == kNoNode ? scenario.start : world.position(start),
                                goal == kNoNode ? scenario.goal : world.position(goal));
  const std::uint64_t best = state.scalar(Scalar::best);
  const std::string cost = cost_to_fall_below(
      best == 0 ? std::nullopt : std::optional(Cost{static_cast<std::int64_t>(best)}.to_double()), least);
  const LengthUnit lengths = shown_lengths(frame.view, scenario.map);
  const std::string length = lengths.metric() ? lengths.text(std::stod(cost), 2) : "that many cells";
  return {"best < " + cost, what + " is shorter than " + length};
}

/// Breakpoints that are of use with the leading pane's planner.
Examples breakpoints_to_take(const Frame& frame) {
  const SearchValues& values = frame.run().info().values;
  if (values.grows()) {
    const std::uint32_t goal = goal_vertex(frame.run().timeline().state());
    return {
        {"event(first_path)", "the tree has met the goal"},
        shorter_path(frame, "the path"),
        {"rewired(" + std::to_string(goal == kNoNode ? 1 : goal) + ")", "the vertex is hung on another one"},
        {"event(replan)", "a replan begins"}};
  }
  if (values.breeds())
    return {{"event(first_path)", "a path hits nothing any more"},
            shorter_path(frame, "the fittest path"),
            {"generation == 10", "ten generations have ended"},
            {"event(replan)", "a replan begins"}};
  return {{"event(replan)", "a replan begins"},
          {when_taken(some_cell(frame), frame.run().lattice()), "the cell is taken from U"},
          {"km > 5 && size(U) >= 100", "values alone, or together"}};
}

/// Quantities that are worth following likewise.
Examples watches_to_take(const Frame& frame) {
  const SearchValues& values = frame.run().info().values;
  if (values.grows())
    return {{"best", "the cost of the best path, in cells"},
            {"vertices", "how many vertices the tree has"},
            {"vertex_cost(1)", "what the way to a vertex costs"}};
  if (values.breeds())
    return {{"best", "the cost of the fittest path that hits nothing, in cells"},
            {"generation", "how many generations have ended"}};
  return {{value_expression(EventKind::g, some_cell(frame), frame.run().lattice()), "the cost of a cell"},
          {"size(U)", "how many cells wait"},
          {"km", "how much is added to new keys"}};
}

void title_with_steps(Frame& frame) {
  const Look& look = frame.look;
  section_title(look, "Breakpoints");
  const BesideTitle place(look, 2);
  for (const ActionId id : {ActionId::breakpoint_back, ActionId::breakpoint_forward}) {
    const Action& each = action(id);
    const bool usable = each.available(context_of(frame));
    if (small_button(look, each.name, {.icon = each.icon, .hint = each.hint(), .enabled = usable}))
      perform(frame, id);
    ImGui::SameLine(0, look.px.xs);
  }
}

/// Where the breakpoint stops next, or what is wrong with it, as a sentence.
std::string next_hit_text(const Frame& frame, std::size_t index) {
  if (const std::string& problem = frame.session.breakpoints().problem(index); !problem.empty())
    return as_sentence(problem);
  const std::span<const Hit> hits = frame.session.breakpoints().hits();
  const std::size_t cursor = frame.session.run().timeline().cursor();
  const auto from = std::partition_point(hits.begin(), hits.end(),
                                         [cursor](const Hit& hit) { return hit.position <= cursor; });
  const auto next = std::find_if(from, hits.end(), [&](const Hit& hit) { return hit.breakpoint == index; });
  return next == hits.end() ? "No stop after the playhead, as far as the run has come."
                            : "Stops next at event " + grouped(next->position) + ".";
}

/// A switch, the condition, how often it stops, and the way to remove it.
void breakpoint_row(Frame& frame, std::size_t index, std::int64_t hits) {
  const Look& look = frame.look;
  const Breakpoint& breakpoint = frame.session.breakpoints().list()[index];
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  ImGui::PushID(static_cast<int>(index));
  bool on = breakpoint.enabled;
  if (toggle(look, "##on", on)) frame.commands.push_back(SwitchBreakpoint{index, on});
  hint(look, {on ? "Switch it off" : "Switch it on"});
  const Breakpoints& all = frame.session.breakpoints();
  const bool sound = all.problem(index).empty();
  const bool more = all.looked_through() < frame.session.run().timeline().size();  // or too many to keep
  const std::string count = !sound      ? "not on this world"
                            : !on       ? ""
                            : hits == 0 ? (more ? "…" : "no stop")
                                        : count_text(hits, "stop", "stops") + (more ? "+" : "");
  const float count_x = right - look.px(28) - text_width(look.fonts.small, count);
  ImGui::SetCursorScreenPos({origin.x + look.px(38), origin.y + look.px(3)});
  text(look.fonts.mono,
       !sound ? look.theme.bad
       : on   ? look.theme.text
              : look.theme.faint,
       elide(look.fonts.mono, breakpoint.condition, count_x - origin.x - look.px(38 + 8)));
  hint(look, {breakpoint.condition.c_str(), "", next_hit_text(frame, index).c_str()});
  draw_text(*ImGui::GetWindowDrawList(), look.fonts.small, {count_x, origin.y + look.px(4)}, look.theme.faint,
            count);
  ImGui::SetCursorScreenPos({right - look.px.small, origin.y - look.px(2)});
  if (small_button(look, "remove", {.icon = icon::times, .hint = {"Remove"}}))
    frame.commands.push_back(RemoveBreakpoint{index});
  ImGui::PopID();
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.px(26)});
}

void breakpoints_section(Frame& frame, std::string& draft) {
  const Look& look = frame.look;
  title_with_steps(frame);
  const Breakpoints& breakpoints = frame.session.breakpoints();
  if (breakpoints.list().empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              "The playhead stops where a condition comes true. Click beside a line in the Code tab, or take "
              "one of "
              "these:");
    Examples list = breakpoints_to_take(frame);
    if (drives(frame.run().scenario(), frame.run().choice()))
      list.insert(list.end(), {{"score(winner) < 0.5", "the arc that it takes is poor"},
                               {"admissible == 0", "it may take none of its arcs"},
                               {"changed(sub_goal)", "it makes for another sub-goal"}});
    examples(look, list, draft);
  }
  std::vector<std::int64_t> counts(breakpoints.list().size());
  for (const Hit& hit : breakpoints.hits())
    if (hit.breakpoint < counts.size()) ++counts[hit.breakpoint];
  for (std::size_t i = 0; i < counts.size(); ++i) breakpoint_row(frame, i, counts[i]);
  if (!counts.empty() && frame.session.runs().size() > 1)
    paragraph(look.fonts.small, look.theme.dim, whose_stops(frame.run().info().name));
  if (entry_field(frame, {"breakpoint", "stop when …", false}, draft)) {
    frame.commands.push_back(AddBreakpoint{draft});
    draft.clear();
  }
}

/// One watch: what it is, its value at the playhead, and its course over the run.
void watch_row(Frame& frame, std::size_t index) {
  const Look& look = frame.look;
  const Session& session = frame.session;
  const std::string& expression = session.watches().list()[index];
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  const std::string& problem = session.watches().problem(index);
  const std::string value =
      problem.empty() ? quantity_text(session.watches().value(session.lead(), index)) : "not on this world";
  const float value_x = right - look.px(28) - text_width(look.fonts.mono_bold, value);
  ImGui::PushID(static_cast<int>(index));
  text_line(look, look.fonts.mono, look.theme.dim, expression, value_x - origin.x - look.px.s);
  hint(look, {expression.c_str(), "", as_sentence(problem).c_str()});
  draw_text(*ImGui::GetWindowDrawList(), look.fonts.mono_bold, {value_x, origin.y}, look.theme.text, value);
  ImGui::SetCursorScreenPos({right - look.px.small, origin.y - look.px(5)});
  if (small_button(look, "remove", {.icon = icon::times, .hint = {"Stop watching it"}}))
    frame.commands.push_back(RemoveWatch{index});
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.px(20)});
  if (problem.empty()) watch_chart(frame, index, look.px(48));
  ImGui::PopID();
  ImGui::Dummy({0, look.px.xs});
}

void watches_section(Frame& frame, std::string& draft) {
  const Look& look = frame.look;
  section_title(look, "Watches");
  const auto list = frame.session.watches().list();
  if (list.empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              "A watch draws a quantity over the whole run. Right click a value in the Cell tab, or take one "
              "of these:");
    Examples suggestions = watches_to_take(frame);
    if (drives(frame.run().scenario(), frame.run().choice()))
      suggestions.push_back({"score(winner)", "the score of the arc that it takes"});
    examples(look, suggestions, draft);
  }
  for (std::size_t i = 0; i < list.size(); ++i) watch_row(frame, i);
  if (entry_field(frame, {"watch", "watch …", true}, draft)) {
    frame.commands.push_back(AddWatch{draft});
    draft.clear();
  }
}

}  // namespace

std::string whose_stops(std::string_view planner) {
  return "The stops are those of " + std::string(planner) +
         ", which leads; the other panes go along. Let another pane lead, and they are its own.";
}

void DebugTab::draw(Frame& frame) {
  breakpoints_section(frame, breakpoint);
  section_rule(frame.look);
  watches_section(frame, watch);
  section_rule(frame.look);
  draw_checks(frame);
  section_rule(frame.look);
  draw_difference(frame, comparison_);
}

FindDifference DebugTab::find_difference(const Session& session) const {
  const auto [one, other] = comparison_.panes;
  const auto panes = static_cast<int>(session.runs().size());
  const bool sound = one != other && one < panes && other < panes;
  return {{sound ? static_cast<std::size_t>(one) : 0, sound ? static_cast<std::size_t>(other) : 1},
          static_cast<Compare>(comparison_.what)};
}

TabKind debug_tab() {
  return {.name = "Debug",
          .label = "Debug",
          .icon = icon::bug,
          .chord = fn(7),
          .teach = "Where to stop, what to follow, and what the planners are held to.",
          .make = make_part<SideTab, DebugTab>};
}

}  // namespace replan::ui
