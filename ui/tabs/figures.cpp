#include "ui/tabs/figures.hpp"

#include <algorithm>
#include <vector>

#include "core/base/clock.hpp"
#include "core/trace/search_state.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/speed_chart.hpp"

namespace replan::ui {
namespace {

/// As the window prints it: thousands apart.
std::string shown(const FigureRow& row, std::size_t pane, bool standing) {
  if (!standing) return "–";
  if (row.info->unit == "ms" && row.values[pane] && *row.values[pane] < kFinestMs) return kUnderFinestMs;
  if (row.info->decimals > 0 || !row.values[pane]) return figure_text(*row.info, row.values[pane]);
  const double scale = row.info->unit == "kB" ? 1000 : 1;
  return grouped(static_cast<std::int64_t>(*row.values[pane] / scale + 0.5));
}

/// A number at the right end of its column, and the best with a bar under it: it is told by more than its
/// colour and weight.
void draw_value(const Look& look, float right, float y, const std::string& text, bool best) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImFont* font = best ? look.fonts.mono_bold : look.fonts.mono;
  const float width = text_width(font, text);
  draw_text(list, font, {right - width, y}, best ? look.theme.good : look.theme.text, text);
  if (!best) return;
  const float foot = y + font->FontSize + look.px(1);
  list.AddRectFilled({right - width, foot}, {right, foot + look.px(2)}, look.theme.good);
}

/// How the columns lie: beside the row's name, or below it where there are more than two panes, or too little room for
/// the planners' names.
struct FiguresLayout {
  float left, width, name;  // name: the share of the names; 0 if they stand above
  std::size_t panes;
  [[nodiscard]] float ratio_width(const Look& look) const { return panes == 2 && name > 0 ? look.px(48) : 0; }
  [[nodiscard]] float right(const Look& look, std::size_t pane) const {
    const float room = width - name - ratio_width(look);
    return left + name + room * static_cast<float>(pane + 1) / static_cast<float>(panes);
  }
};

FiguresLayout figures_layout(const Look& look, const FiguresTable& table) {
  const float width = ImGui::GetContentRegionAvail().x;
  FiguresLayout layout{ImGui::GetCursorScreenPos().x, width, std::min(look.px(140), width * 0.42f),
                       table.names.size()};
  const float room = layout.right(look, 0) - layout.left - layout.name - look.px.s;
  const bool fit = std::all_of(table.names.begin(), table.names.end(), [&](const std::string& each) {
    return text_width(look.fonts.ui, each) <= room;
  });
  if (layout.panes > 2 || !fit) layout.name = 0;
  return layout;
}

void draw_names(const Look& look, const FiguresLayout& layout, const FiguresTable& table) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float before = layout.left + layout.name;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const float right = layout.right(look, i);
    const float room = right - before - look.px.s;
    const float width = std::min(text_width(look.fonts.ui, table.names[i]), room);
    draw_line(look, *ImGui::GetWindowDrawList(), look.fonts.ui, {right - width, origin.y}, look.theme.dim,
              table.names[i], room);
    before = right;
  }
  ImGui::Dummy({layout.width, look.px.row});
}

void draw_ratio(const Look& look, const FiguresLayout& layout, const FigureRow& row, std::size_t pane,
                float y) {
  const auto ratio = row.ratio(pane);
  if (!ratio) return;
  const std::string text = ratio_text(*ratio);
  const ImFont* font = layout.name > 0 ? look.fonts.mono : look.fonts.small;
  const float right = layout.name > 0 ? layout.left + layout.width : layout.right(look, pane);
  draw_text(*ImGui::GetWindowDrawList(), font, {right - text_width(font, text), y}, look.theme.dim, text);
}

void draw_row(const Look& look, const FiguresLayout& layout, const FigureRow& row,
              const std::vector<bool>& standing) {
  const bool stacked = layout.name == 0;
  const bool ratios =
      stacked && std::any_of(row.values.begin() + 1, row.values.end(), [&](const auto& value) {
        return value && row.ratio(static_cast<std::size_t>(&value - row.values.data()));
      });
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float line = look.px.row, height = stacked ? line * (ratios ? 2.5f : 1.75f) : line;
  ImGui::InvisibleButton(row.info->key.data(), {layout.width, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered())
    list.AddRectFilled(origin, {origin.x + layout.width, origin.y + height}, look.theme.hover, look.px(4));
  hint(look, {row.info->label.data(), "", row.info->teach.data()});
  const std::string name =
      std::string(row.info->label) + (row.unit.empty() ? "" : "  " + std::string(row.unit));
  const float y = origin.y + (line - look.fonts.mono->FontSize) * 0.5f;
  draw_line(look, list, look.fonts.ui, {origin.x, y}, look.theme.dim, name,
            stacked ? layout.width : layout.name);
  const float values = stacked ? y + line * 0.75f : y;
  for (std::size_t i = 0; i < layout.panes; ++i) {
    draw_value(look, layout.right(look, i), values, shown(row, i, standing[i]), standing[i] && row.best(i));
    if (standing[i]) draw_ratio(look, layout, row, i, stacked ? values + line * 0.9f : y);  // below the bar
  }
}

void export_menu(Frame& frame) {
  const Look& look = frame.look;
  if (const BesideTitle place(look, 1); small_button(
          look, "export",
          {.icon = icon::download,
           .hint = {"Export", "",
                    "These figures as CSV, JSON, Markdown or LaTeX: to the clipboard or to a file."}}))
    ImGui::OpenPopup("export");
  if (!ImGui::BeginPopup("export")) return;
  const auto entry = [&frame, &look](ActionId id) {
    if (menu_item(look, action(id).label.c_str())) perform(frame, id);
    hint(look, {"", "", action(id).teach.c_str()});
  };
  for (const ActionId id :
       {ActionId::copy_markdown, ActionId::copy_latex, ActionId::copy_csv, ActionId::copy_json})
    entry(id);
  ImGui::Separator();
  entry(ActionId::save_figures);
  ImGui::EndPopup();
}

}  // namespace

/// The figures of the first plan, on the map that it was made for, as far as they are worked out.
FiguresTab::Kept& FiguresTab::kept(const Session& session, std::size_t pane) {
  const Run& run = *session.runs()[pane];
  if (kept_.size() <= pane) kept_.resize(pane + 1);
  std::unique_ptr<Kept>& kept = kept_[pane];
  const Decision& first = run.decisions().front();
  if (!kept || kept->plan != first.plan) {
    const Timeline& log = run.timeline();
    SharedBytes known =
        log.cursor() == first.event ? log.state().known_map() : log.state_at(first.event).known_map();
    kept = std::make_unique<Kept>(session.work().only_if(run.lattice().node_count() > kLargeWorld));
    kept->plan = first.plan;
    // Cannot be cut up: clearances need a transform of the whole map.
    kept->job.start([box = run.lattice(), map = std::move(known), plan = first.plan](const StopToken&) {
      return path_figures(box, map.plain(), *plan->path);
    });
  }
  if (auto figures = kept->job.take()) kept->figures = *figures;
  return *kept;
}

std::vector<RunReport> FiguresTab::as_known(const Session& session, const ViewState& view) {
  std::vector<RunReport> reports;
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    const Run& run = *session.runs()[pane];
    const Decision* decision = run.decision_at(run.timeline().cursor());
    const auto& figures = decision == nullptr ? std::nullopt : kept(session, pane).figures;
    if (!figures) {
      reports.emplace_back();
      reports.back().planner = run.choice().id;
      reports.back().status = status_name(PlanStatus::searching);
    } else {
      reports.push_back(report_at(*decision, *run.decisions().front().plan, *figures, run.choice(),
                                  run.scenario().robot.radius));
    }
    // Also of a pane that has no figures yet: the table is in metres only where all are.
    reports.back().frame = shown_frame(view, run.scenario().map);
  }
  return reports;
}

std::vector<RunReport> FiguresTab::now(const Session& session, const ViewState& view) {
  static_cast<void>(as_known(session, view));  // begins what is not worked out yet
  for (const auto& each : kept_)
    if (each) each->job.wait();
  return as_known(session, view);
}

void ActionContext::copy_figures(FiguresFormat format) {
  ImGui::SetClipboardText(figures_text(format, panels.tabs.get<FiguresTab>().now(session, view)).c_str());
  panels.said =
      std::string("Copied the figures as ") + figures_formats()[static_cast<std::size_t>(format)].name;
  panels.tone = Tone::done;
}

void FiguresTab::draw_fitness(Frame& frame) {
  const Look& look = frame.look;
  section_title(look, "Cost over generations");
  if (const BesideTitle place(look, 1); small_button(
          look, "copy fitness",
          {.icon = icon::copy,
           .hint = {"Copy as CSV", "",
                    "What the fittest path and all of them on average cost after each generation."}})) {
    ImGui::SetClipboardText(fitness_.csv(frame.session).c_str());
    frame.panels.said = "Copied the cost of each generation as CSV";
    frame.panels.tone = Tone::done;
  }
  fitness_.draw(frame, look.px(96));
  section_rule(look);
}

void FiguresTab::draw(Frame& frame) {
  const Look& look = frame.look;
  if (has_gains(frame.session)) {
    section_title(look, "Best path over samples");
    gains_.draw(frame, look.px(96));
    section_rule(look);
  }
  if (has_generations(frame.session)) draw_fitness(frame);
  const std::vector<RunReport> reports = as_known(frame.session, frame.view);
  std::vector<bool> standing;
  for (const RunReport& report : reports)
    standing.push_back(report.status != status_name(PlanStatus::searching));
  const auto at_work = [](const auto& each) { return each && each->job.busy(); };
  const bool busy = std::any_of(kept_.begin(), kept_.end(), at_work);
  if (busy) frame.panels.animated = true;
  if (std::find(standing.begin(), standing.end(), true) == standing.end()) {
    if (busy)
      empty_state(look, icon::bar_chart, "Measuring the path",
                  "On a world as large as this it takes a moment.");
    else
      empty_state(look, icon::bar_chart, "No plan yet",
                  "Step or play on until the first plan is found; its figures show here.");
    return;
  }
  const FiguresTable table = figures_table(reports);
  const FiguresLayout layout = figures_layout(look, table);
  section_title(look, figure_group_title(FigureGroup::first_plan));
  export_menu(frame);
  draw_names(look, layout, table);
  FigureGroup group = FigureGroup::first_plan;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, look.px(1)));
  for (const FigureRow& row : table.rows) {
    if (row.info->wall_time && !frame.view.live) continue;  // a picture is the same on every machine
    if (row.info->group != group) {
      section_rule(look);
      section_title(look, figure_group_title(row.info->group));
      group = row.info->group;
    }
    draw_row(look, layout, row, standing);
  }
  ImGui::PopStyleVar();
  if (!has_speeds(frame.session)) return;
  section_rule(look);
  section_title(look, "Speed over time");
  speed_chart(frame, look.px(72));
}

TabKind figures_tab() {
  return {.name = "Figures",
          .label = "Figures",
          .icon = icon::bar_chart,
          .chord = fn(6),
          .teach =
              "What each planner did and how good its first plan is, side by side, with ratios. The best is "
              "marked where the "
              "panes can be compared.",
          .make = make_part<SideTab, FiguresTab>,
          .per_pane = false};
}

}  // namespace replan::ui
