// Part of the Cell tab, for planners that grow a tree of samples: the vertex nearest to the cell, and why it hangs where it
// does.
#include <algorithm>
#include <limits>
#include <vector>

#include "core/debug/sample_in_hand.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

/// So many candidates are listed.
constexpr std::size_t kMostListed = 12;

/// What the state tells of a vertex.
struct VertexView {
  const CellView& cell;
  std::uint32_t number;

  [[nodiscard]] Place place() const { return place_of(number); }
  [[nodiscard]] Place place_of(std::uint32_t v) const {
    return vertex_place(cell.state, v, cell.run.lattice().solid());
  }
  [[nodiscard]] Cost cost() const { return vertex_cost(cell.state, number); }
  [[nodiscard]] std::uint32_t parent() const { return vertex_parent(cell.state, number); }
};

/// The vertex nearest to the middle of the cell; kNoNode if the tree has none.
std::uint32_t nearest_vertex(const CellView& view) {
  const Place middle = place_in(view.cell);
  const bool solid = view.run.lattice().solid();
  std::uint32_t nearest = kNoNode;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (std::uint32_t v = 0; v < vertex_count(view.state); ++v) {
    if (vertex_cost(view.state, v).is_infinite()) continue;
    const std::int64_t squared = squared_between(vertex_place(view.state, v, solid), middle);
    if (squared >= least) continue;
    least = squared;
    nearest = v;
  }
  return nearest;
}

std::string place_text(const VertexView& vertex) {
  const Point at = point_of(vertex.place());
  std::string words = "(" + decimal_text(at.x, 2) + ", " + decimal_text(at.y, 2);
  if (vertex.cell.run.lattice().solid()) words += ", " + decimal_text(at.z, 2);
  return words + ")";
}

void vertex_values(const Look& look, const VertexView& vertex) {
  const std::uint32_t parent = vertex.parent();
  const std::string number = grouped(std::int64_t{vertex.number}), at = place_text(vertex),
                    cost = cost_text(vertex.cost()),
                    hangs = parent == kNoNode ? "nothing: a root" : grouped(std::int64_t{parent}),
                    edge = parent == kNoNode
                               ? ""
                               : cost_text(length_between(vertex.place(), vertex.place_of(parent)));
  std::vector<KeyValue> pairs = {{"vertex", number}, {"at", at}, {"cost", cost}, {"hangs on", hangs}};
  if (parent != kNoNode) pairs.push_back({"edge", edge});
  key_values(look, pairs, 1);
}

/// The candidates of its birth, the least sum first.
void candidate_table(const Look& look, const SampleInHand& birth, const VertexView& vertex) {
  std::vector<SampleInHand::Candidate> all = birth.candidates;
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  const std::vector<Column> columns = {
      {"candidate", 10, Align::left}, {"way to it", 10}, {"edge", 7}, {"sum", 8}};
  table_head(look, columns);
  for (std::size_t i = 0; i < std::min(all.size(), kMostListed); ++i) {
    const bool blocked = all[i].cost.is_infinite();
    const Cost length =
        birth.place ? length_between(*birth.place, vertex.place_of(all[i].vertex)) : Cost::zero();
    const std::string number = grouped(std::int64_t{all[i].vertex}), edge = cost_text(length),
                      sum = blocked ? "blocked" : cost_text(all[i].cost),
                      way = blocked ? "" : cost_text({all[i].cost.raw - length.raw});
    const std::vector<TableCell> cells = {
        {number}, {way}, {edge}, {sum, blocked ? look.theme.bad : 0, i == 0}};
    table_row(look, static_cast<int>(i), columns, cells, i == 0);
  }
  if (all.size() > kMostListed)
    text(look.fonts.ui, look.theme.faint,
         "and " + grouped(static_cast<std::int64_t>(all.size() - kMostListed)) + " more");
}

/// A link to an event, behind some words.
void event_line(Frame& frame, const char* id, const std::string& words, std::size_t event) {
  const Look& look = frame.look;
  text(look.fonts.ui, look.theme.dim, words);
  ImGui::SameLine(0, look.px.xs);
  if (link(look, id, grouped(event + 1), look.fonts.mono)) frame.commands.push_back(Seek{event + 1});
  hint(look, {"", "", "Click to go there."});
}

/// The last rewiring of the vertex itself, and what it saved.
void rewired_line(Frame& frame, const VertexView& vertex) {
  const Look& look = frame.look;
  const Timeline& log = vertex.cell.run.timeline();
  const auto event = log.last_event(vertex.number, {EventKind::rewired}, log.cursor());
  if (!event) {
    paragraph(look.fonts.ui, look.theme.dim,
              "It has not been rewired: it hangs where it was hung when it came.");
    return;
  }
  const Cost saved{static_cast<std::int64_t>(log.event(*event).delta)};
  paragraph(look.fonts.ui, look.theme.good,
            "A later sample was hung nearer to it: rewiring it saved " + cost_text(saved) + " of its way.");
  event_line(frame, "rewired", "Rewired by event", *event);
}

void why_it_hangs(Frame& frame, const VertexView& vertex) {
  const Look& look = frame.look;
  section_rule(look);
  if (vertex.parent() == kNoNode) {
    section_title(look, "Why does it hang on nothing?");
    paragraph(look.fonts.ui, look.theme.dim, "It is the root: a tree grows from it.");
    return;
  }
  section_title(look, "Why does it hang on " + grouped(std::int64_t{vertex.parent()}) + "?");
  const auto birth = birth_of(vertex.cell.run.log_view(), vertex.number);
  if (birth && !birth->candidates.empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              "When it came, the way over the first of these was the shortest that is free:");
    candidate_table(look, *birth, vertex);
  } else {
    paragraph(look.fonts.ui, look.theme.dim, "It was the vertex nearest to the sample that it came from.");
  }
  rewired_line(frame, vertex);
}

/// What the sample at the cursor has come to.
void sample_words(Frame& frame, const SampleInHand& hand) {
  const Look& look = frame.look;
  section_rule(look);
  section_title(look, "The sample in hand");
  if (hand.rejected) {
    const Event event{.delta = static_cast<std::uint64_t>(*hand.rejected),
                      .node = hand.rejected_at,
                      .kind = EventKind::rejected};
    paragraph(look.fonts.ui, look.theme.bad,
              as_sentence(event_text(frame.run().lattice(), frame.run().info().values, event, 0)) + ".");
    return;
  }
  if (hand.added)
    paragraph(look.fonts.ui, look.theme.text,
              "It has become vertex " + grouped(std::int64_t{*hand.added}) + ", and " +
                  count_text(static_cast<std::int64_t>(hand.rewired.size()), "vertex was", "vertices were") +
                  " hung on it.");
  else
    paragraph(look.fonts.ui, look.theme.dim, "It is being dealt with: step on to see what it comes to.");
}

}  // namespace

void draw_vertex(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  const std::uint32_t number = nearest_vertex(view);
  if (number == kNoNode) {
    paragraph(look.fonts.ui, look.theme.dim, "The tree has no vertex yet: step on, or play.");
    return;
  }
  section_title(look, "The vertex nearest to it");
  const VertexView vertex{view, number};
  vertex_values(look, vertex);
  why_it_hangs(frame, vertex);
  if (const auto hand = sample_in_hand(view.run.log_view())) sample_words(frame, *hand);
}

}  // namespace replan::ui
