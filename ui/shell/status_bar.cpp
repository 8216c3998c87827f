// The status bar: the cell under the cursor, the search in numbers, and how the mission stands.
#include <algorithm>
#include <array>
#include <string>

#include "core/plan/tree_values.hpp"
#include "core/scene/spline_marks.hpp"
#include "ui/canvas/cell_words.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"

namespace replan::ui {
namespace {

struct Verdict {
  ImU32 colour;
  std::string text;
  const char* term;  ///< of the glossary
};

/// Whether a plan was begun between the last decision and the cursor, and has not been finished.
bool searching(const Run& run, const Decision* decision) {
  const Timeline& log = run.timeline();
  const std::size_t from = decision == nullptr ? 0 : decision->event;
  const auto& milestones = run.milestones();
  for (std::size_t i = milestones.size(); i-- > 0 && milestones[i].event >= from;)
    if (milestones[i].event < log.cursor() && milestones[i].kind == EventKind::plan_begin) return true;
  return false;
}

Verdict verdict(const Theme& theme, const Run& run) {
  const Decision* decision = run.decision_at(run.timeline().cursor());
  if (decision == nullptr)
    return run.timeline().cursor() == 0 ? Verdict{theme.faint, "not planned yet", "plan"}
                                        : Verdict{theme.accent, "searching", run.info().step.term.data()};
  if (searching(run, decision)) return {theme.warning, "replanning", "replan"};
  switch (decision->state) {
    case MissionState::planning:
      return {theme.accent, "searching", run.info().step.term.data()};
    case MissionState::arrived:
      return {theme.good, "arrived", "arrival"};
    case MissionState::collision:
      return {theme.bad, "would hit an obstacle", "collision"};
    case MissionState::loop:
      return {theme.bad, "goes round in a circle", "unchecked-parent"};
    case MissionState::stuck:
      return {theme.bad, "stuck: no arc leads on", "stuck"};
    case MissionState::endless:
      return {theme.bad, "turned back again and again", "moving-obstacle"};
    case MissionState::nearest:
      return {theme.warning, "as near to the goal as it can get", "nearest-goal"};
    case MissionState::no_path:
    case MissionState::driving:
      break;
  }
  switch (decision->plan->status) {
    case PlanStatus::start_blocked:
      return {theme.bad, decision->clock > 0 ? "the robot's cell is blocked" : "the start is blocked",
              "no-path"};
    case PlanStatus::goal_blocked:
      return {theme.bad, "the goal is blocked", "no-path"};
    case PlanStatus::no_path:
      return {theme.bad, "no path", "no-path"};
    case PlanStatus::none_found:
      return {theme.bad, "no path found", "no-path"};
    case PlanStatus::found_nearest:
      return {theme.warning, "plan to the nearest reachable cell", "nearest-goal"};
    default:
      return {theme.good, "plan found", "plan"};
  }
}

std::string cell_state(const Frame& frame, Cell cell) {
  // The robots of the panes need not know the same.
  const auto& pointed = frame.view.pointed;
  const bool other = frame.view.view.hovered && pointed && pointed->pane < frame.session.runs().size();
  const Run& run = other ? *frame.session.runs()[pointed->pane] : frame.run();
  return cell_words(run, cell);
}

/// Writes items from the left until the room ends.
class Line {
 public:
  Line(const Look& look, float right)
      : look_(look), right_(right), x_(ImGui::GetCursorScreenPos().x), y_(ImGui::GetCursorScreenPos().y) {}

  /// A number has room for some digits more, or for as many letters as it may come to have, so that what stands behind
  /// it does not move.
  void pair(std::string_view label, std::string_view value, const Hint& what, std::size_t letters = 0) {
    constexpr std::size_t kDigits = 4;
    if (letters == 0) letters = (value.size() + kDigits - 1) / kDigits * kDigits;
    const float before = text_width(look_.fonts.ui, label) + look_.px.xs;
    if (!next(before + text_width(look_.fonts.mono, value),
              before + text_width(look_.fonts.mono, "0") * static_cast<float>(letters)))
      return;
    ImGui::BeginGroup();
    labelled(look_, label, value);
    ImGui::EndGroup();
    hint(look_, what);
  }
  void word(std::string_view words) {
    if (next(text_width(look_.fonts.ui, words))) text(look_.fonts.ui, look_.theme.dim, words);
  }
  /// In a room of its own, which it need not fill.
  void word(std::string_view words, float room, const Hint& what) {
    if (!next(text_width(look_.fonts.ui, words), room)) return;
    text(look_.fonts.ui, look_.theme.dim, words);
    hint(look_, what);
  }
  /// Whether there was room for it.
  bool dot(const Verdict& verdict, float room = 0) {
    const float dot = look_.px(14);
    if (!next(text_width(look_.fonts.ui, verdict.text) + dot, room + dot)) return false;
    status(look_, verdict.colour, verdict.text);
    hint(look_, term_hint(verdict.term));
    return true;
  }
  /// Goes on to an item, behind which the next one stands after `room`, or right behind it if it takes more.
  bool next(float width, float room = 0) {
    if (x_ + width > right_) return false;
    ImGui::SetCursorScreenPos({x_, y_});
    x_ += std::max(width, room) + look_.px(22);
    return true;
  }

 private:
  const Look& look_;
  float right_, x_, y_;
};

/// The numbers at the right edge; returns where they begin.
float right_side(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.session.run();
  const Decision* decision = run.decision_at(run.timeline().cursor());
  const std::string moves =
      "step " + grouped(static_cast<std::int64_t>(run.timeline().state().scalar(Scalar::moves)));
  const std::string time = frame.panels.frame_ms > 0 ? fixed(frame.panels.frame_ms, 1) + " ms" : "";
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  const float time_x = right - text_width(look.fonts.mono, "00.0 ms");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, look.fonts.mono, {right - text_width(look.fonts.mono, time), origin.y}, look.theme.dim,
            time);
  const float moves_x = time_x - look.px(16) - text_width(look.fonts.ui, moves);
  if (decision != nullptr) draw_text(list, look.fonts.ui, {moves_x, origin.y}, look.theme.dim, moves);
  const auto explain = [&](float from, float to, const Hint& what) {
    ImGui::SetCursorScreenPos({from, origin.y});
    ImGui::Dummy({std::max(1.0f, to - from), look.fonts.ui->FontSize});
    hint(look, what);
  };
  explain(time_x, right,
          {"Time of a frame", "", "How long the processor works on one picture of this window."});
  if (decision != nullptr) explain(moves_x, time_x - look.px(16), term_hint("steps"));
  ImGui::SetCursorScreenPos(origin);
  return moves_x;
}

/// While something is at work: what it has come to, and the way to stop it. It ends at `right`, which goes on to where it
/// begins, so that nothing else moves when it comes and grows.
template <class Press>
void at_work(const Look& look, float& right, const std::string& words, const char* id, const Hint& what,
             const Press& press, const char* sign = icon::times) {
  const float y = ImGui::GetCursorScreenPos().y;
  right -= text_width(look.fonts.ui, words) + look.px.xs + look.px.small;
  ImGui::SetCursorScreenPos({right, y});
  text(look.fonts.ui, look.theme.accent, words);
  ImGui::SameLine(0, look.px.xs);
  ImGui::SetCursorScreenPos(
      {ImGui::GetCursorScreenPos().x, y + (look.fonts.ui->FontSize - look.px.small) * 0.5f});
  if (small_button(look, id, {.icon = sign, .hint = what})) press();
  ImGui::SetCursorScreenPos({right, y});
  right -= look.px.l;
}

/// The background's search, or its work on the world.
void busy(Frame& frame, float& right) {
  const Run& run = frame.session.run();
  const bool editing = frame.session.editing_world();
  if (!run.busy() && !editing) return;
  frame.panels.animated = true;
  const Action& stop = action(ActionId::cancel);
  // Once a plan has stood, what goes on in the background is the mission.
  const std::string events = grouped(run.timeline().size()) + " events";
  at_work(frame.look, right,
          editing                   ? "Changing the world…"
          : run.decisions().empty() ? events + " so far"
                                    : "Driving… " + events,
          stop.name, stop.hint(), [&] { perform(frame, ActionId::cancel); });
}

/// What the checks of one kind came to over all panes.
struct CheckSum {
  bool on = false, busy = false;
  std::int64_t wrong = 0;
};

/// A dot for each check that is on. A click leads to what went wrong, or to the checks.
void check_dot(Frame& frame, Line& line, const CheckSum& sum, const char* good, const char* busy,
               const std::string& bad, const char* term) {
  if (!sum.on) return;
  const Theme& theme = frame.look.theme;
  if (!line.dot(sum.wrong > 0 ? Verdict{theme.bad, bad, term}
                : sum.busy    ? Verdict{theme.dim, busy, term}
                              : Verdict{theme.good, good, term}))
    return;
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
  perform(frame, sum.wrong > 0 ? ActionId::first_breach : ActionId::show_debug);
}

void checks(Frame& frame, Line& line) {
  const Session& session = frame.session;
  CheckSum laws, oracle;
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    const LawReport law = session.checks().laws(pane);
    const OracleReport asked = session.checks().oracle(pane);
    const bool lawful = session.runs()[pane]->info().values.lawful();
    laws.on = laws.on || (law.on && lawful);
    laws.busy = laws.busy || (lawful && law.checked < session.runs()[pane]->timeline().size());
    laws.wrong += static_cast<std::int64_t>(law.breaches);
    oracle.on = oracle.on || asked.on;
    oracle.busy = oracle.busy || asked.busy || asked.asked == 0;
    oracle.wrong += static_cast<std::int64_t>(asked.disagreements);
  }
  check_dot(frame, line, oracle, "oracle agrees", "asking the oracle",
            "oracle disagrees: " + count_text(oracle.wrong, "plan", "plans"), "oracle");
  check_dot(frame, line, laws, "invariants hold", "checking invariants",
            count_text(laws.wrong, "breach", "breaches") + " of invariants", "invariant");
}

/// While a trace is written: how far it is, and the way to stop it.
void exporting(Frame& frame, float& right) {
  if (frame.panels.exporting < 0) return;
  at_work(frame.look, right, "Exporting the trace… " + fixed(frame.panels.exporting * 100, 0) + " %",
          "stop export", {"Stop", "", "Stops the export; no file is left."},
          [&] { frame.wish = Wish::stop_export; });
}

/// While the run is on its way to the moment of a link or of a copied state.
void going(Frame& frame, float& right) {
  const auto& on_way = frame.panels.going;
  if (!on_way) return;
  at_work(frame.look, right,
          "Going to event " + grouped(on_way->event) + "… " + fixed(on_way->share * 100, 0) + " %",
          "stop going", {"Stop", "", "Stays where the run has come to by then."},
          [&] { frame.wish = Wish::stop_going; });
}

/// While a batch is at work: how far it is, and the way to its table.
void batching(Frame& frame, float& right) {
  const auto& batch = frame.panels.batch;
  if (!batch) return;
  const std::string words = batch->all == 0
                                ? "Batch: reading the worlds…"
                                : "Batch: " + grouped(batch->done) + " of " + grouped(batch->all) + " runs";
  at_work(
      frame.look, right, words, "show batch", {"Show the batch", "", "Its table, and what stops it."},
      [&] { perform(frame, ActionId::batch); }, icon::table);
}

/// While the clipboard's text takes longer than a frame.
void copying(Frame& frame, float& right) {
  ClipboardWork& work = frame.panels.clipboard;
  if (!work.busy()) return;
  const std::string words = work.copy    ? "Copying the state… " + fixed(work.copy->share() * 100, 0) + " %"
                            : work.cells ? "Copying the cells…"
                                         : "Reading the clipboard…";
  at_work(frame.look, right, words, "stop clipboard", {"Stop", "", "Nothing is copied or pasted."},
          [&] { work = {}; });
}

/// While a film of a part of the run is made: how far it is, and the way to stop it.
void filming(Frame& frame, float& right) {
  const double made = frame.panels.recording.made;
  if (made < 0) return;
  frame.panels.animated = true;
  at_work(frame.look, right, "Making the film… " + fixed(made * 100, 0) + " %", "stop film",
          {"Stop", "", "Gives the film up; no file is left."}, [&] { frame.wish = Wish::stop_film; });
}

/// Beside how large a cell is: smaller, larger, the whole world.
void zoom_buttons(Frame& frame, Line& line) {
  const Look& look = frame.look;
  constexpr std::array kIds = {ActionId::zoom_out, ActionId::zoom_in, ActionId::fit};
  if (!line.next(look.px.small * static_cast<float>(kIds.size()))) return;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({origin.x - look.px.s, origin.y - (look.px.small - look.px.l) * 0.5f});
  for (const ActionId id : kIds) {
    const Action& each = action(id);
    if (small_button(look, each.name, {.icon = each.icon, .hint = each.hint()})) perform(frame, id);
    ImGui::SameLine(0, 0);
  }
}

/// What the planner keeps to go on with: an open list, a tree, or a population.
void held(const Run& run, Line& line) {
  const SearchState& state = run.timeline().state();
  const SearchValues& values = run.info().values;
  if (values.grows())
    line.pair("tree", grouped(std::int64_t{vertex_count(state)}),
              {"Vertices of the tree", "",
               "How many vertices the tree of samples has, those that were cut off among them. This planner "
               "keeps no open list."});
  else if (values.breeds())
    line.pair(
        "generation", grouped(static_cast<std::int64_t>(state.scalar(Scalar::generation))),
        {"Generation", "",
         "How many generations of paths have been bred for this goal. This planner keeps no open list."});
  else
    line.pair("|U|", grouped(state.queue_size()), term_hint("open-list"));
}

}  // namespace

void draw_status_bar(Frame& frame) {
  const Look& look = frame.look;
  edge(look, Edge::top);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float right = right_side(frame) - look.px.l;
  busy(frame, right);
  exporting(frame, right);
  going(frame, right);
  batching(frame, right);
  copying(frame, right);
  filming(frame, right);
  ImGui::SetCursorScreenPos(origin);
  Line line(look, right);
  const Run& run = frame.run();
  const View& view = frame.view.view;
  const std::optional<Cell> cell = view.hovered ? view.hovered : view.pinned;
  const GridMap& map = frame.session.scenario().map;
  const bool inside = cell && map.contains(*cell);
  const bool solid = map.box().solid();
  const auto place = [solid](Cell at) {
    return std::to_string(at.x) + ", " + std::to_string(at.y) + (solid ? ", " + std::to_string(at.z) : "");
  };
  line.pair("Cell", inside ? place(*cell) : "–",
            {"Cell", "",
             solid ? "Column, row and layer, from (0, 0, 0) at the top left of the lowest layer."
                   : "Column and row, from (0, 0) at the top left."},
            place({map.width - 1, map.height - 1, map.depth - 1}).size());
  const std::optional<MapFrame> metres = shown_frame(frame.view, map);
  const LengthUnit lengths = shown_lengths(frame.view, map);
  if (metres && inside) {
    const Point middle = metres->to_metres(centre_of(*cell));
    line.pair("at", fixed(middle.x, 2) + ", " + fixed(middle.y, 2) + " m",
              {"Place", "", "The middle of the cell in the map's own frame: x to the right, y up."}, 16);
  }
  line.word(inside ? cell_state(frame, *cell) : "", text_width(look.fonts.ui, "obstacle · known"),
            {"What stands there", "",
             "In the true world, and whether the robot knows of it. It plans on what it believes alone."});
  if (const PullIn* pull = inside ? pull_in_at(run, view, *cell) : nullptr) {
    const std::string words =
        "The curve is pulled in: it would have hit " + node_text(run, map.box().node(pull->cell));
    line.word(
        words, text_width(look.fonts.ui, words),
        {"Pulled in", "",
         "Where the curve would have hit an obstacle, it is drawn nearer to the path that it smooths."});
  }
  const StrokeKind stroke = frame.view.editing.stroke;
  if (stroke == StrokeKind::erases_wall) line.word("erasing, since the first cell was an obstacle");
  if (stroke == StrokeKind::erases) line.word("erasing");
  if (stroke == StrokeKind::paints) line.word("painting, since the first cell was free");
  line.dot(verdict(look.theme, run), text_width(look.fonts.ui, "replanning"));
  checks(frame, line);
  const Decision* decision = run.decision_at(run.timeline().cursor());
  if (decision != nullptr && decision->state == MissionState::arrived)
    line.pair("travelled", lengths.text(decision->figures.travelled, 1), term_hint("travelled"));
  else if (decision != nullptr && has_path(decision->plan->status))
    line.pair("to go", lengths.text(std::max(decision->plan->length - decision->along_plan, 0.0), 1),
              term_hint("to-go"));
  held(run, line);
  const std::string bias = cost_text(run.timeline().state().km(), 2);
  if (run.info().from_goal && run.info().values.lookahead()) line.pair("km", bias, term_hint("km"));
  if (run.info().values.waves && run.info().values.declares(fields::kFocused.kind))
    line.pair("d", bias, term_hint("d"));
  for (const PlanNumber& number : run.info().values.numbers) {
    if (run.timeline().state().scalar(number.which) == 0) continue;  // there has been no plan yet
    const std::string label(number.label), help(number.help);
    const Cost value{static_cast<std::int64_t>(run.timeline().state().scalar(number.which))};
    line.pair(label.c_str(), cost_text(value, 3), {label.c_str(), "", help.c_str()});
  }
  const double zoom = frame.panels.zoom / static_cast<double>(look.px.scale);
  line.pair("Zoom", fixed(zoom, zoom < 10 ? 1 : 0) + " px",
            {"Zoom", "", "How many pixels of the display a cell is wide."});
  zoom_buttons(frame, line);
}

}  // namespace replan::ui
