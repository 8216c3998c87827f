#include <algorithm>

#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"
#include "core/debug/offers.hpp"
#include "core/debug/open_order.hpp"
#include "core/debug/wave.hpp"
#include "core/export/case_text.hpp"
#include "core/export/json_lines.hpp"
#include "core/export/trace_text.hpp"
#include "core/lattice/box_words.hpp"
#include "core/plan/population_values.hpp"
#include "core/plan/tree_values.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

constexpr int kWholeWorld = 200;                   // cells along a side that are still drawn all
constexpr int kPartWidth = 100, kPartHeight = 60;  // of a larger world
constexpr std::int64_t kMostLetters = 20'000;      // of all layers together; else those of one are drawn
constexpr int kAround = 3;                         // cells listed on each side of the pin or the robot
constexpr std::size_t kMostListed = 64, kMostQueued = 20;

/// What is written, and the state at the log's cursor.
struct Source {
  const Scenario& scenario;
  const LogView& view;
  const CaseFocus& focus;
  const SearchState& state;
  NodeId robot;
  bool lookahead;

  [[nodiscard]] Cell middle() const {
    if (focus.region) {
      const auto [low, high] = *focus.region;
      return {(low.x + high.x + 1) / 2, (low.y + high.y + 1) / 2, (low.z + high.z) / 2};
    }
    return focus.pin.value_or(robot == kNoNode ? scenario.start : view.lattice.position(robot));
  }
};

std::string number(Cost cost) {
  std::string text;
  if (cost.is_infinite())
    text = "inf";
  else
    append_cost(text, cost);
  return text;
}

std::string cell_of(const Source& from, NodeId node) {
  const Box& world = from.view.lattice;
  return node < world.node_count() ? cell_text(world.position(node), world.solid()) : "none";
}

/// "name      value"
std::string labelled(std::string_view name, const std::string& value) {
  std::string line(name);
  line.resize(std::max<std::size_t>(10, line.size() + 1), ' ');
  return line + value + "\n";
}

std::string planner_line(const Source& from) {
  std::string line = std::string(from.view.info.id) + " (" + std::string(from.view.info.name) + ")";
  for (const Parameter& parameter : from.view.info.parameters)
    line +=
        " " + std::string(parameter.key) + "=" + format_value(parameter, from.view.settings.get(parameter));
  return line;
}

/// The event before the cursor, as a line of the JSON Lines trace.
std::string last_event(const Source& from) {
  const std::size_t cursor = from.view.log.cursor();
  if (cursor == 0) return "none yet";
  const Event& event = from.view.log.event(cursor - 1);
  const SearchState before = from.view.log.state_at(cursor - 1);
  const TraceRun run{from.view, {}, {}, {}, {}};
  std::string line;
  JsonLines(run).event(line, cursor - 1, event, before);
  line.pop_back();
  return line;
}

/// The cells in the open list, the next one first: the first kMostQueued of them.
std::vector<NodeId> next_queued(const Source& from) {
  const SearchState& state = from.state;
  std::vector<OpenEntry> entries;
  for (NodeId n = 0; n < state.node_count(); ++n) {
    if (n % SearchState::kPage == 0 && !state.touched(EventKind::queue, n))
      n += static_cast<NodeId>(SearchState::kPage) - 1;
    else if (state.queued(n))
      entries.push_back(open_entry(state, from.view.info.values.order, n));
  }
  const std::size_t shown = std::min(entries.size(), kMostQueued);
  std::partial_sort(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(shown), entries.end());
  std::vector<NodeId> nodes(shown);
  std::transform(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(shown), nodes.begin(),
                 [](const OpenEntry& entry) { return entry.node; });
  return nodes;
}

/// What is the matter with the ends of the plan: the letters of the world cannot show it.
std::string ends_lines(const Source& from) {
  const SearchState& state = from.state;
  const NodeId wanted = state.wanted_goal(), aim = state.node(Scalar::goal);
  std::string text;
  const auto say = [&](NodeId node, const char* known, const char* unknown) {
    if (node >= state.node_count() || !state.truly_blocked(node)) return;
    text += labelled("", state.known_blocked(node) ? known : unknown);
  };
  say(from.robot, "an obstacle stands on the robot's cell and keeps it there",
      "an obstacle stands on the robot's cell; it may drive out");
  say(wanted, "an obstacle stands on the goal's cell",
      "an obstacle stands on the goal's cell, which the robot does not know");
  if (aim != kNoNode && wanted != aim)
    text += labelled("", "the goal cannot be reached: it makes for " + cell_of(from, aim) +
                             ", the reachable cell nearest to it");
  return text;
}

/// What the planner keeps: an open list U, a tree, or a population of paths.
std::string kept_line(const Source& from, std::size_t queued) {
  const SearchValues& values = from.view.info.values;
  if (values.lists()) return labelled("U", counted(queued, "cell"));
  const std::uint64_t cost = from.state.scalar(Scalar::best);
  const std::string best =
      cost == 0 ? "no path yet" : "the best path costs " + number({static_cast<std::int64_t>(cost)});
  if (values.grows()) {
    const std::uint32_t count = vertex_count(from.state);
    return labelled("tree", std::to_string(count) + (count == 1 ? " vertex, " : " vertices, ") + best);
  }
  if (values.breeds())
    return labelled("paths", counted(path_count(from.state), "path") + " with the child, " + best);
  return "";
}

std::string run_lines(const Source& from, std::size_t queued) {
  const Timeline& log = from.view.log;
  std::string moment = "event " + std::to_string(log.cursor()) + " of " + std::to_string(log.size());
  if (log.cursor() > 0) moment += ", pseudo-code line " + std::to_string(log.event(log.cursor() - 1).line);
  std::string text = labelled("planner", planner_line(from)) + labelled("moment", moment) +
                     labelled("last", last_event(from));
  text += labelled("robot", cell_of(from, from.robot) + ", step " +
                                std::to_string(from.state.scalar(Scalar::moves)) + ", replan " +
                                std::to_string(from.state.scalar(Scalar::replans)) + "; goal " +
                                cell_of(from, from.state.wanted_goal()));
  text += ends_lines(from);
  if (from.lookahead) text += labelled("km", number(from.state.km()));
  return text + kept_line(from, queued);
}

char letter(const Source& from, NodeId node) {
  const SearchState& state = from.state;
  const Box& lattice = from.view.lattice;
  if (node == from.robot) return state.truly_blocked(node) ? 'X' : 'R';
  const bool known = state.known_blocked(node);
  if (state.moving(node)) return 'M';
  if (state.wall(node)) return known ? '@' : '?';
  if (known) return '!';
  const NodeId goal = state.wanted_goal();
  if (node == (goal == kNoNode ? lattice.node(from.scenario.goal) : goal)) return 'G';
  return node == lattice.node(from.scenario.start) ? 'S' : '.';
}

/// Where a stretch of `length` cells begins that has `middle` in it, on a side of `size` cells.
int placed(int middle, int length, int size) {
  return std::clamp(middle - length / 2, 0, std::max(0, size - length));
}

std::string layer_lines(const Source& from, const CellBox& shown, int z) {
  std::string text = from.view.lattice.solid() ? labelled("layer", std::to_string(z)) : "";
  for (int y = shown.low.y; y <= shown.high.y; ++y) {
    for (int x = shown.low.x; x <= shown.high.x; ++x) text += letter(from, from.view.lattice.node({x, y, z}));
    text += '\n';
  }
  return text;
}

std::string world_lines(const Source& from) {
  const Box& lattice = from.view.lattice;
  const int width = lattice.width(), height = lattice.height();
  const Cell middle = from.middle();
  CellBox shown{{0, 0, 0}, {width - 1, height - 1, lattice.depth() - 1}};
  std::string title = size_text(lattice);
  if (width > kWholeWorld || height > kWholeWorld) {
    shown.low = {placed(middle.x, kPartWidth, width), placed(middle.y, kPartHeight, height), 0};
    shown.high.x = std::min(shown.low.x + kPartWidth, width) - 1;
    shown.high.y = std::min(shown.low.y + kPartHeight, height) - 1;
    title += ", of which these begin at " + cell_text(shown.low);
  }
  const bool all_layers = cell_count(shown) <= kMostLetters;
  std::string text = labelled("world", title) +
                     labelled("",
                              ". free, @ obstacle, ? one that the robot does not know of, "
                              "! one that is gone without its knowing,") +
                     labelled("", "M moving, S start, G goal, R robot, X robot in an obstacle");
  if (lattice.solid() && !all_layers) return text + layer_lines(from, shown, middle.z);
  for (int z = 0; z < lattice.depth(); ++z) text += layer_lines(from, shown, z);
  return text;
}

/// Rows of equally many cells, in columns.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      line.append(widths[i] - row[i].size() + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

const char* consistency(const Source& from, NodeId node) {
  const Cost g = from.state.g(node), rhs = from.state.rhs(node);
  if (from.state.known_blocked(node)) return "obstacle";
  if (too_near(from.view, from.state, node)) return "too near";
  const SearchValues& kept = from.view.info.values;
  if (kept.grows() || kept.breeds()) return "free";  // a cell has no state of its own there
  if (from.view.info.values.waves) return wave_name(wave_of(from.state, node));
  if (!from.lookahead) return from.state.queued(node) ? "open" : g.is_infinite() ? "unseen" : "settled";
  if (g == rhs) return g.is_infinite() ? "unseen" : "consistent";
  return g > rhs ? "g > rhs" : "g < rhs";
}

/// In U by which key, or not.
std::string key_text(const Source& from, NodeId node) {
  if (!from.state.queued(node)) return "-";
  const OpenEntry entry = open_entry(from.state, from.view.info.values.order, node);
  const bool third = !from.view.info.values.order.third.empty();
  if (!from.lookahead && !third) return number(entry.k1);
  const std::string key = "[" + number(entry.k1) + "; " + number(entry.k2);
  return third ? key + "; " + number(entry.k3) + "]" : key + "]";
}

std::string visits_text(const Source& from, NodeId node) {
  const std::uint32_t times = from.state.times_expanded(node);
  return times == 0 ? "-" : "#" + std::to_string(from.state.order(node)) + ", " + counted(times, "time");
}

std::string field_text(const Source& from, const Field& field, NodeId node) {
  const std::uint64_t raw = from.state.value(field.kind, node);
  switch (field.type) {
    case FieldType::cost:
      return number({static_cast<std::int64_t>(raw)});
    case FieldType::queue:
      return key_text(from, node);
    case FieldType::node:
      return cell_of(from, static_cast<NodeId>(raw) - 1u);
    case FieldType::visits:
      return visits_text(from, node);
    default:
      return value_text(from.view.lattice, field, raw);
  }
}

/// The planner's values in the order of the columns: costs first, what it waits by in U, parents, the rest.
std::vector<const Field*> columns(const Source& from) {
  constexpr FieldType kOrder[] = {FieldType::cost, FieldType::queue, FieldType::node,    FieldType::visits,
                                  FieldType::name, FieldType::count, FieldType::obstacle};
  std::vector<const Field*> columns;
  for (const FieldType type : kOrder)
    for (const Field& field : from.view.info.values.fields)
      if (field.shown && field.type == type) columns.push_back(&field);
  return columns;
}

std::vector<std::string> value_names(const Source& from) {
  std::vector<std::string> names = {"cell", "state"};
  for (const Field* field : columns(from))
    names.emplace_back(field->type == FieldType::queue    ? "in U by"
                       : field->type == FieldType::visits ? "expanded"
                                                          : field->name);
  return names;
}

std::vector<std::string> values(const Source& from, NodeId node) {
  std::vector<std::string> row = {cell_of(from, node), consistency(from, node)};
  for (const Field* field : columns(from)) row.push_back(field_text(from, *field, node));
  return row;
}

std::string table(const Source& from, const std::vector<NodeId>& nodes) {
  std::vector<std::vector<std::string>> rows = {value_names(from)};
  for (const NodeId node : nodes) rows.push_back(values(from, node));
  return aligned(rows);
}

/// An obstacle, or a cell that the search has not come to.
bool says_nothing(const Source& from, NodeId node) {
  return from.state.known_blocked(node) ||
         (from.state.g(node).is_infinite() && from.state.rhs(node).is_infinite() &&
          !from.state.queued(node) && from.state.order(node) == 0);
}

/// The cells in focus, those that the search has come to.
std::string focus_lines(const Source& from) {
  const Cell middle = from.middle();
  const CellBox around =
      from.focus.region.value_or(CellBox{{middle.x - kAround, middle.y - kAround, middle.z - kAround},
                                         {middle.x + kAround, middle.y + kAround, middle.z + kAround}});
  const Box& lattice = from.view.lattice;
  std::vector<NodeId> nodes;
  std::size_t left_out = 0;
  for (int z = std::max(0, around.low.z); z <= std::min(lattice.depth() - 1, around.high.z); ++z)
    for (int y = std::max(0, around.low.y); y <= std::min(lattice.height() - 1, around.high.y); ++y)
      for (int x = std::max(0, around.low.x); x <= std::min(lattice.width() - 1, around.high.x); ++x)
        nodes.push_back(lattice.node({x, y, z}));
  std::erase_if(nodes, [&](NodeId node) {
    return says_nothing(from, node) && (from.focus.region || lattice.position(node) != middle);
  });
  if (nodes.size() > kMostListed) {
    // In space they are many: the nearest ones tell most.
    if (lattice.solid())
      std::stable_sort(nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) {
        return squared_distance(lattice.position(a), middle) < squared_distance(lattice.position(b), middle);
      });
    left_out = nodes.size() - kMostListed;
    nodes.resize(kMostListed);
  }
  const std::string what = from.focus.region ? "of the region from " + cell_text(around.low, lattice.solid())
                                             : "around " + cell_text(middle, lattice.solid());
  return labelled("cells", what) + table(from, nodes) +
         (left_out > 0 ? "and " + std::to_string(left_out) + " more\n" : "");
}

std::string hash_text(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t i = text.size(); i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
  return text;
}

}  // namespace

std::string case_scenario(const Scenario& scenario) {
  Scenario held = scenario;
  held.map_file.clear();  // the map goes along
  held.map_reading = {};
  const Json document = Json::parse(scenario_text(held), nullptr, false);
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

CaseDraft draft_case(const Scenario& scenario, const LogView& view, const CaseFocus& focus) {
  const SearchState& state = view.log.state();
  const Source from{scenario, view, focus, state, state.node(Scalar::robot), view.info.values.lookahead()};
  const std::vector<NodeId> next = next_queued(from);
  const std::size_t queued = state.queue_size();
  std::string text =
      std::string(kCaseTitle) +
      (view.lattice.solid() ? ": what follows 'scenario' in the last line is the whole scenario.\n\n"
                            : ": pasted into Replan, this text goes to the moment that it shows.\n\n");
  text += run_lines(from, queued) + "\n" + world_lines(from) + "\n" + focus_lines(from);
  if (queued > 0) {
    const std::string title = queued == next.size() ? "in order" : "the first " + std::to_string(next.size());
    text += "\n" + labelled("U", title) + table(from, next);
  }
  return {std::move(text), focus.pane, view.log.cursor()};
}

std::string complete(const CaseDraft& draft, std::uint64_t state, const std::string& scenario) {
  const Json at = {{"pane", draft.pane}, {"event", draft.event}, {"state", hash_text(state)}};
  return draft.words + "\n" + std::string(kCaseAt) + at.dump() + "\n" + std::string(kCaseScenario) +
         scenario + "\n";
}

std::string case_text(const Scenario& scenario, const LogView& view, const CaseFocus& focus) {
  return complete(draft_case(scenario, view, focus), view.log.state().hash(), case_scenario(scenario));
}

}  // namespace replan
