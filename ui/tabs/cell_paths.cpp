// Part of the Cell tab, for planners that breed paths: the child in hand and why it is as it is, and the paths over the cell.
#include <algorithm>
#include <vector>

#include "core/debug/child_words.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

/// So many rows are listed.
constexpr std::size_t kMostRows = 12;

void rows_left_out(const Look& look, std::size_t count) {
  if (count <= kMostRows) return;
  text(look.fonts.ui, look.theme.faint,
       "and " + grouped(static_cast<std::int64_t>(count - kMostRows)) + " more");
}

/// What the child would cost with each neighbour, the fittest first.
void tried_table(const Look& look, const CellView& view, const ChildInHand& hand, LengthUnit lengths) {
  std::vector<ChildInHand::Tried> all = hand.tried;
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.unfitness < b.unfitness; });
  const std::vector<Column> columns = {{"neighbour", 10, Align::left}, {"whole path", 10}, {"hits", 6}};
  table_head(look, columns);
  for (std::size_t i = 0; i < std::min(all.size(), kMostRows); ++i) {
    const bool taken = all[i].cell == hand.changed_to, hits = all[i].unfitness.hits;
    const std::string cell = node_text(view.run.lattice(), all[i].cell),
                      cost = lengths.text(all[i].unfitness.cost);
    const std::vector<TableCell> cells = {
        {cell}, {cost, 0, taken}, {hits ? "yes" : "no", hits ? look.theme.bad : 0}};
    table_row(look, static_cast<int>(i), columns, cells, taken);
  }
  rows_left_out(look, all.size());
}

void child_section(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  section_title(look, "The child in hand");
  const auto hand = child_in_hand(view.run.log_view());
  if (!hand) {
    paragraph(look.fonts.ui, look.theme.dim, "No child is being bred at this moment: step on, or play.");
    return;
  }
  const LengthUnit lengths = shown_lengths(frame.view, view.run.scenario().map);
  for (const std::string& words : child_words(view.run.log_view(), *hand, lengths))
    paragraph(look.fonts.ui, look.theme.text, words);
  if (!hand->tried.empty()) tried_table(look, view, *hand, lengths);
}

bool leads_over(const BredPath& path, NodeId cell) {
  return std::any_of(path.begin(), path.end(), [cell](const PathPlace& place) { return place.cell == cell; });
}

/// A member that has the cell, and its place by fitness.
struct PathOver {
  std::uint32_t number;
  std::size_t rank;
};

/// The members that have the cell, the fittest first.
std::vector<PathOver> paths_over(const SearchState& state, NodeId cell) {
  std::vector<PathOver> paths;
  const std::vector<std::uint32_t> ranks = paths_by_fitness(state, path_named(state, Scalar::child));
  for (std::size_t i = 0; i < ranks.size(); ++i)
    if (leads_over(bred_path(state, ranks[i]), cell)) paths.push_back({ranks[i], i + 1});
  return paths;
}

void path_row(const Look& look, const CellView& view, std::span<const Column> columns, PathOver over,
              LengthUnit lengths) {
  const BredPath path = bred_path(view.state, over.number);
  const bool leads = over.number == path_named(view.state, Scalar::leader);
  const auto hits =
      std::count_if(path.begin(), path.end(), [](const PathPlace& place) { return place.hit != kNoNode; });
  const std::string name = "#" + std::to_string(over.rank) + (leads ? ", the fittest" : ""),
                    cells = std::to_string(path.size()),
                    cost = lengths.text(path_cost(view.state, over.number)), hit = std::to_string(hits);
  const std::vector<TableCell> row = {{name}, {cells}, {cost}, {hit, hits > 0 ? look.theme.bad : 0}};
  table_row(look, static_cast<int>(1000 + over.number), columns, row, leads);
}

void paths_section(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  section_rule(look);
  section_title(look, "Paths that turn at this cell");
  const std::vector<PathOver> paths = paths_over(view.state, view.node);
  if (paths.empty()) {
    paragraph(look.fonts.ui, look.theme.dim, "No path of the population has it.");
    return;
  }
  paragraph(look.fonts.ui, look.theme.dim,
            "Paths are numbered by their fitness at this moment: #1 is the fittest.");
  const std::vector<Column> columns = {{"path", 10, Align::left}, {"cells", 6}, {"cost", 10}, {"hits", 6}};
  table_head(look, columns);
  const LengthUnit lengths = shown_lengths(frame.view, view.run.scenario().map);
  for (std::size_t i = 0; i < std::min(paths.size(), kMostRows); ++i)
    path_row(look, view, columns, paths[i], lengths);
  rows_left_out(look, paths.size());
}

/// How the fittest path came to be, if a child became it.
void leader_section(Frame& frame, const CellView& view, PathBirth& leader_birth) {
  const Look& look = frame.look;
  const std::uint32_t leader = path_named(view.state, Scalar::leader);
  if (leader == kNoNode) return;
  section_rule(look);
  section_title(look, "Where the fittest path comes from");
  const auto& birth = leader_birth.follow(view.run.log_view(), view.run.log_id(), leader);
  if (!birth) {
    paragraph(look.fonts.ui, look.theme.dim,
              "It is one of the first paths, or a replan has joined it to where the robot is.");
    return;
  }
  const LengthUnit lengths = shown_lengths(frame.view, view.run.scenario().map);
  for (const std::string& words : child_words(view.run.log_view(), *birth, lengths))
    paragraph(look.fonts.ui, look.theme.dim, words);
}

}  // namespace

void draw_child_why(Frame& frame, const CellView& view) {
  child_section(frame, view);
}

void draw_paths(Frame& frame, const CellView& view, PathBirth& leader_birth) {
  child_section(frame, view);
  paths_section(frame, view);
  leader_section(frame, view, leader_birth);
}

}  // namespace replan::ui
