#include "ui/tabs/analysis.hpp"

#include <array>

#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {

void AnalysisTab::draw(Frame& frame) {
  static constexpr std::array<const char*, 2> kAnalyses = {"Scatter plot", "Tree of parents"};
  int part = static_cast<int>(part_);
  if (segments(frame.look, "analysis", kAnalyses, part)) part_ = static_cast<Part>(part);
  ImGui::Dummy({0, frame.look.px.xs});
  if (part_ == Part::scatter) {
    lit_ = false;
    return scatter_.draw(frame);
  }
  // Once each time that it comes up: who switches it off then does not want it.
  if (!std::exchange(lit_, true)) replan::show_family(frame.view.view.overlays);
  family_.draw(frame);
}

void show_scatter(ViewState& view, PanelState& panels) {
  show_tab(view, panels, "analysis");
  panels.tabs.get<AnalysisTab>().show_scatter();
}

void show_family(ViewState& view, PanelState& panels) {
  show_tab(view, panels, "analysis");
  panels.tabs.get<AnalysisTab>().show_family();
}

bool has_scatter(const Session& session, const PanelState& panels) {
  return panels.tabs.get<AnalysisTab>().scatter().has_points(session.run());
}

void copy_scatter(const Session& session, PanelState& panels) {
  panels.tabs.get<AnalysisTab>().scatter().copy(session.run(), panels);
}

TabKind analysis_tab() {
  return {.name = "Analysis",
          .label = "Analysis",
          .icon = icon::bar_chart,
          .chord = fn(11),
          .teach = "A run as a whole: a scatter plot of its cells, and the tree that their parents make.",
          .make = make_part<SideTab, AnalysisTab>,
          // The bar has no room for one more in a row.
          .in_bar = [](const Session&) { return false; }};
}

}  // namespace replan::ui
