#include "ui/tabs/scatter.hpp"

#include <algorithm>
#include <cmath>

#include "core/session/world_edit.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/scatter_picture.hpp"

namespace replan::ui {
namespace {

/// Of one frame, for reading and painting.
constexpr double kScatterMs = 4;
/// So many rows are copied at most.
constexpr std::size_t kMostCopied = 100'000;
/// Of a cell in which many vertices of a tree lie, so many are marked.
constexpr std::size_t kMostRowsMarked = 32;

int bins_of(const Look& look, float pixels) {
  return std::max(1, static_cast<int>(pixels / look.px(kBinSide)));
}

std::string range_text(const Measure& measure, const ColumnRange& range) {
  return measure_text(measure, range.low) + " … " + measure_text(measure, range.high);
}

}  // namespace

std::string no_points_words(const PlannerInfo& planner) {
  const char* points = planner.values.grows() ? "every vertex of the tree is a point here."
                       : planner.values.breeds()
                           ? "every cell that the paths of the population go through is a point here."
                           : "every cell that the search comes to is a point here.";
  return "Press " + action(ActionId::step_forward).keys + " for the first " + std::string(planner.step.one) +
         "; " + points;
}

void ScatterView::choose(std::string x, std::string y) {
  x_.id = std::move(x);
  y_.id = std::move(y);
  brush_.reset();
}

/// The last value that the planner declares, of a tree the cost, stands in for one that it does not have.
const Measure& ScatterView::measure(const Axis& axis) const {
  const auto with_id = [&](const Measure& each) { return each.id == axis.id; };
  const auto found = std::find_if(measures_.begin(), measures_.end(), with_id);
  if (found != measures_.end()) return *found;
  const auto is_value = [](const Measure& each) { return each.source == Measure::Source::value; };
  const auto value = std::find_if(measures_.rbegin(), measures_.rend(), is_value);
  return value != measures_.rend() ? *value : measures_.front();
}

/// While the playhead moves by itself each picture is brought to its end, so that something is seen; else the latest moment is
/// what counts.
void ScatterView::follow(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const bool plays = frame.session.playback().direction != 0 || run.busy();
  const Deadline deadline = frame.view.live ? Deadline(kScatterMs) : Deadline::never();
  reader_.follow(run.log_view(), run.log_id(), measure(x_), measure(y_), !plays, deadline);
  painter_.follow(
      {reader_.columns(), x_.logarithmic, y_.logarithmic, bins_of(look, plot_.max.x - plot_.min.x),
       bins_of(look, plot_.max.y - plot_.min.y), brush_},
      deadline);
  if (reader_.behind() || painter_.behind()) frame.panels.animated = true;
}

void ScatterView::axis_row(const Look& look, const char* name, const char* id, Axis& axis) {
  std::vector<const char*> names;
  for (const Measure& each : measures_) names.push_back(each.label.c_str());
  const Measure& shown = measure(axis);
  int current = static_cast<int>(&shown - measures_.data());
  ImGui::PushID(id);
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, name);
  ImGui::SameLine(look.px.l + look.px(60));
  const float toggle_room = look.px(74);
  if (combo(look, "##measure", names, current, ImGui::GetContentRegionAvail().x - toggle_room)) {
    axis.id = measures_[static_cast<std::size_t>(current)].id;
    brush_.reset();
  }
  hint(look, {shown.label.c_str(), "", shown.help.c_str()});
  ImGui::SameLine(0, look.px.m);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + look.px.xs);
  toggle(look, "log", axis.logarithmic);
  ImGui::PopID();
}

void ScatterView::choose_axes(Frame& frame) {
  axis_row(frame.look, "Across", "across", x_);
  axis_row(frame.look, "Up", "up", y_);
}

const std::vector<std::size_t>& ScatterView::rows_of(Rows& kept, const PlotPicture& picture, NodeId cell) {
  if (kept.columns == picture.columns && kept.cell == cell) return kept.rows;
  kept = {picture.columns, cell, {}};
  const RunColumns& columns = *picture.columns;
  for (std::size_t row = 0; row < columns.points.size() && kept.rows.size() < kMostRowsMarked; ++row)
    if (columns.cell(row) == cell) kept.rows.push_back(row);
  return kept.rows;
}

/// Rings around the points of the pinned cell and of the one under the mouse.
void ScatterView::draw_marks(Frame& frame, const PlotPicture& picture) {
  const Look& look = frame.look;
  const PlotPlace place{plot_, picture};
  const View& view = frame.view.view;
  const Box& world = frame.run().lattice();
  const auto mark = [&](Rows& kept, const std::optional<Cell>& cell, ImU32 colour, float radius) {
    if (!cell || !world.contains(*cell)) return;
    for (const std::size_t row : rows_of(kept, picture, world.node(*cell)))
      ImGui::GetWindowDrawList()->AddCircle(place.of(row), radius, colour, 0, look.px(1.5f));
  };
  ImGui::PushClipRect(plot_.min, plot_.max, true);
  mark(hovered_rows_, view.hovered, look.theme.dim, look.px(5));
  mark(pinned_rows_, view.pinned, look.theme.text, look.px(6));
  ImGui::PopClipRect();
}

void ScatterView::draw_brush(const Look& look, const PlotPicture& picture) const {
  if (!brush_) return;
  const PlotPlace place{plot_, picture};
  const auto inside = [this](ImVec2 at) {
    return ImVec2(std::clamp(at.x, plot_.min.x, plot_.max.x), std::clamp(at.y, plot_.min.y, plot_.max.y));
  };
  const ImVec2 low = inside(place.at(brush_->x_low, brush_->y_low)),
               high = inside(place.at(brush_->x_high, brush_->y_high));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({low.x, high.y}, {high.x, low.y}, with_alpha(look.theme.mover, 0.18f));
  list.AddRect({low.x, high.y}, {high.x, low.y}, look.theme.mover, 0, 0, look.px(1.5f));
}

/// A drag draws a rectangle; a click pins the point's cell, or, where there is none, takes the rectangle away.
void ScatterView::take_mouse(Frame& frame, const PlotPicture& picture) {
  const PlotPlace place{plot_, picture};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Look& look = frame.look;
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(0)) pressed_ = mouse;
  if (pressed_) {
    const ImVec2 from = *pressed_;
    const bool drags = std::abs(mouse.x - from.x) + std::abs(mouse.y - from.y) > look.px(4);
    if (drags) {
      brush_ = PlotBrush{place.x(std::min(from.x, mouse.x)), place.x(std::max(from.x, mouse.x)),
                         place.y(std::max(from.y, mouse.y)), place.y(std::min(from.y, mouse.y))};
      show_brushed(frame.view.view.overlays);
      frame.panels.animated = true;
    }
    if (ImGui::IsMouseDown(0)) return;
    pressed_.reset();
    if (drags) return;
    if (const auto row = place.near(mouse, look.px(8)))
      show_cell(frame, frame.run().lattice().position(picture.columns->cell(*row)));
    else
      brush_.reset();
    return;
  }
  if (!ImGui::IsItemHovered()) return;
  if (const auto row = place.near(mouse, look.px(8)))
    point_at(frame, frame.run().lattice().position(picture.columns->cell(*row)));
}

/// To the next point by the numbers across, and pins its cell.
void ScatterView::take_keys(Frame& frame, const PlotPicture& picture, int steps) {
  if (steps == 0) return;
  const RunColumns& columns = *picture.columns;
  const auto before = [&](std::size_t a, std::size_t b) {
    return columns.x[a] != columns.x[b] ? columns.x[a] < columns.x[b] : a < b;
  };
  std::optional<std::size_t> from;
  if (const auto& pinned = frame.view.view.pinned; pinned && frame.run().lattice().contains(*pinned)) {
    const auto& rows = rows_of(pinned_rows_, picture, frame.run().lattice().node(*pinned));
    if (!rows.empty()) from = rows.front();
  }
  std::optional<std::size_t> next;
  for (std::size_t row = 0; row < columns.points.size(); ++row) {
    const bool ahead = !from || (steps > 0 ? before(*from, row) : before(row, *from));
    if (ahead && (!next || (steps > 0 ? before(row, *next) : before(*next, row)))) next = row;
  }
  if (next) show_cell(frame, frame.run().lattice().position(columns.cell(*next)));
}

void ScatterView::draw_plot(Frame& frame, const PlotPicture& picture) {
  const Look& look = frame.look;
  const PlotPlace place{plot_, picture};
  ImGui::SetCursorScreenPos(plot_.min);
  ImGui::InvisibleButton("scatter", {plot_.max.x - plot_.min.x, plot_.max.y - plot_.min.y});
  take_mouse(frame, picture);
  tab_stop(look);
  take_keys(frame, picture, arrow_steps(look));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_plot_axes(look, list, place, measure(x_), measure(y_));
  draw_points(look, list, place);
  draw_brush(look, picture);
  draw_marks(frame, picture);
}

/// How many there are of each kind, with their marks, and what is not in the plot.
void ScatterView::tell(const Frame& frame, const PlotPicture& picture) const {
  const Look& look = frame.look;
  const RunColumns& columns = *picture.columns;
  const char* one = frame.run().info().values.grows() ? "vertex" : "cell";
  const char* more = frame.run().info().values.grows() ? "vertices" : "cells";
  const auto number = [&](std::size_t count) {
    return count_text(static_cast<std::int64_t>(count), one, more);
  };
  std::string words = number(columns.points.size()) + " at event " + grouped(columns.position) + ".";
  if (columns.without > 0)
    words +=
        " " + number(columns.without) + (columns.without == 1 ? " lacks" : " lack") + " one of the numbers.";
  if (picture.shown < columns.points.size())
    words += " " + number(columns.points.size() - picture.shown) +
             " at 0 or below, which a logarithmic axis has no place for.";
  if (columns.points.size() > kMarkedPoints)
    words += " Too many for marks: each square has those of its place, the fuller the stronger.";
  if (reader_.behind() && columns.position != frame.run().timeline().cursor())
    words += " The playhead is at another: reading, " +
             grouped(static_cast<std::int64_t>(reader_.progress() * 100)) + "\u00A0%.";
  paragraph(look.fonts.small, look.theme.dim, words);
  std::array<bool, kPointStates> there{};
  for (const PlotBin& bin : picture.bins)
    if (bin.count > 0) there[static_cast<std::size_t>(bin.state)] = true;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float x = origin.x + look.px(4);
  for (std::size_t state = kPointStates; state-- > 0;) {
    if (!there[state]) continue;
    const auto name = point_state_name(static_cast<PointState>(state));
    draw_point(look, list, {x, origin.y + look.fonts.small->FontSize / 2 + look.px(1)},
               static_cast<PointState>(state));
    draw_text(list, look.fonts.small, {x + look.px.s, origin.y}, look.theme.dim, name);
    x += look.px(20) + text_width(look.fonts.small, name);
  }
  ImGui::Dummy({0, look.fonts.small->FontSize + look.px.xs});
}

/// What is in the rectangle, whose ends can be typed; without one, how to draw it.
void ScatterView::tell_brush(Frame& frame, const PlotPicture& picture) {
  const Look& look = frame.look;
  section_rule(look);
  section_title(look, "Rectangle");
  if (const BesideTitle place(look, 1);
      small_button(look, "copy scatter", {.icon = icon::copy, .hint = action(ActionId::copy_scatter).hint()}))
    perform(frame, ActionId::copy_scatter);
  if (!brush_) {
    paragraph(
        look.fonts.ui, look.theme.dim,
        "Drag a rectangle in the plot: the cells of its points light up on the canvas. A click on a point "
        "pins its cell; Left and Right go from point to point while the plot has the keyboard.");
    if (!button(look, "All points", ButtonKind::plain)) return;
    brush_ = PlotBrush{picture.x.low, picture.x.high, picture.y.low, picture.y.high};
    show_brushed(frame.view.view.overlays);
    return;
  }
  const bool current = picture.brush == brush_;
  std::string words =
      current ? count_text(static_cast<std::int64_t>(picture.brushed_points), "point in ", "points in ") +
                    count_text(static_cast<std::int64_t>(picture.brushed->size()), "cell", "cells")
              : "Counting …";
  if (current && picture.brushed_points > 0)
    words += ": " + measure(x_).label + " " + range_text(measure(x_), picture.brushed_x) + ", " +
             measure(y_).label + " " + range_text(measure(y_), picture.brushed_y);
  paragraph(look.fonts.ui, look.theme.text, words + ".");
  const float width = (ImGui::GetContentRegionAvail().x - look.px(60) - look.px.s) / 2;
  const auto ends = [&](const char* name, const char* id, double& low, double& high) {
    ImGui::PushID(id);
    ImGui::AlignTextToFramePadding();
    text(look.fonts.ui, look.theme.dim, name);
    ImGui::SameLine(look.px.l + look.px(60));
    ImGui::SetNextItemWidth(width);
    number_field(look, "##low", ImGuiDataType_Double, &low, "%.2f");
    ImGui::SameLine(0, look.px.s);
    ImGui::SetNextItemWidth(width);
    number_field(look, "##high", ImGuiDataType_Double, &high, "%.2f");
    ImGui::PopID();
  };
  ends("Across", "across ends", brush_->x_low, brush_->x_high);
  ends("Up", "up ends", brush_->y_low, brush_->y_high);
  if (button(look, "No rectangle", ButtonKind::quiet)) brush_.reset();
}

void ScatterView::mark_cells(Frame& frame, const PlotPicture& picture) const {
  if (brush_ && picture.brushed) frame.view.view.brushed = picture.brushed;
}

bool ScatterView::has_points(const Run& run) const {
  const auto& columns = reader_.columns();
  return columns && columns->log_id == run.log_id() && !columns->points.empty();
}

void ScatterView::copy(const Run& run, PanelState& panels) const {
  if (!has_points(run)) return;
  const RunColumns& columns = *reader_.columns();
  ImGui::SetClipboardText(
      columns_csv(run.log_view(), columns, measure(x_), measure(y_), brush_, kMostCopied).c_str());
  const bool all =
      brush_ ? painter_.picture()->brushed_points <= kMostCopied : columns.points.size() <= kMostCopied;
  if (!all)
    panels.said = "Copied the first " + grouped(kMostCopied) + " points as CSV";
  else
    panels.said = brush_ ? "Copied the points in the rectangle as CSV" : "Copied all points as CSV";
  panels.tone = Tone::done;
}

void ScatterView::draw(Frame& frame) {
  const Look& look = frame.look;
  if (planner_ != &frame.run().info()) {
    planner_ = &frame.run().info();
    measures_ = measures_of(*planner_);
    brush_.reset();
  }
  if (frame.run().timeline().cursor() == 0)
    return empty_state(look, icon::bar_chart, "No search yet", no_points_words(*planner_));
  choose_axes(frame);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, head = look.px(20), foot = look.px(20);
  const float height = std::clamp(ImGui::GetContentRegionAvail().y * 0.42f, look.px(150), look.px(300));
  plot_ = {{origin.x + look.px.hair, origin.y + head},
           {origin.x + std::max(width, look.px(60)), origin.y + height}};
  follow(frame);
  const std::shared_ptr<const PlotPicture> picture = painter_.picture();
  const bool mine = picture && picture->columns->log_id == frame.run().log_id();
  if (mine) draw_plot(frame, *picture);
  ImGui::SetCursorScreenPos({origin.x, origin.y + height + foot});
  if (!mine) {
    frame.panels.animated = true;
    return progress(look, static_cast<float>(reader_.progress()), "Reading the run");
  }
  tell(frame, *picture);
  tell_brush(frame, *picture);
  mark_cells(frame, *picture);
}

}  // namespace replan::ui
