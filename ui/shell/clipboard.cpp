#include "ui/shell/clipboard.hpp"

#include <algorithm>

#include "core/base/words.hpp"
#include "ui/documents/files.hpp"
#include "ui/shell/actions.hpp"
#include "ui/tools/select.hpp"

namespace replan::ui {
namespace {

/// What copying may take of a frame.
constexpr double kSliceMs = 8;
/// Bytes of text that are read at once.
constexpr std::size_t kLongText = std::size_t{1} << 18;

MapRegion as_region(const CellRect& rect) {
  return {rect.low.x, rect.low.y, rect.high.x - rect.low.x + 1, rect.high.y - rect.low.y + 1};
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height) + " cells";
}

/// Every cell of a map as changes, with its upper left cell at a place; what falls outside the world or would block a
/// cell of `keep_free` is left out.
std::vector<CellChange> placed(const GridMap& cells, Cell at, const GridMap& world,
                               std::span<const Cell> keep_free) {
  std::vector<CellChange> changes;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x) {
      const Cell to{at.x + x, at.y + y};
      const bool blocked = cells.at({x, y});
      if (!world.contains(to)) continue;
      if (blocked && std::find(keep_free.begin(), keep_free.end(), to) != keep_free.end()) continue;
      changes.push_back({to, blocked});
    }
  return changes;
}

/// Where start and goal stand now.
std::vector<Cell> standing(const Session& session) {
  std::vector<Cell> cells = {session.scenario().start, session.scenario().goal};
  const Run& run = session.run();
  if (const NodeId node = run.timeline().state().wanted_goal(); node != kNoNode)
    cells.push_back(run.lattice().position(node));
  return cells;
}

void say(PanelState& panels, std::string sentence, bool bad = false) {
  panels.said = std::move(sentence);
  panels.said_bad = bad;
}

WorkPlace place_for(bool large) {
  return {.in_step = !large, .wake = {}};
}

}  // namespace

StateCopy::StateCopy(const Session& session, const CaseFocus& focus)
    : draft_(draft_case(session.run().scenario(), session.run().log_view(), focus)),
      hash_(session.run().timeline().state()),
      scenario_(place_for(session.run().lattice().node_count() > kLargeWorld)) {
  scenario_.start([held = session.snapshot()](const std::stop_token&) { return case_scenario(*held); });
}

std::optional<std::string> StateCopy::go_on(const Deadline& deadline) {
  if (auto text = scenario_.take()) scenario_text_ = std::move(text);
  if (!hash_.advance(deadline) || !scenario_text_) return std::nullopt;
  return complete(draft_, hash_.value(), *scenario_text_);
}

PastedText read_pasted(const std::string& text) {
  if (is_case_text(text)) return {parse_case_text(text, "the clipboard")};
  return {std::nullopt, parse_ascii_map(text, "the clipboard")};
}

void ActionContext::copy_world() {
  const Scenario& scenario = session.scenario();
  const MapFile world{session.world(), scenario.start, scenario.goal};
  ImGui::SetClipboardText(ascii_text(world).c_str());
  say(panels, "Copied the world as text: " + size_text(scenario.map.width, scenario.map.height));
}

void ActionContext::copy_state() {
  CaseFocus focus{session.lead(), view.view.pinned, std::nullopt};
  if (view.editing.region) focus.region = as_region(*view.editing.region);
  panels.clipboard.copy = std::make_unique<StateCopy>(session, focus);
  go_on_copying();
}

void ActionContext::go_on_copying() {
  std::unique_ptr<StateCopy>& copy = panels.clipboard.copy;
  if (!copy) return;
  const std::optional<std::string> text = copy->go_on(Deadline(kSliceMs));
  if (!text) return;
  ImGui::SetClipboardText(text->c_str());
  say(panels,
      "Copied the state at event " + std::to_string(copy->event()) + " as text; pasting it comes back here");
  copy.reset();
}

void ActionContext::copy_region() {
  const MapRegion region = as_region(*view.editing.region);
  const MapFile world{session.world()};
  ImGui::SetClipboardText(ascii_text(world, region).c_str());
  say(panels, "Copied " + size_text(region.width, region.height) + " as text");
}

void ActionContext::cut_region() {
  copy_region();
  clear_region();
}

void ActionContext::paste() {
  const char* text = ImGui::GetClipboardText();
  if (text == nullptr || *text == '\0') return say(panels, "The clipboard holds no text", true);
  std::string held = text;
  panels.clipboard.paste = std::make_unique<Background<PastedText>>(place_for(held.size() > kLongText));
  panels.clipboard.paste->start(
      [held = std::move(held)](const std::stop_token&) { return read_pasted(held); });
  go_on_pasting();
}

void ActionContext::go_on_pasting() {
  if (!panels.clipboard.paste) return;
  auto read = panels.clipboard.paste->take();
  if (!read) return;
  panels.clipboard.paste.reset();
  if (read->moment)
    put_in_moment(std::move(*read->moment));
  else
    put_in_cells(read->cells);
}

void ActionContext::put_in_moment(Result<CaseMoment> moment) {
  if (!moment) return say(panels, moment.error(), true);
  if (const auto plane = check_plane(moment->scenario.map, ""); !plane)
    return say(panels, plane.error(), true);
  panels.pasted = std::make_shared<const CaseMoment>(std::move(moment.value()));
  wish = Wish::go_to_pasted;
}

void ActionContext::put_in_cells(const Result<MapFile>& read) {
  if (!read) return say(panels, read.error(), true);
  const Scenario& scenario = session.scenario();
  const GridMap& cells = read->map;
  for (const std::string& note : read->found.notes) panels.notices.push_back(note);
  const std::string noted = read->found.notes.empty() ? "" : "; " + read->found.notes.front();
  if (read->start && read->goal) {
    const bool same_frame = cells.width == scenario.map.width && cells.height == scenario.map.height &&
                            read->start == scenario.start && read->goal == scenario.goal;
    // Cell by cell if it can be, so that the plan is repaired.
    if (same_frame && cells.blocked.size() <= kLargeWorld)
      push(PaintCells{placed(cells, {0, 0}, scenario.map, standing(session)), 0});
    else
      push(ReplaceMap{cells, read->start, read->goal});
    return say(panels, "Pasted a world of " + size_text(cells.width, cells.height) + noted);
  }
  const Cell at = view.editing.region ? view.editing.region->low
                                      : view.view.pinned.value_or(view.view.hovered.value_or(Cell{0, 0}));
  push(PaintCells{placed(cells, at, scenario.map, standing(session)), 0});
  const Cell end{std::min(at.x + cells.width, scenario.map.width) - 1,
                 std::min(at.y + cells.height, scenario.map.height) - 1};
  select_with_tool(view, {at, end});
  const bool whole = end.x - at.x + 1 == cells.width && end.y - at.y + 1 == cells.height;
  say(panels, "Pasted " + size_text(cells.width, cells.height) +
                  (whole ? "" : "; what did not fit into the world was left out") + noted);
}

}  // namespace replan::ui
