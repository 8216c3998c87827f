// Part of the Cell tab: why the cell's rhs (A*: its g) is what it is.
#include <algorithm>
#include <vector>

#include "core/debug/offers.hpp"
#include "core/debug/wave.hpp"
#include "core/plan/common_parameters.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

/// Where the values are those of corners, which neighbours have no part in.
std::string words_of_corners(const CellView& view) {
  const NodeId parent = view.state.lp(view.node);
  if (parent == kNoNode)
    return "Only both ends, and cells at a corner of an obstacle that was seen, have a value here.";
  return "Neighbours have no part in it: its nearest point is reached straight from that of " +
         node_text(view.run, parent) + ", its parent.";
}

/// Why there is nothing to add up; empty if there is.
std::string special_case(const CellView& view, const std::vector<Offer>& all) {
  if (view.run.timeline().cursor() == 0) return "The search has not begun: no cell has a value yet.";
  const PlannerInfo& planner = view.run.info();
  if (view.node == view.state.node(planner.root()))
    return planner.values.waves ? "This is the goal: its h is 0."
           : !view.lookahead    ? "This is the start: its g is 0."
           : planner.from_goal  ? "This is the goal: its rhs is 0, by definition."
                                : "This is the start: its rhs is 0, by definition.";
  if (view.state.known_blocked(view.node))
    return "On the robot's map this cell is an obstacle, so no move leads in or out.";
  if (too_near(view.run.log_view(), view.state, view.node))
    return "This cell is nearer to an obstacle than the robot's radius: its centre keeps out.";
  if (!view.run.info().point_only.empty()) return words_of_corners(view);
  if (all.empty()) return "There are obstacles all around: no move leads from here.";
  if (all.front().sum.is_infinite())
    return "No neighbour has a value, so no way through any of them is known.";
  return "";
}

/// "(3, 4)", or both ends of the side that a way leads to: "(3, 4)-(4, 4)".
std::string end_text(const CellView& view, const Offer& offer) {
  const std::string at = node_text(view.run, offer.node);
  return offer.side == kNoNode ? at : at + "-" + node_text(view.run, offer.side);
}

/// Whether the cell's way on is that one.
bool is_taken(const CellView& view, const Offer& offer) {
  const bool interpolated = view.run.info().values.interpolated;
  const NodeId side =
      interpolated ? static_cast<NodeId>(view.state.value(fields::kSide.kind, view.node)) - 1u : kNoNode;
  return offer.node == view.state.lp(view.node) && offer.side == side;
}

/// What its costs are called: "g".
const char* cost_name(const CellView& view) {
  return view.run.info().values.field(EventKind::g).label.data();
}

/// Each as wide as the widest that stands in it.
std::vector<Column> offer_columns(const CellView& view, const std::vector<Offer>& all) {
  std::size_t at = 9, c = 3, g = 3, dist = 4, sum = 3;
  for (const Offer& offer : all) {
    if (offer.sum.is_infinite()) break;
    at = std::max(at, end_text(view, offer).size());
    c = std::max(c, cost_text(offer.step).size());
    g = std::max(g, cost_text(offer.g).size());
    dist = std::max(dist, cost_text(offer.dist).size());
    sum = std::max(sum, cost_text(offer.sum).size());
  }
  const auto wide = [](std::size_t letters) { return static_cast<float>(letters + 1); };
  std::vector<Column> columns = {
      {"neighbour", wide(at), Align::left}, {"c", wide(c)}, {cost_name(view), wide(g)}};
  if (view.run.info().clearance) columns.push_back({"dist", wide(dist)});
  columns.push_back({"sum", wide(sum)});
  return columns;
}

/// Each neighbour's sum, the least first; a click goes on to the neighbour.
void offer_table(Frame& frame, const CellView& view, const std::vector<Offer>& all) {
  const Look& look = frame.look;
  const bool with_dist = view.run.info().clearance != nullptr;
  const std::vector<Column> columns = offer_columns(view, all);
  table_head(look, columns);
  std::size_t shown = 0;
  for (; shown < all.size() && !all[shown].sum.is_infinite(); ++shown) {
    const Offer& offer = all[shown];
    const bool winner = is_taken(view, offer);
    const std::string at = end_text(view, offer), c = cost_text(offer.step), g = cost_text(offer.g),
                      dist = cost_text(offer.dist), sum = cost_text(offer.sum);
    std::vector<TableCell> cells = {{at}, {c}, {g}};
    if (with_dist) cells.push_back({dist});
    cells.push_back({sum, 0, winner});
    if (table_row(look, static_cast<int>(shown), columns, cells, winner))
      show_cell(frame, view.run.lattice().position(offer.node));
  }
  if (shown == all.size()) return;
  std::vector<TableCell> cells(columns.size());
  const std::string more = std::to_string(all.size() - shown) + " more";
  cells.front() = {more, look.theme.faint};
  cells.back() = {"∞", look.theme.faint};
  table_row(look, -1, columns, cells);
}

/// What is known of the way straight to the remote parent; nothing for planners without sight.
const char* remote_words(const CellView& view) {
  if (!view.run.info().sight) return "";
  const NodeId local = view.state.lp(view.node), remote = view.state.rp(view.node);
  if (parameters::checks_along_path(view.run.settings()))
    return remote == kNoNode
               ? "Sight is checked along the path alone, and no leap from this cell is kept: it "
                 "has no rp."
               : "Its rp was seen along a path. It is kept until a cell of the box between the two changes.";
  if (remote == kNoNode || remote == view.node) return "";
  if (remote == local) return "Its rp is its lp, which needs no sight check.";
  return view.state.queued(view.node) ? "Sight to its rp is assumed. It is checked when the cell is taken."
                                      : "Sight to its rp was checked when the cell was taken.";
}

/// Who wrote the value last; a click goes there.
void written_line(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  const Timeline& log = view.run.timeline();
  const EventKind kind = view.lookahead ? EventKind::rhs : EventKind::g;
  const auto written = log.last_event(view.node, {kind}, log.cursor());
  if (!written) return;
  ImGui::Dummy({0, look.px.xs});
  text(look.fonts.ui, look.theme.dim, "Written by event");
  ImGui::SameLine(0, look.px.xs);
  if (link(look, "writer", grouped(*written + 1), look.fonts.mono))
    frame.commands.push_back(Seek{*written + 1});
  hint(look, {"", "", "Click to go to where it was written."});
  paragraph(look.fonts.ui, look.theme.dim, as_sentence(origin_text(frame, *written)) + ".");
}

/// What the cell waits for, in a search whose costs rise and fall in waves.
void wave_words(const Look& look, const CellView& view, Cost least) {
  const Wave wave = wave_of(view.state, view.node);
  const Cost h = view.state.g(view.node);
  ImGui::Dummy({0, look.px.xs});
  if (wave == Wave::raise)
    paragraph(
        look.fonts.ui, look.theme.warning,
        "RAISE: its way became dearer. When it is taken it looks for a better one, then tells all cells "
        "whose back-pointers lead to it.");
  if (wave == Wave::lower)
    paragraph(look.fonts.ui, look.theme.accent,
              "LOWER: when it is taken it offers its cost to its neighbours.");
  if (least < h)
    paragraph(look.fonts.ui, look.theme.dim,
              "A neighbour offers less, " + cost_text(least) + ": the search has not come to that one yet.");
  else if (least > h)
    paragraph(look.fonts.ui, look.theme.dim,
              "No neighbour offers so little any more: the wave that raises this cell is yet to come.");
}

}  // namespace

void draw_why(Frame& frame, const CellView& view) {
  if (view.run.info().sampling) return draw_vertex_why(frame, view);
  if (view.run.info().evolving) return draw_child_why(frame, view);
  const Look& look = frame.look;
  const Cost value = view.lookahead ? view.state.rhs(view.node) : view.state.g(view.node);
  const char* name = view.lookahead ? "rhs" : cost_name(view);
  section_title(look, std::string("Why is ") + name + " " + cost_text(value) + "?");
  const std::vector<Offer> all = offers_to(view.run.log_view(), view.state, view.node);
  if (const std::string special = special_case(view, all); !special.empty()) {
    paragraph(look.fonts.ui, look.theme.dim, special);
    return written_line(frame, view);
  }
  offer_table(frame, view, all);
  written_line(frame, view);
  if (const std::string_view words = remote_words(view); !words.empty())
    paragraph(look.fonts.ui, look.theme.dim, words);
  if (view.run.info().values.waves) return wave_words(look, view, all.front().sum);
  if (all.front().sum == value) return;
  ImGui::Dummy({0, look.px.xs});
  paragraph(look.fonts.ui, look.theme.warning,
            view.lookahead ? "The least sum is " + cost_text(all.front().sum) +
                                 ": the search has not updated this cell yet."
                           : "A neighbour offers less: it has not been expanded yet.");
}

}  // namespace replan::ui
