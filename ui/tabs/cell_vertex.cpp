// Part of the Cell tab, for planners that grow a tree of samples: the vertex nearest to the cell, and why it hangs where it
// does.
#include <algorithm>
#include <vector>

#include "core/debug/sample_in_hand.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/cell_past.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

/// So many candidates are listed.
constexpr std::size_t kMostListed = 12;

std::uint32_t vertex_near(const Frame& frame, const CellView& view) {
  return frame.panels.nearest_vertex.follow(view.run.log_view(), view.run.log_id(), view.cell);
}

void no_vertex(const Look& look) {
  paragraph(look.fonts.ui, look.theme.dim, "The tree has no vertex yet: step on, or play.");
}

/// What the state tells of a vertex.
struct VertexView {
  const CellView& cell;
  std::uint32_t number;
  LengthUnit lengths;

  [[nodiscard]] Place place() const { return place_of(number); }
  [[nodiscard]] Place place_of(std::uint32_t v) const {
    return vertex_place(cell.state, v, cell.run.lattice().solid());
  }
  [[nodiscard]] Cost cost() const { return vertex_cost(cell.state, number); }
  [[nodiscard]] std::uint32_t parent() const { return vertex_parent(cell.state, number); }
};

std::string place_text(const Frame& frame, const VertexView& vertex) {
  const Point at = point_of(vertex.place());
  if (const auto metres = shown_frame(frame.view, frame.session.scenario().map))
    return metres_text(metres->to_metres(at), vertex.cell.run.lattice().solid());
  std::string words = "(" + decimal_text(at.x, 2) + ", " + decimal_text(at.y, 2);
  if (vertex.cell.run.lattice().solid()) words += ", " + decimal_text(at.z, 2);
  return words + ")";
}

void vertex_values(const Frame& frame, const VertexView& vertex) {
  const std::uint32_t parent = vertex.parent();
  const std::string number = grouped(std::int64_t{vertex.number}), at = place_text(frame, vertex),
                    cost = vertex.lengths.text(vertex.cost()),
                    hangs = parent == kNoNode ? "nothing: a root" : grouped(std::int64_t{parent}),
                    edge = parent == kNoNode
                               ? ""
                               : vertex.lengths.text(length_between(vertex.place(), vertex.place_of(parent)));
  std::vector<KeyValue> pairs = {{"vertex", number}, {"at", at}, {"cost", cost}, {"hangs on", hangs}};
  if (parent != kNoNode) pairs.push_back({"edge", edge});
  key_values(frame.look, pairs, 1);
}

/// To stop where it is rewired, and to follow its cost.
void vertex_buttons(Frame& frame, std::uint32_t number) {
  const Look& look = frame.look;
  const std::string vertex = "(" + std::to_string(number) + ")", rewired = "rewired" + vertex,
                    cost = "vertex_cost" + vertex;
  const bool stops = find_breakpoint(frame.session, rewired).has_value(),
             watched = is_watched(frame.session, cost);
  if (button(look, stops ? "Do not break on it" : "Break when rewired", ButtonKind::quiet, icon::bug))
    frame.commands.push_back(toggle_breakpoint(frame.session, rewired));
  hint(look, {rewired.c_str(), "", "Playing stops where this vertex is hung on another one."});
  ImGui::SameLine(0, look.px.s);
  if (button(look, watched ? "Do not watch it" : "Watch its cost", ButtonKind::quiet, icon::eye))
    frame.commands.push_back(toggle_watch(frame.session, cost));
  hint(look, {cost.c_str(), "", "A small chart of its cost over the run, in the tab Debug."});
}

/// The candidates of its birth, the least sum first.
void candidate_table(const Look& look, std::vector<SampleInHand::Candidate> all, const VertexView& vertex) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  const std::vector<Column> columns = {
      {"candidate", 10, Align::left}, {"way to it", 10}, {"edge", 7}, {"sum", 8}};
  table_head(look, columns);
  for (std::size_t i = 0; i < std::min(all.size(), kMostListed); ++i) {
    const bool blocked = all[i].cost.is_infinite();
    const Cost length = length_between(vertex.place(), vertex.place_of(all[i].vertex));
    const std::string number = grouped(std::int64_t{all[i].vertex}), edge = vertex.lengths.text(length, 2),
                      sum = blocked ? "blocked" : vertex.lengths.text(all[i].cost, 2),
                      way = blocked ? "" : vertex.lengths.text(Cost{all[i].cost.raw - length.raw}, 2);
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

/// The lines of the pseudo-code on which a tree is hung on another root, the tree of the goal on that of the start, and a
/// vertex on a new start.
constexpr int kMetLine = 12, kRootedLine = 16, kNewRootLine = 18;

/// Of a parent that is written: the event by which its cost, right behind it, is written too.
std::size_t settled_by(const Timeline& log, std::size_t hung) {
  const std::size_t next = hung + 1;
  const bool settles = next < log.size() && log.event(next).kind == fields::kVertexCost.kind &&
                       log.event(next).node == log.event(hung).node;
  return settles ? next : hung;
}

/// How it came to hang where it does since it came, and what that saved.
void rehung_line(Frame& frame, const VertexView& vertex, const std::optional<VertexBirth>& birth) {
  const Look& look = frame.look;
  const Timeline& log = vertex.cell.run.timeline();
  const auto hung = log.last_event(vertex.number, {fields::kVertexParent.kind}, log.cursor());
  auto rewired = log.last_event(vertex.number, {EventKind::rewired}, log.cursor());
  // One that is found and not yet done says nothing of what the vertex hangs on.
  if (rewired && (!hung || *hung < *rewired))
    rewired = log.last_event(vertex.number, {EventKind::rewired}, *rewired);
  const int line = hung ? int{log.event(*hung).line} : 0;
  if (hung && line >= kRootedLine && line < kNewRootLine) {
    paragraph(look.fonts.ui, look.theme.dim,
              "The tree was turned round when the robot moved: what it hangs on hung on it before.");
    return event_line(frame, "turned", "Turned by event", *hung);
  }
  if (hung && line == kMetLine && !rewired && vertex.number != goal_vertex(vertex.cell.state) &&
      (!birth || *hung > birth->event)) {
    paragraph(look.fonts.ui, look.theme.dim,
              "It grew from the goal, and was turned round when the two trees met.");
    return event_line(frame, "met", "Turned by event", *hung);
  }
  if (!rewired) {
    paragraph(look.fonts.ui, look.theme.dim,
              "It has not been rewired itself: it hangs where it was hung when it came.");
    return;
  }
  const std::string saved = vertex.lengths.text(Cost{static_cast<std::int64_t>(log.event(*rewired).delta)});
  paragraph(
      look.fonts.ui, look.theme.good,
      line == kNewRootLine
          ? "The robot has moved on: hung on where it stands now, this vertex saved " + saved + " of its way."
          : "The way over a later vertex is shorter: when it was hung on that, it saved " + saved +
                " of its way.");
  event_line(frame, "rewired", "Rewired by event", settled_by(log, *hung));
}

/// Why a vertex hangs where it does that had no candidates.
const char* nearest_words(const VertexView& vertex) {
  if (vertex.number == goal_vertex(vertex.cell.state))
    return "It is the goal: it hangs on the vertex over which the way to it is shortest, of those near "
           "enough that see it.";
  return vertex.cell.run.info().informed ? "It was put between two vertices of the path."
                                         : "It was the vertex nearest to the sample that it came from.";
}

/// What the candidates of its birth are, and what has become of its way since.
void came_words(const Look& look, const std::vector<SampleInHand::Candidate>& candidates,
                const VertexView& vertex) {
  Cost least = Cost::infinity();
  for (const SampleInHand::Candidate& candidate : candidates) least = std::min(least, candidate.cost);
  if (vertex.cost() < least && !least.is_infinite())
    paragraph(look.fonts.ui, look.theme.dim,
              "Since it came its way has become " + vertex.lengths.text(Cost{least.raw - vertex.cost().raw}) +
                  " shorter, by its own rewiring or that of a vertex before it.");
  paragraph(look.fonts.ui, look.theme.dim,
            "When it came, the way over the first of these was the shortest that is free:");
}

void why_it_hangs(Frame& frame, const VertexView& vertex) {
  const Look& look = frame.look;
  if (vertex.parent() == kNoNode) {
    section_title(look, "Why does it hang on nothing?");
    paragraph(look.fonts.ui, look.theme.dim, "It is the root: a tree grows from it.");
    return;
  }
  section_title(look, "Why does it hang on " + grouped(std::int64_t{vertex.parent()}) + "?");
  const Cost edge = length_between(vertex.place(), vertex.place_of(vertex.parent()));
  paragraph(look.fonts.ui, look.theme.text,
            "Its way is that to " + grouped(std::int64_t{vertex.parent()}) + ", " +
                vertex.lengths.text(Cost{vertex.cost().raw - edge.raw}) + ", and the edge from there, " +
                vertex.lengths.text(edge) + ": " + vertex.lengths.text(vertex.cost()) + ".");
  const auto birth = birth_of(vertex.cell.run.log_view(), vertex.number);
  rehung_line(frame, vertex, birth);
  if (birth && !birth->candidates.empty()) {
    came_words(look, birth->candidates, vertex);
    candidate_table(look, birth->candidates, vertex);
  } else {
    paragraph(look.fonts.ui, look.theme.dim, nearest_words(vertex));
  }
  if (birth) event_line(frame, "birth", "It came by event", birth->event);
}

/// What each vertex that was hung on the new one has saved, the most first.
void rewired_table(const Frame& frame, std::vector<SampleInHand::Rewired> all) {
  const Look& look = frame.look;
  const SearchState& state = frame.run().timeline().state();
  const LengthUnit lengths = shown_lengths(frame.view, frame.session.scenario().map);
  if (all.empty()) return;
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return b.saves < a.saves; });
  const std::vector<Column> columns = {{"hung on it", 10, Align::left}, {"its way now", 12}, {"saved", 8}};
  table_head(look, columns);
  Cost together = Cost::zero();
  for (std::size_t i = 0; i < all.size(); ++i) {
    together = together + all[i].saves;
    if (i >= kMostListed) continue;
    const std::string number = grouped(std::int64_t{all[i].vertex}),
                      way = lengths.text(vertex_cost(state, all[i].vertex), 2),
                      saved = lengths.text(all[i].saves, 2);
    const std::vector<TableCell> cells = {{number}, {way}, {saved, look.theme.good}};
    table_row(look, static_cast<int>(i), columns, cells, false);
  }
  paragraph(look.fonts.ui, look.theme.dim,
            "Together they saved " + lengths.text(together) +
                "; what hangs on them is nearer to the start by as much.");
}

/// What the sample at the cursor has come to.
void sample_words(Frame& frame, const SampleInHand& hand) {
  const Look& look = frame.look;
  section_rule(look);
  section_title(look, hand.pulls ? "The sample in hand, of phase 2" : "The sample in hand");
  if (hand.pulls)
    paragraph(look.fonts.ui, look.theme.dim,
              "There is a path: samples pull it straight now, and the tree stays as it is.");
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
  rewired_table(frame, hand.rewired);
}

}  // namespace

void draw_vertex_why(Frame& frame, const CellView& view) {
  const std::uint32_t number = vertex_near(frame, view);
  if (number == kNoNode) return no_vertex(frame.look);
  why_it_hangs(frame, {view, number, shown_lengths(frame.view, frame.session.scenario().map)});
}

void draw_vertex(Frame& frame, const CellView& view, CellPast& past) {
  const Look& look = frame.look;
  const std::uint32_t number = vertex_near(frame, view);
  if (number == kNoNode) return no_vertex(look);
  section_title(look, "The vertex nearest to it");
  const VertexView vertex{view, number, shown_lengths(frame.view, frame.session.scenario().map)};
  vertex_values(frame, vertex);
  vertex_buttons(frame, number);
  section_rule(look);
  why_it_hangs(frame, vertex);
  section_rule(look);
  past.draw_vertex(frame, number);
  if (const auto hand = sample_in_hand(view.run.log_view())) sample_words(frame, *hand);
}

}  // namespace replan::ui
