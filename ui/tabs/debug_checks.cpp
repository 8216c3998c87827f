// What the planners are held to: their own laws, the oracle, and one another. Part of the Debug tab.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/debug/event_words.hpp"
#include "core/lattice/box_words.hpp"
#include "ui/icons.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/debug.hpp"

namespace replan::ui {
namespace {

void go_to(Frame& frame, std::size_t pane, std::size_t position) {
  if (pane != frame.session.lead()) frame.commands.push_back(Lead{pane});
  frame.commands.push_back(Seek{position});
}

/// The pane's planner, if there are several.
std::string of_pane(const Session& session, std::size_t pane) {
  return session.runs().size() < 2 ? "" : std::string(session.runs()[pane]->info().name) + ": ";
}

/// "go there" and "break on it" below what is wrong.
void ways_to(Frame& frame, std::size_t pane, std::size_t position, const char* condition) {
  const Look& look = frame.look;
  if (link(look, "go", "Go there", look.fonts.ui)) go_to(frame, pane, position);
  ImGui::SameLine(0, look.px.l);
  const bool set = find_breakpoint(frame.session, condition).has_value();
  if (link(look, "break", set ? "Stop breaking on it" : "Break on it", look.fonts.ui))
    frame.commands.push_back(toggle_breakpoint(frame.session, condition));
  ImGui::Dummy({0, look.px.xs});
}

void laws_of(Frame& frame, std::size_t pane) {
  const Look& look = frame.look;
  const LawReport report = frame.session.checks().laws(pane);
  const std::size_t size = frame.session.runs()[pane]->timeline().size();
  const std::string name = of_pane(frame.session, pane);
  if (!frame.session.runs()[pane]->info().values.lawful()) {
    status(look, look.theme.dim, name + "none are checked");
    hint(look, {"No laws", "",
                "What this planner keeps, a tree or a population, has no laws that are checked here."});
    return;
  }
  ImGui::PushID(static_cast<int>(pane));
  if (report.first) {
    status(look, look.theme.bad,
           name + count_text(static_cast<std::int64_t>(report.breaches), "breach", "breaches") +
               ", the first at event " + grouped(report.first->position));
    paragraph(look.fonts.ui, look.theme.text, as_sentence(report.first->law) + ".");
    paragraph(look.fonts.mono, look.theme.dim, report.first->words);
    if (report.first->node != kNoNode) {
      const Cell cell = frame.session.runs()[pane]->lattice().position(report.first->node);
      if (link(look, "cell", "Cell " + cell_text(cell, frame.session.runs()[pane]->lattice()), look.fonts.ui))
        show_cell(frame, cell);
      point_at(frame, cell);
      ImGui::SameLine(0, look.px.l);
    }
    ways_to(frame, pane, report.first->position, "event(invariant)");
  } else if (report.checked < size) {
    status(look, look.theme.dim,
           name + "hold so far: " + grouped(report.checked) + " of " + grouped(size) + " events");
  } else {
    status(look, look.theme.good, name + "hold after each of " + grouped(size) + " events");
  }
  ImGui::PopID();
}

std::string disagreement_text(const Disagreement& first) {
  const std::string plan = first.plan == 0 ? "The first plan" : "Replan " + grouped(first.plan);
  if (first.claimed.is_infinite())
    return plan + " finds no path, yet there is one that costs " + cost_text(first.right) + ".";
  if (first.right.is_infinite())
    return plan + " claims a path that costs " + cost_text(first.claimed) + ", yet there is none.";
  return plan + " costs " + cost_text(first.claimed) + "; the cheapest one costs " + cost_text(first.right) +
         ".";
}

void oracle_of(Frame& frame, std::size_t pane) {
  const Look& look = frame.look;
  const OracleReport report = frame.session.checks().oracle(pane);
  const std::string name = of_pane(frame.session, pane);
  const auto asked = static_cast<std::int64_t>(report.asked);
  ImGui::PushID(static_cast<int>(pane));
  if (report.first) {
    const Disagreement& first = *report.first;
    status(look, look.theme.bad,
           name + "disagrees with " +
               count_text(static_cast<std::int64_t>(report.disagreements), "plan", "plans"));
    paragraph(look.fonts.ui, look.theme.text, disagreement_text(first));
    ways_to(frame, pane, first.position, "event(oracle)");
  } else if (report.busy || asked == 0) {
    status(look, look.theme.dim,
           name + (report.busy ? "being asked… " + count_text(asked, "plan", "plans") + " so far"
                               : "nothing to ask yet: there is no plan"));
  } else {
    status(look, look.theme.good, name + "agrees with " + count_text(asked, "plan", "plans"));
    if (!report.exact)
      hint(look, {"", "",
                  "With these settings the planner does not promise a cheapest path. The oracle asks only "
                  "whether it "
                  "finds one where there is one."});
  }
  ImGui::PopID();
}

}  // namespace

void draw_checks(Frame& frame) {
  const Look& look = frame.look;
  const Checks& checks = frame.session.checks();
  section_title(look, "Checks");
  bool laws = checks.laws(frame.session.lead()).on, oracle = checks.oracle(frame.session.lead()).on;
  const bool laws_switched = toggle(look, "The planner's own laws", laws);
  hint(look, term_hint("invariant"));
  ImGui::PushID("laws");
  if (laws && !laws_switched)
    for (std::size_t pane = 0; pane < frame.session.runs().size(); ++pane) laws_of(frame, pane);
  ImGui::PopID();
  const bool oracle_switched = toggle(look, "The oracle: plain Dijkstra on the robot's map", oracle);
  hint(look, term_hint("oracle"));
  ImGui::PushID("oracle");
  if (oracle && !oracle_switched)
    for (std::size_t pane = 0; pane < frame.session.runs().size(); ++pane) oracle_of(frame, pane);
  ImGui::PopID();
  if (laws_switched || oracle_switched) frame.commands.push_back(SetChecks{laws, oracle});
  if (!laws && !oracle)
    paragraph(
        look.fonts.ui, look.theme.dim,
        "Each step is held to what the planner promises, each plan to the cheapest way there is. The first "
        "step that goes wrong is found and marked on the timeline.");
}

namespace {

void difference_choices(Frame& frame, Comparison& comparison) {
  const Look& look = frame.look;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < frame.session.runs().size(); ++i)
    names.push_back(std::to_string(i + 1) + "  " + std::string(frame.session.runs()[i]->info().name));
  std::vector<const char*> items;
  for (const std::string& name : names) items.push_back(name.c_str());
  const float half = (ImGui::GetContentRegionAvail().x - look.px.s) * 0.5f;
  for (int& pane : comparison.panes) pane = std::clamp(pane, 0, static_cast<int>(items.size()) - 1);
  if (comparison.panes[0] == comparison.panes[1]) comparison.panes = {0, 1};
  combo(look, "##first", items, comparison.panes[0], half);
  ImGui::SameLine(0, look.px.s);
  combo(look, "##second", items, comparison.panes[1], half);
  static constexpr std::array<const char*, 4> kWhat = {"every event", "expansions", "costs of plans",
                                                       "the robot's way"};
  combo(look, "##what", kWhat, comparison.what, half);
  hint(look,
       {"What is compared", "",
        "Every event that both planners write; which cell is taken and the g that it gets; what each plan "
        "costs; or where the robot goes."});
  ImGui::SameLine(0, look.px.s);
  if (comparison.panes[0] != comparison.panes[1] && button(look, "Find", ButtonKind::primary, icon::search)) {
    frame.commands.push_back(FindDifference{
        {static_cast<std::size_t>(comparison.panes[0]), static_cast<std::size_t>(comparison.panes[1])},
        static_cast<Compare>(comparison.what)});
  }
}

/// The cell of each of the two, to point at, and to go there with the Cell tab telling of it.
void parted_cells(Frame& frame, const Difference& difference) {
  const Look& look = frame.look;
  for (std::size_t i = 0; i < 2; ++i) {
    const Run& run = *frame.session.runs()[difference.panes[i]];
    const NodeId node = difference.nodes[i];
    const std::string place = node == kNoNode ? "there" : "to " + node_text(run.lattice(), node);
    ImGui::PushID(static_cast<int>(i));
    const bool clicked = link(look, "go", ("Go " + place).c_str(), look.fonts.ui);
    hint(look, {"", "", "Both panes stand where they part; this one leads, and its cell is pinned."});
    if (node != kNoNode) point_at(frame, run.lattice().position(node));
    ImGui::SameLine(0, look.px.s);
    text(look.fonts.ui, look.theme.dim, run.info().name);
    ImGui::PopID();
    if (!clicked) continue;
    frame.commands.push_back(Lead{difference.panes[i]});
    frame.commands.push_back(FindDifference{difference.panes, difference.what});
    if (node != kNoNode) show_cell(frame, run.lattice().position(node));
  }
}

}  // namespace

void draw_difference(Frame& frame, Comparison& comparison) {
  const Look& look = frame.look;
  const Checks& checks = frame.session.checks();
  section_title(look, "First difference");
  if (frame.session.runs().size() < 2) {
    paragraph(look.fonts.ui, look.theme.dim,
              "With two planners side by side, this finds the first moment at which they part ways.");
    if (button(look, "Show two planners", ButtonKind::plain, icon::columns))
      frame.commands.push_back(SetPanes{2});
    return;
  }
  difference_choices(frame, comparison);
  if (checks.comparing()) {
    frame.panels.animated = true;
    progress(look, -1, "Running both until they part…");
    return;
  }
  if (checks.comparison().empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              "Runs both as far as they are alike, and goes to where they differ first.");
    return;
  }
  paragraph(look.fonts.ui, look.theme.text, as_sentence(checks.comparison()));
  if (const auto& difference = checks.difference()) parted_cells(frame, *difference);
}

}  // namespace replan::ui
