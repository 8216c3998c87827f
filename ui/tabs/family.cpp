#include "ui/tabs/family.hpp"

#include <algorithm>

#include "core/debug/shown_family.hpp"
#include "core/session/world_edit.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Of one frame, for reading parents.
constexpr double kFamilyMs = 3;
/// Of the children of one cell so many are listed, and no more rows than that in all.
constexpr std::size_t kMostChildren = 500, kMostFamilyRows = 20'000;
/// The way to the root is indented by so many levels at most, and what is unfolded beside it by so many more: names keep
/// their room.
constexpr std::size_t kWayLevels = 3, kMostLevels = 7;

Cost cost_of_point(const Run& run, NodeId point) {
  const SearchState& state = run.timeline().state();
  return run.info().values.grows() ? vertex_cost(state, point) : state.g(point);
}

std::string point_name(const Run& run, NodeId point) {
  const SearchState& state = run.timeline().state();
  const std::string cell = cell_text(cell_of_point(run.log_view(), state, point), run.lattice().solid());
  return run.info().values.grows() ? grouped(static_cast<std::size_t>(point)) + " " + cell : cell;
}

/// What a point costs more than the one it hangs on.
std::string edge_text(const Run& run, NodeId point) {
  const NodeId parent = parent_of(run.info(), run.timeline().state(), point);
  if (parent == kNoNode) return "";
  const Cost own = cost_of_point(run, point), its = cost_of_point(run, parent);
  if (own.is_infinite() || its.is_infinite()) return "∞";
  return cost_text(Cost{own.raw - its.raw}, 2);
}

}  // namespace

/// The node of the cell; of a tree the vertex that was chosen there, else the nearest one.
NodeId FamilyView::point_of_cell(Frame& frame, Cell cell) {
  const Run& run = frame.run();
  if (!run.info().values.grows()) return run.lattice().node(cell);
  const SearchState& state = run.timeline().state();
  if (chosen_ && chosen_->first == cell && chosen_->second < vertex_count(state)) return chosen_->second;
  return frame.panels.nearest_vertex.follow(run.log_view(), run.log_id(), cell);
}

/// While the playhead moves by itself each tree is brought to its end, so that something is seen; else what was begun for
/// another moment is given up.
void FamilyView::follow(Frame& frame) {
  const Run& run = frame.run();
  const std::size_t cursor = run.timeline().cursor();
  const bool plays = frame.session.playback().direction != 0 || run.busy();
  const bool large = run.lattice().node_count() > kLargeWorld;
  if (log_id_ != run.log_id()) {
    log_id_ = run.log_id();
    tree_.reset();
    reader_.cancel();
    job_.reset();
    below_job_.reset();
    below_.reset();
    below_tree_.reset();
  }
  const bool late = !tree_ || tree_->table().position != cursor;
  const bool under_way = reader_.busy() || (job_ && job_->busy());
  if (late && (!under_way || (!plays && begun_ != cursor))) {
    if (job_) job_->cancel();
    reader_.begin(run.log_view(), run.log_id());
    begun_ = cursor;
  }
  const bool whole = !frame.view.live || !large;
  if (auto table = reader_.read(whole ? Deadline::never() : Deadline(kFamilyMs))) {
    if (!job_) job_ = std::make_unique<Background<Tree>>(frame.session.work().only_if(!whole));
    job_->start_slices([builder = std::make_shared<ParentTreeBuilder>(std::move(table))](
                           const StopToken&) -> std::optional<Tree> {
      if (builder->advance()) return std::nullopt;
      return std::make_shared<const ParentTree>(builder->take());
    });
  }
  if (job_)
    if (auto done = job_->take()) tree_ = std::move(*done);
  if (reader_.busy() || (job_ && job_->busy())) frame.panels.animated = true;
}

/// The cells below the point, off the thread where they may be many.
void FamilyView::follow_below(Frame& frame) {
  const std::size_t nodes = frame.run().lattice().node_count();
  if (tree_ && (below_tree_ != tree_ || below_point_ != point_)) {
    const bool many = frame.view.live && nodes > kLargeWorld;
    if (!below_job_) below_job_ = std::make_unique<Background<Cells>>(frame.session.work().only_if(many));
    if (below_point_ != point_) below_.reset();
    below_tree_ = tree_;
    below_point_ = point_;
    below_job_->start_slices([below = std::make_shared<CellsBelow>(tree_, point_, nodes)](
                                 const StopToken&) -> std::optional<Cells> {
      if (below->advance()) return std::nullopt;
      return std::make_shared<const CellSet>(below->take());
    });
  }
  if (!below_job_) return;
  if (auto done = below_job_->take()) below_ = std::move(*done);
  if (below_job_->busy()) frame.panels.animated = true;
}

void FamilyView::show_on_canvas(Frame& frame) {
  const Run& run = frame.run();
  ShownFamily now{run.log_id(), {}, below_};
  for (const NodeId each : up_.points)
    now.way.push_back(place_of_point(run.log_view(), run.timeline().state(), each));
  const bool same =
      shown_ && shown_->log_id == now.log_id && shown_->below == now.below && shown_->way == now.way;
  if (!same) {
    shown_ = std::make_shared<const ShownFamily>(std::move(now));
    frame.panels.animated = true;
  }
  frame.view.view.family = shown_;
}

/// Those that hang on a point, each with its own below it where they are unfolded.
void FamilyView::list_children(NodeId parent, std::size_t depth, std::size_t level, NodeId without) {
  std::size_t listed = 0;
  const auto children = tree_->children(parent);
  for (const NodeId child : children) {
    if (child == without || std::find(up_.points.begin(), up_.points.end(), child) != up_.points.end())
      continue;
    if (listed++ == kMostChildren || rows_.size() >= kMostFamilyRows) {
      rows_.push_back({FamilyRow::Kind::more, parent, depth, level, children.size() - listed + 1, false});
      return;
    }
    const bool open = unfolded_.contains(child);
    rows_.push_back({FamilyRow::Kind::relative, child, depth, level, tree_->children(child).size(), open});
    if (open) list_children(child, depth + 1, std::min(level + 1, kMostLevels), kNoNode);
  }
}

/// From the root down to the point, then its children. The siblings of each on the way are folded into a line.
void FamilyView::make_rows(const Frame& frame) {
  const Run& run = frame.run();
  const RowsKey key{tree_, point_, run.log_id(), run.timeline().cursor(), unfolding_};
  if (key == rows_key_) return;
  if (key.point != rows_key_.point) reveal_ = true;
  rows_key_ = key;
  rows_.clear();
  using Kind = FamilyRow::Kind;
  const std::vector<NodeId>& up = up_.points;
  for (std::size_t i = up.size(); i-- > 0;) {
    const std::size_t depth = up.size() - 1 - i, level = std::min(depth, kWayLevels);
    const bool known = tree_ && up[i] < tree_->point_count();
    const std::size_t count = known ? tree_->children(up[i]).size() : 0;
    rows_.push_back({i == 0 ? Kind::self : Kind::ancestor, up[i], depth, level, count, true});
    if (!known || rows_.size() >= kMostFamilyRows) continue;
    if (i == 0) {
      list_children(up[i], depth + 1, level + 1, kNoNode);
      continue;
    }
    const bool holds = tree_->parent(up[i - 1]) == up[i];
    const std::size_t siblings = count - (holds ? 1 : 0);
    if (siblings == 0) continue;
    const bool open = unfolded_.contains(up[i]);
    const std::size_t beside = std::min(depth + 1, kWayLevels);
    rows_.push_back({Kind::siblings, up[i], depth + 1, beside, siblings, open});
    if (open) list_children(up[i], depth + 1, beside + 1, up[i - 1]);
  }
}

void FamilyView::go_to(Frame& frame, NodeId point) {
  const Run& run = frame.run();
  const Cell cell = cell_of_point(run.log_view(), run.timeline().state(), point);
  chosen_ = {cell, point};
  show_cell(frame, cell);
}

/// To the parent, the first child, and the siblings.
void FamilyView::draw_steps(Frame& frame) {
  const Look& look = frame.look;
  const NodeId parent = up_.points.size() > 1 ? up_.points[1] : kNoNode;
  const bool known = tree_ && point_ < tree_->point_count();
  const auto siblings =
      known && parent < tree_->point_count() ? tree_->children(parent) : std::span<const NodeId>{};
  const auto own = std::find(siblings.begin(), siblings.end(), point_);
  const auto children = known ? tree_->children(point_) : std::span<const NodeId>{};
  const NodeId first = children.empty() ? kNoNode : children.front(),
               before = own != siblings.end() && own != siblings.begin() ? *std::prev(own) : kNoNode,
               after = own != siblings.end() && std::next(own) != siblings.end() ? *std::next(own) : kNoNode;
  const auto step = [&](const char* id, const char* icon, const char* title, const char* teach, NodeId to) {
    if (small_button(look, id, {.icon = icon, .hint = {title, "", teach}, .enabled = to != kNoNode}))
      go_to(frame, to);
    ImGui::SameLine(0, look.px.xs);
  };
  step("parent", icon::caret_up, "Its parent", "Pins the cell that this one hangs on.", parent);
  step("child", icon::caret_down, "Its first child", "Pins the first of those that hang on it.", first);
  step("sibling before", icon::caret_left, "The sibling before it",
       "Pins the one before it of those that hang on the same parent.", before);
  step("sibling after", icon::caret_right, "The sibling after it",
       "Pins the one after it of those that hang on the same parent.", after);
  ImGui::NewLine();
}

void FamilyView::draw_heading(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const bool grows = run.info().values.grows();
  section_title(look, (grows ? "Vertex " : "Cell ") + point_name(run, point_));
  if (up_.circle) {
    paragraph(look.fonts.ui, look.theme.warning,
              "Its parents lead in a circle of cells and to no root. A planner that is set as printed can "
              "make one.");
  } else if (up_.points.size() == 1) {
    paragraph(look.fonts.ui, look.theme.dim, "It hangs on nothing: it is a root of the search.");
  }
  if (!tree_ || point_ >= tree_->point_count()) {
    paragraph(look.fonts.ui, look.theme.dim, "Counting what hangs on it …");
    return;
  }
  const std::string depth = grouped(up_.points.size() - 1),
                    children = grouped(tree_->children(point_).size()),
                    below = tree_->in_circle(point_) ? "a circle" : grouped(tree_->below(point_));
  const std::vector<KeyValue> values = {{"depth", depth}, {"children", children}, {"below it", below}};
  key_values(look, values, 2);
  if (tree_->table().position != run.timeline().cursor())
    paragraph(look.fonts.small, look.theme.faint,
              "Children and counts are those of event " + grouped(tree_->table().position) + ".");
}

void FamilyView::draw_row(Frame& frame, std::size_t number, std::span<const Column> columns) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const FamilyRow row = rows_[number];
  const bool fold = row.kind == FamilyRow::Kind::siblings, more = row.kind == FamilyRow::Kind::more;
  const bool folds = fold || (row.kind == FamilyRow::Kind::relative && row.count > 0);
  const float indent = look.px(6) * static_cast<float>(row.level), mark = look.px(14);
  std::string name, g, edge, below;
  if (fold) {
    name = count_text(static_cast<std::int64_t>(row.count), "sibling", "siblings");
  } else if (more) {
    name = "and " + grouped(row.count) + " more";
  } else {
    name = point_name(run, row.point);
    g = cost_text(cost_of_point(run, row.point), 2);
    edge = edge_text(run, row.point);
    if (tree_ && row.point < tree_->point_count() && !tree_->in_circle(row.point))
      below = grouped(tree_->below(row.point));
  }
  const ImU32 colour = fold || more                            ? look.theme.faint
                       : row.kind == FamilyRow::Kind::relative ? look.theme.dim
                                                               : look.theme.text;
  const std::string depth = grouped(row.depth);
  const std::vector<TableCell> cells = {
      {depth, look.theme.faint}, {"", 0}, {g, colour}, {edge, look.theme.dim}, {below, look.theme.dim}};
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const bool clicked =
      table_row(look, static_cast<int>(number), columns, cells, row.kind == FamilyRow::Kind::self);
  const bool hovered = ImGui::IsItemHovered();
  tab_stop(look);
  const int turn = folds ? arrow_steps(look) : 0;
  const float left = origin.x + columns[0].weight + indent;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (folds)
    draw_icon(list, look.fonts.ui, {left + look.px(5), origin.y + look.px.row / 2}, look.theme.dim,
              row.open ? icon::caret_down : icon::caret_right);
  draw_text(list, look.fonts.mono, {left + mark, origin.y + (look.px.row - look.fonts.mono->FontSize) / 2},
            colour, elide(look.fonts.mono, name, columns[1].weight - indent - mark));
  const bool on_mark = folds && hovered && ImGui::GetIO().MousePos.x < left + mark;
  if (!fold && !more) point_at(frame, cell_of_point(run.log_view(), run.timeline().state(), row.point));
  const bool folding = turn != 0 ? (turn > 0) != row.open : clicked && (fold || on_mark);
  if (clicked && !folding && !more) return go_to(frame, row.point);
  if (!folding) return;
  if (!unfolded_.erase(row.point)) unfolded_.insert(row.point);
  ++unfolding_;
}

void FamilyView::draw_rows(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const float whole = ImGui::GetContentRegionAvail().x;
  const auto chars = [&](std::size_t count) {
    return text_width(look.fonts.mono, "0") * static_cast<float>(count) + look.px(10);
  };
  const std::size_t most = tree_ ? tree_->members() : 0;
  const float depth = chars(std::max<std::size_t>(grouped(up_.points.size()).size(), 3)), g = chars(7),
              edge = chars(6), below = chars(std::max<std::size_t>(grouped(most).size(), 6));
  const std::string g_label(run.info().values.grows() ? "cost" : run.info().values.field(EventKind::g).label);
  const std::array<Column, 5> columns = {
      {{"", depth},
       {run.info().values.grows() ? "vertex" : "cell",
        std::max(whole - depth - g - edge - below, look.px(60)), Align::left},
       {g_label.c_str(), g},
       {"edge", edge},
       {"below", below}}};
  table_header(look, columns);
  hint(look, {"The tree of parents", "",
              "From the root down to the cell, then what hangs on it. edge: what it costs more than its "
              "parent. below: how "
              "many hang on it, and on those. A click on a row pins its cell; one on a mark, or Right with "
              "the keyboard on it, unfolds it."});
  if (reveal_) {
    const auto own = std::find_if(rows_.begin(), rows_.end(),
                                  [](const FamilyRow& row) { return row.kind == FamilyRow::Kind::self; });
    const auto number = static_cast<std::size_t>(own - rows_.begin());
    // With the first of its children.
    reveal_row(look, std::min(number + 3, rows_.size() - 1), rows_.size(), 0, scroll_);
    reveal_row(look, number, rows_.size(), 0, scroll_);
    reveal_ = false;
  }
  const RowsInSight sight = begin_rows(look, "family", rows_.size(), 0, scroll_);
  for (std::size_t row = sight.first; row < std::min(sight.last, rows_.size()); ++row)
    draw_row(frame, row, columns);
  end_rows();
}

void FamilyView::draw(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  if (!keeps_parents(run.info()))
    return empty_state(
        look, icon::sitemap, "No parents",
        "This planner keeps no parents: its paths are whole from the beginning. Choose another one to "
        "see what hangs on what.");
  const auto cell = frame.cell();
  if (!cell)
    return empty_state(
        look, icon::sitemap, "Point at a cell",
        "Its parents up to the root of the search show here, and the cells that hang on it. A click "
        "with Select pins it.");
  point_ = point_of_cell(frame, *cell);
  follow(frame);
  up_ = point_ == kNoNode ? Ancestry{} : ancestry(run.info(), run.timeline().state(), point_);
  const bool alone =
      up_.points.size() < 2 && tree_ && point_ < tree_->point_count() && tree_->children(point_).empty();
  if (point_ == kNoNode || alone) {
    const std::string at = cell_text(*cell, run.lattice().solid());
    return empty_state(look, icon::sitemap, "Not in the tree",
                       "At this moment the search has not come to cell " + at +
                           ": it has no parent, and nothing hangs on it. Play, or choose another cell.");
  }
  follow_below(frame);
  show_on_canvas(frame);
  draw_heading(frame);
  draw_steps(frame);
  make_rows(frame);
  draw_rows(frame);
}

}  // namespace replan::ui
