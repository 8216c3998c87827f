// The Cell tab: everything that the planner holds of one cell, and why its rhs (A*: its g) is what it is.
#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "core/trace/search_state.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// One neighbour's offer: c + g + dist = sum.
struct Offer {
  NodeId node;
  Cost step, g, dist, sum;
};

/// What a cell's values mean depends on the planner: D* Lite looks ahead by rhs, A* knows g alone.
struct CellView {
  const Run& run;
  const SearchState& state;
  Cell cell;
  NodeId node;
  bool lookahead;  // the planner keeps rhs

  CellView(const Run& of, Cell at)
      : run(of),
        state(of.timeline().state()),
        cell(at),
        node(of.lattice().node(at)),
        lookahead(of.info().incremental) {}
};

/// Moves from the cell on the robot's map at the cursor: of a window of 3 x 3 cells under the same rules.
std::vector<Offer> offers(const CellView& view) {
  const Grid2& lattice = view.run.lattice();
  const int left = std::max(view.cell.x - 1, 0), top = std::max(view.cell.y - 1, 0);
  const int right = std::min(view.cell.x + 1, lattice.width() - 1),
            bottom = std::min(view.cell.y + 1, lattice.height() - 1);
  std::vector<std::uint8_t> blocked;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      blocked.push_back(view.state.known_blocked(lattice.node(Cell{x, y})) ? 1 : 0);
  const Grid2 window({right - left + 1, bottom - top + 1}, std::move(blocked), lattice.rules());
  const NodeId middle = window.node(Cell{view.cell.x - left, view.cell.y - top});
  std::vector<Offer> all;
  for (auto rest = static_cast<std::uint32_t>(window.moves(middle)); rest != 0; rest &= rest - 1) {
    const int d = std::countr_zero(rest);
    const Cell at = window.position(window.neighbour(middle, d));
    const NodeId node = lattice.node(Cell{at.x + left, at.y + top});
    const Cost g = view.state.g(node), dist = view.state.dist(node), step = Grid2::step_cost(d);
    all.push_back({node, step, g, dist, step + g + dist});
  }
  std::stable_sort(all.begin(), all.end(), [](const Offer& a, const Offer& b) { return a.sum < b.sum; });
  return all;
}

std::pair<const char*, ImU32> consistency(const Theme& theme, const CellView& view) {
  const Cost g = view.state.g(view.node), rhs = view.state.rhs(view.node);
  if (view.state.known_blocked(view.node)) return {"obstacle", theme.dim};
  if (!view.lookahead)
    return g.is_infinite()                ? std::pair{"not seen", theme.dim}
           : view.state.queued(view.node) ? std::pair{"open", theme.accent}
                                          : std::pair{"settled", theme.text};
  if (g.is_infinite() && rhs.is_infinite())
    return {view.state.order(view.node) == 0 ? "not seen" : "no value", theme.dim};
  if (g == rhs) return {"consistent", theme.text};
  return g > rhs ? std::pair{"over", theme.accent} : std::pair{"under", theme.warning};
}

/// Its place in the open list, counted; empty where that would take long.
std::string rank_text(const CellView& view) {
  constexpr std::size_t kMostNodes = std::size_t{1} << 20;
  if (!view.state.queued(view.node)) return "no";
  if (!view.lookahead || view.state.node_count() > kMostNodes) return "yes";
  const auto key = [&](NodeId n) { return std::tuple(view.state.k1(n), view.state.k2(n), n); };
  const auto mine = key(view.node);
  std::size_t rank = 1;
  for (NodeId n = 0; n < view.state.node_count(); ++n) {
    if (n % PagedArray<std::uint64_t>::kPage == 0 && !view.state.touched(EventKind::queue, n)) {
      n += static_cast<NodeId>(PagedArray<std::uint64_t>::kPage) - 1;
      continue;
    }
    if (view.state.queued(n) && key(n) < mine) ++rank;
  }
  return "yes, #" + std::to_string(rank);
}

void values(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  const SearchState& state = view.state;
  const PlannerInfo& info = view.run.info();
  const auto [state_word, state_colour] = consistency(look.theme, view);
  const bool marked = state_colour != look.theme.text && state_colour != look.theme.dim;
  const std::string g = cost_text(state.g(view.node)), rhs = cost_text(state.rhs(view.node)),
                    dist = cost_text(state.dist(view.node));
  const std::string lp = node_text(view.run, state.lp(view.node)),
                    rp = node_text(view.run, state.rp(view.node));
  const std::string queue = rank_text(view), order = grouped(std::int64_t{state.order(view.node)});
  const std::string times = std::to_string(state.times_expanded(view.node)) + "×";
  std::string key = "—";
  if (state.queued(view.node))
    key =
        cost_text(state.k1(view.node), 1) + (view.lookahead ? " ; " + cost_text(state.k2(view.node), 1) : "");
  std::vector<KeyValue> pairs = {{"g", g}};
  if (view.lookahead) pairs.push_back({"rhs", rhs});
  if (info.clearance) pairs.push_back({"dist", dist});
  pairs.push_back({"state", state_word, state_colour, marked});
  pairs.push_back({view.lookahead ? "key" : "f", key});
  pairs.push_back({"in U", queue});
  pairs.push_back({view.lookahead ? "lp" : "parent", lp});
  if (info.sight) pairs.push_back({"rp", rp});
  if (state.order(view.node) != 0) {
    pairs.push_back({"expanded", times});
    pairs.push_back({"as number", order});
  }
  key_values(look, pairs);
}

/// Why there is nothing to add up; empty if there is.
const char* special_case(const CellView& view, const std::vector<Offer>& all) {
  if (view.node == view.state.node(view.lookahead ? Scalar::goal : Scalar::start))
    return view.lookahead ? "This is the goal: its rhs is 0, by definition."
                          : "This is the start: its g is 0.";
  if (view.state.known_blocked(view.node))
    return "The robot takes this cell for an obstacle: no move leads in or out.";
  if (all.empty()) return "Obstacles stand all around: no move leads from here.";
  if (all.front().sum.is_infinite()) return "No neighbour has a value now: no way leads on from here yet.";
  return "";
}

/// Each neighbour's sum, the least first; a click goes on to the neighbour.
void offer_table(Frame& frame, const CellView& view, const std::vector<Offer>& all) {
  const Look& look = frame.look;
  const bool with_dist = view.run.info().clearance;
  std::vector<Column> columns = {{"neighbour", 1.6f, Align::left}, {"c", 1}, {"g", 1.2f}};
  if (with_dist) columns.push_back({"dist"});
  columns.push_back({"sum", 1.2f});
  table_header(look, columns);
  std::size_t shown = 0;
  for (; shown < all.size() && !all[shown].sum.is_infinite(); ++shown) {
    const Offer& offer = all[shown];
    const bool winner = offer.node == view.state.lp(view.node);
    const std::string at = node_text(view.run, offer.node), c = cost_text(offer.step), g = cost_text(offer.g),
                      dist = cost_text(offer.dist), sum = cost_text(offer.sum);
    std::vector<TableCell> cells = {{at}, {c}, {g}};
    if (with_dist) cells.push_back({dist});
    cells.push_back({sum, 0, winner});
    if (table_row(look, static_cast<int>(shown), columns, cells, winner))
      frame.view.view.pinned = view.run.lattice().position(offer.node);
  }
  if (shown == all.size()) return;
  std::vector<TableCell> cells(columns.size());
  const std::string more = std::to_string(all.size() - shown) + " more";
  cells.front() = {more, look.theme.faint};
  cells.back() = {"∞", look.theme.faint};
  table_row(look, -1, columns, cells);
}

/// The table and, where it does not add up yet, the reason.
void explain(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  const Cost value = view.lookahead ? view.state.rhs(view.node) : view.state.g(view.node);
  const char* name = view.lookahead ? "rhs" : "g";
  section_title(look, std::string("Why is ") + name + " " + cost_text(value) + "?");
  const std::vector<Offer> all = offers(view);
  if (const std::string_view special = special_case(view, all); !special.empty()) {
    paragraph(look.fonts.ui, look.theme.dim, special);
    return;
  }
  offer_table(frame, view, all);
  if (all.front().sum == value) return;
  ImGui::Dummy({0, look.px.xs});
  paragraph(look.fonts.ui, look.theme.warning,
            view.lookahead ? "The least sum is " + cost_text(all.front().sum) +
                                 ": UpdateVertex has yet to come to this cell."
                           : "A neighbour offers less: it has not been expanded yet.");
}

/// The lines about the current one, as in the Code tab.
void code_excerpt(Frame& frame) {
  const Result<PlannerPage>& page = page_of(frame.panels, frame.run().choice().id);
  if (!page) return;
  const PseudoBlock* block = page->block_of(current_line(frame.run()));
  if (block == nullptr) return;
  section_rule(frame.look);
  section_title(frame.look, block->title);
  draw_pseudo_code(frame, *block, 4);
}

}  // namespace

void draw_cell_panel(Frame& frame) {
  const Look& look = frame.look;
  const std::optional<Cell> cell = frame.cell();
  if (!cell) {
    empty_state(look, icon::crosshairs, "Point at a cell",
                "Its values show here. Click a cell with Select to pin it, then step and watch them change.");
    return;
  }
  const CellView view(frame.run(), *cell);
  section_title(look,
                "Cell " + cell_text(*cell) + (frame.view.view.pinned ? " — pinned" : " — under the cursor"));
  values(frame, view);
  section_rule(look);
  explain(frame, view);
  code_excerpt(frame);
}

}  // namespace replan::ui
